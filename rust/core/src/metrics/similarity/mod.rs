//! Structural similarity. Wang, Bovik, Sheikh, Simoncelli: Image quality assessment: from error visibility to
//! structural similarity, 2004: weighted means, variances and covariance in a window that moves over both images.
//!
//! With s = x + y and d = x − y, σx² + σy² = (σs² + σd²)/2 and 2 σxy = (σs² − σd²)/2: four moments instead of five.
//! Both factors of the measure are 1 minus a non-negative term that is 0 for equal images.

mod direct;
mod global;
mod masked;
mod measure;
mod moments;
mod scales;
#[cfg(test)]
mod tests;
mod window;
mod tiles;

pub use scales::{Scales, Shrunk, multiscale};
pub use window::{Counted, Mask, Similarity, SimilaritySums, Window};

use super::pair::Pair;
use super::pixel_rows::PixelRows;
use crate::base::{Error, Result};
use global::global;
use masked::Masked;
use tiles::Windows;

/// Returns the summed similarity of windows and, if requested, writes its map: rows of the image's width. Images are
/// mirrored at their borders. Without a map only windows that count are computed.
pub fn similarity<P: PixelRows>(
    pair: &Pair<'_, P>,
    window: &Window,
    constants: Similarity,
    counted: Counted<'_>,
    map: Option<&mut [P::Real]>,
) -> Result<SimilaritySums> {
    let size = [pair.reference.height, pair.reference.width];
    if let Some(mask) = counted.mask {
        pair.reference.expect_size("mask", [mask.plane().height, mask.plane().width])?;
    }
    if let Some(map) = map.as_ref().filter(|map| map.len() != size[0] * size[1]) {
        return Err(Error::value("map", format!("{} × {} values", size[0], size[1]), map.len()));
    }
    let constants = [constants.c1, constants.c2];
    let sums = match (window, counted.mask) {
        (Window::Global, _) => global(pair, constants, counted, map),
        (Window::Weights(weights), Some(Mask::Windows(mask))) => {
            let Counted { contrast, progress, .. } = counted;
            Masked { pair: *pair, weights, constants, mask, contrast, progress }.sums(map)
        }
        (Window::Weights(weights), _) => Windows::new(*pair, weights, constants, counted).sums(map),
    };
    counted.progress.check().map(|()| sums)
}
