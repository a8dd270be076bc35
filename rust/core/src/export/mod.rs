//! Export of geometry as glTF files that a viewer loads one after the other.
//!
//! The caller divides objects into groups, and each group becomes a GLB. Static meshes with one placement are merged by
//! material. Meshes with several placements are written once and instanced. Moving objects are named nodes. Positions
//! are rounded to a grid shared by all files, so objects that touch stay together. Files are compressed with
//! `EXT_meshopt_compression` or hold uncompressed arrays that need no extension.
//!
//! Errors are bounded: see [`Settings::step`] for positions, [`NORMAL_ERROR_DEG`] for normals and [`UV_ERROR_TEXELS`]
//! for texture coordinates. Colours are exact.

mod attribute;
mod detail;
mod document;
mod encoder;
mod faces;
mod gather;
mod grid;
mod mesh;
mod numbering;
mod placement;
mod plan;
pub mod ranges;
mod statistics;
mod surfaces;
#[cfg(test)]
mod tests;

pub use detail::texels_per_radian;
pub use encoder::{Export, Glb, SharedMesh};
pub use gather::NORMAL_ERROR_DEG;
pub use plan::Settings;
pub use statistics::{Kind, Statistics};
pub use surfaces::UV_ERROR_TEXELS;
