//! Varints, frames and capsules of HTTP/3 and WebTransport (RFC 9000, 16; RFC 9114, 7; draft-ietf-webtrans-http3), and
//! header fields (QPACK, RFC 9204) without a dynamic table: the server's settings allow none.

use std::collections::HashMap;

use bytes::{Buf, BufMut};
use httlib_huffman::DecoderSpeed;

/// Reads a varint, whose first two bits encode its length; none if bytes are missing.
pub fn read_varint(bytes: &mut &[u8]) -> Option<u64> {
    let first = *bytes.first()?;
    let length = varint_length(first);
    if bytes.len() < length {
        return None;
    }
    let number = bytes.get_uint(length);
    Some(number & (u64::MAX >> (64 - 8 * length + 2)))
}

/// Length of a varint by its first byte.
pub fn varint_length(first: u8) -> usize {
    1 << (first >> 6)
}

/// Writes a varint in its shortest form.
pub fn put_varint(out: &mut impl BufMut, number: u64) {
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
    put_varint(out, kind);
    put_varint(out, body.len() as u64);
    out.put_slice(body);
}

/// Beginning of the control stream, with the server's settings.
pub fn settings() -> Vec<u8> {
    let (mut out, mut body) = (Vec::new(), Vec::new());
    for (name, value) in SETTINGS {
        put_varint(&mut body, name);
        put_varint(&mut body, value);
    }
    put_varint(&mut out, CONTROL);
    put_frame(&mut out, frame::SETTINGS, &body);
    out
}

/// Frame that ends a session with a code and a short reason.
pub fn close_frame(code: u32, reason: &str) -> Vec<u8> {
    let (mut out, mut capsule) = (Vec::new(), Vec::new());
    put_varint(&mut capsule, CLOSE);
    put_varint(&mut capsule, 4 + reason.len() as u64);
    capsule.put_u32(code);
    capsule.put_slice(reason.as_bytes());
    put_frame(&mut out, frame::DATA, &capsule);
    out
}

/// Names of the header fields of a request that the server uses.
const USED_FIELDS: [&str; 6] = [":method", ":scheme", ":protocol", ":authority", ":path", "origin"];

/// Values of the used header fields by their names.
pub type Fields = HashMap<&'static str, String>;

/// Entries of QPACK's static table that a session request can use. Fields with other indices are ignored.
const STATIC_TABLE: [(u64, &str, &str); 12] = [
    (0, ":authority", ""),
    (1, ":path", "/"),
    (15, ":method", "CONNECT"),
    (16, ":method", "DELETE"),
    (17, ":method", "GET"),
    (18, ":method", "HEAD"),
    (19, ":method", "OPTIONS"),
    (20, ":method", "POST"),
    (21, ":method", "PUT"),
    (22, ":scheme", "http"),
    (23, ":scheme", "https"),
    (90, "origin", ""),
];
/// Greatest index of the static table.
const MAX_INDEX: u64 = 98;

/// Decodes the fields of a request; none if the bytes are invalid.
pub fn read_fields(mut bytes: &[u8]) -> Option<Fields> {
    let mut fields = Fields::default();
    // The required insert count must be 0; the base, which follows, is then without effect.
    if read_prefixed_integer(&mut bytes, 8)? != 0 {
        return None;
    }
    read_prefixed_integer(&mut bytes, 7)?;
    while let Some(first) = bytes.first().copied() {
        let (name, value) = match first {
            // Indexed field line, static table.
            0xc0.. => {
                let (name, value) = static_field(read_prefixed_integer(&mut bytes, 6)?)?;
                (name.as_bytes().to_vec(), value.to_owned())
            }
            // Literal field line with a name of the static table.
            0x50..0x60 | 0x70..0x80 => {
                let (name, _) = static_field(read_prefixed_integer(&mut bytes, 4)?)?;
                (name.as_bytes().to_vec(), String::from_utf8(read_string(&mut bytes, 7)?).ok()?)
            }
            // Literal field line with a literal name.
            0x20..0x40 => (read_string(&mut bytes, 3)?, String::from_utf8(read_string(&mut bytes, 7)?).ok()?),
            // Dynamic table.
            _ => return None,
        };
        if let Some(used) = USED_FIELDS.into_iter().find(|used| used.as_bytes() == name)
            && fields.insert(used, value).is_some()
        {
            // Each field occurs at most once.
            return None;
        }
    }
    Some(fields)
}

/// Header block of a response with a status code.
pub fn status_fields(status: u16) -> Vec<u8> {
    // Name 24 of the static table (`:status`), and a plain value of three bytes.
    [&[0, 0, 0x5f, 24 - 15, 3], status.to_string().as_bytes()].concat()
}

fn static_field(index: u64) -> Option<(&'static str, &'static str)> {
    let entry = STATIC_TABLE.iter().find(|(entry, ..)| *entry == index);
    (index <= MAX_INDEX).then(|| entry.map_or(("", ""), |(_, name, value)| (*name, *value)))
}

