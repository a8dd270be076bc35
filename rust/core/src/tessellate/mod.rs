//! Splits triangles until morphing their vertices shows them where morphing every point would, within a tolerance and for
//! every user of a region.
//!
//! Popescu, Lee, Choi, Fahmy (2022) morph vertices; the bound is ours (`bound.rs`). Edges are cut where they cross r₁ and r₂,
//! because the morph has kinks there, and in between until the bound holds. Whether and where an edge is cut follows from
//! the edge alone, so that nothing cracks between triangles, meshes or objects. Edges that touch no point between the
//! radii are never cut: what lies within r₁ or beyond r₂ stays as it is, bit for bit.

mod bound;
mod arrays;
mod assemble;
mod counts;
mod rule;
mod scene;
mod split;
#[cfg(test)]
mod tests;

pub use arrays::{Arrays, tessellate_arrays};
pub use counts::SplitCounts;
pub use rule::{Precision, Rule, Settings};
pub use scene::{needs_split, split_scene, tessellate_scene};
pub use split::Piece;
