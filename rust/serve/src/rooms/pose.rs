//! Where a user's head, hands and pointer are, as bytes.

use bytes::{Buf, BufMut};

/// Most bytes of a pose.
pub const MOST: usize = LEAST + 2 * PLACED + 4;
/// Bytes of a pose without hands and pointer.
const LEAST: usize = 4 + 8 + 1 + PLACED;
/// Bytes of a position and a rotation.
const PLACED: usize = 3 * 4 + 4 * 2;
/// Greatest coordinate, and greatest length of a pointer, metres.
const FARTHEST: f32 = 1e6;
/// Squares of the least and the greatest length of a rotation; rounding to 16 bits changes it by 1e-4 at most.
const UNIT: std::ops::RangeInclusive<f32> = 0.81..=1.21;
/// The number that 1 is in a rotation.
const ONE: f32 = 32767.0;

/// A sentence on bytes that end too early.
const SHORT: &str = "a pose is too short";

/// Flag: the group's users are to acknowledge this pose.
const ACKNOWLEDGED: u8 = 1;
/// Flag: no pose follows until the user moves again.
const STOPS: u8 = 1 << 1;
/// Flags of the hands.
const HANDS: [u8; 2] = [1 << 2, 1 << 3];
/// Place of the pointer's two flags.
const POINTER: u8 = 4;
/// Flags that have a meaning.
const KNOWN: u8 = 0b11_1111;

/// A position and a rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    /// Metres from the scene's origin.
    pub position: [f32; 3],
    /// Unit quaternion (x, y, z, w), in units of 1/32767.
    pub rotation: [i16; 4],
}

/// What a pointer's ray begins at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Begin {
    /// The head.
    Head,
    /// The left hand.
    Left,
    /// The right hand.
    Right,
}

/// A user's pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Its number; each is greater than those before.
    pub sequence: u32,
    /// The user's clock, in microseconds from any begin.
    pub clock: u64,
    /// The group's users are to acknowledge it.
    pub is_acknowledged: bool,
    /// No pose follows until the user moves again: who extrapolates stays at this one.
    pub stops: bool,
    /// The head.
    pub head: Placed,
    /// The left and the right hand.
    pub hands: [Option<Placed>; 2],
    /// The pointer's ray, along −z of its begin, and its length in metres.
    pub pointer: Option<(Begin, f32)>,
}

impl Pose {
    /// Bytes that it takes.
    pub fn bytes(&self) -> usize {
        let hands = self.hands.iter().flatten().count();
        LEAST + hands * PLACED + self.pointer.map_or(0, |_| 4)
    }

    /// Read a pose that takes all of these bytes; a sentence if they are none.
    pub fn read(mut body: &[u8]) -> Result<Self, &'static str> {
        let short = |_| SHORT;
        let sequence = body.try_get_u32_le().map_err(short)?;
        let clock = body.try_get_u64_le().map_err(short)?;
        let flags = body.try_get_u8().map_err(short)?;
        if flags & !KNOWN != 0 {
            return Err("a pose has flags without a meaning");
        }
        let head = placed(&mut body)?;
        let mut hands = [None; 2];
        for (hand, flag) in hands.iter_mut().zip(HANDS) {
            if flags & flag != 0 {
                *hand = Some(placed(&mut body)?);
            }
        }
        let begin = match flags >> POINTER {
            0 => None,
            1 => Some(Begin::Head),
            2 => Some(Begin::Left),
            _ => Some(Begin::Right),
        };
        let pointer = match begin {
            None => None,
            Some(Begin::Left) if hands[0].is_none() => return Err("a pointer begins at no hand"),
            Some(Begin::Right) if hands[1].is_none() => return Err("a pointer begins at no hand"),
            Some(begin) => {
                let length = body.try_get_f32_le().map_err(short)?;
                if !(0.0..=FARTHEST).contains(&length) {
                    return Err("a pointer's length is none");
                }
                Some((begin, length))
            }
        };
        if !body.is_empty() {
            return Err("a pose is too long");
        }
        let (is_acknowledged, stops) = (flags & ACKNOWLEDGED != 0, flags & STOPS != 0);
        Ok(Pose { sequence, clock, is_acknowledged, stops, head, hands, pointer })
    }

    /// Write it.
    pub fn write(&self, out: &mut impl BufMut) {
        let [left, right] = self.hands.map(|hand| hand.is_some());
        let set = [(self.is_acknowledged, ACKNOWLEDGED), (self.stops, STOPS), (left, HANDS[0]), (right, HANDS[1])];
        let pointer = self.pointer.map_or(0, |(begin, _)| 1 + begin as u8) << POINTER;
        let flags = set.iter().filter(|(is_set, _)| *is_set).fold(pointer, |flags, (_, flag)| flags | flag);
        out.put_u32_le(self.sequence);
        out.put_u64_le(self.clock);
        out.put_u8(flags);
        for placed in [Some(self.head), self.hands[0], self.hands[1]].into_iter().flatten() {
            placed.position.iter().for_each(|value| out.put_f32_le(*value));
            placed.rotation.iter().for_each(|value| out.put_i16_le(*value));
        }
        if let Some((_, length)) = self.pointer {
            out.put_f32_le(length);
        }
    }
}

fn placed(body: &mut &[u8]) -> Result<Placed, &'static str> {
    let short = |_| SHORT;
    let (mut position, mut rotation) = ([0.0; 3], [0; 4]);
    for value in &mut position {
        *value = body.try_get_f32_le().map_err(short)?;
    }
    for value in &mut rotation {
        *value = body.try_get_i16_le().map_err(short)?;
    }
    // Not-a-number is in no range.
    if !position.iter().all(|value| (-FARTHEST..=FARTHEST).contains(value)) {
        return Err("a position is none");
    }
    let length: f32 = rotation.iter().map(|value| (f32::from(*value) / ONE).powi(2)).sum();
    if !UNIT.contains(&length) {
        return Err("a rotation is no unit quaternion");
    }
    Ok(Placed { position, rotation })
}
