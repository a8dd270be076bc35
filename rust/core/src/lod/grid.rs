//! How much of y curves of a grid explain: p of each, its mean taken off and scaled to length 1, so that one product
//! with y tells. The grid depends on the places of samples only: curves with the same ones share it.

use super::descend::{LEAST_RISE, TAIL};
use super::logistic::{self, Line};
use crate::base::simd::widest;

/// Columns of one step of the product.
const BLOCK: usize = 64;
/// The least rise; below it curves hardly differ from a straight line over ln x.
const GENTLEST: f64 = 0.25;
/// From one rise to the next.
const FACTOR: f64 = 1.7;
/// Transitions this much steeper than samples are dense lie between two of them: `steps` has those.
const DENSE: f64 = 3.0;
/// However many samples there are.
const STEEPEST: f64 = 150.0;
/// Between middles, in units of the transition.
const SPACING: f64 = 1.2;
/// How far beyond the samples, in the same units.
const BEYOND: f64 = 4.0;

/// Curves and what is known of them.
#[derive(Debug)]
pub(super) struct Grid {
    pub(super) lines: Vec<Line>,
    /// Before, after, the nearest gentler, the nearest steeper; itself where there is none.
    neighbors: Vec<[u32; 4]>,
    /// By sample, then by column; columns padded to blocks with 0.
    basis: Vec<f32>,
    columns: usize,
}

impl Grid {
    /// Over samples at `v` by rising v, `places` being the different ones.
    pub(super) fn new(v: &[f64], places: &[f64]) -> Self {
        let (levels, steps) = levels(places);
        let lines: Vec<Line> = levels.iter().flatten().copied().collect();
        let neighbors = neighbors(&levels, &steps);
        let columns = lines.len().div_ceil(BLOCK) * BLOCK;
        let basis = basis(v, &levels, columns);
        Self { lines, neighbors, basis, columns }
    }

    /// The share of y that each column explains; `y` has length 1 and mean 0.
    pub(super) fn explain(&self, y: &[f32], explained: &mut Vec<f32>) {
        explained.clear();
        explained.resize(self.columns, 0.0);
        explain(&self.basis, y, explained);
    }

    /// Columns that explain no less than their neighbours do.
    pub(super) fn peaks(&self, explained: &[f32]) -> impl Iterator<Item = usize> {
        let is_peak = |&n: &usize| self.neighbors[n].iter().all(|&other| explained[n] >= explained[other as usize]);
        (0..self.lines.len()).filter(is_peak)
    }
}

/// Lines of one rise by rising middle, from tail to tail, for each rise; and the middles.
fn levels(places: &[f64]) -> (Vec<Vec<Line>>, Vec<Vec<f64>>) {
    let finite: Vec<f64> = places.iter().copied().filter(|&v| v >= -1.0).collect();
    let steepest = (DENSE * (finite.len() - 1) as f64).min(STEEPEST);
    let mut between: Vec<f64> = finite.windows(2).flat_map(|pair| [pair[0], 0.5 * (pair[0] + pair[1])]).collect();
    between.push(1.0);
    let (mut levels, mut all) = (Vec::new(), Vec::new());
    let mut rise = GENTLEST;
    while rise < FACTOR * steepest {
        let reach = 1.0 + BEYOND / rise;
        let even = (2.0 * reach * rise / SPACING).ceil();
        let mut middles = vec![-1.0 - TAIL / rise];
        if even > between.len() as f64 {
            middles.extend(&between);
        } else {
            middles.extend((0..=even as usize).map(|n| reach * (2.0 * n as f64 / even - 1.0)));
        }
        middles.push(1.0 + TAIL / rise);
        levels.push(middles.iter().map(|&origin| Line { level: 0.0, rise: -rise, origin }).collect());
        all.push(middles);
        rise *= FACTOR;
    }
    levels.push(vec![Line { level: 0.0, rise: -LEAST_RISE, origin: 0.0 }]);
    all.push(vec![0.0]);
    (levels, all)
}

