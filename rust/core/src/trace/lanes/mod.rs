//! Short vectors of float32 numbers, in the widest form that the processor supports.
//!
//! Each operation is defined bit for bit, so a kernel written once over `Lanes` gives the same result on every
//! instruction set. Operations are plain IEEE arithmetic without fused multiply-add; `min` and `max` are defined as on
//! x86.

mod array;
mod isa;
mod level;
#[cfg(test)]
mod tests;
#[cfg(target_arch = "x86_64")]
mod x86;

pub(crate) use array::Portable;
pub(crate) use isa::{Isa, Lanes};
pub(crate) use level::InstructionSet;
pub use level::{instruction_sets, use_instruction_set};
#[cfg(target_arch = "x86_64")]
pub(crate) use x86::{Avx2, Avx512};
