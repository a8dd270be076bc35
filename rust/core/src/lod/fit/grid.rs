//! Grid of curves, and the fraction of y's variance that each curve explains. A column has the values p of one curve at
//! the samples, shifted to mean 0 and scaled to length 1; the square of its product with y is the explained fraction.
//! The grid depends only on the positions of the samples, so fits with the same positions share it.

use std::ops::Range;

use super::super::elementary::exp;
use super::descend::{MAX_TAU, MIN_RISE};
use super::logistic::{LANES, Line};
use crate::base::simd::vectorized;

/// Number of columns that a kernel processes together.
const BLOCK: usize = 64;
/// Minimum rise. At smaller rises curves are nearly straight lines over ln x.
const MIN_GRID_RISE: f64 = 0.25;
/// Ratio of successive rises.
const RISE_FACTOR: f64 = 1.7;
/// Maximum ratio of a start's residual to that of its neighbours at other rises; above 1, because the rises are coarse.
const RIDGE_FACTOR: f32 = 1.1;
/// Maximum rise divided by the number of gaps between positions; `best_steps` finds steeper transitions.
const SAMPLE_STEEPNESS: f64 = 3.0;
/// Maximum rise, however many samples there are.
const MAX_GRID_RISE: f64 = 150.0;
/// Number of columns whose p are computed together.
const WIDTH: usize = 16;
/// Distance between middles of transitions, in units of 1/rise.
const SPACING: f64 = 1.2;
/// Maximum exponent, reached at x = 0, where p is 1. No shift makes it overflow.
const LARGEST: f64 = 300.0;
/// Maximum e^τ. It is finite in float32, and p is 1 there.
const SATURATED: f64 = 1e30;
/// Distance of the outermost middles from the samples, in units of 1/rise.
const MARGIN: f64 = 4.0;

/// Maximum number of samples, and of positions, in the search for starts: ten times the distinguishable columns.
const GRID_SAMPLES: usize = 2_048;

/// Curves and their columns.
#[derive(Debug)]
pub(super) struct CurveGrid {
    levels: Vec<Level>,
    /// Middles of the transitions, ascending within each level.
    middles: Vec<f64>,
    /// A row for each sample, with the values of all columns; rows are padded with 0 to whole blocks.
    basis: Vec<f32>,
    columns: usize,
    /// Index of each row's sample, by ascending v.
    pub(super) samples: Vec<usize>,
}

/// Curves with the same rise.
#[derive(Clone, Debug)]
struct Level {
    rise: f64,
    columns: Range<usize>,
}

impl CurveGrid {
    /// Creates the grid for samples at ascending `v`, with distinct `positions` whose runs have these `ends`.
    pub(super) fn new(v: &[f64], ends: &[usize], positions: &[f64]) -> Self {
        let (levels, middles) = levels(positions);
        let columns = middles.len().div_ceil(BLOCK) * BLOCK;
        let samples = choose_samples(v.len(), ends);
        let rows: Vec<f64> = samples.iter().map(|&n| v[n]).collect();
        let basis = basis(&rows, &levels, &middles, columns);
        Self { levels, middles, basis, columns, samples }
    }

    /// Writes the fraction of y that each column explains. `y` has a value for each row, mean 0 and length 1.
    pub(super) fn explain(&self, y: &[f32], explained: &mut Vec<f32>) {
        explained.clear();
        explained.resize(self.columns, 0.0);
        explain(&self.basis, y, explained);
    }

    /// Calls `visit` with the explained fraction and the line of each peak: a curve that explains at least as much as
    /// its neighbours of the same rise, and nearly as much as its neighbours of adjacent rises.
    pub(super) fn peaks(&self, explained: &[f32], mut visit: impl FnMut(f32, Line)) {
        for (k, level) in self.levels.iter().enumerate() {
            let Range { start, end } = level.columns;
            for n in start..end {
                let fraction = explained[n];
                if n > start && explained[n - 1] > fraction || n + 1 < end && explained[n + 1] > fraction {
                    continue;
                }
                let middle = self.middles[n];
                let is_better =
                    |other: &Level| 1.0 - fraction > RIDGE_FACTOR * (1.0 - explained[self.nearest(other, middle)]);
                // Level 0, the straight line, is no neighbour, because curves deviate from it in both directions.
                let gentler = self.levels[1..].get(k.wrapping_sub(2)).is_some_and(is_better);
                let steeper = k > 0 && self.levels.get(k + 1).is_some_and(is_better);
                if !gentler && !steeper {
                    visit(fraction, Line { level: 0.0, rise: -level.rise, origin: middle });
                }
            }
        }
    }

