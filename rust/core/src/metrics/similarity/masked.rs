//! Similarity restricted to a mask: other pixels have weight 0, and the remaining weights of a window are scaled to
//! sum to 1. Knutsson, Westin: Normalized and differential convolution, 1993.

use super::super::extremes::{LANES, ValueRange, lanes};
use super::super::pair::Pair;
use super::super::pixel_rows::PixelRows;
use super::super::plane::{Plane, Region};
use super::direct::Patch;
use super::measure::{Measure, Measurement};
use super::window::{MapRows, SimilaritySums, sum_bands};
use crate::base::simd::vectorized;
use crate::base::{Progress, Real};

/// Rows per task: fixed, so that sums do not depend on the number of threads.
const ROWS: usize = 64;
/// Fields summed per window: 1, s, s², d, d² for masked pixels, 0 elsewhere.
const FIELDS: usize = 5;

/// Maximum distance of a window from the level, in units of its contrast. Squares lose 2e-15 times its square.
const MAX_DISTANCE: f64 = 50.0;

/// A comparison by windows that see only masked pixels. It uses float64, because a window's mean may lie far from the
/// band's level, and the square of that distance cancels in the variances.
pub(super) struct Masked<'a, P> {
    pub pair: Pair<'a, P>,
    pub weights: &'a [f64],
    pub constants: [f64; 2],
    pub mask: Plane<'a, u8>,
    pub contrast: bool,
    pub progress: &'a Progress,
}

type Fields = [Vec<f64>; FIELDS];

impl<P: PixelRows> Masked<'_, P> {
    /// Returns sums over the masked pixels. Other pixels of the map are NaN.
    pub(super) fn sums(&self, mut map: Option<&mut [P::Real]>) -> SimilaritySums {
        if let Some(map) = &mut map {
            map.fill(P::Real::narrow(f64::NAN));
        }
        let (height, width) = (self.mask.height, self.mask.width);
        let bounds = self.mask.bounds(Region { rows: [0, height], columns: [0, width] });
        sum_bands([height, width], ROWS, map, |rows, map| self.band(bounds.within_rows(rows), map))
    }

    fn band(&self, region: Region, mut map: Option<MapRows<'_, P::Real>>) -> SimilaritySums {
        let mut sums = SimilaritySums::default();
        let [first, end] = region.columns;
        if region.is_empty() || self.progress.check().is_err() {
            return sums;
        }
        let (taps, columns) = (self.weights.len(), end - first);
        let (before, after) = (taps / 2, taps - 1 - taps / 2);
        let levels = self.pair.levels(&region, Some(&self.mask));
        let measure = Measure { levels, constants: self.constants };
        // Similarity, contrast factor and precision of a row's windows. `patch` and `recomputed` serve the windows that
        // one level is not precise enough for.
        let (mut results, mut patch, mut recomputed) = (vec![[0.0; 3]; columns], None, Vec::new());
        // Whole vectors are summed; the last lanes may lie outside the region.
        let padded = columns.next_multiple_of(LANES);
        let fields = |length: usize| -> Fields { std::array::from_fn(|_| vec![0.0; length]) };
        let (mut line, mut window) = (fields(padded + taps - 1), fields(padded));
        let mut ring: Vec<Fields> = (0..taps).map(|_| fields(padded)).collect();
        for read in 0..region.rows[1] - region.rows[0] + taps - 1 {
            // Rows outside the image, and pixels outside the mask, are zeros.
            let row = (region.rows[0] + read).checked_sub(before).filter(|&row| row < self.mask.height);
            self.load(row, region, levels, before, &mut line, &mut sums.range);
            for (line, sums) in line.iter().zip(&mut ring[read % taps]) {
                weigh_line(line, self.weights, sums);
            }
            let Some(row) = (region.rows[0] + read).checked_sub(before + after).filter(|&row| row >= region.rows[0])
            else {
                continue;
            };
            for (field, sums) in window.iter_mut().enumerate() {
                weigh_rows(&ring, field, (read + 1) % taps, self.weights, sums);
            }
            let mut has_failed = false;
            for column in (first..end).filter(|&column| self.mask.contains(row, column)) {
                let index = column - first;
                let scale = 1.0 / window[0][index];
                let (s, ss) = (window[1][index] * scale, window[2][index] * scale);
                let (d, dd) = (window[3][index] * scale, window[4][index] * scale);
                let Measurement { similarity, contrast, .. } =
                    measure.similarity::<true, false>([s, ss - s * s], [d, dd - d * d]);
                // Squares relative to a band's level are imprecise in windows far from it.
                let contrasts = 0.5 * (ss - s * s + dd - d * d) + self.constants[1];
                let is_precise = s * s + d * d <= MAX_DISTANCE * MAX_DISTANCE * contrasts && similarity.is_finite();
                has_failed |= !is_precise;
                results[index] = [similarity, contrast, if is_precise { 1.0 } else { 0.0 }];
            }
            if has_failed {
                let patch = patch.get_or_insert_with(|| {
                    Patch::new(&self.pair, self.weights, self.constants, &region, Some(&self.mask))
                });
                let is_masked = |n: usize| first + n < end && self.mask.contains(row, first + n);
                patch.measure_row(
                    row - region.rows[0],
                    |n| is_masked(n) && results[n][2] == 0.0,
                    |n, similarity, contrast| recomputed.push((n, [similarity, contrast, 1.0])),
                );
                recomputed.drain(..).for_each(|(n, result)| results[n] = result);
            }
            for column in (first..end).filter(|&column| self.mask.contains(row, column)) {
                let [similarity, contrast, _] = results[column - first];
                sums.similarity += similarity;
                sums.contrast += if self.contrast { contrast } else { 0.0 };
                sums.pixels += 1.0;
                if let Some(map) = &mut map {
                    map.write(row, column, &[similarity]);
                }
            }
        }
        sums
    }

    /// Loads a row of fields, beginning `before` pixels left of the region.
    fn load(
        &self,
        row: Option<usize>,
        region: Region,
        levels: [f64; 2],
        before: usize,
        line: &mut Fields,
        range: &mut ValueRange,
    ) {
        line.iter_mut().for_each(|field| field.fill(0.0));
        let Some(row) = row else { return };
        for column in (region.columns[0]..region.columns[1]).filter(|&column| self.mask.contains(row, column)) {
            let [x, y] = [&self.pair.reference, &self.pair.test].map(|image| image.value(row, column).wide());
            range.include(x);
            range.include(y);
            let [x, y] = [x - levels[0], y - levels[1]];
            let (s, d) = (x + y, x - y);
            for (field, value) in line.iter_mut().zip([1.0, s, s * s, d, d * d]) {
                field[column - region.columns[0] + before] = value;
            }
        }
    }
}

