//! Windows computed separately, relative to their middle pixels: first the means, then the deviations. No digits are
//! lost if the squares of values fit in float64. This takes ten times as long as separable passes, and is used where
//! one level for many windows loses precision.

use super::super::pair::Pair;
use super::super::pixel_rows::PixelRows;
use super::super::plane::{Plane, Region, mirror};
use crate::base::Real;
use crate::base::simd::vectorized;

/// Windows per vector operation.
const LANES: usize = 8;

/// Pixels seen by the windows of a region, in float64.
pub(super) struct Patch<'a> {
    weights: &'a [f64],
    constants: [f64; 2],
    /// Values of each image, rows of `width`; 0 for unseen pixels.
    values: [Vec<f64>; 2],
    /// 1 for seen pixels, otherwise 0.
    visibility: Vec<f64>,
    width: usize,
}

impl<'a> Patch<'a> {
    /// Loads the pixels of a mask or, without one, of the mirrored image.
    pub fn new<P: PixelRows>(
        pair: &Pair<'_, P>,
        weights: &'a [f64],
        constants: [f64; 2],
        part: &Region,
        mask: Option<&Plane<'_, u8>>,
    ) -> Self {
        let size = [pair.reference.height, pair.reference.width];
        let (taps, before) = (weights.len(), weights.len() as i64 / 2);
        let height = part.rows[1] - part.rows[0] + taps - 1;
        let width = (part.columns[1] - part.columns[0]).next_multiple_of(LANES) + taps - 1;
        let mut patch = Self {
            weights,
            constants,
            values: [vec![0.0; width * height], vec![0.0; width * height]],
            visibility: vec![0.0; width * height],
            width,
        };
        for row in 0..height {
            let down = (part.rows[0] + row) as i64 - before;
            for column in 0..part.columns[1] - part.columns[0] + taps - 1 {
                let across = (part.columns[0] + column) as i64 - before;
                let [image_row, image_column] = [mirror(down, size[0]), mirror(across, size[1])];
                let is_inside = down == image_row as i64 && across == image_column as i64;
                if mask.is_none_or(|mask| is_inside && mask.contains(image_row, image_column)) {
                    let index = row * width + column;
                    patch.values[0][index] = pair.reference.value(image_row, image_column).wide();
                    patch.values[1][index] = pair.test.value(image_row, image_column).wide();
                    patch.visibility[index] = 1.0;
                }
            }
        }
        patch
    }

    /// Calls `report` with the number, similarity and contrast factor of each wanted window of a row.
    pub fn measure_row(&self, row: usize, wanted: impl Fn(usize) -> bool, mut report: impl FnMut(usize, f64, f64)) {
        let columns = self.width + 1 - self.weights.len();
        for first in (0..columns).step_by(LANES) {
            if !(first..first + LANES).any(&wanted) {
                continue;
            }
            let factors = measure_block(self, row * self.width + first);
            for (lane, &[similarity, contrast]) in factors.iter().enumerate() {
                if wanted(first + lane) {
                    report(first + lane, similarity, contrast);
                }
            }
        }
    }
}

vectorized! {
    fn measure_block(patch: &Patch<'_>, from: usize) -> [[f64; 2]; LANES] = block;
}

/// Computes the windows that begin at `from` and at the next positions.
#[inline(always)]
fn block(patch: &Patch<'_>, from: usize) -> [[f64; 2]; LANES] {
    let [xs, ys] = &patch.values;
    let weights = patch.weights;
    let middle = from + weights.len() / 2 * (patch.width + 1);
    let (mut x_level, mut y_level) = ([0.0; LANES], [0.0; LANES]);
    for i in 0..LANES {
        (x_level[i], y_level[i]) = (xs[middle + i], ys[middle + i]);
    }
    let (mut total, mut x_mean, mut y_mean) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
    for (down, &down_weight) in weights.iter().enumerate() {
        for (across, &across_weight) in weights.iter().enumerate() {
            let (index, weight) = (from + down * patch.width + across, down_weight * across_weight);
            let (x, y, visibility) =
                (&xs[index..index + LANES], &ys[index..index + LANES], &patch.visibility[index..index + LANES]);
            for i in 0..LANES {
                let tap_weight = weight * visibility[i];
                total[i] += tap_weight;
                x_mean[i] += tap_weight * (x[i] - x_level[i]);
                y_mean[i] += tap_weight * (y[i] - y_level[i]);
            }
        }
    }
    for i in 0..LANES {
        x_mean[i] /= total[i];
        y_mean[i] /= total[i];
    }
    let (mut variances, mut difference_variances) = ([0.0; LANES], [0.0; LANES]);
    for (down, &down_weight) in weights.iter().enumerate() {
        for (across, &across_weight) in weights.iter().enumerate() {
            let (index, weight) = (from + down * patch.width + across, down_weight * across_weight);
            let (xs, ys, visibility) =
                (&xs[index..index + LANES], &ys[index..index + LANES], &patch.visibility[index..index + LANES]);
            for i in 0..LANES {
                let tap_weight = weight * visibility[i];
                let (x, y) = ((xs[i] - x_level[i]) - x_mean[i], (ys[i] - y_level[i]) - y_mean[i]);
                variances[i] += tap_weight * (x * x + y * y);
                difference_variances[i] += tap_weight * ((x - y) * (x - y));
            }
        }
    }
    let mut factors = [[0.0; 2]; LANES];
    for i in 0..LANES {
        let (x, y) = (x_level[i] + x_mean[i], y_level[i] + y_mean[i]);
        let difference = (x_level[i] - y_level[i]) + (x_mean[i] - y_mean[i]);
        let means = [x * x + y * y + patch.constants[0], difference * difference];
        let (similarity, contrast) =
            ssim_factors(means, [variances[i] / total[i] + patch.constants[1], difference_variances[i] / total[i]]);
        factors[i] = [similarity, contrast];
    }
    factors
}

/// Returns similarity and contrast factor by two divisions, because the product of the divisors could overflow.
/// Arguments: the sum of both squared means and c₁, the squared difference of the means, the sum of both variances and
/// c₂, and the variance of the difference.
#[inline(always)]
pub(super) fn ssim_factors([means, difference]: [f64; 2], [variances, difference_variance]: [f64; 2]) -> (f64, f64) {
    let contrast = (variances - difference_variance) / variances;
    ((means - difference) / means * contrast, contrast)
}
