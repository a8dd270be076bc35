//! Meshes that lie in the bytes of files: rows of numbers that become arrays when the meshes are used, each once and at
//! its place. A file of ten thousand meshes is read without an array for each of them.

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