    /// Returns the column of a level with the nearest middle.
    fn nearest(&self, level: &Level, middle: f64) -> usize {
        let Range { start, end } = level.columns;
        let upper = (start + self.middles[start..end].partition_point(|&m| m < middle)).min(end - 1);
        let lower = upper.saturating_sub(1).max(start);
        if (self.middles[upper] - middle).abs() < (middle - self.middles[lower]).abs() { upper } else { lower }
    }
}

/// Returns the samples for the grid: all if there are few. Otherwise evenly spaced samples, and one sample for each of
/// evenly spaced positions, so that rare positions are included.
fn choose_samples(count: usize, ends: &[usize]) -> Vec<usize> {
    if count <= 2 * GRID_SAMPLES {
        return (0..count).collect();
    }
    let evenly =
        |last: usize| (0..GRID_SAMPLES).map(move |k| (k as u128 * last as u128 / (GRID_SAMPLES - 1) as u128) as usize);
    let mut samples: Vec<usize> = evenly(count - 1).chain(evenly(ends.len() - 1).map(|k| ends[k] - 1)).collect();
    samples.sort_unstable();
    samples.dedup();
    samples
}

/// Returns the levels, and the middles of their curves, from tail to tail. Level 0 is a straight line.
fn levels(positions: &[f64]) -> (Vec<Level>, Vec<f64>) {
    let first = positions.partition_point(|&v| v < -1.0);
    let finite = &positions[first..];
    let steepest = (SAMPLE_STEEPNESS * (finite.len() - 1) as f64).min(MAX_GRID_RISE);
    let mut levels = vec![Level { rise: MIN_RISE, columns: 0..1 }];
    let mut middles = vec![0.0];
    let mut rise = MIN_GRID_RISE;
    while rise < RISE_FACTOR * steepest {
        let start = middles.len();
        let reach = 1.0 + MARGIN / rise;
        let even = (2.0 * reach * rise / SPACING).ceil();
        middles.push(-1.0 - MAX_TAU / rise);
        if even > (2 * finite.len() - 1) as f64 {
            for pair in finite.windows(2) {
                middles.extend([pair[0], 0.5 * (pair[0] + pair[1])]);
            }
            middles.push(1.0);
        } else {
            middles.extend((0..=even as usize).map(|n| reach * (2.0 * n as f64 / even - 1.0)));
        }
        middles.push(1.0 + MAX_TAU / rise);
        levels.push(Level { rise, columns: start..middles.len() });
        rise *= RISE_FACTOR;
    }
    (levels, middles)
}

fn basis(v: &[f64], levels: &[Level], middles: &[f64], columns: usize) -> Vec<f32> {
    // e^(rise (v − middle)) is a product of two exponentials, so a rise needs one exponential per sample and column.
    let (mut shifts, mut powers) = (Vec::with_capacity(columns), Vec::with_capacity(2 * levels.len() * v.len()));
    for Level { rise, columns: range } in levels {
        // Uses the one of σ and 1 − σ that is small at the samples if they lie in a tail, because it keeps its digits.
        shifts.extend(middles[range.clone()].iter().map(|middle| -rise * middle.abs()));
        powers.extend(v.iter().map(|v| (-rise * v).min(LARGEST)));
        powers.extend(v.iter().map(|v| rise * v));
    }
    exp_all(&mut shifts);
    exp_all(&mut powers);
    let mut basis = vec![0.0; v.len() * columns];
    for (Level { columns: range, .. }, powers) in levels.iter().zip(powers.chunks_exact(2 * v.len())) {
        let count = middles[range.clone()].partition_point(|&middle| middle < 0.0);
        let (low_shifts, high_shifts) = shifts[range.clone()].split_at(count);
        let (falling, rising) = powers.split_at(v.len());
        fill(falling, low_shifts, &mut basis[range.start..], columns);
        fill(rising, high_shifts, &mut basis[range.start + count..], columns);
    }
    normalize(&mut basis, columns);
    basis
}

