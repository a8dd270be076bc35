//! Short vectors of float32 numbers, in the widest form that the processor supports.
//!
//! Each operation is defined bit for bit, so a kernel written once over `Lanes` gives the same result on every
//! instruction set. Operations are plain IEEE arithmetic without fused multiply-add; `min` and `max` are defined as on
//! x86.

mod array;
mod isa;
#[cfg(test)]
mod tests;
#[cfg(target_arch = "x86_64")]
mod x86;

use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

pub(crate) use array::Portable;
pub(crate) use isa::{Isa, Lanes};
#[cfg(target_arch = "x86_64")]
pub(crate) use x86::{Avx2, Avx512};

use crate::base::{Error, Result};

/// Instruction sets that have kernels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum InstructionSet {
    /// Arrays, for which the compiler generates the target's baseline instructions.
    Portable,
    /// 256-bit vectors.
    #[cfg(target_arch = "x86_64")]
    Avx2(Avx2),
    /// 512-bit vectors for groups of rays.
    #[cfg(target_arch = "x86_64")]
    Avx512(Avx512),
}

impl InstructionSet {
    /// Returns the sets that this processor supports, the best last.
    pub(crate) fn available() -> Vec<Self> {
        let mut sets = vec![Self::Portable];
        #[cfg(target_arch = "x86_64")]
        {
            sets.extend(Avx2::detect().map(Self::Avx2));
            sets.extend(Avx512::detect().map(Self::Avx512));
        }
        sets
    }

    /// Returns the public name.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Portable => "portable",
            #[cfg(target_arch = "x86_64")]
            Self::Avx2(_) => "avx2",
            #[cfg(target_arch = "x86_64")]
            Self::Avx512(_) => "avx512",
        }
    }

    /// Returns the selected set, by default the best one.
    #[inline]
    pub(crate) fn current() -> Self {
        let sets = AVAILABLE.get_or_init(Self::available);
        let selected = sets.get(SELECTED.load(Ordering::Relaxed)).or(sets.last());
        selected.copied().unwrap_or(Self::Portable)
    }
}

/// Instruction sets that this processor supports, the best last.
static AVAILABLE: OnceLock<Vec<InstructionSet>> = OnceLock::new();
/// Index in `AVAILABLE`; an index beyond the end selects the best set.
static SELECTED: AtomicUsize = AtomicUsize::new(usize::MAX);

/// Returns the names of the instruction sets that have kernels and that this processor supports, the best last.
pub fn instruction_sets() -> Vec<&'static str> {
    AVAILABLE.get_or_init(InstructionSet::available).iter().map(|set| set.name()).collect()
}

/// Selects the instruction set for all tracing of this process, for tests and timing. All sets give the same bits.
pub fn use_instruction_set(name: &str) -> Result<()> {
    let names = instruction_sets();
    let Some(index) = names.iter().position(|&known| known == name) else {
        return Err(Error::value("name", format!("one of {}", names.join(", ")), format!("'{name}'")));
    };
    SELECTED.store(index, Ordering::Relaxed);
    Ok(())
}
