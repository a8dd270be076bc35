//! Binary frames of rooms, little-endian: a kind, the body's length in 16 bits, and the body. docs/rooms.md specifies
//! every field.

use bytes::{Buf, BufMut};

use super::pose::Pose;

/// Version of the frame format.
pub const VERSION: u8 = 1;
/// Greatest size of a user's name, bytes.
pub const NAME: usize = 64;
/// Greatest payload of `say`, bytes.
pub const SAY: usize = 1 << 12;
/// Greatest payload of a signal, bytes.
pub const SIGNAL: usize = 1 << 14;
/// Size of a frame's header, bytes.
pub const HEAD: usize = 3;

const HELLO: u8 = 1;
const POSE: u8 = 2;
const ACK: u8 = 3;
const SAID: u8 = 4;
const SIGNALLED: u8 = 5;
const BYE: u8 = 6;
/// Bit that marks the server's frames.
const SERVER: u8 = 0x80;
const WELCOME: u8 = SERVER | 1;
const POSED: u8 = SERVER | POSE;
const SETTLED: u8 = SERVER | ACK;
const TOLD: u8 = SERVER | SAID;
const PASSED: u8 = SERVER | SIGNALLED;
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
#[expect(missing_docs, reason = "a kind tells of its fields")]
pub enum FromUser<'a> {
    /// First frame: the user's group, its name, and the ticket of its previous connection, or nothing.
    Hello { group: u16, name: &'a str, ticket: &'a [u8] },
    /// Pose of the user.
    Pose(Pose),
    /// Acknowledges another user's pose with this number and all earlier ones.
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
#[expect(missing_docs, reason = "a kind tells of its fields")]
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

const SHORT: Fault = Fault::Frame("a frame is too short");

impl<'a> FromUser<'a> {
    /// Reads the first frame; also returns the remaining bytes.
    pub fn read(bytes: &'a [u8]) -> Result<(Self, &'a [u8]), Fault> {
        let (kind, mut body, rest) = split(bytes)?;
        let frame = match kind {
            HELLO => {
                let version = body.try_get_u8().map_err(|_| SHORT)?;
                if version != VERSION {
                    return Err(Fault::Version(version));
                }
                let group = number(&mut body)?;
                let name = name(&mut body)?;
                FromUser::Hello { group, name, ticket: take_prefixed(&mut body)? }
            }
            POSE => return Ok((FromUser::Pose(Pose::read(body).map_err(Fault::Frame)?), rest)),
            ACK => FromUser::Ack { user: number(&mut body)?, sequence: body.try_get_u32_le().map_err(|_| SHORT)? },
            SAID => FromUser::Say { to: to(&mut body)?, payload: payload(&mut body, SAY)? },
            SIGNALLED => FromUser::Signal { user: number(&mut body)?, payload: payload(&mut body, SIGNAL)? },
            BYE => FromUser::Bye,
            _ => return Err(Fault::Frame("a frame has a kind that users do not send")),
        };
        if body.is_empty() { Ok((frame, rest)) } else { Err(Fault::Frame("a frame is too long")) }
    }

    /// Writes the frame; names and payloads must not exceed their limits.
    pub fn write(&self, out: &mut impl BufMut) {
        match *self {
            FromUser::Hello { group, name, ticket } => {
                head(out, HELLO, 1 + 2 + 1 + name.len() + 1 + ticket.len());
                out.put_u8(VERSION);
                out.put_u16_le(group);
                put_counted(out, name.as_bytes());
                put_counted(out, ticket);
            }
            FromUser::Pose(pose) => {
                head(out, POSE, pose.bytes());
                pose.write(out);
            }
            FromUser::Ack { user, sequence } => {
                head(out, ACK, 2 + 4);
                out.put_u16_le(user);
                out.put_u32_le(sequence);
            }
            FromUser::Say { to, payload } => {
                head(out, SAID, 1 + payload.len());
                out.put_u8(to as u8);
                out.put_slice(payload);
            }
            FromUser::Signal { user, payload } => {
                head(out, SIGNALLED, 2 + payload.len());
                out.put_u16_le(user);
                out.put_slice(payload);
            }
            FromUser::Bye => head(out, BYE, 0),
        }
    }
}

impl<'a> FromServer<'a> {
    /// Reads the first frame; also returns the remaining bytes.
    pub fn read(bytes: &'a [u8]) -> Result<(Self, &'a [u8]), Fault> {
        let (kind, mut body, rest) = split(bytes)?;
        let frame = match kind {
            WELCOME => {
                let (user, others) = (number(&mut body)?, number(&mut body)?);
                FromServer::Welcome { user, others, ticket: take_prefixed(&mut body)? }
            }
            JOINED => {
                let (user, group) = (number(&mut body)?, number(&mut body)?);
                FromServer::Joined { user, group, name: name(&mut body)? }
            }
            LEFT => FromServer::Left { user: number(&mut body)? },
            POSED => {
                let user = number(&mut body)?;
                return Ok((FromServer::Pose { user, pose: Pose::read(body).map_err(Fault::Frame)? }, rest));
            }
            TOLD => {
                let (user, to) = (number(&mut body)?, to(&mut body)?);
                FromServer::Say { user, to, payload: payload(&mut body, SAY)? }
            }
            PASSED => FromServer::Signal { user: number(&mut body)?, payload: payload(&mut body, SIGNAL)? },
            SETTLED => FromServer::Settled { sequence: body.try_get_u32_le().map_err(|_| SHORT)? },
            REFUSED => {
                let code = body.try_get_u8().map_err(|_| SHORT)?;
                let sentence = std::str::from_utf8(payload(&mut body, SAY)?);
                FromServer::Refused { code, sentence: sentence.map_err(|_| Fault::Frame("a sentence is no text"))? }
            }
            _ => return Err(Fault::Frame("a frame has a kind that the server does not send")),
        };
        if body.is_empty() { Ok((frame, rest)) } else { Err(Fault::Frame("a frame is too long")) }
    }

