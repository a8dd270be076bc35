//! How far a picture is from another one, and how far it is broken.

mod discontinuity;
mod similarity;

use rayon::prelude::*;

use crate::base::{Error, Result};

pub use discontinuity::{Neighbourhood, discontinuity};
pub use similarity::{Similarity, Window, similarity};

/// Values that one task sums up: fixed, so that sums do not depend on the number of threads.
const TILE: usize = 1 << 14;

/// Mean of the squared differences of two images, in float64.
pub fn mean_squared_error(reference: &[f64], test: &[f64]) -> Result<f64> {
    if reference.len() != test.len() || reference.is_empty() {
        return Err(Error::value("test", format!("{} values, more than none", reference.len()), test.len()));
    }
    let square = |(a, b): (&f64, &f64)| (a - b) * (a - b);
    let tile = |(a, b): (&[f64], &[f64])| a.iter().zip(b).map(square).sum::<f64>();
    let tiles: Vec<f64> = reference.par_chunks(TILE).zip(test.par_chunks(TILE)).map(tile).collect();
    Ok(tiles.iter().sum::<f64>() / reference.len() as f64)
}

/// Object completion: the share of the reference's objects that are visible at all (OVC), and the mean share of each
/// one's pixels that are (OFC). CloVR (2024), Eq. 1–2. None where the reference shows no object. Negative numbers are none.
pub fn object_completion(reference: &[i32], test: &[i32]) -> Option<(f64, f64)> {
    let (wanted, found) = (pixels_of(reference), pixels_of(test));
    let mut counts = (0u64, 0u64, 0.0);
    for (object, &pixels) in wanted.iter().enumerate().filter(|(_, pixels)| **pixels > 0) {
        let seen = found.get(object).copied().unwrap_or(0);
        counts.0 += 1;
        counts.1 += u64::from(seen > 0);
        counts.2 += seen.min(pixels) as f64 / pixels as f64;
    }
    let objects = counts.0 as f64;
    (counts.0 > 0).then(|| (counts.1 as f64 / objects, counts.2 / objects))
}

/// Pixels of each object number.
fn pixels_of(ids: &[i32]) -> Vec<u64> {
    let most = ids.iter().copied().max().unwrap_or(-1);
    let mut pixels = vec![0; usize::try_from(i64::from(most) + 1).unwrap_or(0)];
    for &id in ids {
        if let Some(count) = usize::try_from(id).ok().and_then(|id| pixels.get_mut(id)) {
            *count += 1;
        }
    }
    pixels
}
