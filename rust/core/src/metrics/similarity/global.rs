//! Similarity with one window over the whole image.

use rayon::prelude::*;

use super::super::extremes::{Extremes, ValueRange};
use super::super::pair::Pair;
use super::super::pixel_rows::PixelRows;
use super::super::plane::{Plane, Region};
use super::direct::ssim_factors;
use super::measure::power_sums;
use super::window::{Mask, Selection, SimilaritySums};
use crate::base::Real;

/// Number of pixels per task and per row segment: fixed, so that sums do not depend on the number of threads.
const TASK_PIXELS: usize = 1 << 14;

/// Computes one similarity for all pixels, with the whole image as window. If the mask restricts windows, the window
/// has only the mask's pixels.
pub(super) fn global<P: PixelRows>(
    pair: &Pair<'_, P>,
    constants: [f64; 2],
    selection: Selection<'_>,
    map: Option<&mut [P::Real]>,
) -> SimilaritySums {
    let (height, width) = (pair.reference.height, pair.reference.width);
    let mask = selection.mask.map(|mask| *mask.plane());
    let window_mask = mask.filter(|_| matches!(selection.mask, Some(Mask::Windows(_))));
    let image = Region { rows: [0, height], columns: [0, width] };
    let bounds = window_mask.map_or(image, |mask| mask.bounds(image));
    if bounds.is_empty() {
        return SimilaritySums::default();
    }
    let levels = pair.levels(&bounds, window_mask.as_ref());
    let rows = (TASK_PIXELS / width).max(1);
    let task = |n: usize| {
        if selection.progress.check().is_err() {
            return ([0.0; 5], ValueRange::default());
        }
        let end = bounds.rows[1].min(bounds.rows[0] + (n + 1) * rows);
        let mut extremes = Extremes::default();
        let mut sums = [0.0; 5];
        for row in bounds.rows[0] + n * rows..end {
            sums = add(sums, row_sums(pair, row, bounds, levels, window_mask));
            if selection.range {
                pair.extend(&Region { rows: [row, row + 1], ..bounds }, &mut extremes);
            }
        }
        (sums, extremes.range())
    };
    let tasks = (bounds.rows[1] - bounds.rows[0]).div_ceil(rows);
    let tasks: Vec<([f64; 5], ValueRange)> = (0..tasks).into_par_iter().map(task).collect();
    let range = tasks.iter().fold(ValueRange::default(), |range, task| range.union(task.1));
    let [pixels, sums @ ..] = tasks.into_iter().map(|task| task.0).fold([0.0; 5], add);
    let [s, d, ss, dd] = sums.map(|sum| sum / pixels);
    let [x, y] = [levels[0] + 0.5 * (s + d), levels[1] + 0.5 * (s - d)];
    let mean_difference = (levels[0] - levels[1]) + d;
    let [s_variance, d_variance] = [ss - s * s, dd - d * d].map(|variance| variance.max(0.0));
    let variances = 0.5 * (s_variance + d_variance) + constants[1];
    let (similarity, contrast) =
        ssim_factors([x * x + y * y + constants[0], mean_difference * mean_difference], [variances, d_variance]);
    if let Some(map) = map {
        map.fill(P::Real::narrow(similarity));
    }
    let count = mask.map_or(pixels, |mask| mask.count() as f64);
    SimilaritySums { similarity: similarity * count, contrast: contrast * count, pixels: count, range }
}

fn add(sums: [f64; 5], terms: [f64; 5]) -> [f64; 5] {
    std::array::from_fn(|i| sums[i] + terms[i])
}

/// Returns the number of a row's pixels in the window, and their sums of s, d, s² and d².
fn row_sums<P: PixelRows>(
    pair: &Pair<'_, P>,
    row: usize,
    bounds: Region,
    levels: [f64; 2],
    window_mask: Option<Plane<'_, u8>>,
) -> [f64; 5] {
    let mut total = [0.0; 5];
    let (mut s, mut d) = (Vec::with_capacity(TASK_PIXELS), Vec::with_capacity(TASK_PIXELS));
    let mut first = bounds.columns[0];
    while first < bounds.columns[1] {
        let columns = first..bounds.columns[1].min(first + TASK_PIXELS);
        s.resize(columns.len(), 0.0);
        d.resize(columns.len(), 0.0);
        pair.gather(row, columns.clone(), levels, [&mut s, &mut d]);
        if let Some(mask) = window_mask {
            for values in [&mut s, &mut d] {
                let mut columns = columns.clone();
                values.retain(|_| columns.next().is_some_and(|column| mask.contains(row, column)));
            }
        }
        let [sum_s, sum_d, sum_ss, sum_dd] = power_sums(&s, &d);
        total = add(total, [s.len() as f64, sum_s, sum_d, sum_ss, sum_dd]);
        first = columns.end;
    }
    total
}
