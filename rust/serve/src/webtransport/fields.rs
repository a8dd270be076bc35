//! Header fields of requests and responses (QPACK, RFC 9204), without a dynamic table: the server's settings allow
//! none.

use httlib_huffman::DecoderSpeed;

/// Header fields of a request that the server uses.
#[derive(Debug, Default, PartialEq)]
pub struct Fields {
    pub method: Option<String>,
    pub scheme: Option<String>,
    pub protocol: Option<String>,
    pub authority: Option<String>,
    pub path: Option<String>,
    pub origin: Option<String>,
}

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
const LAST: u64 = 98;

/// Decodes the fields of a request; none if the bytes are invalid.
pub fn read(mut bytes: &[u8]) -> Option<Fields> {
    let mut fields = Fields::default();
    // Required insert count, which must be 0, then the base, which is irrelevant.
    if integer(&mut bytes, 8)? != 0 {
        return None;
    }
    integer(&mut bytes, 7)?;
    while let Some(first) = bytes.first().copied() {
        match first {
            // Indexed field line, static table.
            0xc0.. => {
                let (name, value) = static_field(integer(&mut bytes, 6)?)?;
                fields.set(name.as_bytes(), value.to_owned())?;
            }
            // Literal field line with a name of the static table.
            0x50..0x60 | 0x70..0x80 => {
                let (name, _) = static_field(integer(&mut bytes, 4)?)?;
                let value = text(&mut bytes, 7)?;
                fields.set(name.as_bytes(), String::from_utf8(value).ok()?)?;
            }
            // Literal field line with a literal name.
            0x20..0x40 => {
                let (name, value) = (text(&mut bytes, 3)?, text(&mut bytes, 7)?);
                fields.set(&name, String::from_utf8(value).ok()?)?;
            }
            // Dynamic table.
            _ => return None,
        }
    }
    Some(fields)
}

impl Fields {
    /// Stores a field; none if it is a duplicate.
    fn set(&mut self, name: &[u8], value: String) -> Option<()> {
        let field = match name {
            b":method" => &mut self.method,
            b":scheme" => &mut self.scheme,
            b":protocol" => &mut self.protocol,
            b":authority" => &mut self.authority,
            b":path" => &mut self.path,
            b"origin" => &mut self.origin,
            _ => return Some(()),
        };
        field.replace(value).is_none().then_some(())
    }
}

/// Header block of a response with a status code.
pub fn answer(status: u16) -> Vec<u8> {
    // Name 24 of the static table (`:status`), and a plain value of three bytes.
    let mut bytes = vec![0, 0, 0x5f, 24 - 15, 3];
    bytes.extend_from_slice(status.to_string().as_bytes());
    bytes
}

fn static_field(number: u64) -> Option<(&'static str, &'static str)> {
    let found = KNOWN.iter().find(|(index, ..)| *index == number);
    (number <= LAST).then(|| found.map_or(("", ""), |(_, name, value)| (*name, *value)))
}

/// Decodes a prefixed integer with `bits` bits in its first byte (RFC 7541, 5.1).
fn integer(bytes: &mut &[u8], bits: u32) -> Option<u64> {
    let most = (1 << bits) - 1;
    let mut next = || {
        let (first, rest) = bytes.split_first()?;
        *bytes = rest;
        Some(u64::from(*first))
    };
    let first = next()? & most;
    if first < most {
        return Some(first);
    }
    let mut value = most;
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
    let (taken, rest) = bytes.split_at_checked(length)?;
    *bytes = rest;
    if !is_compressed {
        return Some(taken.to_vec());
    }
    let mut plain = Vec::with_capacity(2 * length);
    httlib_huffman::decode(taken, &mut plain, DecoderSpeed::FourBits).ok()?;
    Some(plain)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn some(text: &str) -> Option<String> {
        Some(text.to_owned())
    }

    #[test]
    fn a_request_for_a_session_is_read() {
        let mut bytes = vec![0, 0, 0xc0 | 15, 0xc0 | 23, 0x50, 9];
        bytes.extend_from_slice(b"localhost");
        bytes.extend_from_slice(&[0x51, 6]);
        bytes.extend_from_slice(b"/rooms");
        bytes.extend_from_slice(&[0x27, 2]);
        bytes.extend_from_slice(b":protocol");
        bytes.push(12);
        bytes.extend_from_slice(b"webtransport");
        // An unused field of the static table, and the origin, Huffman-coded as in RFC 7541, C.4.1.
        bytes.extend_from_slice(&[0xc0 | 29, 0x5f, 90 - 15, 0x8c]);
        bytes.extend_from_slice(&[0xf1, 0xe3, 0xc2, 0xe5, 0xf2, 0x3a, 0x6b, 0xa0, 0xab, 0x90, 0xf4, 0xff]);
        let expected = Fields {
            method: some("CONNECT"),
            scheme: some("https"),
            protocol: some("webtransport"),
            authority: some("localhost"),
            path: some("/rooms"),
            origin: some("www.example.com"),
        };
        assert_eq!(read(&bytes), Some(expected));
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
        let mut state = 1_u64;
        let mut below = |end: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as usize % end
        };
        for _ in 0..20_000 {
            let mut bytes: Vec<u8> = (0..below(60)).map(|_| below(256) as u8).collect();
            // Most have a valid beginning.
            if let (Some(begin), true) = (bytes.get_mut(..2), below(4) > 0) {
                begin.fill(0);
            }
            let _ = read(&bytes);
        }
    }
}
