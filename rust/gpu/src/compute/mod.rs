//! Compute kernels on frames that stay on the device, and on long arrays.

mod discontinuity;
pub(crate) mod memory;
pub(crate) mod programs;
mod similarity;
mod stream;

pub use discontinuity::discontinuity;
pub use similarity::{MAX_TAPS, Similarity, similarity};
pub use stream::{Filter, lookup, morph};
