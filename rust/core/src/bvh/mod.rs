//! Trees of boxes: one over a mesh's triangles, one over a scene's instances. Built by obvhs, traversed by `trace`.

mod blocks;
mod groups;
mod tree;
mod wide;

pub(crate) use blocks::Block;
pub use groups::MeshArrays;
pub use tree::{Bvh, Tlas};
pub(crate) use wide::{LEAF, NO_CHILD, Node, WIDTH, Wide};
