//! Batches of polygons: outlines of buildings, planar surfaces with holes, and faces of meshes.

mod faces;
mod junctions;
mod outlines;
mod prisms;
mod triangulate;
pub mod wkb;

pub(super) use faces::{FaceClipper, fan_covers};
pub use faces::{Fans, triangulate_faces};
pub use outlines::Polygons;
pub use prisms::prisms;
pub use triangulate::{Faces, triangulate};
