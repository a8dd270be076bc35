//! Levels over cells of size: most sizes lie in cells in which one level is the answer throughout.

use super::curves::{Model, Parameters};
use super::{Line, Rules};
use crate::lod::logistic::exp;

/// Cells over σ, of equal widths because f is a line.
const SIGMAS: usize = 8;
/// Cells over σ′: so many binary digits of its mantissa, and as many octaves at most.
const DIGITS: u32 = 4;
const OCTAVES: u64 = 24;
const SHIFT: u32 = f64::MANTISSA_DIGITS - 1 - DIGITS;
/// Greatest σ′ of a table: more than any.
const MOST: f64 = 16.0;
/// Set where the level may be a finer one: then curves decide.
const UNSURE: u8 = 0x80;
/// From so many objects of a model on, a table is quicker than curves.
pub(super) const WORTH: usize = 256;

/// A model's levels.
#[derive(Debug)]
pub(super) struct Table {
    /// Levels of cells, σ′ by σ′ for each σ.
    cells: Vec<u8>,
    /// Cells a radian² of σ.
    fineness: f64,
    /// Bits of the first cell's σ′, shifted, and the last cell's number.
    base: u64,
    last: u64,
}

impl Table {
    /// `None` for models with one level or more than bytes can name.
    pub fn new(model: &Model<'_>, rules: &Rules) -> Option<Self> {
        let count = model.curves.len();
        let limit = model.limit(rules.reference);
        if count == 0 || count >= UNSURE as usize {
            return None;
        }
        let [least, greatest] = model.range;
        let top = greatest.min(MOST).to_bits() >> SHIFT;
        let base = (least.to_bits() >> SHIFT).clamp(top.saturating_sub(OCTAVES << DIGITS), top);
        let last = top - base;
        let mut edges: Vec<f64> = (0..=last + 1).map(|n| f64::from_bits((base + n) << SHIFT)).collect();
        // Smaller ones are in the first cell.
        edges[0] = edges[0].min(least);
        let logarithms: Vec<f64> = edges.iter().map(|x| x.ln()).collect();
        // Least and greatest score of each level in each cell.
        let mut bounds = vec![[f64::NEG_INFINITY; 2]; count * (last as usize + 1)];
        let mut scores = vec![0.0; edges.len()];
        for (curve, bounds) in model.curves.iter().zip(bounds.chunks_exact_mut(last as usize + 1)) {
            let margin = scored(curve, &logarithms, &mut scores);
            for (bound, ends) in bounds.iter_mut().zip(scores.windows(2)) {
                if !margin.is_nan() {
                    *bound = [ends[0].min(ends[1]) - margin, ends[0].max(ends[1]) + margin];
                }
            }
        }
        let mut cells = Vec::with_capacity(SIGMAS * (last as usize + 1));
        for sigma in 0..SIGMAS {
            let [low, high] = range(&rules.line, limit, sigma);
            cells.extend((0..=last as usize).map(|cell| level(&bounds, count, cell, low, high)));
        }
        Some(Self { cells, fineness: SIGMAS as f64 / limit, base, last })
    }

    /// The level of a size, and whether it surely is: else it is at most that level.
    #[inline(always)]
    pub fn level(&self, sigma: f64, seen: f64) -> (usize, bool) {
        let row = ((sigma * self.fineness) as usize).min(SIGMAS - 1);
        let cell = (seen.to_bits() >> SHIFT).saturating_sub(self.base).min(self.last);
        let found = self.cells[row * (self.last as usize + 1) + cell as usize];
        ((found & !UNSURE) as usize, found < UNSURE)
    }
}

/// Least and greatest threshold of a cell over σ, and what they are rounded by.
fn range(line: &Line, limit: f64, cell: usize) -> [f64; 2] {
    let ends = [cell, cell + 1].map(|n| line.at(limit * n as f64 / SIGMAS as f64));
    let margin = 1e-14 * (line.level.abs() + (line.rise * limit).abs());
    [ends[0].min(ends[1]) - margin, ends[0].max(ends[1]) + margin]
}

/// A curve at sizes given by their logarithms, and by how much rounding may move it; NaN where there is no curve.
fn scored(&[a, b, c, d]: &Parameters, logarithms: &[f64], to: &mut [f64]) -> f64 {
    let middle = c.ln();
    for (to, logarithm) in to.iter_mut().zip(logarithms) {
        let ratio = exp(b * (logarithm - middle));
        *to = d + (a - d) / (1.0 + ratio);
    }
    // A unit in the last place of a logarithm, times b, moves the ratio by that share and the score by a quarter of it.
    (a - d).abs() * (1e-14 + b * (40.0 + middle.abs()) * 1e-15) + (a.abs() + d.abs()) * 1e-15
}

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