vectorized! {
    fn weigh_line(line: &[f64], weights: &[f64], sums: &mut [f64]) = fused weigh_line_kernel;
    fn weigh_rows(ring: &[Fields], field: usize, first: usize, weights: &[f64], sums: &mut [f64])
        = fused weigh_rows_kernel;
}

/// Writes weighted sums of a line's values; the n-th sum begins at the n-th value.
#[inline(always)]
fn weigh_line_kernel<const FUSED: bool>(line: &[f64], weights: &[f64], sums: &mut [f64]) {
    for (block, sums) in sums.as_chunks_mut::<LANES>().0.iter_mut().enumerate() {
        let mut sum = [0.0; LANES];
        for (k, &weight) in weights.iter().enumerate() {
            let values: &[f64; LANES] = lanes(&line[block * LANES + k..]);
            for i in 0..LANES {
                sum[i] = f64::fuse::<FUSED>(weight, values[i], sum[i]);
            }
        }
        *sums = sum;
    }
}

/// Writes weighted sums of one field over the ring's rows, starting at row `first`.
#[inline(always)]
fn weigh_rows_kernel<const FUSED: bool>(
    ring: &[Fields],
    field: usize,
    first: usize,
    weights: &[f64],
    sums: &mut [f64],
) {
    for (block, sums) in sums.as_chunks_mut::<LANES>().0.iter_mut().enumerate() {
        let mut sum = [0.0; LANES];
        for (k, &weight) in weights.iter().enumerate() {
            let slot = if first + k < ring.len() { first + k } else { first + k - ring.len() };
            let values: &[f64; LANES] = lanes(&ring[slot][field][block * LANES..]);
            for i in 0..LANES {
                sum[i] = f64::fuse::<FUSED>(weight, values[i], sum[i]);
            }
        }
        *sums = sum;
    }
}
