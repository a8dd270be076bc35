//! Numbers and frames of HTTP/3 and WebTransport as bytes (RFC 9000, 16; RFC 9114, 7; draft-ietf-webtrans-http3).

use bytes::{Buf, BufMut};

/// A number whose first two bits tell its bytes; none if some are missing.
pub fn number(bytes: &mut &[u8]) -> Option<u64> {
    let first = *bytes.first()?;
    let length = length_of(first);
    if bytes.len() < length {
        return None;
    }
    let number = bytes.get_uint(length);
    Some(number & (u64::MAX >> (64 - 8 * length + 2)))
}

/// Bytes of a number that begins with this one.
pub fn length_of(first: u8) -> usize {
    1 << (first >> 6)
}

/// Write a number in as few bytes as it needs.
pub fn put_number(out: &mut impl BufMut, number: u64) {
    match number {
        0..0x40 => out.put_u8(number as u8),
        0x40..0x4000 => out.put_u16(number as u16 | 1 << 14),
        0x4000..0x4000_0000 => out.put_u32(number as u32 | 2 << 30),
        _ => out.put_u64(number | 3 << 62),
    }
}

/// Kinds of frames.
pub mod frame {
    /// The body of an answer, here capsules.
    pub const DATA: u64 = 0;
    /// The head of a request or of an answer.
    pub const HEADERS: u64 = 1;
    /// The abilities of a side.
    pub const SETTINGS: u64 = 4;
    /// The rest of the stream is one of WebTransport; the number of its session follows.
    pub const STREAM: u64 = 0x41;
}

/// The kind of a stream by which a side tells its settings.
const CONTROL: u64 = 0;
/// Settings with their values: no table for headers, requests that become sessions, datagrams, sessions of
/// WebTransport under both of its names.
const SETTINGS: [(u64, u64); 6] = [(1, 0), (7, 0), (8, 1), (0x33, 1), (0x2b60_3742, 1), (0xc671_706a, 1)];
/// The kind of a capsule that ends a session.
const CLOSE: u64 = 0x2843;

/// The bytes of a frame.
pub fn put_frame(out: &mut Vec<u8>, kind: u64, body: &[u8]) {
    put_number(out, kind);
    put_number(out, body.len() as u64);
    out.put_slice(body);
}

/// The begin of the stream by which the server tells its settings.
pub fn settings() -> Vec<u8> {
    let (mut out, mut body) = (Vec::new(), Vec::new());
    for (name, value) in SETTINGS {
        put_number(&mut body, name);
        put_number(&mut body, value);
    }
    put_number(&mut out, CONTROL);
    put_frame(&mut out, frame::SETTINGS, &body);
    out
}

/// The frame by which a session ends, with a code and a short reason.
pub fn close(code: u32, reason: &str) -> Vec<u8> {
    let (mut out, mut capsule) = (Vec::new(), Vec::new());
    put_number(&mut capsule, CLOSE);
    put_number(&mut capsule, 4 + reason.len() as u64);
    capsule.put_u32(code);
    capsule.put_slice(reason.as_bytes());
    put_frame(&mut out, frame::DATA, &capsule);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The examples of RFC 9000, A.1.
    #[test]
    fn numbers_are_those_of_the_specification() {
        for (bytes, expected) in [
            (&[0xc2, 0x19, 0x7c, 0x5e, 0xff, 0x14, 0xe8, 0x8c][..], 151_288_809_941_952_652),
            (&[0x9d, 0x7f, 0x3e, 0x7d], 494_878_333),
            (&[0x7b, 0xbd], 15_293),
            (&[0x25], 37),
        ] {
            let (mut read, mut written) = (bytes, Vec::new());
            assert_eq!(number(&mut read), Some(expected));
            assert!(read.is_empty());
            put_number(&mut written, expected);
            assert_eq!(written, bytes);
            assert_eq!(number(&mut &bytes[..bytes.len() - 1]), None);
        }
        assert_eq!(number(&mut &[0x40, 0x25][..]), Some(37), "longer than it needs");
    }
}
