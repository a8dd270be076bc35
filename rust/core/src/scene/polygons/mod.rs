//! Batches of polygons with holes: outlines of buildings, and planar surfaces.

mod outlines;
mod prisms;
mod triangulate;
pub mod wkb;

pub use outlines::Polygons;
pub use prisms::prisms;
pub use triangulate::{Faces, triangulate};
