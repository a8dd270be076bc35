//! Header fields of requests and responses (QPACK, RFC 9204), without a dynamic table: the server's settings allow
//! none.

use std::collections::HashMap;

use httlib_huffman::DecoderSpeed;

/// Names of the header fields of a request that the server uses.
const USED: [&str; 6] = [":method", ":scheme", ":protocol", ":authority", ":path", "origin"];

/// Values of the used header fields by their names.
pub type Fields = HashMap<&'static str, String>;

/// Entries of QPACK's static table that a session request can use. Fields with other indices are ignored.
const KNOWN: [(u64, &str, &str); 12] = [
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
pub fn read(mut bytes: &[u8]) -> Option<Fields> {
    let mut fields = Fields::default();
    // Required insert count, which must be 0, then the base, which is irrelevant.
    if integer(&mut bytes, 8)? != 0 {
        return None;
    }
    integer(&mut bytes, 7)?;
    while let Some(first) = bytes.first().copied() {
        let (name, value) = match first {
            // Indexed field line, static table.
            0xc0.. => {
                let (name, value) = static_field(integer(&mut bytes, 6)?)?;
                (name.as_bytes().to_vec(), value.to_owned())
            }
            // Literal field line with a name of the static table.
            0x50..0x60 | 0x70..0x80 => {
                let (name, _) = static_field(integer(&mut bytes, 4)?)?;
                (name.as_bytes().to_vec(), String::from_utf8(text(&mut bytes, 7)?).ok()?)
            }
            // Literal field line with a literal name.
            0x20..0x40 => (text(&mut bytes, 3)?, String::from_utf8(text(&mut bytes, 7)?).ok()?),
            // Dynamic table.
            _ => return None,
        };
        if let Some(used) = USED.into_iter().find(|used| used.as_bytes() == name)
            && fields.insert(used, value).is_some()
        {
            // Each field occurs at most once.
            return None;
        }
    }
    Some(fields)
}

/// Header block of a response with a status code.
pub fn answer(status: u16) -> Vec<u8> {
    // Name 24 of the static table (`:status`), and a plain value of three bytes.
    [&[0, 0, 0x5f, 24 - 15, 3], status.to_string().as_bytes()].concat()
}

fn static_field(index: u64) -> Option<(&'static str, &'static str)> {
    let known = KNOWN.iter().find(|(known, ..)| *known == index);
    (index <= MAX_INDEX).then(|| known.map_or(("", ""), |(_, name, value)| (*name, *value)))
}

/// Decodes a prefixed integer with `bits` bits in its first byte (RFC 7541, 5.1).
fn integer(bytes: &mut &[u8], bits: u32) -> Option<u64> {
    let max_prefix = (1 << bits) - 1;
    let mut next = || bytes.split_off_first().map(|byte| u64::from(*byte));
    let first = next()? & max_prefix;
    if first < max_prefix {
        return Some(first);
    }
    let mut value = max_prefix;
    // No valid length or index needs more bytes.
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
fn text(bytes: &mut &[u8], bits: u32) -> Option<Vec<u8>> {
    let is_compressed = bytes.first()? >> bits & 1 == 1;
    let length = usize::try_from(integer(bytes, bits)?).ok()?;
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
    use crate::rooms::tests::support::Numbers;

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
        assert_eq!(read(&bytes), Some(USED.into_iter().zip(values).collect()));
        let twice = [&bytes[..], &[0xc0 | 15]].concat();
        assert_eq!(read(&twice), None, "a method comes twice");
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
            assert_eq!(read(wrong), None, "{wrong:02x?}");
        }
    }

    #[test]
    fn any_bytes_are_read_or_refused() {
        let mut numbers = Numbers(1);
        for _ in 0..20_000 {
            let mut bytes: Vec<u8> = (0..numbers.below(60)).map(|_| numbers.below(256) as u8).collect();
            // Most have a valid beginning.
            if let (Some(begin), true) = (bytes.get_mut(..2), numbers.below(4) > 0) {
                begin.fill(0);
            }
            let _ = read(&bytes);
        }
    }
}
