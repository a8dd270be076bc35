//! A few float32 side by side, in the widest form that the processor has.
//!
//! Every operation is defined bit for bit, so that a kernel written once over `Lanes` gives the same answer on any
//! instruction set: plain IEEE arithmetic, never a fused multiply-add, and the x86 meaning of `min` and `max`.

mod array;
#[cfg(target_arch = "x86_64")]
mod x86;

use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::base::{Error, Result};

pub(crate) use array::Portable;
#[cfg(target_arch = "x86_64")]
pub(crate) use x86::{Avx2, Avx512};

/// An instruction set. A value of this type proves that the processor has it.
pub(crate) trait Isa: Copy {
    /// One ray against the triangles of a block.
    type Four: Lanes<Self>;
    /// One ray against the children of a node.
    type Eight: Lanes<Self>;
    /// A group of rays against one box or triangle.
    type Group: Lanes<Self>;
}

/// `N` float32. Masks are bits, the lowest for the first lane.
pub(crate) trait Lanes<I>: Copy {
    /// Number of lanes.
    const N: usize;
    /// The same number in all lanes.
    fn splat(isa: I, x: f32) -> Self;
    /// The first `N` of a slice.
    fn load(isa: I, from: &[f32]) -> Self;
    /// Writes to the first `N` of a slice.
    fn store(self, to: &mut [f32]);
    /// Sum.
    fn add(self, other: Self) -> Self;
    /// Difference.
    fn sub(self, other: Self) -> Self;
    /// Product.
    fn mul(self, other: Self) -> Self;
    /// Quotient.
    fn div(self, other: Self) -> Self;
    /// `self < other ? self : other`.
    fn min(self, other: Self) -> Self;
    /// `self > other ? self : other`.
    fn max(self, other: Self) -> Self;
    /// `self < other`; false for NaN.
    fn lt(self, other: Self) -> u32;
    /// `self <= other`; false for NaN.
    fn le(self, other: Self) -> u32;
    /// `self == other`; false for NaN.
    fn eq(self, other: Self) -> u32;
    /// Lanes of `self` where the mask is set, else of `other`.
    fn select(self, mask: u32, other: Self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
}

/// The instruction sets that there are kernels for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Level {
    /// Arrays; the compiler makes of them what every processor of the target has.
    Portable,
    /// 256 bits.
    #[cfg(target_arch = "x86_64")]
    Avx2(Avx2),
    /// 512 bits for groups of rays.
    #[cfg(target_arch = "x86_64")]
    Avx512(Avx512),
}

impl Level {
    /// All that this processor has, the best last.
    pub(crate) fn available() -> Vec<Self> {
        let mut levels = vec![Self::Portable];
        #[cfg(target_arch = "x86_64")]
        {
            levels.extend(Avx2::detect().map(Self::Avx2));
            levels.extend(Avx512::detect().map(Self::Avx512));
        }
        levels
    }

    /// Its public name.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Portable => "portable",
            #[cfg(target_arch = "x86_64")]
            Self::Avx2(_) => "avx2",
            #[cfg(target_arch = "x86_64")]
            Self::Avx512(_) => "avx512",
        }
    }

    /// The best one, or the one that was chosen.
    #[inline]
    pub(crate) fn current() -> Self {
        let levels = LEVELS.get_or_init(Self::available);
        let chosen = levels.get(CHOSEN.load(Ordering::Relaxed)).or(levels.last());
        chosen.copied().unwrap_or(Self::Portable)
    }
}

static LEVELS: OnceLock<Vec<Level>> = OnceLock::new();
/// Position in `LEVELS`; beyond the end stands for the best.
static CHOSEN: AtomicUsize = AtomicUsize::new(usize::MAX);

/// Names of the instruction sets that this processor has kernels for, the best last.
pub fn instruction_sets() -> Vec<&'static str> {
    LEVELS.get_or_init(Level::available).iter().map(|level| level.name()).collect()
}

/// Makes all tracing of this process use one of them. The answers are the same bits; this is for tests and timing.
pub fn use_instruction_set(name: &str) -> Result<()> {
    let names = instruction_sets();
    let Some(found) = names.iter().position(|&known| known == name) else {
        return Err(Error::value("name", format!("one of {}", names.join(", ")), format!("'{name}'")));
    };
    CHOSEN.store(found, Ordering::Relaxed);
    Ok(())
}

#[cfg(test)]
mod tests;
