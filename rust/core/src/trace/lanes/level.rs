//! The instruction sets that this processor has, and the one in use.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

#[cfg(target_arch = "x86_64")]
use super::x86::{Avx2, Avx512};
use crate::base::{Error, Result};

/// The instruction sets that there are kernels for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum InstructionSet {
    /// Arrays; the compiler makes of them what every processor of the target has.
    Portable,
    /// 256 bits.
    #[cfg(target_arch = "x86_64")]
    Avx2(Avx2),
    /// 512 bits for groups of rays.
    #[cfg(target_arch = "x86_64")]
    Avx512(Avx512),
}

impl InstructionSet {
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

static LEVELS: OnceLock<Vec<InstructionSet>> = OnceLock::new();
/// Position in `LEVELS`; beyond the end stands for the best.
static CHOSEN: AtomicUsize = AtomicUsize::new(usize::MAX);

/// Names of the instruction sets that this processor has kernels for, the best last.
pub fn instruction_sets() -> Vec<&'static str> {
    LEVELS.get_or_init(InstructionSet::available).iter().map(|level| level.name()).collect()
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