fn neighbors(levels: &[Vec<Line>], middles: &[Vec<f64>]) -> Vec<[u32; 4]> {
    let first: Vec<usize> = levels
        .iter()
        .scan(0, |next, level| {
            *next += level.len();
            Some(*next - level.len())
        })
        .collect();
    // The straight line is last, and a neighbour of none.
    let curved = levels.len() - 1;
    let nearest = |k: usize, middle: f64| {
        let upper = middles[k].partition_point(|&m| m < middle).min(middles[k].len() - 1);
        let lower = upper.saturating_sub(1);
        let closer =
            if (middles[k][upper] - middle).abs() < (middle - middles[k][lower]).abs() { upper } else { lower };
        first[k] + closer
    };
    let mut neighbors = Vec::new();
    for (k, level) in middles.iter().enumerate() {
        for (n, &middle) in level.iter().enumerate() {
            let own = first[k] + n;
            let before = if n > 0 { own - 1 } else { own };
            let after = if n + 1 < level.len() { own + 1 } else { own };
            let gentler = if k > 0 && k < curved { nearest(k - 1, middle) } else { own };
            let steeper = if k + 1 < curved { nearest(k + 1, middle) } else { own };
            neighbors.push([before, after, gentler, steeper].map(|index| index as u32));
        }
    }
    neighbors
}

fn basis(v: &[f64], levels: &[Vec<Line>], columns: usize) -> Vec<f32> {
    let mut values = vec![0.0; v.len() * columns];
    let mut first = 0;
    for level in levels {
        let rise = level[0].rise;
        let shifts: Vec<f64> = level.iter().map(|line| logistic::exp(-rise * line.origin)).collect();
        for (n, &v) in v.iter().enumerate() {
            // e^(rise (v − origin)) as a product: one exponential for each sample, none of which overflows.
            let start = n * columns + first;
            logistic_row(logistic::exp((rise * v).min(300.0)), &shifts, &mut values[start..start + shifts.len()]);
        }
        first += level.len();
    }
    let count = v.len() as f64;
    let (mut means, mut lengths) = (vec![0.0; columns], vec![0.0; columns]);
    for row in values.chunks_exact(columns) {
        means.iter_mut().zip(row).for_each(|(mean, p)| *mean += p / count);
    }
    for row in values.chunks_exact_mut(columns) {
        for ((p, mean), length) in row.iter_mut().zip(&means).zip(&mut lengths) {
            *p -= mean;
            *length += *p * *p;
        }
    }
    let scales: Vec<f64> =
        lengths.iter().map(|&length: &f64| if length > 0.0 { 1.0 / length.sqrt() } else { 0.0 }).collect();
    values.chunks_exact(columns).flat_map(|row| row.iter().zip(&scales).map(|(g, scale)| (g * scale) as f32)).collect()
}

widest! {
    fn logistic_row(e: f64, shifts: &[f64], p: &mut [f64]) = logistic_row_kernel;
}

#[inline(always)]
fn logistic_row_kernel(e: f64, shifts: &[f64], p: &mut [f64]) {
    let count = shifts.len();
    let p = &mut p[..count];
    for i in 0..count {
        let e = e * shifts[i];
        p[i] = e / (1.0 + e);
    }
}

widest! {
    fn explain(basis: &[f32], y: &[f32], explained: &mut [f32]) = explain_kernel;
}

#[inline(always)]
fn explain_kernel(basis: &[f32], y: &[f32], explained: &mut [f32]) {
    let columns = explained.len();
    let (blocks, _) = explained.as_chunks_mut::<BLOCK>();
    for (k, block) in blocks.iter_mut().enumerate() {
        let mut sums = [0.0f32; BLOCK];
        for n in 0..y.len() {
            let start = n * columns + k * BLOCK;
            let row: &[f32; BLOCK] = basis[start..start + BLOCK].as_array().expect("a block");
            for i in 0..BLOCK {
                sums[i] += y[n] * row[i];
            }
        }
        for i in 0..BLOCK {
            block[i] = sums[i] * sums[i];
        }
    }
}
