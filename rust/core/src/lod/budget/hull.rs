//! Ladders of selectable levels, their scores for a block of objects, and the slopes of the upper hulls.

use super::super::elementary::{exp, ln};
use super::super::select::{Model, Parameters, score};
use super::prices::{ALWAYS, class};
use crate::base::simd::vectorized;
use crate::base::{Error, Result};

/// Curves of a model, and the triangle counts of all its levels.
#[derive(Clone, Copy, Debug)]
pub struct RatedModel<'a> {
    /// Curves, sizes and pixels.
    pub model: Model<'a>,
    /// For each curve, a second curve that is added to it, for scores that fall and rise again with size; or empty.
    pub rises: &'a [Parameters],
    /// Triangle count of each level, level 0 first, never increasing.
    pub triangles: &'a [i64],
}

impl RatedModel<'_> {
    /// Returns the score of a level at a size up to the maximum measured one.
    pub fn score(&self, level: usize, curve_size: f64) -> f64 {
        let rise = level.checked_sub(1).and_then(|n| self.rises.get(n));
        self.model.score(level, curve_size)
            + rise.map_or(0.0, |curve| score(curve, curve_size.max(self.model.range[0])))
    }
}

/// Selectable levels of a model: level 0 and those with curves, finest first.
#[derive(Clone, Debug)]
pub(super) struct Ladder {
    /// Level number in the model of each ladder position.
    pub level: Vec<i32>,
    pub triangles: Vec<u64>,
    /// Triangles added by each step; step n leads from level n + 1 to level n.
    pub added: Vec<u64>,
    /// a, b, ln c and d of each level but the first.
    pub curves: Vec<[f64; 4]>,
    /// Parameters of the curves that are added, in the same form; one for each level but the first, or none.
    pub rises: Vec<[f64; 4]>,
    /// A row for each coarser level k: 1/(triangles of j − triangles of k) for the levels j < k, +∞ for equal counts.
    pub per_triangle: Vec<f64>,
    /// Minimum and maximum size at which curves are evaluated.
    pub range: [f64; 2],
}

impl Ladder {
    pub fn new(rated: &RatedModel<'_>, number: usize) -> Result<Self> {
        let RatedModel { model, rises, triangles } = rated;
        model.check(number)?;
        let mut ladder = Self {
            level: vec![0],
            triangles: vec![triangles[0] as u64],
            added: Vec::new(),
            curves: Vec::new(),
            rises: Vec::new(),
            per_triangle: Vec::new(),
            range: [model.range[0], model.greatest()],
        };
        for (n, &[a, b, c, d]) in model.curves.iter().enumerate() {
            if [a, b, c, d].iter().any(|value| value.is_nan()) {
                continue;
            }
            let coarser = triangles[n + 1] as u64;
            for &finer in &ladder.triangles {
                let difference = finer.checked_sub(coarser).ok_or_else(|| {
                    let expected = format!("no more triangles in coarser levels of model {number}");
                    Error::value("models", expected, format!("{coarser} after {finer}"))
                })?;
                ladder.per_triangle.push(1.0 / difference as f64);
            }
            ladder.added.push(ladder.triangles[ladder.triangles.len() - 1] - coarser);
            ladder.level.push(n as i32 + 1);
            ladder.triangles.push(coarser);
            ladder.curves.push([a, b, c.ln(), d]);
            ladder.rises.extend(rises.get(n).map(|&[a, b, c, d]| [a, b, c.ln(), d]));
        }
        Ok(ladder)
    }

    /// Returns the number of steps between neighbouring levels.
    pub fn steps(&self) -> usize {
        self.curves.len()
    }

    /// Returns 1/(triangles of `finer` − triangles of `coarser`).
    pub fn inverse(&self, coarser: usize, finer: usize) -> f64 {
        self.per_triangle[coarser * (coarser - 1) / 2 + finer]
    }
}

/// Number of objects in a block.
pub(super) const LANES: usize = 32;

/// Maximum relative difference of two slopes that rounding can cause.
const ROUNDING: f64 = 1e-12;

/// One number per object of a block.
pub(super) type Lanes = [f64; LANES];
/// Class of one step for each object of a block.
pub(super) type Classes = [u16; LANES];

/// Levels that a block's objects may choose. An object's floor is the coarsest level with a sufficient score.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Choice {
    /// All levels.
    All,
    /// Levels at least as fine as each object's floor.
    FromFloor,
    /// Levels at most as fine as each object's floor.
    ToFloor,
}

vectorized! {
    /// Writes the scores of all levels at some sizes. Level 0 scores 1.
    pub(super) fn scores(ladder: &Ladder, sizes: &Lanes, to: &mut [Lanes]) = fused scores_kernel;
    /// Writes the slope of each step: the score per triangle that the hull gains between levels n + 1 and n. Slopes
    /// decrease towards finer levels. Steps on one edge of the hull have the same bits. The slope is 0 for steps to
    /// levels that cannot be chosen, and +∞ for steps that are always taken.
    pub(super) fn slopes(ladder: &Ladder, scores: &[Lanes], floors: &Lanes, choice: Choice, to: &mut [Lanes])
        = slopes_kernel;
    /// Writes the weighted score added by each step.
    pub(super) fn gains(scores: &[Lanes], weights: &Lanes, to: &mut [Lanes]) = gains_kernel;
    /// Multiplies slopes by their factors, and writes their classes.
    pub(super) fn weigh(slopes: &mut [Lanes], factors: &SlopeFactors, classes: &mut [Classes]) = weigh_kernel;
}

