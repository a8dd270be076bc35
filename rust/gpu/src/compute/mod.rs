//! Kernels on what lies on the device: frames that were not read back, and long arrays.

mod discontinuity;
mod lookup;
mod memory;
mod morph;
mod programs;
mod similarity;
mod stream;

pub use discontinuity::discontinuity;
pub use lookup::{Filter, Map, lookup};
pub use morph::morph;
pub use similarity::{Compared, MOST_TAPS, similarity};
