//! Structural similarity. Wang, Bovik, Sheikh, Simoncelli: Image quality assessment: from error visibility to
//! structural similarity, 2004: weighted means, variances and covariance in a window that moves over both images.
//!
//! With s = x + y and d = x − y, σx² + σy² = (σs² + σd²)/2 and 2 σxy = (σs² − σd²)/2: four moments instead of five.
//! Both factors of the measure are 1 minus a non-negative term that is 0 for equal images.

mod direct;
mod global;
mod masked;
mod measure;
mod moments;
mod scales;
#[cfg(test)]
mod tests;
mod window;
mod tiles;

pub use scales::{Scales, Shrunk, multiscale, similarity};
pub use window::{Mask, Selection, Similarity, SimilaritySums, Window};
