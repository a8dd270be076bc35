//! Binary frames of rooms, little-endian: a kind, the body's length in 16 bits, and the body. docs/rooms.md specifies
//! every field.

use bytes::{Buf, BufMut, TryGetError};

use super::pose::Pose;

/// Version of the frame format.
pub const VERSION: u8 = 1;
/// Maximum size of a user's name, bytes.
pub const MAX_NAME_BYTES: usize = 64;
/// Maximum payload of `say`, bytes.
pub const MAX_SAY_BYTES: usize = 1 << 12;
/// Maximum payload of a signal, bytes.
pub const MAX_SIGNAL_BYTES: usize = 1 << 14;
/// Size of a frame's header, bytes.
pub const HEADER_BYTES: usize = 3;

const HELLO: u8 = 1;
const POSE: u8 = 2;
const ACK: u8 = 3;
const SAY: u8 = 4;
const SIGNAL: u8 = 5;
const BYE: u8 = 6;
/// Bit that marks the server's frames.
const SERVER: u8 = 0x80;
const WELCOME: u8 = SERVER | 1;
const USER_POSE: u8 = SERVER | POSE;
const SETTLED: u8 = SERVER | ACK;
const USER_SAY: u8 = SERVER | SAY;
const USER_SIGNAL: u8 = SERVER | SIGNAL;
const JOINED: u8 = SERVER | 6;
const LEFT: u8 = SERVER | 7;
const REFUSED: u8 = SERVER | 8;

/// Reason why bytes are not a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// Malformed; with a description.
    Frame(&'static str),
    /// A frame of another version.
    Version(u8),
}

/// Recipients of a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum To {
    /// Other users of the sender's group.
    Group,
    /// Other users of the room.
    Room,
}

