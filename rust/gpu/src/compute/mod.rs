//! Compute kernels on frames that stay on the device, and on long arrays.

mod discontinuity;
mod lookup;
pub(crate) mod memory;
mod morph;
pub(crate) mod programs;
mod similarity;
mod stream;

pub use discontinuity::discontinuity;
pub use lookup::{CubeMap, Filter, lookup};
pub use morph::morph;
pub use similarity::{MAX_TAPS, Similarity, similarity};