vectorized! {
    fn exp_all(values: &mut [f64]) = exp_all_kernel;
    fn fill(powers: &[f64], shifts: &[f64], basis: &mut [f32], columns: usize) = fill_kernel;
    fn normalize(basis: &mut [f32], columns: usize) = normalize_kernel;
    fn explain(basis: &[f32], y: &[f32], explained: &mut [f32]) = explain_kernel;
}

#[inline(always)]
fn exp_all_kernel(values: &mut [f64]) {
    let (packs, remainder) = values.as_chunks_mut::<LANES>();
    for pack in packs {
        for value in pack {
            *value = exp::<false>(*value);
        }
    }
    for value in remainder {
        *value = exp::<false>(*value);
    }
}

/// Computes p of the columns of one rise.
#[inline(always)]
fn fill_kernel(powers: &[f64], shifts: &[f64], basis: &mut [f32], columns: usize) {
    let (packs, remainder) = shifts.as_chunks::<WIDTH>();
    for n in 0..powers.len() {
        let row = &mut basis[n * columns..n * columns + shifts.len()];
        let (row_packs, row_remainder) = row.as_chunks_mut::<WIDTH>();
        for k in 0..packs.len() {
            let mut p = [0.0f32; WIDTH];
            for i in 0..WIDTH {
                let e = powers[n] * packs[k][i];
                p[i] = if e < SATURATED { e as f32 } else { SATURATED as f32 };
            }
            for p in &mut p {
                *p /= 1.0 + *p;
            }
            row_packs[k] = p;
        }
        for i in 0..remainder.len() {
            let e = (powers[n] * remainder[i]).min(SATURATED) as f32;
            row_remainder[i] = e / (1.0 + e);
        }
    }
}

/// Subtracts each column's mean and scales the column to length 1; a constant column becomes 0.
#[inline(always)]
fn normalize_kernel(basis: &mut [f32], columns: usize) {
    let (blocks, _) = basis.as_chunks_mut::<BLOCK>();
    let (rows, blocks_per_row) = (blocks.len() * BLOCK / columns, columns / BLOCK);
    for k in 0..blocks_per_row {
        let (mut mean, mut scale) = ([0.0f32; BLOCK], [0.0f32; BLOCK]);
        for n in 0..rows {
            let row = &blocks[n * blocks_per_row + k];
            for i in 0..BLOCK {
                mean[i] += row[i];
            }
        }
        for mean in &mut mean {
            *mean /= rows as f32;
        }
        for n in 0..rows {
            let row = &mut blocks[n * blocks_per_row + k];
            for i in 0..BLOCK {
                row[i] -= mean[i];
                scale[i] += row[i] * row[i];
            }
        }
        for scale in &mut scale {
            *scale = if *scale > 0.0 { 1.0 / scale.sqrt() } else { 0.0 };
        }
        for n in 0..rows {
            let row = &mut blocks[n * blocks_per_row + k];
            for i in 0..BLOCK {
                row[i] *= scale[i];
            }
        }
    }
}

#[inline(always)]
fn explain_kernel(basis: &[f32], y: &[f32], explained: &mut [f32]) {
    let (explained, _) = explained.as_chunks_mut::<BLOCK>();
    let (blocks, _) = basis.as_chunks::<BLOCK>();
    let blocks_per_row = explained.len();
    for (k, fraction) in explained.iter_mut().enumerate() {
        let mut sums = [0.0f32; BLOCK];
        for n in 0..y.len() {
            let row = &blocks[n * blocks_per_row + k];
            for i in 0..BLOCK {
                sums[i] += y[n] * row[i];
            }
        }
        for i in 0..BLOCK {
            fraction[i] = sums[i] * sums[i];
        }
    }
}
