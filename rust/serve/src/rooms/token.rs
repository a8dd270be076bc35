//! Tokens, which admit a user to a room, and tickets, which restore a user's number.

use data_encoding::HEXLOWER;
use hmac::{Hmac, KeyInit, Mac};
use sha2::Sha256;

/// Least size of a key, bytes.
const MIN_KEY_BYTES: usize = 16;
/// Size of a ticket's truncated signature, bytes.
const TICKET_SIGNATURE_BYTES: usize = 16;
/// Size of a ticket, bytes.
pub const TICKET_BYTES: usize = 2 + 8 + TICKET_SIGNATURE_BYTES;
/// Prefixes of signed bytes (domain separation), so that a ticket is not a valid token.
const TOKEN_PREFIX: &[u8] = b"nearfar room token 1\0";
const TICKET_PREFIX: &[u8] = b"nearfar return ticket 2\0";

/// Unique number of a token; only one connection can use it at a time.
pub type TokenNumber = [u8; 16];

/// Key that signs tokens and tickets (HMAC-SHA-256).
#[derive(Clone)]
pub struct Key(Hmac<Sha256>);

impl Key {
    /// Creates a key from secret bytes.
    pub fn new(secret: &[u8]) -> Result<Self, String> {
        if secret.len() < MIN_KEY_BYTES {
            return Err(format!("expected a key of {MIN_KEY_BYTES} bytes or more, got {}", secret.len()));
        }
        Hmac::new_from_slice(secret).map(Key).map_err(|error| error.to_string())
    }

    /// Creates a token for a room that expires at `ends`, in seconds since 1970. Numbers must be unique and
    /// unpredictable.
    pub fn token(&self, room: &str, ends: u64, number: TokenNumber) -> String {
        let signature = self.sign_token(room, ends, &number).finalize().into_bytes();
        format!("{ends}.{}.{}", HEXLOWER.encode(&number), HEXLOWER.encode(&signature))
    }

    /// Checks a token for a room at a time in seconds since 1970; returns its number, or the reason for refusal.
    pub fn check(&self, room: &str, now: u64, token: &str) -> Result<TokenNumber, &'static str> {
        const WRONG: &str = "expected a token that was made for this room";
        let parts: Vec<&str> = token.split('.').collect();
        let [ends, number, signature] = parts[..] else { return Err(WRONG) };
        let is_number = ends.bytes().all(|byte| byte.is_ascii_digit());
        let ends: u64 = ends.parse().ok().filter(|_| is_number).ok_or(WRONG)?;
        let [number, signature] =
            [number, signature].map(|digits| HEXLOWER.decode(digits.as_bytes()).unwrap_or_default());
        let number: TokenNumber = number.try_into().map_err(|_| WRONG)?;
        // Constant-time comparison.
        self.sign_token(room, ends, &number).verify_slice(&signature).map_err(|_| WRONG)?;
        if now < ends { Ok(number) } else { Err("expected a token that has not expired") }
    }

    /// Creates a ticket for a user's number and identity in a room; it is valid only with the user's token.
    pub fn ticket(&self, room: &str, token: Option<&TokenNumber>, user: u16, identity: u64) -> [u8; TICKET_BYTES] {
        let mut ticket = [0; TICKET_BYTES];
        ticket[..2].copy_from_slice(&user.to_le_bytes());
        ticket[2..10].copy_from_slice(&identity.to_le_bytes());
        let signature = self.sign_ticket(room, token, &ticket[..10]).finalize().into_bytes();
        ticket[10..].copy_from_slice(&signature[..TICKET_SIGNATURE_BYTES]);
        ticket
    }

    /// User number and identity of a ticket, if it is valid for this room and token.
    pub fn check_ticket(&self, room: &str, token: Option<&TokenNumber>, ticket: &[u8]) -> Option<(u16, u64)> {
        let ticket: &[u8; TICKET_BYTES] = ticket.try_into().ok()?;
        self.sign_ticket(room, token, &ticket[..10]).verify_truncated_left(&ticket[10..]).ok()?;
        let user = u16::from_le_bytes(ticket[..2].try_into().ok()?);
        Some((user, u64::from_le_bytes(ticket[2..10].try_into().ok()?)))
    }

    fn sign_token(&self, room: &str, ends: u64, number: &TokenNumber) -> Hmac<Sha256> {
        // The room's name comes last, after fields of fixed length, so that different inputs never have equal bytes.
        self.0
            .clone()
            .chain_update(TOKEN_PREFIX)
            .chain_update(ends.to_le_bytes())
            .chain_update(number)
            .chain_update(room)
    }

    fn sign_ticket(&self, room: &str, token: Option<&TokenNumber>, head: &[u8]) -> Hmac<Sha256> {
        let head =
            self.0.clone().chain_update(TICKET_PREFIX).chain_update(head).chain_update([u8::from(token.is_some())]);
        head.chain_update(token.copied().unwrap_or_default()).chain_update(room)
    }
}
