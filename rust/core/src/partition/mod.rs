//! Partition of a scene into triangles that stay geometry and triangles that are baked into the environment map.
//!
//! A triangle's zone follows from its minimum distance ρ from the vertical axis through the centre: near (≤ r₁),
//! intermediate (≤ r₂) or far. Static triangles that reach beyond r₂ are baked; all others are drawn. Static triangles
//! across r₂ are both baked and drawn, and renderers choose for each pixel. Distances are computed in float64 and
//! rounded once to float32, the precision of the geometry, so `triangle_radii`, `Partition` and `LoadCurve` agree about
//! every triangle.

mod arrays;
mod classify;
mod divide;
mod load_curve;
mod object_radii;
mod radii;
mod ring_load;
#[cfg(test)]
mod tests;

pub use arrays::triangle_radii;
pub use classify::{ChosenFaces, Class, Mixed, TriangleSet, Zone};
pub use divide::{Partition, PartitionCounts};
pub use load_curve::LoadCurve;
pub use object_radii::{ObjectRadii, Rule, object_radii};
pub use radii::radii_of;
pub use ring_load::{RingLoad, ring_loads};
