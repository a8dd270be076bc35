//! Frames of rooms as bytes, little-endian: a kind, the length of the body in 16 bits, and the body. The table in
//! docs/rooms.md has every field.

use bytes::{Buf, BufMut};

use super::pose::Pose;

/// Version of all frames.
pub const VERSION: u8 = 1;
/// Most bytes of a user's name.
pub const NAME: usize = 64;
/// Most bytes of what is said.
pub const SAY: usize = 1 << 12;
/// Most bytes of a signal.
pub const SIGNAL: usize = 1 << 14;
/// Bytes of a frame before its body.
pub const HEAD: usize = 3;

const HELLO: u8 = 1;
const POSE: u8 = 2;
const ACK: u8 = 3;
const SAID: u8 = 4;
const SIGNALLED: u8 = 5;
const BYE: u8 = 6;
/// Kinds of the server's frames have this bit.
const SERVER: u8 = 0x80;
const WELCOME: u8 = SERVER | 1;
const POSED: u8 = SERVER | POSE;
const SETTLED: u8 = SERVER | ACK;
const TOLD: u8 = SERVER | SAID;
const PASSED: u8 = SERVER | SIGNALLED;
const JOINED: u8 = SERVER | 6;
const LEFT: u8 = SERVER | 7;
const REFUSED: u8 = SERVER | 8;

/// Why bytes are no frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// They are none of this version; a sentence.
    Frame(&'static str),
    /// They are one of another version.
    Version(u8),
}

/// Whom a user says something to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum To {
    /// Others of its group.
    Group,
    /// Others of its room.
    Room,
}

/// A frame of a user.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "a kind tells of its fields")]
pub enum FromUser<'a> {
    /// The first one: which group the user joins, its name, and the ticket of its last time, or nothing.
    Hello { group: u16, name: &'a str, ticket: &'a [u8] },
    /// Where the user is.
    Pose(Pose),
    /// The user has another one's pose of this number, and needs none before.
    Ack { user: u16, sequence: u32 },
    /// To others, in order.
    Say { to: To, payload: &'a [u8] },
    /// To one user.
    Signal { user: u16, payload: &'a [u8] },
    /// The user leaves.
    Bye,
}

/// A frame of the server.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "a kind tells of its fields")]
pub enum FromServer<'a> {
    /// The user's number, how many others are there (`joined` of each follows), and a ticket for the next time.
    Welcome { user: u16, others: u16, ticket: &'a [u8] },
    /// A user is there.
    Joined { user: u16, group: u16, name: &'a str },
    /// A user is not there any more.
    Left { user: u16 },
    /// Where a user of the group is.
    Pose { user: u16, pose: Pose },
    /// A user says something.
    Say { user: u16, to: To, payload: &'a [u8] },
    /// A user's signal.
    Signal { user: u16, payload: &'a [u8] },
    /// All others of the group have acknowledged this pose of the user, or a later one.
    Settled { sequence: u32 },
    /// The connection ends; the reason's number, and a sentence.
    Refused { code: u8, sentence: &'a str },
}

const SHORT: Fault = Fault::Frame("a frame is too short");

impl<'a> FromUser<'a> {
    /// Read the first frame of some bytes; the rest of them.
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
                FromUser::Hello { group, name, ticket: counted(&mut body)? }
            }
            POSE => return Ok((FromUser::Pose(Pose::read(body).map_err(Fault::Frame)?), rest)),
            ACK => FromUser::Ack { user: number(&mut body)?, sequence: body.try_get_u32_le().map_err(|_| SHORT)? },
            SAID => FromUser::Say { to: to(&mut body)?, payload: payload(&mut body, SAY)? },
            SIGNALLED => FromUser::Signal { user: number(&mut body)?, payload: payload(&mut body, SIGNAL)? },
            BYE => FromUser::Bye,
            _ => return Err(Fault::Frame("a frame is of no kind that users send")),
        };
        if body.is_empty() { Ok((frame, rest)) } else { Err(Fault::Frame("a frame is too long")) }
    }

    /// Write it; names and payloads are no longer than they may be.
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
    /// Read the first frame of some bytes; the rest of them.
    pub fn read(bytes: &'a [u8]) -> Result<(Self, &'a [u8]), Fault> {
        let (kind, mut body, rest) = split(bytes)?;
        let frame = match kind {
            WELCOME => {
                let (user, others) = (number(&mut body)?, number(&mut body)?);
                FromServer::Welcome { user, others, ticket: counted(&mut body)? }
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
            _ => return Err(Fault::Frame("a frame is of no kind that the server sends")),
        };
        if body.is_empty() { Ok((frame, rest)) } else { Err(Fault::Frame("a frame is too long")) }
    }

    /// Bytes that it takes, with its head.
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

    /// Write it; names and payloads are no longer than they may be.
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

/// Kind and body of the first frame, and the bytes behind it.
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

/// All that is left of a body.
fn payload<'a>(body: &mut &'a [u8], most: usize) -> Result<&'a [u8], Fault> {
    let all = std::mem::take(body);
    if all.len() <= most { Ok(all) } else { Err(Fault::Frame("a payload is too long")) }
}

/// So many bytes as the first one tells.
fn counted<'a>(body: &mut &'a [u8]) -> Result<&'a [u8], Fault> {
    let length = body.try_get_u8().map_err(|_| SHORT)?;
    let (taken, rest) = body.split_at_checked(usize::from(length)).ok_or(SHORT)?;
    *body = rest;
    Ok(taken)
}

fn put_counted(out: &mut impl BufMut, bytes: &[u8]) {
    out.put_u8(bytes.len() as u8);
    out.put_slice(bytes);
}

fn name<'a>(body: &mut &'a [u8]) -> Result<&'a str, Fault> {
    let text = std::str::from_utf8(counted(body)?).map_err(|_| Fault::Frame("a name is no text"))?;
    if text.len() > NAME {
        return Err(Fault::Frame("a name is too long"));
    }
    if text.chars().any(char::is_control) {
        return Err(Fault::Frame("a name has control characters"));
    }
    Ok(text)
}