/// Decodes a prefixed integer with `bits` bits in its first byte (RFC 7541, 5.1).
fn read_prefixed_integer(bytes: &mut &[u8], bits: u32) -> Option<u64> {
    let max_prefix = (1 << bits) - 1;
    let mut next = || bytes.split_off_first().map(|byte| u64::from(*byte));
    let first = next()? & max_prefix;
    if first < max_prefix {
        return Some(first);
    }
    let mut value = max_prefix;
    // No valid length or index has more than three further bytes.
    for shift in [0, 7, 14] {
        let byte = next()?;
        value += (byte & 0x7f) << shift;
        if byte & 0x80 == 0 {
            return Some(value);
        }
    }
    None
}

/// Decodes a string: a Huffman flag, its length as a prefixed integer with `bits` bits, and its bytes.
fn read_string(bytes: &mut &[u8], bits: u32) -> Option<Vec<u8>> {
    let is_compressed = bytes.first()? >> bits & 1 == 1;
    let length = usize::try_from(read_prefixed_integer(bytes, bits)?).ok()?;
    let string = bytes.split_off(..length)?;
    if !is_compressed {
        return Some(string.to_vec());
    }
    let mut plain = Vec::with_capacity(2 * length);
    httlib_huffman::decode(string, &mut plain, DecoderSpeed::FourBits).ok()?;
    Some(plain)
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::rooms::tests::support::Random;

    /// Examples of RFC 9000, A.1.
    #[test]
    fn varints_equal_the_specification() {
        for (bytes, expected) in [
            (&[0xc2, 0x19, 0x7c, 0x5e, 0xff, 0x14, 0xe8, 0x8c][..], 151_288_809_941_952_652),
            (&[0x9d, 0x7f, 0x3e, 0x7d], 494_878_333),
            (&[0x7b, 0xbd], 15_293),
            (&[0x25], 37),
        ] {
            let (mut read, mut written) = (bytes, Vec::new());
            assert_eq!(read_varint(&mut read), Some(expected));
            assert!(read.is_empty());
            put_varint(&mut written, expected);
            assert_eq!(written, bytes);
            assert_eq!(read_varint(&mut &bytes[..bytes.len() - 1]), None);
        }
        assert_eq!(read_varint(&mut &[0x40, 0x25][..]), Some(37), "a longer form than necessary");
    }

    /// Header block of a request for a session, without an origin.
    pub fn session_fields(path: &str) -> Vec<u8> {
        let (start, literal_name) = ([0, 0, 0xc0 | 15, 0xc0 | 23, 0x50, 9], [0x27, 2]);
        let path = [&[0x51, path.len() as u8], path.as_bytes()].concat();
        [&start[..], b"localhost", &path, &literal_name, b":protocol", &[12], b"webtransport"].concat()
    }

    #[test]
    fn a_request_for_a_session_is_read() {
        // An unused field of the static table, and the origin, Huffman-coded as in RFC 7541, C.4.1.
        let origin = [0xf1, 0xe3, 0xc2, 0xe5, 0xf2, 0x3a, 0x6b, 0xa0, 0xab, 0x90, 0xf4, 0xff];
        let bytes = [&session_fields("/rooms")[..], &[0xc0 | 29, 0x5f, 90 - 15, 0x8c], &origin].concat();
        let values = ["CONNECT", "https", "webtransport", "localhost", "/rooms", "www.example.com"].map(str::to_owned);
        assert_eq!(read_fields(&bytes), Some(USED_FIELDS.into_iter().zip(values).collect()));
        let twice = [&bytes[..], &[0xc0 | 15]].concat();
        assert_eq!(read_fields(&twice), None, "a method comes twice");
    }

    #[test]
    fn invalid_fields_are_refused() {
        for wrong in [
            &[][..],
            &[0],
            &[1, 0],
            &[0, 0, 0x80],
            &[0, 0, 0x10],
            &[0, 0, 0x00],
            &[0, 0, 0x40, 0],
            &[0, 0, 0xff, 0x30],
            &[0, 0, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff],
            &[0, 0, 0x50, 4, 1],
            &[0, 0, 0x50, 1, 0xff],
            &[0, 0, 0x23, 1],
        ] {
            assert_eq!(read_fields(wrong), None, "{wrong:02x?}");
        }
    }

    #[test]
    fn any_bytes_are_read_or_refused() {
        let mut random = Random(1);
        for _ in 0..20_000 {
            let mut bytes: Vec<u8> = (0..random.below(60)).map(|_| random.below(256) as u8).collect();
            // Most have a valid beginning.
            if let (Some(begin), true) = (bytes.get_mut(..2), random.below(4) > 0) {
                begin.fill(0);
            }
            let _ = read_fields(&bytes);
        }
    }
}
