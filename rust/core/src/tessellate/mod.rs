//! Splits triangles until the interpolated morph of their vertices is within a tolerance of the morph of every point,
//! for every user of a region.
//!
//! Popescu, Lee, Choi, Fahmy (2022) morph vertices; the error bound is nearfar's own (`bound.rs`). Edges are cut where
//! they cross r₁ and r₂, because the morph has kinks there, and between the radii until the bound holds. The cut of an
//! edge depends on the edge alone, so there are no cracks between triangles, meshes or objects. Edges without points
//! between the radii are never cut, so geometry within r₁ or beyond r₂ stays as it is, bit for bit.

mod arrays;
mod assemble;
mod blend;
mod bound;
mod counts;
mod grown;
mod grown_bound;
mod rule;
mod scene;
mod segment;
mod settings;
mod split;
mod steps;
#[cfg(test)]
mod grown_tests;
#[cfg(test)]
mod tests;

pub use arrays::{Arrays, tessellate_arrays};
pub use counts::SplitCounts;
pub use rule::Rule;
pub use scene::{needs_split, split_scene, tessellate_scene};
pub use settings::{Precision, Settings, Stages, bent_from};
pub use split::Piece;
pub use steps::Steps;
