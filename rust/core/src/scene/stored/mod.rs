//! Meshes stored in the bytes of files as rows of numbers, which are converted when a mesh is used. So a file of ten
//! thousand meshes is read without an array for each mesh.

mod color;
mod fitness;
mod join;
mod meshes;
mod rows;
#[cfg(test)]
mod tests;

pub use join::StoredPart;
pub use meshes::{Attributes, StoredFaces, StoredMeshes};
pub use rows::{ComponentType, Rows};