/// Factors of slopes, for each object of a block.
#[derive(Clone, Copy, Debug)]
pub(super) struct SlopeFactors {
    pub weights: Lanes,
    /// Factor of the steps up to the previous frame's level, which are those from `held_from` on.
    pub hold: f64,
    pub held_from: Lanes,
    /// Steps from this one on are always taken.
    pub always_from: Lanes,
}

/// Returns whether a level lies on the hull's edge between two others, rather than below it.
pub(super) fn is_on_edge(ladder: &Ladder, scores: &[Lanes], lane: usize, edge: [usize; 2], position: usize) -> bool {
    let [coarse, fine] = edge;
    let gain = |position: usize| scores[position][lane] - scores[coarse][lane];
    let triangles = |position: usize| (ladder.triangles[position] - ladder.triangles[coarse]) as f64;
    gain(position) * triangles(fine) >= gain(fine) * triangles(position) * (1.0 - ROUNDING)
}

#[inline(always)]
fn weigh_kernel(slopes: &mut [Lanes], factors: &SlopeFactors, classes: &mut [Classes]) {
    for (step, (slopes, classes)) in slopes.iter_mut().zip(classes).enumerate() {
        for n in 0..LANES {
            let hold = if step as f64 >= factors.held_from[n] { factors.hold } else { 1.0 };
            slopes[n] *= factors.weights[n] * hold;
            classes[n] = if step as f64 >= factors.always_from[n] { ALWAYS } else { class(slopes[n]) };
        }
    }
}

#[inline(always)]
fn scores_kernel<const FUSED: bool>(ladder: &Ladder, sizes: &Lanes, to: &mut [Lanes]) {
    let [least, greatest] = ladder.range;
    let mut logarithms = [0.0; LANES];
    for n in 0..LANES {
        let size = if sizes[n] < least { least } else { sizes[n] };
        logarithms[n] = ln::<FUSED>(if size > greatest { greatest } else { size });
    }
    to[0] = [1.0; LANES];
    for (curve, to) in ladder.curves.iter().zip(&mut to[1..]) {
        *to = [0.0; LANES];
        add_curve::<FUSED>(curve, &logarithms, to);
    }
    for (curve, to) in ladder.rises.iter().zip(&mut to[1..]).filter(|(curve, _)| (curve[0], curve[3]) != (0.0, 0.0)) {
        add_curve::<FUSED>(curve, &logarithms, to);
    }
}

/// Adds a curve's values at logarithms of sizes.
#[inline(always)]
fn add_curve<const FUSED: bool>(&[a, b, middle, d]: &[f64; 4], logarithms: &Lanes, to: &mut Lanes) {
    for n in 0..LANES {
        let steps = b * (logarithms[n] - middle);
        // Computed from the nearer plateau, so that no digits cancel.
        let small = exp::<FUSED>(-steps.abs());
        let fraction = small / (1.0 + small);
        let (near, far) = if steps < 0.0 { (a, d) } else { (d, a) };
        to[n] += near + (far - near) * fraction;
    }
}

#[inline(always)]
fn gains_kernel(scores: &[Lanes], weights: &Lanes, to: &mut [Lanes]) {
    for ((finer, coarser), to) in scores.iter().zip(&scores[1..]).zip(to) {
        for n in 0..LANES {
            to[n] = weights[n] * (finer[n] - coarser[n]);
        }
    }
}

/// Computes the slope of the smallest concave function above the levels. With scores M and triangles T, its slope
/// between levels i + 1 and i is the maximum over j ≤ i of the minimum over k > i of (M_j − M_k)/(T_j − T_k).
#[inline(always)]
fn slopes_kernel(ladder: &Ladder, scores: &[Lanes], floors: &Lanes, choice: Choice, to: &mut [Lanes]) {
    let count = ladder.triangles.len();
    for to in &mut *to {
        *to = [f64::NEG_INFINITY; LANES];
    }
    for finer in 0..count - 1 {
        let mut least = [f64::INFINITY; LANES];
        for step in (finer..count - 1).rev() {
            let coarser = step + 1;
            let inverse = ladder.inverse(coarser, finer);
            for n in 0..LANES {
                let gain = scores[finer][n] - scores[coarser][n];
                // Ignores steps without triangles and without gain, whose slope would be 0/0.
                let is_useless = (inverse == f64::INFINITY) & (gain <= 0.0);
                let slope = if is_useless { f64::NEG_INFINITY } else { gain * inverse };
                let slope = match choice {
                    Choice::FromFloor if coarser as f64 > floors[n] => f64::INFINITY,
                    Choice::ToFloor if (finer as f64) < floors[n] => f64::NEG_INFINITY,
                    _ => slope,
                };
                least[n] = if slope < least[n] { slope } else { least[n] };
                to[step][n] = if least[n] > to[step][n] { least[n] } else { to[step][n] };
            }
        }
    }
    // Despite rounding, a finer step must not have a greater slope than a coarser one.
    let mut limit = [f64::INFINITY; LANES];
    for (step, to) in to.iter_mut().enumerate().rev() {
        for n in 0..LANES {
            let is_included = choice == Choice::FromFloor && step as f64 >= floors[n];
            let slope = if to[n] > 0.0 { to[n] } else { 0.0 };
            let slope = if slope < limit[n] { slope } else { limit[n] };
            to[n] = if is_included { f64::INFINITY } else { slope };
            limit[n] = to[n];
        }
    }
}
