//! Faces, their tiles, and the step of codes.

use crate::base::{Error, Result, number};

/// Greatest logarithm of the ratio of two codes' ranges.
pub const MOST_STEP: f64 = 700.0 / 65535.0;

/// Faces of a map and the tiles that change.
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
    /// The number of faces that so many texels are.
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
        if !(step > 0.0 && step <= MOST_STEP) {
            return Err(Error::value("step", format!("a number from 0 to {MOST_STEP}"), number(step)));
        }
        Ok(texels / area)
    }
}
