//! What every stage stands on: errors, threads, progress, random numbers, shared arrays.

pub mod buffer;
pub mod error;
pub mod memory;
pub mod pool;
pub mod progress;
pub mod random;
pub mod real;
pub(crate) mod simd;

pub use buffer::Buffer;
pub use error::{Error, Result, number};
pub use progress::Progress;
pub use real::Real;
