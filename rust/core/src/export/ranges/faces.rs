//! Face layout of a range map, its tiles, and the step of codes.

use crate::base::{Error, Result, number};

/// Maximum logarithm of the ratio of two consecutive codes' ranges.
pub const MAX_STEP: f64 = 700.0 / 65535.0;

/// Layout of a map's faces, and its listed tiles.
#[derive(Clone, Copy, Debug)]
pub struct Faces<'a> {
    /// Texels along a face.
    pub size: usize,
    /// Texels along a tile; it divides `size`.
    pub tile: usize,
    /// Ascending numbers of the tiles in which texels may change, by face, row and column.
    pub listed: &'a [u32],
    /// Natural logarithm of the ratio of two consecutive codes' ranges.
    pub step: f64,
}

impl Faces<'_> {
    /// Returns the number of faces for a number of texels.
    pub(super) fn count(&self, texels: usize) -> Result<usize> {
        let Self { size, tile, listed, step } = *self;
        let area = size.checked_mul(size).filter(|&area| area > 0 && texels.is_multiple_of(area));
        let Some(area) = area.filter(|_| tile > 0 && size.is_multiple_of(tile)) else {
            return Err(Error::value("tile", "a divisor of the face size, and whole faces", tile));
        };
        let tiles = texels / (tile * tile);
        if !listed.is_sorted_by(|a, b| a < b) || listed.last().is_some_and(|&last| last as usize >= tiles) {
            return Err(Error::value("tiles", format!("ascending numbers below {tiles}"), "others"));
        }
        if !(step > 0.0 && step <= MAX_STEP) {
            return Err(Error::value("step", format!("a number from 0 to {MAX_STEP}"), number(step)));
        }
        Ok(texels / area)
    }
}
