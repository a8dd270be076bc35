//! Splits triangles until the interpolated morph of their vertices is within a tolerance of the morph of every point,
//! for every user of a region.
//!
//! Popescu, Lee, Choi, Fahmy (2022) morph vertices; the error bounds are nearfar's own (`bound.rs` for blends,
//! `grown_bound.rs` for cylinders while they grow). Edges are cut where they cross r₁ and r₂, because the morph has
//! kinks there, and between the radii until the bound holds. The cut of an edge depends on the edge alone, so there
//! are no cracks between triangles, meshes or objects. Triangles within r₁, which do not move, and triangles beyond r₂,
//! which a blend moves as a whole, are never cut and keep their bits.

mod assemble;
mod blend;
mod bound;
mod edge;
mod grown;
mod grown_bound;
mod rule;
mod scene;
mod settings;
mod split;
#[cfg(test)]
mod tests;

pub use assemble::{Arrays, SplitCounts, tessellate_arrays};
pub use rule::Rule;
pub use scene::{needs_split, split_scene, tessellate_scene};
pub use settings::{Precision, ServedMorphs, Settings, Steps, bent_from};
pub use split::Piece;
