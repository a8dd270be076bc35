//! How far a picture is from another one, and how far it is broken.

mod batch;
mod completion;
mod direct;
mod discontinuity;
mod global;
mod masked;
mod measure;
mod moments;
mod plane;
mod scales;
mod similarity;
mod squares;
#[cfg(test)]
mod tests;
mod vectors;
mod windows;

pub use batch::{Comparison, Stacks};
pub use completion::object_completion;
pub use discontinuity::{Neighbourhood, discontinuity};
pub use measure::{Measured, Source};
pub use plane::{Pixel, Plane, Real};
pub use similarity::{Pair, Similarity, Sums, Window};
