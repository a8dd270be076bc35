//! Tokens, which admit a user to a room, and tickets, which restore a user's number.

use std::fmt::Write;

use hmac::{Hmac, KeyInit, Mac};
use sha2::Sha256;

/// Least size of a key, bytes.
const KEY: usize = 16;
/// Size of a token's unique number, bytes.
const NUMBER: usize = 16;
/// Size of a token's signature, bytes.
const CODE: usize = 32;
/// Size of a ticket's truncated signature, bytes.
const SHORT: usize = 16;
/// Size of a ticket, bytes.
pub const TICKET: usize = 2 + 8 + SHORT;
/// Prefixes of signed bytes (domain separation), so that a ticket is not a valid token.
const ENTRY: &[u8] = b"nearfar room token 1\0";
const RETURN: &[u8] = b"nearfar return ticket 2\0";

/// Unique number of a token; only one connection can use it at a time.
pub type Number = [u8; NUMBER];

/// Key that signs tokens and tickets (HMAC-SHA-256).
#[derive(Clone)]
pub struct Key(Hmac<Sha256>);

impl Key {
    /// Creates a key from secret bytes.
    pub fn new(secret: &[u8]) -> Result<Self, String> {
        if secret.len() < KEY {
            return Err(format!("expected a key of {KEY} bytes or more, got {}", secret.len()));
        }
        Hmac::new_from_slice(secret).map(Key).map_err(|error| error.to_string())
    }

    /// Creates a token for a room that expires at `ends`, in seconds since 1970. Numbers must be unique and
    /// unpredictable.
    pub fn token(&self, room: &str, ends: u64, number: Number) -> String {
        let mut text = format!("{ends}.");
        put_hex(&mut text, &number);
        text.push('.');
        put_hex(&mut text, &self.entry(room, ends, &number).finalize().into_bytes());
        text
    }

    /// Checks a token for a room at a time in seconds since 1970; returns its number, or the reason for refusal.
    pub fn check(&self, room: &str, now: u64, token: &str) -> Result<Number, &'static str> {
        const WRONG: &str = "expected a token that was made for this room";
        let mut parts = token.split('.');
        let (Some(ends), Some(number), Some(code), None) = (parts.next(), parts.next(), parts.next(), parts.next())
        else {
            return Err(WRONG);
        };
        let is_number = ends.bytes().all(|byte| byte.is_ascii_digit());
        let ends: u64 = ends.parse().ok().filter(|_| is_number).ok_or(WRONG)?;
        let number: Number = from_hex(number).ok_or(WRONG)?;
        let code: [u8; CODE] = from_hex(code).ok_or(WRONG)?;
        // Constant-time comparison.
        self.entry(room, ends, &number).verify_slice(&code).map_err(|_| WRONG)?;
        if now < ends { Ok(number) } else { Err("expected a token that has not expired") }
    }

    /// Creates a ticket for a user's number and identity in a room; it is valid only with the user's token.
    pub fn ticket(&self, room: &str, token: Option<&Number>, user: u16, identity: u64) -> [u8; TICKET] {
        let mut ticket = [0; TICKET];
        ticket[..2].copy_from_slice(&user.to_le_bytes());
        ticket[2..10].copy_from_slice(&identity.to_le_bytes());
        let code = self.back(room, token, &ticket[..10]).finalize().into_bytes();
        ticket[10..].copy_from_slice(&code[..SHORT]);
        ticket
    }

    /// User number and identity of a ticket, if it is valid for this room and token.
    pub fn back_to(&self, room: &str, token: Option<&Number>, ticket: &[u8]) -> Option<(u16, u64)> {
        let ticket: &[u8; TICKET] = ticket.try_into().ok()?;
        self.back(room, token, &ticket[..10]).verify_truncated_left(&ticket[10..]).ok()?;
        let user = u16::from_le_bytes(ticket[..2].try_into().ok()?);
        Some((user, u64::from_le_bytes(ticket[2..10].try_into().ok()?)))
    }

    fn entry(&self, room: &str, ends: u64, number: &Number) -> Hmac<Sha256> {
        // The room's name comes last, after fields of fixed length, so that different inputs never have equal bytes.
        self.0.clone().chain_update(ENTRY).chain_update(ends.to_le_bytes()).chain_update(number).chain_update(room)
    }

    fn back(&self, room: &str, token: Option<&Number>, head: &[u8]) -> Hmac<Sha256> {
        let head = self.0.clone().chain_update(RETURN).chain_update(head).chain_update([u8::from(token.is_some())]);
        head.chain_update(token.copied().unwrap_or_default()).chain_update(room)
    }
}

fn put_hex(text: &mut String, bytes: &[u8]) {
    for byte in bytes {
        let _ = write!(text, "{byte:02x}");
    }
}

fn from_hex<const COUNT: usize>(text: &str) -> Option<[u8; COUNT]> {
    let digits = text.as_bytes();
    let digit = |index: usize| match digits[index] {
        digit @ b'0'..=b'9' => Some(digit - b'0'),
        digit @ b'a'..=b'f' => Some(digit - b'a' + 10),
        _ => None,
    };
    if digits.len() != 2 * COUNT {
        return None;
    }
    let mut bytes = [0; COUNT];
    for (index, byte) in bytes.iter_mut().enumerate() {
        *byte = digit(2 * index)? << 4 | digit(2 * index + 1)?;
    }
    Some(bytes)
}
