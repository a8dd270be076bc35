//! Export of geometry as glTF files that a viewer loads one after the other.
//!
//! Objects are divided into groups, and each group becomes a GLB: static meshes that are used once are merged by
//! material, meshes with several placements are written once and placed, and moving objects are named nodes. Positions
//! are rounded to a grid shared by all files, so objects that touch stay together. Files are compressed with
//! `EXT_meshopt_compression` or hold plain arrays that need no extension.
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
pub use statistics::{Kind, Statistics};
pub use surfaces::UV_ERROR_TEXELS;

use crate::base::{Error, Result, number};

/// Limits of `Settings::step`: beyond the needs of float32 positions and scenes, and within the exponents of the
/// EXPONENTIAL filter.
const MIN_STEP: f64 = 1.0 / (1u64 << 40) as f64;
const MAX_STEP: f64 = (1u64 << 20) as f64;

/// Settings of an export.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Step of the grid of positions in metres, rounded down to a power of two. The error of a position is at most
    /// half a step per axis. Coordinates beyond 2²³ steps use coarser steps, as float32 demands; `Statistics` has the
    /// maximum error.
    pub step: f64,
    /// Whether arrays are compressed; otherwise files need no extension, unless images are WebP.
    pub compressed: bool,
}

impl Default for Settings {
    /// 2⁻¹⁰ m: errors of at most half a millimetre, up to 8 km from the origin.
    fn default() -> Self {
        Self { step: 1.0 / 1024.0, compressed: true }
    }
}

impl Settings {
    fn check(&self) -> Result<()> {
        if !(MIN_STEP..=MAX_STEP).contains(&self.step) {
            let expected = format!("metres from {} to {}", number(MIN_STEP), number(MAX_STEP));
            return Err(Error::value("step", expected, number(self.step)));
        }
        Ok(())
    }
}
