//! Look-up tables of levels over cells of (σ, σ′). In most cells one level is correct for all sizes.

use std::hint::select_unpredictable;

use rayon::prelude::*;

use super::super::elementary::exp;
use super::curves::{Model, Parameters, score};
use super::objects::CHUNK;
use super::rules::{Rules, ThresholdLine};

/// log₂ of the number of cells over σ, which have equal widths because f is linear.
const SIGMA_DIGITS: u32 = 3;
const SIGMA_CELLS: u64 = 1 << SIGMA_DIGITS;
/// log₂ of the number of σ cells for σ′ up to the minimum measured σ′, where all scores are constant and only f varies.
const SMALL_DIGITS: u32 = 8;
const SMALL_CELLS: u64 = 1 << SMALL_DIGITS;
/// Relative widening of the cells over σ, so that no σ lies beyond the last cell.
const WIDENING: f64 = 1e-12;
/// Largest number x for which 1 + x is less than 2 after rounding.
const BELOW_1: f64 = 1.0 - f64::EPSILON;
const MANTISSA: u32 = f64::MANTISSA_DIGITS - 1;
/// log₂ of the number of σ′ cells per octave.
const DIGITS: u32 = 4;
/// Maximum number of octaves of σ′.
const OCTAVES: u64 = 24;
const SHIFT: u32 = MANTISSA - DIGITS;
/// Bit of cells in which a finer level may be correct, so that the curves decide.
pub(super) const UNSURE: u8 = 0x80;
/// Minimum number of objects per model at which a table is faster than curves.
pub(super) const OBJECTS_PER_TABLE: usize = 256;

/// Tables of all models.
#[derive(Debug, Default)]
pub(super) struct Tables {
    /// Levels of each model's cells: one per σ cell for small σ′, then for each σ cell one per σ′ cell.
    cells: Vec<u8>,
    /// Head of each model.
    heads: Vec<Head>,
}

/// Ranges and offsets of a model's cells.
#[derive(Clone, Copy, Debug)]
struct Head {
    /// 1/(maximum σ), slightly reduced.
    fineness: f64,
    /// σ′ up to which the scores are those of the minimum measured σ′.
    least: f64,
    /// σ′ above which the level is 0.
    greatest: f64,
    /// Index of the model's first cell.
    first: u32,
    /// Shifted bits of the first cell's σ′.
    base: u32,
    /// Number of the last cell over σ′.
    last: u32,
}

