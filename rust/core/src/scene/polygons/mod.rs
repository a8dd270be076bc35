//! Polygons with holes, many at once: outlines of buildings, and surfaces in their own plane.

mod outlines;
mod prisms;
mod triangulate;
pub mod wkb;

pub use outlines::Polygons;
pub use prisms::prisms;
pub use triangulate::{Faces, triangulate};
