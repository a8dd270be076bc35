//! Binary format of a pose: a user's head, hands and pointer.

use bytes::{Buf, BufMut, TryGetError};

/// Maximum size of a pose, bytes.
pub const MAX_BYTES: usize = MIN_BYTES + 2 * PLACEMENT_BYTES + 4;
/// Size of a pose without hands and pointer, bytes.
const MIN_BYTES: usize = 4 + 8 + 1 + PLACEMENT_BYTES;
/// Size of a position and a rotation, bytes.
const PLACEMENT_BYTES: usize = 3 * 4 + 4 * 2;
/// Maximum coordinate, and maximum length of a pointer, metres.
const MAX_METRES: f32 = 1e6;
/// Range of a rotation's squared length; rounding to 16 bits changes the length by at most 1e-4.
const SQUARED_LENGTHS: std::ops::RangeInclusive<f32> = 0.81..=1.21;
/// Integer that represents 1 in a rotation.
const ONE: f32 = 32767.0;

/// Flag: users of the group acknowledge this pose.
const ACKNOWLEDGED: u8 = 1;
/// Flag: no pose follows until the user moves again.
const STOPS: u8 = 1 << 1;
/// Flags of the hands.
const HANDS: [u8; 2] = [1 << 2, 1 << 3];
/// Bit position of the pointer's two flags.
const POINTER: u8 = 4;
/// Mask of all defined flags.
const KNOWN_FLAGS: u8 = 0b11_1111;

/// Position and rotation of a head or a hand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Position in metres from the scene's origin.
    pub position: [f32; 3],
    /// Unit quaternion (x, y, z, w), in units of 1/32767.
    pub rotation: [i16; 4],
}

/// Part of the body from which a pointer's ray starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointerOrigin {
    /// The head.
    Head,
    /// The left hand.
    Left,
    /// The right hand.
    Right,
}

/// Pose of a user.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Sequence number, greater than all earlier ones.
    pub sequence: u32,
    /// The user's clock, in microseconds from an arbitrary start.
    pub clock: u64,
    /// Whether users of the group acknowledge it.
    pub is_acknowledged: bool,
    /// Whether no pose follows until the user moves again, so that extrapolation stops here.
    pub stops: bool,
    /// The head.
    pub head: Placement,
    /// Left and right hand.
    pub hands: [Option<Placement>; 2],
    /// Origin of the pointer's ray, which points along its −z, and its length in metres.
    pub pointer: Option<(PointerOrigin, f32)>,
}

impl Pose {
    /// Encoded size, bytes.
    pub fn bytes(&self) -> usize {
        let hands = self.hands.iter().flatten().count();
        MIN_BYTES + hands * PLACEMENT_BYTES + self.pointer.map_or(0, |_| 4)
    }

    /// Decodes a pose that fills all bytes; an error describes the fault.
    pub fn read(mut body: &[u8]) -> Result<Self, &'static str> {
        let (sequence, clock) = (body.try_get_u32_le().map_err(too_short)?, body.try_get_u64_le().map_err(too_short)?);
        let flags = body.try_get_u8().map_err(too_short)?;
        if flags & !KNOWN_FLAGS != 0 {
            return Err("a pose has unknown flags");
        }
        let head = read_placement(&mut body)?;
        let mut hands = [None; 2];
        for (hand, flag) in hands.iter_mut().zip(HANDS) {
            if flags & flag != 0 {
                *hand = Some(read_placement(&mut body)?);
            }
        }
        let origin = match flags >> POINTER {
            0 => None,
            1 => Some(PointerOrigin::Head),
            2 if hands[0].is_some() => Some(PointerOrigin::Left),
            3 if hands[1].is_some() => Some(PointerOrigin::Right),
            _ => return Err("a pointer begins at a missing hand"),
        };
        let pointer = match origin {
            Some(origin) => Some((origin, body.try_get_f32_le().map_err(too_short)?)),
            None => None,
        };
        if pointer.is_some_and(|(_, length)| !(0.0..=MAX_METRES).contains(&length)) {
            return Err("a pointer's length is not valid");
        }
        if !body.is_empty() {
            return Err("a pose is too long");
        }
        let (is_acknowledged, stops) = (flags & ACKNOWLEDGED != 0, flags & STOPS != 0);
        Ok(Pose { sequence, clock, is_acknowledged, stops, head, hands, pointer })
    }

    /// Encodes the pose.
    pub fn write(&self, out: &mut impl BufMut) {
        let [left, right] = self.hands.map(|hand| hand.is_some());
        let flags = [(self.is_acknowledged, ACKNOWLEDGED), (self.stops, STOPS), (left, HANDS[0]), (right, HANDS[1])];
        let pointer = self.pointer.map_or(0, |(origin, _)| 1 + origin as u8) << POINTER;
        let flags = flags.iter().filter(|(is_set, _)| *is_set).fold(pointer, |flags, (_, flag)| flags | flag);
        out.put_u32_le(self.sequence);
        out.put_u64_le(self.clock);
        out.put_u8(flags);
        for placement in [Some(self.head), self.hands[0], self.hands[1]].into_iter().flatten() {
            placement.position.iter().for_each(|value| out.put_f32_le(*value));
            placement.rotation.iter().for_each(|value| out.put_i16_le(*value));
        }
        if let Some((_, length)) = self.pointer {
            out.put_f32_le(length);
        }
    }
}

fn too_short(_: TryGetError) -> &'static str {
    "a pose is too short"
}

fn read_placement(body: &mut &[u8]) -> Result<Placement, &'static str> {
    let (mut position, mut rotation) = ([0.0; 3], [0; 4]);
    for value in &mut position {
        *value = body.try_get_f32_le().map_err(too_short)?;
    }
    for value in &mut rotation {
        *value = body.try_get_i16_le().map_err(too_short)?;
    }
    // NaN is in no range.
    if !position.iter().all(|value| (-MAX_METRES..=MAX_METRES).contains(value)) {
        return Err("a position is out of range");
    }
    let squared_length: f32 = rotation.iter().map(|value| (f32::from(*value) / ONE).powi(2)).sum();
    if !SQUARED_LENGTHS.contains(&squared_length) {
        return Err("a rotation is not a unit quaternion");
    }
    Ok(Placement { position, rotation })
}
