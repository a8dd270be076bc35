//! Mean squared error of raw pixel values.

use rayon::prelude::*;

use super::extremes::{Extremes, ValueRange};
use super::pair::Pair;
use super::pixel_rows::PixelRows;
use super::plane::Region;
use crate::base::{Progress, Result};

/// Pixels per task: fixed, so that sums do not depend on the number of threads, and few enough for integer sums.
const TILE: usize = 1 << 14;

/// Image size in bytes below which one thread is as fast as all.
const SERIAL_BYTES: usize = 1 << 22;

/// Mean squared difference of two images, and the range of their values.
#[derive(Clone, Copy, Debug)]
pub struct SquaredError {
    /// Mean in float64; exact for integers.
    pub mean: f64,
    /// Range of both images' values, if requested.
    pub range: ValueRange,
}

/// Compares two images pixel by pixel.
pub fn mean_squared_error<P: PixelRows>(pair: &Pair<'_, P>, range: bool, progress: &Progress) -> Result<SquaredError> {
    let (height, width) = (pair.reference.height, pair.reference.width);
    let run = |row: usize, first: usize| {
        let end = width.min(first + TILE);
        match (pair.reference.run(row, first..end), pair.test.run(row, first..end)) {
            (Some(x), Some(y)) => P::squares(x, y),
            _ => (first..end).map(|column| pair.square(row, column)).sum(),
        }
    };
    let rows = (TILE / width).max(1);
    let task = |n: usize| {
        let mut extremes = Extremes::default();
        let rows = n * rows..height.min((n + 1) * rows);
        let row_sum = |row: usize| -> f64 {
            if range {
                pair.extend(&Region { rows: [row, row + 1], columns: [0, width] }, &mut extremes);
            }
            (0..width).step_by(TILE).map(|first| run(row, first)).sum()
        };
        let sum: f64 = rows.map(row_sum).sum();
        progress.check().map(|()| (sum, extremes.range()))
    };
    let tasks = height.div_ceil(rows);
    // Same sums in the same order on one thread or many: waking threads takes as long as reading a few megabytes.
    let sums: Vec<(f64, ValueRange)> = if height.saturating_mul(width).saturating_mul(size_of::<P>()) < SERIAL_BYTES {
        (0..tasks).map(task).collect::<Result<_>>()?
    } else {
        (0..tasks).into_par_iter().map(task).collect::<Result<_>>()?
    };
    Ok(SquaredError {
        mean: sums.iter().map(|task| task.0).sum::<f64>() / (height as f64 * width as f64),
        range: sums.iter().fold(ValueRange::default(), |range, task| range.and(task.1)),
    })
}
