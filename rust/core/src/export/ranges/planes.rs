//! Byte planes of prediction residuals: frequent small numbers in few bits, and rare large ones in planes of their own.
//!
//! There are nine planes: flags of changed texels, flags of texels without a surface, and seven planes of residuals. A
//! residual is a sum of up to four digits: a bit, a pair of bits, a byte and a 16-bit word. A digit that has its
//! maximum is followed by the next one. The trust in the prediction decides the first digit: a bit with `High` trust, a
//! pair with `Some` and `Calm`, a byte with `Low`. Bits and pairs fill a byte from its highest bit. The plane of words
//! has all high bytes, then all low bytes.

use crate::base::{Error, Result};

/// Number of planes.
pub(super) const PLANES: usize = 9;
/// Plane of bits, after the two planes of flags.
const BITS: usize = 2;
/// Planes of pairs for `High`, `Some` and `Calm` trust.
const PAIRS: [usize; 3] = [3, 4, 5];
/// Planes of bytes that follow a pair, and for `Low` trust.
const BYTES: [usize; 2] = [6, 7];
const WORDS: usize = 8;

/// Trust in a prediction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Trust {
    High,
    Some,
    /// No run predicts the texel, but its left and upper neighbour are similar.
    Calm,
    Low,
}

impl Trust {
    /// Returns the planes of bits, pairs and bytes for residuals of this trust.
    fn planes(self) -> (Option<usize>, Option<usize>, usize) {
        match self {
            Self::High => (Some(BITS), Some(PAIRS[0]), BYTES[0]),
            Self::Some => (None, Some(PAIRS[1]), BYTES[0]),
            Self::Calm => (None, Some(PAIRS[2]), BYTES[0]),
            Self::Low => (None, None, BYTES[1]),
        }
    }
}

/// Flag of a texel; its value is the number of its plane.
#[derive(Clone, Copy, Debug)]
pub(super) enum Flag {
    /// The texel changes.
    Changed,
    /// The texel has no surface.
    Nothing,
}

/// Writer or reader of planes, so that both share the walk over the texels. A writer stores and returns `value`; a
/// reader ignores it and returns the stored value.
pub(super) trait Link {
    /// Writes or reads a flag.
    fn flag(&mut self, flag: Flag, predicted: bool, value: bool) -> Result<bool>;
    /// Writes or reads the difference between a code and its prediction, with 0, −1, 1, −2, … as 0, 1, 2, 3, ….
    fn residual(&mut self, trust: Trust, value: u16) -> Result<u16>;
}

/// A plane of bits or pairs.
#[derive(Default)]
struct BitPlane {
    bytes: Vec<u8>,
    /// Number of used bits of the last byte, modulo 8.
    used: u32,
}

impl BitPlane {
    fn push(&mut self, value: u8, bits: u32) {
        if self.used.is_multiple_of(8) {
            self.bytes.push(0);
        }
        if let Some(last) = self.bytes.last_mut() {
            *last |= value << (8 - bits - self.used % 8);
        }
        self.used = (self.used + bits) % 8;
    }
}

#[derive(Default)]
pub(super) struct Writer {
    packed: [BitPlane; BYTES[0]],
    bytes: [Vec<u8>; 2],
    words: Vec<u16>,
}

impl Writer {
    pub fn planes(self) -> Vec<Vec<u8>> {
        let words =
            [8, 0].map(|shift| self.words.iter().map(|word| (word >> shift) as u8).collect::<Vec<_>>()).concat();
        self.packed.map(|packed| packed.bytes).into_iter().chain(self.bytes).chain([words]).collect()
    }
}

impl Link for Writer {
    fn flag(&mut self, flag: Flag, predicted: bool, value: bool) -> Result<bool> {
        self.packed[flag as usize].push((predicted ^ value).into(), 1);
        Ok(value)
    }

    fn residual(&mut self, trust: Trust, value: u16) -> Result<u16> {
        let (bit, pair, byte) = trust.planes();
        let mut remainder = value;
        for (plane, bits) in [(bit, 1), (pair, 2)] {
            let Some(plane) = plane else { continue };
            let max = (1 << bits) - 1;
            self.packed[plane].push(remainder.min(max) as u8, bits);
            if remainder < max {
                return Ok(value);
            }
            remainder -= max;
        }
        self.bytes[byte - BYTES[0]].push(remainder.min(255) as u8);
        if remainder >= 255 {
            self.words.push(remainder - 255);
        }
        Ok(value)
    }
}

pub(super) struct Reader<'a> {
    planes: [&'a [u8]; PLANES],
    /// Number of bits, pairs, bytes or words read from each plane.
    read: [usize; PLANES],
}

impl<'a> Reader<'a> {
    pub fn new(planes: &[&'a [u8]]) -> Result<Self> {
        let planes: [&[u8]; PLANES] = planes.try_into().map_err(|_| damage_error("another number of planes"))?;
        Ok(Self { planes, read: [0; PLANES] })
    }

    /// Fails if bytes remain unread.
    pub fn finish(self) -> Result<()> {
        let read_bytes = |plane: usize| match plane {
            WORDS => 2 * self.read[plane],
            _ if BYTES.contains(&plane) => self.read[plane],
            _ => self.read[plane].div_ceil(8),
        };
        let is_finished = (0..PLANES).all(|plane| read_bytes(plane) == self.planes[plane].len());
        if is_finished { Ok(()) } else { Err(damage_error("more bytes")) }
    }

    fn bits(&mut self, plane: usize, bits: usize) -> Result<u16> {
        let index = self.read[plane];
        let byte = self.planes[plane].get(index / 8).ok_or_else(|| damage_error("fewer bytes"))?;
        self.read[plane] += bits;
        Ok(u16::from(byte >> (8 - bits - index % 8)) & ((1 << bits) - 1))
    }

    fn byte(&mut self, plane: usize) -> Result<u16> {
        let byte = self.planes[plane].get(self.read[plane]).ok_or_else(|| damage_error("fewer bytes"))?;
        self.read[plane] += 1;
        Ok(u16::from(*byte))
    }

    fn word(&mut self) -> Result<u16> {
        let (high, low) = self.planes[WORDS].split_at(self.planes[WORDS].len() / 2);
        let index = self.read[WORDS];
        let (Some(&high), Some(&low)) = (high.get(index), low.get(index)) else {
            return Err(damage_error("fewer bytes"));
        };
        self.read[WORDS] += 1;
        Ok(u16::from_be_bytes([high, low]))
    }
}

impl Link for Reader<'_> {
    fn flag(&mut self, flag: Flag, predicted: bool, _: bool) -> Result<bool> {
        Ok(predicted ^ (self.bits(flag as usize, 1)? == 1))
    }

    fn residual(&mut self, trust: Trust, _: u16) -> Result<u16> {
        let (bit, pair, byte) = trust.planes();
        let mut sum = 0;
        for (plane, bits) in [(bit, 1), (pair, 2)] {
            let Some(plane) = plane else { continue };
            let value = self.bits(plane, bits)?;
            sum += value;
            if value < (1 << bits) - 1 {
                return Ok(sum);
            }
        }
        let byte = self.byte(byte)?;
        let word = if byte == 255 { self.word()? } else { 0 };
        (sum + byte).checked_add(word).ok_or_else(|| damage_error("a number beyond 16 bits"))
    }
}

/// Returns the error for malformed planes.
pub(super) fn damage_error(got: &str) -> Error {
    Error::value("ranges", "planes of the listed tiles", got)
}
