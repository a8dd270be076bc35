//! Mean squared error, on pixels as they are.

use rayon::prelude::*;

use super::pair::Pair;
use super::pixel_rows::PixelRows;

/// Pixels that one task sums up: fixed, so that sums do not depend on the number of threads, and few enough for the
/// sums of whole numbers.
const TILE: usize = 1 << 14;

/// Bytes of an image below which one thread is as fast as all.
const SERIAL_BYTES: usize = 1 << 22;

/// Mean of the squared differences of two images, in float64; exact for whole numbers.
pub fn mean_squared_error<P: PixelRows>(pair: &Pair<'_, P>) -> f64 {
    let (height, width) = (pair.reference.height, pair.reference.width);
    let run = |row: usize, first: usize| {
        let end = width.min(first + TILE);
        match (pair.reference.run(row, first..end), pair.test.run(row, first..end)) {
            (Some(x), Some(y)) => P::squares(x, y),
            _ => (first..end).map(|column| pair.square(row, column)).sum(),
        }
    };
    let rows = (TILE / width).max(1);
    let task = |n: usize| -> f64 {
        let rows = n * rows..height.min((n + 1) * rows);
        rows.map(|row| (0..width).step_by(TILE).map(|first| run(row, first)).sum::<f64>()).sum()
    };
    let tasks = height.div_ceil(rows);
    // The same sums in the same order on one thread or many: waking threads takes as long as reading a few megabytes.
    let sums: Vec<f64> = if height.saturating_mul(width).saturating_mul(size_of::<P>()) < SERIAL_BYTES {
        (0..tasks).map(task).collect()
    } else {
        (0..tasks).into_par_iter().map(task).collect()
    };
    sums.iter().sum::<f64>() / (height as f64 * width as f64)
}