    /// Size of the frame with its header, bytes.
    pub fn bytes(&self) -> usize {
        HEAD + match self {
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
        let start = |out: &mut _, kind| head(out, kind, self.bytes() - HEAD);
        match *self {
            FromServer::Welcome { user, others, ticket } => {
                start(out, WELCOME);
                out.put_u16_le(user);
                out.put_u16_le(others);
                put_counted(out, ticket);
            }
            FromServer::Joined { user, group, name } => {
                start(out, JOINED);
                out.put_u16_le(user);
                out.put_u16_le(group);
                put_counted(out, name.as_bytes());
            }
            FromServer::Left { user } => {
                start(out, LEFT);
                out.put_u16_le(user);
            }
            FromServer::Pose { user, pose } => {
                start(out, POSED);
                out.put_u16_le(user);
                pose.write(out);
            }
            FromServer::Say { user, to, payload } => {
                start(out, TOLD);
                out.put_u16_le(user);
                out.put_u8(to as u8);
                out.put_slice(payload);
            }
            FromServer::Signal { user, payload } => {
                start(out, PASSED);
                out.put_u16_le(user);
                out.put_slice(payload);
            }
            FromServer::Settled { sequence } => {
                start(out, SETTLED);
                out.put_u32_le(sequence);
            }
            FromServer::Refused { code, sentence } => {
                start(out, REFUSED);
                out.put_u8(code);
                out.put_slice(sentence.as_bytes());
            }
        }
    }
}

/// Splits off the kind and body of the first frame; also returns the remaining bytes.
fn split(mut bytes: &[u8]) -> Result<(u8, &[u8], &[u8]), Fault> {
    let kind = bytes.try_get_u8().map_err(|_| SHORT)?;
    let length = usize::from(number(&mut bytes)?);
    let (body, rest) = bytes.split_at_checked(length).ok_or(SHORT)?;
    Ok((kind, body, rest))
}

fn head(out: &mut impl BufMut, kind: u8, length: usize) {
    out.put_u8(kind);
    out.put_u16_le(length as u16);
}

fn number(body: &mut &[u8]) -> Result<u16, Fault> {
    body.try_get_u16_le().map_err(|_| SHORT)
}

fn to(body: &mut &[u8]) -> Result<To, Fault> {
    match body.try_get_u8().map_err(|_| SHORT)? {
        0 => Ok(To::Group),
        1 => Ok(To::Room),
        _ => Err(Fault::Frame("expected the group or the room")),
    }
}

/// Takes the rest of a body, of at most `most` bytes.
fn payload<'a>(body: &mut &'a [u8], most: usize) -> Result<&'a [u8], Fault> {
    let all = std::mem::take(body);
    if all.len() <= most { Ok(all) } else { Err(Fault::Frame("a payload is too long")) }
}

/// Takes a byte string with a one-byte length prefix.
fn take_prefixed<'a>(body: &mut &'a [u8]) -> Result<&'a [u8], Fault> {
    let length = body.try_get_u8().map_err(|_| SHORT)?;
    let (taken, rest) = body.split_at_checked(usize::from(length)).ok_or(SHORT)?;
    *body = rest;
    Ok(taken)
}

fn put_counted(out: &mut impl BufMut, bytes: &[u8]) {
    out.put_u8(bytes.len() as u8);
    out.put_slice(bytes);
}

/// Whether a character is a Unicode format character (Cf): invisible, or changing the direction of text.
fn is_format(each: char) -> bool {
    matches!(each,
        '\u{ad}' | '\u{600}'..='\u{605}' | '\u{61c}' | '\u{6dd}' | '\u{70f}' | '\u{890}'..='\u{891}' | '\u{8e2}'
        | '\u{180e}' | '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}'..='\u{2064}'
        | '\u{2066}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{110bd}' | '\u{110cd}'
        | '\u{13430}'..='\u{1343f}' | '\u{1bca0}'..='\u{1bca3}' | '\u{1d173}'..='\u{1d17a}' | '\u{e0001}'
        | '\u{e0020}'..='\u{e007f}')
}

fn name<'a>(body: &mut &'a [u8]) -> Result<&'a str, Fault> {
    let text = std::str::from_utf8(take_prefixed(body)?).map_err(|_| Fault::Frame("a name is no text"))?;
    if text.len() > NAME {
        return Err(Fault::Frame("a name is too long"));
    }
    if text.chars().any(|each| each.is_control() || is_format(each)) {
        return Err(Fault::Frame("a name has characters that control or format text"));
    }
    Ok(text)
}
