//! Byte planes of prediction residuals: frequent small numbers in few bits, apart from rare large ones.
//!
//! Nine planes: flags of changed texels, flags of texels without a surface, and residuals. With high trust a residual
//! starts with a bit; if that is 1, a pair of bits follows for the rest. With some trust or calm it starts with a
//! pair. A pair of 3 is followed by a byte for the rest; with low trust a residual starts with a byte. A byte of 255
//! is followed by a word for the rest; words are stored as all high bytes before all low ones. Bits and pairs fill a
//! byte from its highest bit.

use crate::base::{Error, Result};

/// Number of planes.
pub(super) const PLANES: usize = 9;
/// Plane of the first bits of residuals; the planes before it have the flags.
const BITS: usize = 2;
/// Pair planes: after a bit, with some trust, and calm.
const PAIRS: [usize; 3] = [3, 4, 5];
/// Byte planes: after a pair, and with low trust.
const BYTES: [usize; 2] = [6, 7];
const WORDS: usize = 8;

/// Trust in a prediction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Trust {
    High,
    Some,
    /// Predicted by agreeing neighbours only.
    Calm,
    Low,
}

impl Trust {
    /// Returns the bit, pair and byte plane for residuals of this trust.
    fn planes(self) -> (Option<usize>, Option<usize>, usize) {
        match self {
            Self::High => (Some(BITS), Some(PAIRS[0]), BYTES[0]),
            Self::Some => (None, Some(PAIRS[1]), BYTES[0]),
            Self::Calm => (None, Some(PAIRS[2]), BYTES[0]),
            Self::Low => (None, None, BYTES[1]),
        }
    }
}

/// Flag of a texel; its number is that of its plane.
#[derive(Clone, Copy, Debug)]
pub(super) enum Flag {
    /// The texel changes.
    Changed,
    /// The texel has no surface.
    Nothing,
}

/// One end of the planes: a writer stores and returns its arguments, a reader returns what it reads.
pub(super) trait Link {
    /// Codes a flag.
    fn flag(&mut self, flag: Flag, predicted: bool, value: bool) -> Result<bool>;
    /// Codes the difference of a code from its prediction, folded: 0, −1, 1, −2, … as 0, 1, 2, 3, ….
    fn residual(&mut self, trust: Trust, value: u16) -> Result<u16>;
}

/// A plane of numbers of a few bits each.
#[derive(Default)]
struct Packed {
    bytes: Vec<u8>,
    used: u32,
}

impl Packed {
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
    packed: [Packed; BYTES[0]],
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
        let planes: [&[u8]; PLANES] = planes.try_into().map_err(|_| damaged("another number of planes"))?;
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
        if is_finished { Ok(()) } else { Err(damaged("more bytes")) }
    }

    fn bits(&mut self, plane: usize, bits: usize) -> Result<u16> {
        let index = self.read[plane];
        let byte = self.planes[plane].get(index / 8).ok_or_else(|| damaged("fewer bytes"))?;
        self.read[plane] += bits;
        Ok(u16::from(byte >> (8 - bits - index % 8)) & ((1 << bits) - 1))
    }

    fn byte(&mut self, plane: usize) -> Result<u16> {
        let byte = self.planes[plane].get(self.read[plane]).ok_or_else(|| damaged("fewer bytes"))?;
        self.read[plane] += 1;
        Ok(u16::from(*byte))
    }

    fn word(&mut self) -> Result<u16> {
        let (high, low) = self.planes[WORDS].split_at(self.planes[WORDS].len() / 2);
        let index = self.read[WORDS];
        let (Some(&high), Some(&low)) = (high.get(index), low.get(index)) else { return Err(damaged("fewer bytes")) };
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
        (sum + byte).checked_add(word).ok_or_else(|| damaged("a number beyond 16 bits"))
    }
}

/// Returns the error for malformed planes.
pub(super) fn damaged(got: &str) -> Error {
    Error::value("ranges", "planes of the listed tiles", got)
}