impl Tables {
    /// Builds the tables; `None` if a model has too many levels for a byte, or if there are too many cells for u32.
    pub fn new(models: &[Model<'_>], rules: &Rules) -> Option<Self> {
        let of_models: Option<Vec<_>> = models.par_iter().map(|model| table(model, rules)).collect();
        let mut tables = Self::default();
        for (head, cells) in of_models? {
            tables.heads.push(Head { first: u32::try_from(tables.cells.len()).ok()?, ..head });
            tables.cells.extend(cells);
        }
        Some(tables)
    }

    /// Looks up the level of each open object for (σ, σ′), with the bit UNSURE if a finer level may be correct.
    #[inline(never)]
    pub fn look_up(
        &self,
        model: &[i64],
        places: &[u16],
        sigma: &[f64; CHUNK],
        size: &[f64; CHUNK],
        to: &mut [u8; CHUNK],
    ) {
        let (heads, cells) = (&self.heads[..], &self.cells[..]);
        for (((&place, &sigma), &size), to) in places.iter().zip(sigma).zip(size).zip(to) {
            let Head { fineness, least, greatest, first, base, last } = heads[model[usize::from(place)] as usize];
            // The leading mantissa bits of 1 + fraction are the number of the σ cell.
            let fraction = sigma * fineness;
            let fraction = if fraction < BELOW_1 { fraction } else { BELOW_1 };
            let small = (1.0 + fraction).to_bits() >> (MANTISSA - SMALL_DIGITS) & (SMALL_CELLS - 1);
            let row = small >> (SMALL_DIGITS - SIGMA_DIGITS);
            let cell = ((size.to_bits() >> SHIFT) as i64 - i64::from(base)).clamp(0, i64::from(last)) as u64;
            let large = SMALL_CELLS + row * (u64::from(last) + 1) + cell;
            // Not a branch, which would be mispredicted half of the time.
            let level_in_cell = cells[(u64::from(first) + select_unpredictable(size <= least, small, large)) as usize];
            *to = if size > greatest { 0 } else { level_in_cell };
        }
    }
}

/// Builds a model's cells and their head. A model with one level has one cell for each σ cell.
fn table(model: &Model<'_>, rules: &Rules) -> Option<(Head, Vec<u8>)> {
    let count = model.curves.len();
    // Few objects are larger and need a level other than 0.
    let limit = model.limit(rules).min(rules.reference);
    if count == 0 {
        let head = Head { fineness: 0.0, least: 0.0, greatest: 0.0, first: 0, base: 0, last: 0 };
        return Some((head, vec![0; (SMALL_CELLS + SIGMA_CELLS) as usize]));
    }
    if count >= UNSURE as usize {
        return None;
    }
    let (least, greatest) = (model.range[0], model.greatest());
    let top = greatest.to_bits() >> SHIFT;
    let base = (least.min(greatest).to_bits() >> SHIFT).clamp(top.saturating_sub(OCTAVES << DIGITS), top);
    let last = top - base;
    let width = last as usize + 1;
    let mut edges: Vec<f64> = (0..=last + 1).map(|n| f64::from_bits((base + n) << SHIFT)).collect();
    // The first cell is used only for σ′ above the minimum, wherever its octave begins.
    edges[0] = least;
    let logarithms: Vec<f64> = edges.iter().map(|x| x.ln()).collect();
    // Minimum and maximum score of each level in each cell.
    let mut bounds = vec![[f64::NEG_INFINITY; 2]; count * width];
    let mut scores = vec![0.0; edges.len()];
    for (curve, bounds) in model.curves.iter().zip(bounds.chunks_exact_mut(width)) {
        let margin = write_scores(curve, &logarithms, &mut scores);
        for (bound, ends) in bounds.iter_mut().zip(scores.windows(2)) {
            if !margin.is_nan() {
                *bound = [ends[0].min(ends[1]) - margin, ends[0].max(ends[1]) + margin];
            }
        }
    }
    // These scores have the same bits as the curves' scores.
    let smallest: Vec<_> = model.curves.iter().map(|curve| [score(curve, least); 2]).collect();
    let mut cells = Vec::with_capacity(SMALL_CELLS as usize + SIGMA_CELLS as usize * width);
    cells.extend((0..SMALL_CELLS).map(|sigma| {
        let [low, high] = range(&rules.line, limit, sigma, SMALL_CELLS);
        level(&smallest, count, 0, low, high)
    }));
    for sigma in 0..SIGMA_CELLS {
        let [low, high] = range(&rules.line, limit, sigma, SIGMA_CELLS);
        cells.extend((0..width).map(|cell| level(&bounds, count, cell, low, high)));
    }
    if limit < model.limit(rules) {
        // Larger objects share the last cells.
        let last_row = cells.len() - width;
        cells[SMALL_CELLS as usize - 1] = count as u8 | UNSURE;
        cells[last_row..].fill(count as u8 | UNSURE);
    }
    let fineness = (1.0 - WIDENING) / limit;
    // If the limit is 0 or among the smallest floats, there is one cell.
    let fineness = if fineness.is_finite() { fineness } else { 0.0 };
    let (base, last) = (base as u32, last as u32);
    Some((Head { fineness, least, greatest, first: 0, base, last }, cells))
}

/// Returns the minimum and maximum threshold in one of `count` cells over σ, with a margin for rounding.
fn range(line: &ThresholdLine, limit: f64, cell: u64, count: u64) -> [f64; 2] {
    let ends = [cell, cell + 1].map(|n| line.value(limit * n as f64 / count as f64));
    let margin = 1e-14 * line.level.abs() + 2.0 * WIDENING * (line.rise * limit).abs();
    [ends[0].min(ends[1]) - margin, ends[0].max(ends[1]) + margin]
}

/// Writes a curve's scores at sizes given by their logarithms. Returns a bound of their error, NaN without a curve.
fn write_scores(&[a, b, c, d]: &Parameters, logarithms: &[f64], to: &mut [f64]) -> f64 {
    let middle = c.ln();
    for (to, logarithm) in to.iter_mut().zip(logarithms) {
        let ratio = exp::<false>(b * (logarithm - middle));
        *to = d + (a - d) / (1.0 + ratio);
    }
    // An error e in a logarithm changes the ratio by the fraction b e, and the score by at most |a − d| b e/4.
    (a - d).abs() * (1e-14 + b * (40.0 + middle.abs()) * 1e-15) + (a.abs() + d.abs()) * 1e-15
}

/// Returns a cell's level for thresholds from `low` to `high`, given the score bounds of `count` levels.
fn level(bounds: &[[f64; 2]], count: usize, cell: usize, low: f64, high: f64) -> u8 {
    let width = bounds.len() / count;
    for level in (1..=count).rev() {
        let [least, greatest] = bounds[(level - 1) * width + cell];
        if least >= high {
            return level as u8;
        }
        if greatest >= low {
            return level as u8 | UNSURE;
        }
    }
    0
}