/// A frame of a user.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the comments of the variants describe their fields")]
pub enum FromUser<'a> {
    /// First frame: the user's group, its name, and the ticket of its previous connection, or nothing.
    Hello { group: u16, name: &'a str, ticket: &'a [u8] },
    /// Pose of the user.
    Pose(Pose),
    /// Acknowledgement of another user's pose, and of all its earlier ones.
    Ack { user: u16, sequence: u32 },
    /// Message to others, delivered in order.
    Say { to: To, payload: &'a [u8] },
    /// Message to one user.
    Signal { user: u16, payload: &'a [u8] },
    /// Departure of the user.
    Bye,
}

/// A frame of the server.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the comments of the variants describe their fields")]
pub enum FromServer<'a> {
    /// The user's number, the number of other users (a `joined` frame for each follows), and a ticket for reconnection.
    Welcome { user: u16, others: u16, ticket: &'a [u8] },
    /// A user is in the room.
    Joined { user: u16, group: u16, name: &'a str },
    /// A user has left the room.
    Left { user: u16 },
    /// Pose of a user of the group.
    Pose { user: u16, pose: Pose },
    /// Message of a user.
    Say { user: u16, to: To, payload: &'a [u8] },
    /// Signal of a user.
    Signal { user: u16, payload: &'a [u8] },
    /// All other users of the group have acknowledged this pose of the user, or a later one.
    Settled { sequence: u32 },
    /// End of the connection, with the reason's code and a description.
    Refused { code: u8, sentence: &'a str },
}

const TOO_SHORT: Fault = Fault::Frame("a frame is too short");

impl From<TryGetError> for Fault {
    fn from(_: TryGetError) -> Self {
        TOO_SHORT
    }
}

impl<'a> FromUser<'a> {
    /// Reads the first frame; also returns the remaining bytes.
    pub fn read(bytes: &'a [u8]) -> Result<(Self, &'a [u8]), Fault> {
        let (kind, mut body, rest) = split(bytes)?;
        let frame = match kind {
            HELLO => {
                let version = body.try_get_u8()?;
                if version != VERSION {
                    return Err(Fault::Version(version));
                }
                let (group, name) = (body.try_get_u16_le()?, read_name(&mut body)?);
                FromUser::Hello { group, name, ticket: read_string(&mut body)? }
            }
            POSE => return Ok((FromUser::Pose(Pose::read(body).map_err(Fault::Frame)?), rest)),
            ACK => FromUser::Ack { user: body.try_get_u16_le()?, sequence: body.try_get_u32_le()? },
            SAY => FromUser::Say { to: read_recipients(&mut body)?, payload: read_payload(&mut body, MAX_SAY_BYTES)? },
            SIGNAL => {
                FromUser::Signal { user: body.try_get_u16_le()?, payload: read_payload(&mut body, MAX_SIGNAL_BYTES)? }
            }
            BYE => FromUser::Bye,
            _ => return Err(Fault::Frame("a frame has a kind that users do not send")),
        };
        if body.is_empty() { Ok((frame, rest)) } else { Err(Fault::Frame("a frame is too long")) }
    }

    /// Writes the frame; names and payloads must not exceed their limits.
    pub fn write(&self, out: &mut impl BufMut) {
        match *self {
            FromUser::Hello { group, name, ticket } => {
                let (group, name) = (group.to_le_bytes(), name.as_bytes());
                write_frame(
                    out,
                    HELLO,
                    &[&[VERSION], &group, &[name.len() as u8], name, &[ticket.len() as u8], ticket],
                );
            }
            FromUser::Pose(pose) => {
                write_header(out, POSE, pose.bytes());
                pose.write(out);
            }
            FromUser::Ack { user, sequence } => write_frame(out, ACK, &[&user.to_le_bytes(), &sequence.to_le_bytes()]),
            FromUser::Say { to, payload } => write_frame(out, SAY, &[&[to as u8], payload]),
            FromUser::Signal { user, payload } => write_frame(out, SIGNAL, &[&user.to_le_bytes(), payload]),
            FromUser::Bye => write_frame(out, BYE, &[]),
        }
    }
}

impl<'a> FromServer<'a> {
    /// Reads the first frame; also returns the remaining bytes.
    pub fn read(bytes: &'a [u8]) -> Result<(Self, &'a [u8]), Fault> {
        let (kind, mut body, rest) = split(bytes)?;
        let frame = match kind {
            WELCOME => {
                let (user, others) = (body.try_get_u16_le()?, body.try_get_u16_le()?);
                FromServer::Welcome { user, others, ticket: read_string(&mut body)? }
            }
            JOINED => {
                let (user, group) = (body.try_get_u16_le()?, body.try_get_u16_le()?);
                FromServer::Joined { user, group, name: read_name(&mut body)? }
            }
            LEFT => FromServer::Left { user: body.try_get_u16_le()? },
            USER_POSE => {
                let user = body.try_get_u16_le()?;
                return Ok((FromServer::Pose { user, pose: Pose::read(body).map_err(Fault::Frame)? }, rest));
            }
            USER_SAY => {
                let (user, to) = (body.try_get_u16_le()?, read_recipients(&mut body)?);
                FromServer::Say { user, to, payload: read_payload(&mut body, MAX_SAY_BYTES)? }
            }
            USER_SIGNAL => {
                FromServer::Signal { user: body.try_get_u16_le()?, payload: read_payload(&mut body, MAX_SIGNAL_BYTES)? }
            }
            SETTLED => FromServer::Settled { sequence: body.try_get_u32_le()? },
            REFUSED => {
                let code = body.try_get_u8()?;
                let sentence = std::str::from_utf8(read_payload(&mut body, MAX_SAY_BYTES)?);
                FromServer::Refused { code, sentence: sentence.map_err(|_| Fault::Frame("a sentence is not UTF-8"))? }
            }
            _ => return Err(Fault::Frame("a frame has a kind that the server does not send")),
        };
        if body.is_empty() { Ok((frame, rest)) } else { Err(Fault::Frame("a frame is too long")) }
    }

    /// Size of the frame with its header, bytes.
    pub fn bytes(&self) -> usize {
        HEADER_BYTES
            + match self {
                FromServer::Welcome { ticket, .. } => 2 + 2 + 1 + ticket.len(),
                FromServer::Joined { name, .. } => 2 + 2 + 1 + name.len(),
                FromServer::Left { .. } => 2,
                FromServer::Pose { pose, .. } => 2 + pose.bytes(),
                FromServer::Say { payload, .. } => 2 + 1 + payload.len(),
                FromServer::Signal { payload, .. } => 2 + payload.len(),
                FromServer::Settled { .. } => 4,
                FromServer::Refused { sentence, .. } => 1 + sentence.len(),
            }
    }

    /// Writes the frame; names and payloads must not exceed their limits.
    pub fn write(&self, out: &mut impl BufMut) {
        match *self {
            FromServer::Welcome { user, others, ticket } => {
                let numbers = [user.to_le_bytes(), others.to_le_bytes()];
                write_frame(out, WELCOME, &[numbers.as_flattened(), &[ticket.len() as u8], ticket]);
            }
            FromServer::Joined { user, group, name } => {
                let numbers = [user.to_le_bytes(), group.to_le_bytes()];
                write_frame(out, JOINED, &[numbers.as_flattened(), &[name.len() as u8], name.as_bytes()]);
            }
            FromServer::Left { user } => write_frame(out, LEFT, &[&user.to_le_bytes()]),
            FromServer::Pose { user, pose } => {
                write_header(out, USER_POSE, 2 + pose.bytes());
                out.put_u16_le(user);
                pose.write(out);
            }
            FromServer::Say { user, to, payload } => {
                write_frame(out, USER_SAY, &[&user.to_le_bytes(), &[to as u8], payload])
            }
            FromServer::Signal { user, payload } => write_frame(out, USER_SIGNAL, &[&user.to_le_bytes(), payload]),
            FromServer::Settled { sequence } => write_frame(out, SETTLED, &[&sequence.to_le_bytes()]),
            FromServer::Refused { code, sentence } => write_frame(out, REFUSED, &[&[code], sentence.as_bytes()]),
        }
    }
}

/// Splits off the kind and body of the first frame; also returns the remaining bytes.
fn split(mut bytes: &[u8]) -> Result<(u8, &[u8], &[u8]), Fault> {
    let kind = bytes.try_get_u8()?;
    let length = usize::from(bytes.try_get_u16_le()?);
    let (body, rest) = bytes.split_at_checked(length).ok_or(TOO_SHORT)?;
    Ok((kind, body, rest))
}

/// Writes a frame whose body consists of these fields.
fn write_frame(out: &mut impl BufMut, kind: u8, fields: &[&[u8]]) {
    write_header(out, kind, fields.iter().map(|field| field.len()).sum());
    fields.iter().for_each(|field| out.put_slice(field));
}

fn write_header(out: &mut impl BufMut, kind: u8, length: usize) {
    out.put_u8(kind);
    out.put_u16_le(length as u16);
}

fn read_recipients(body: &mut &[u8]) -> Result<To, Fault> {
    match body.try_get_u8()? {
        0 => Ok(To::Group),
        1 => Ok(To::Room),
        _ => Err(Fault::Frame("expected the group or the room")),
    }
}

/// Reads the rest of a body, of at most `max_bytes`.
fn read_payload<'a>(body: &mut &'a [u8], max_bytes: usize) -> Result<&'a [u8], Fault> {
    let payload = std::mem::take(body);
    if payload.len() <= max_bytes { Ok(payload) } else { Err(Fault::Frame("a payload is too long")) }
}

/// Reads a byte string with a one-byte length prefix.
fn read_string<'a>(body: &mut &'a [u8]) -> Result<&'a [u8], Fault> {
    let length = body.try_get_u8()?;
    body.split_off(..usize::from(length)).ok_or(TOO_SHORT)
}

/// Whether a character is a Unicode format character (Cf): invisible, or changing the direction of text.
fn is_format(character: char) -> bool {
    matches!(character,
        '\u{ad}' | '\u{600}'..='\u{605}' | '\u{61c}' | '\u{6dd}' | '\u{70f}' | '\u{890}'..='\u{891}' | '\u{8e2}'
        | '\u{180e}' | '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}'..='\u{2064}'
        | '\u{2066}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{110bd}' | '\u{110cd}'
        | '\u{13430}'..='\u{1343f}' | '\u{1bca0}'..='\u{1bca3}' | '\u{1d173}'..='\u{1d17a}' | '\u{e0001}'
        | '\u{e0020}'..='\u{e007f}')
}

fn read_name<'a>(body: &mut &'a [u8]) -> Result<&'a str, Fault> {
    let text = std::str::from_utf8(read_string(body)?).map_err(|_| Fault::Frame("a name is not UTF-8"))?;
    if text.len() > MAX_NAME_BYTES {
        return Err(Fault::Frame("a name is too long"));
    }
    if text.chars().any(|character| character.is_control() || is_format(character)) {
        return Err(Fault::Frame("a name has characters that control or format text"));
    }
    Ok(text)
}
