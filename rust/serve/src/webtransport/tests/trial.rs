//! Arbitrary bytes as a connection's first stream and as a datagram, for tests and fuzzing.

use axum::http::header;
use futures_util::FutureExt;

use super::{session, wire};

/// Reads bytes as a session request, and checks that a valid one has a path and a host. Reads them as varints, and
/// checks that each keeps its value when it is written in its shortest form.
pub fn run(bytes: &[u8]) {
    let result = session::read_request(&mut &bytes[..]).now_or_never();
    if let Ok(request) = result.expect("all bytes are there") {
        assert!(request.uri().path().starts_with('/'), "a request without a path");
        assert!(request.headers().contains_key(header::HOST), "a request without a host");
    }
    let mut rest = bytes;
    while let Some(number) = wire::read_varint(&mut rest) {
        let mut written = Vec::new();
        wire::put_varint(&mut written, number);
        assert_eq!(wire::read_varint(&mut &written[..]), Some(number), "the value has changed");
    }
    assert!(session::payload(bytes).is_none_or(|payload| payload.len() < bytes.len()), "a datagram without a session");
}
