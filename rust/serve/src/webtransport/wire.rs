//! Varints, frames and capsules of HTTP/3 and WebTransport (RFC 9000, 16; RFC 9114, 7; draft-ietf-webtrans-http3).

use bytes::{Buf, BufMut};

/// Reads a varint, whose first two bits encode its length; none if bytes are missing.
pub fn number(bytes: &mut &[u8]) -> Option<u64> {
    let first = *bytes.first()?;
    let length = length_of(first);
    if bytes.len() < length {
        return None;
    }
    let number = bytes.get_uint(length);
    Some(number & (u64::MAX >> (64 - 8 * length + 2)))
}

/// Length of a varint by its first byte.
pub fn length_of(first: u8) -> usize {
    1 << (first >> 6)
}

/// Writes a varint in its shortest form.
pub fn put_number(out: &mut impl BufMut, number: u64) {
    match number {
        0..0x40 => out.put_u8(number as u8),
        0x40..0x4000 => out.put_u16(number as u16 | 1 << 14),
        0x4000..0x4000_0000 => out.put_u32(number as u32 | 2 << 30),
        _ => out.put_u64(number | 3 << 62),
    }
}

/// Frame types.
pub mod frame {
    /// Body of a response; here it holds capsules.
    pub const DATA: u64 = 0;
    /// Headers of a request or a response.
    pub const HEADERS: u64 = 1;
    /// Settings of an endpoint.
    pub const SETTINGS: u64 = 4;
    /// Turns the rest of the stream into a WebTransport stream; the session ID follows.
    pub const STREAM: u64 = 0x41;
}

/// Type of the control stream.
const CONTROL: u64 = 0;
/// Settings and values: no dynamic table, no blocked streams, extended CONNECT, datagrams, and WebTransport under both
/// of its codes.
const SETTINGS: [(u64, u64); 6] = [(1, 0), (7, 0), (8, 1), (0x33, 1), (0x2b60_3742, 1), (0xc671_706a, 1)];
/// Type of the capsule that ends a session.
const CLOSE: u64 = 0x2843;

pub fn put_frame(out: &mut Vec<u8>, kind: u64, body: &[u8]) {
    put_number(out, kind);
    put_number(out, body.len() as u64);
    out.put_slice(body);
}

/// Beginning of the control stream, with the server's settings.
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

/// Frame that ends a session with a code and a short reason.
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

    /// Examples of RFC 9000, A.1.
    #[test]
    fn numbers_equal_the_specification() {
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
