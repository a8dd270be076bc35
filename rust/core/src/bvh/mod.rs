//! Bounding volume hierarchies: one over the triangles of each mesh, one over the instances of a scene. obvhs builds
//! them; the module `trace` traverses them.

mod binary;
mod blocks;
mod groups;
mod tree;
mod wide;

pub(crate) use blocks::Block;
pub use groups::MeshArrays;
pub use tree::{Bvh, Tlas};
pub(crate) use wide::{LEAF, NO_CHILD, Node, WIDTH, Wide};
