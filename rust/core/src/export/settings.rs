//! Settings of an export.

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
    pub(super) fn check(&self) -> Result<()> {
        if !(MIN_STEP..=MAX_STEP).contains(&self.step) {
            let expected = format!("metres from {} to {}", number(MIN_STEP), number(MAX_STEP));
            return Err(Error::value("step", expected, number(self.step)));
        }
        Ok(())
    }
}
