//! A few float32 side by side, in the widest form that the processor has.
//!
//! Every operation is defined bit for bit, so that a kernel written once over `Lanes` gives the same answer on any
//! instruction set: plain IEEE arithmetic, never a fused multiply-add, and the x86 meaning of `min` and `max`.

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
