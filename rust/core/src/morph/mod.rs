//! The morph: joins near geometry as the user sees it to a far environment as the centre sees it.
//!
//! Popescu, Lee, Choi, Fahmy: continuous near–far partitioning, 2022, Eq. 1–3 (`Kind::Blend`); CloVR by the same group,
//! 2024, Alg. 1 (`Kind::Cylinder`), whose printed formula of w lacks its brackets.

mod blend;
mod cylinder;
mod lanes;
mod point;
mod stream;
#[cfg(test)]
mod tests;

pub use point::{Kind, Morph, Morphed};
