//! Meshes stored in the bytes of files: rows of numbers, converted to arrays when a mesh is used, once and in place. A
//! file of ten thousand meshes is read without an array for each of them.

mod color;
mod fitness;
mod join;
mod meshes;
mod rows;
#[cfg(test)]
mod tests;

pub use join::StoredPart;
pub use meshes::{Attributes, StoredFaces, StoredMeshes};
pub use rows::{Number, Rows};
