//! The curves of a model at one size: scores, the coarsest sufficient level, and fading between levels.

use super::rules::Rules;
use crate::base::{Error, Result};

/// Difference of score assumed below the coarsest level: the difference between levels in measurements.
const STEP: f64 = 0.05;
/// Range of sizes below the greatest size over which the level falls to 0, as a share of the greatest size, for a fade
/// of 1; it is proportional to the fade.
const FADE_RANGE: f64 = 0.25;

/// a, b, c and d of y = d + (a−d)/(1+(x/c)^b).
pub type Parameters = [f64; 4];

/// Curves of all levels of one object except level 0.
#[derive(Clone, Copy, Debug)]
pub struct Model<'a> {
    /// Curves from level 1 on; NaN for a level without a curve.
    pub curves: &'a [Parameters],
    /// Least and greatest measured solid angle, steradians.
    pub range: [f64; 2],
}

/// A size σ, the size that the eye sees, and the score that is required.
#[derive(Clone, Copy, Debug)]
pub(super) struct SizeQuery {
    pub sigma: f64,
    pub seen: f64,
    pub threshold: f64,
}

/// y at x ≥ 0, computed from the nearer plateau, so that no digits cancel.
pub(super) fn score(&[a, b, c, d]: &Parameters, x: f64) -> f64 {
    let steps = b * if (x / c - 1.0).abs() < 0.5 { ((x - c) / c).ln_1p() } else { x.ln() - c.ln() };
    let small = (-steps.abs()).exp();
    let share = small / (1.0 + small);
    if steps < 0.0 { a + (d - a) * share } else { d + (a - d) * share }
}

impl Model<'_> {
    pub(super) fn check(&self, number: usize) -> Result<()> {
        let [least, greatest] = self.range;
        if self.curves.is_empty() || (0.0 <= least && least <= greatest) {
            return Ok(());
        }
        let got = format!("{least} and {greatest} at index {number}");
        Err(Error::value("models", "solid angles of at least 0, the least first", got))
    }

    /// Size above which the level is 0; −∞ for a model with one level.
    pub(super) fn limit(&self, reference: f64) -> f64 {
        if self.curves.is_empty() { f64::NEG_INFINITY } else { self.range[1].min(reference) }
    }

    /// Score of a level at a size up to the greatest measured one.
    pub(super) fn score(&self, level: usize, seen: f64) -> f64 {
        match level.checked_sub(1) {
            None => 1.0,
            Some(n) => score(&self.curves[n], seen.max(self.range[0])),
        }
    }

    /// The coarsest sufficient level, at most `most`.
    pub(super) fn coarsest(&self, most: usize, asked: &SizeQuery) -> usize {
        if asked.seen > self.range[1] {
            return 0;
        }
        (1..=most).rev().find(|&level| self.score(level, asked.seen) >= asked.threshold).unwrap_or(0)
    }

    /// The coarsest sufficient level. Levels coarser than the previous one must exceed the threshold by the hysteresis.
    pub(super) fn held(&self, previous: usize, asked: &SizeQuery, rules: &Rules) -> usize {
        let most = self.curves.len();
        let share = 1.0 - rules.hysteresis;
        let too_large = asked.seen > self.range[1] * share || asked.sigma > self.limit(rules.reference) * share;
        if previous == 0 && too_large {
            return 0;
        }
        let surely = SizeQuery { threshold: asked.threshold + rules.hysteresis, ..*asked };
        self.coarsest(most, &surely).max(self.coarsest(previous.min(most), asked))
    }

    /// The level while it fades to the next finer one.
    pub(super) fn shown(&self, level: usize, asked: &SizeQuery, rules: &Rules) -> f64 {
        if level == 0 || rules.fade == 0.0 {
            return level as f64;
        }
        let own = self.score(level, asked.seen);
        let coarser = (level + 1..=self.curves.len()).map(|other| self.score(other, asked.seen));
        let next = coarser.filter(|other| !other.is_nan()).reduce(f64::max).unwrap_or(own - STEP);
        // With hysteresis a level may be finer than required by more than one level, so the share is clamped.
        let way = if own > next { ((own - asked.threshold) / (own - next)).clamp(0.0, 1.0) } else { 1.0 };
        let weight = 1.0 - (way / rules.fade).min(1.0);
        let finer = self.coarsest(level - 1, asked);
        let faded = level as f64 - weight * (level - finer) as f64;
        let left = |size: f64, limit: f64| if limit > 0.0 { 1.0 - size / limit } else { 1.0 };
        let room = left(asked.sigma, self.limit(rules.reference)).min(left(asked.seen, self.range[1]));
        let most = self.curves.len() as f64 * (room / (FADE_RANGE * rules.fade)).clamp(0.0, 1.0);
        faded.min(most)
    }
}
