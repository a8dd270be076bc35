//! The morph that joins near geometry, seen from the user's eye, to a far environment seen from the centre.
//!
//! Popescu, Lee, Choi, Fahmy: the continuous near–far partitioning of 2022, Eq. 1–3 (`Kind::Blend`); and the same
//! group's CloVR of 2024, Alg. 1 (`Kind::Cylinder`), whose printed w lacks the brackets.

mod blend;
mod cylinder;
mod lanes;
mod point;
mod stream;
#[cfg(test)]
mod tests;

pub use point::{Kind, Morph, Morphed};
