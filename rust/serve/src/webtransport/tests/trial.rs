//! Arbitrary bytes as a connection's first stream and as a datagram, for tests and fuzzing.

use axum::http::header;
use futures_util::FutureExt;

use super::{session, wire};

/// Reads bytes as a session request, which has a path and a host if it is valid. Checks that varints among the bytes
/// keep their values when they are written in their shortest form.
pub fn run(bytes: &[u8]) {
    let asked = session::read_request(&mut &bytes[..]).now_or_never();
    if let Ok(request) = asked.expect("all bytes are there") {
        assert!(request.uri().path().starts_with('/'), "a request without a path");
        assert!(request.headers().contains_key(header::HOST), "a request without a host");
    }
    let mut rest = bytes;
    while let Some(number) = wire::number(&mut rest) {
        let mut written = Vec::new();
        wire::put_number(&mut written, number);
        assert_eq!(wire::number(&mut &written[..]), Some(number), "another number");
    }
    assert!(session::payload(bytes).is_none_or(|payload| payload.len() < bytes.len()), "a datagram without a session");
}
