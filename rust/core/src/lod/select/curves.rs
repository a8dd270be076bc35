//! Curves of a model: scores, the coarsest sufficient level, and fading between levels.

use super::rules::{Rules, SizeLimit};
use crate::base::{Error, Result};

/// Assumed difference between the scores of the coarsest level and of a next coarser one, as measured between levels.
const STEP: f64 = 0.05;
/// A level fades to 0 over this fraction of the sizes up to the maximum size, times the fade.
const FADE_RANGE: f64 = 0.25;
/// Solid angle of all directions, slightly reduced so that a sphere around the eye exceeds it.
const ALL_DIRECTIONS: f64 = 4.0 * std::f64::consts::PI * (1.0 - 1e-12);
/// Relative increase, more than rounding, of the size from which no level suffices.
const WIDENING: f64 = 1e-9;

/// Parameters a, b, c and d of y = d + (a−d)/(1+(x/c)^b).
pub type Parameters = [f64; 4];

/// Curves of all levels of one object except level 0.
#[derive(Clone, Copy, Debug)]
pub struct Model<'a> {
    /// Curves from level 1 on; NaN for a level without a curve.
    pub curves: &'a [Parameters],
    /// Minimum and maximum measured solid angle, steradians.
    pub range: [f64; 2],
    /// Width of the pixels that the curves were measured with, as a tangent; NaN if unknown.
    pub pixel: f64,
}

/// Sizes of an object, and the required score.
#[derive(Clone, Copy, Debug)]
pub(super) struct SizeQuery {
    /// σ
    pub sigma: f64,
    /// σ′, the displayed size.
    pub displayed: f64,
    /// Size at which curves are evaluated: σ′ in pixels of the model; +∞ if σ′ exceeds its limit.
    pub curve_size: f64,
    pub threshold: f64,
}

/// Returns y at x ≥ 0, computed from the nearer plateau so that no digits cancel.
pub(crate) fn score(&[a, b, c, d]: &Parameters, x: f64) -> f64 {
    let steps = b * if (x / c - 1.0).abs() < 0.5 { ((x - c) / c).ln_1p() } else { x.ln() - c.ln() };
    let small = (-steps.abs()).exp();
    let fraction = small / (1.0 + small);
    if steps < 0.0 { a + (d - a) * fraction } else { d + (a - d) * fraction }
}

impl Model<'_> {
    pub(crate) fn check(&self, number: usize) -> Result<()> {
        let [least, greatest] = self.range;
        if self.curves.is_empty() || (0.0 <= least && least <= greatest) {
            return Ok(());
        }
        let got = format!("{least} and {greatest} at index {number}");
        Err(Error::value("models", "ascending solid angles of at least 0", got))
    }

    /// Returns σ above which the level is 0, by the rules or because f exceeds all scores; −∞ if there is one level.
    pub(super) fn limit(&self, rules: &Rules) -> f64 {
        if self.curves.is_empty() {
            return f64::NEG_INFINITY;
        }
        let best = self.curves.iter().map(|&[a, _, _, d]| a.max(d)).fold(f64::NEG_INFINITY, f64::max);
        let end = (best - rules.line.level) / rules.line.rise * (1.0 + WIDENING);
        let end = if rules.line.rise > 0.0 { end.max(0.0) } else { ALL_DIRECTIONS };
        let reference = if rules.limit == SizeLimit::Own { rules.reference } else { ALL_DIRECTIONS };
        end.min(reference).min(ALL_DIRECTIONS)
    }

    /// Returns the maximum size at which curves are evaluated; no sphere is larger than all directions.
    pub(crate) fn greatest(&self) -> f64 {
        self.range[1].min(4.0 * std::f64::consts::PI)
    }

    /// Returns the area of the model's pixels as a multiple of the eye's pixels; 1 if the model's are unknown.
    pub(super) fn pixel_area(&self, eye: f64) -> f64 {
        if self.pixel.is_nan() { 1.0 } else { (self.pixel / eye) * (self.pixel / eye) }
    }

    /// Returns the score of a level at a size up to the maximum measured one.
    pub(crate) fn score(&self, level: usize, curve_size: f64) -> f64 {
        match level.checked_sub(1) {
            None => 1.0,
            Some(n) => score(&self.curves[n], curve_size.max(self.range[0])),
        }
    }

    /// Returns the coarsest sufficient level, at most `max_level`.
    pub(super) fn coarsest(&self, max_level: usize, query: &SizeQuery) -> usize {
        if query.curve_size > self.greatest() {
            return 0;
        }
        (1..=max_level).rev().find(|&level| self.score(level, query.curve_size) >= query.threshold).unwrap_or(0)
    }

    /// Returns the coarsest sufficient level; levels coarser than the previous one need the hysteresis as a margin.
    pub(super) fn level_with_hysteresis(&self, previous: usize, query: &SizeQuery, rules: &Rules) -> usize {
        let max_level = self.curves.len();
        if previous == 0 && self.relative_margin(query, rules) < rules.hysteresis {
            return 0;
        }
        let with_margin = SizeQuery { threshold: query.threshold + rules.hysteresis, ..*query };
        self.coarsest(max_level, &with_margin).max(self.coarsest(previous.min(max_level), query))
    }

    /// Returns the level as a fraction, for fading to the next finer level.
    pub(super) fn fading_level(&self, level: usize, query: &SizeQuery, rules: &Rules) -> f64 {
        if level == 0 || rules.fade == 0.0 {
            return level as f64;
        }
        let score = self.score(level, query.curve_size);
        let coarser = (level + 1..=self.curves.len()).map(|other| self.score(other, query.curve_size));
        let next = coarser.filter(|other| !other.is_nan()).reduce(f64::max).unwrap_or(score - STEP);
        // With hysteresis a level may be finer than required by more than one, so the fraction is clamped.
        let excess = if score > next { ((score - query.threshold) / (score - next)).clamp(0.0, 1.0) } else { 1.0 };
        let weight = 1.0 - (excess / rules.fade).min(1.0);
        let finer = self.coarsest(level - 1, query);
        let faded = level as f64 - weight * (level - finer) as f64;
        let limit =
            self.curves.len() as f64 * (self.relative_margin(query, rules) / (FADE_RANGE * rules.fade)).clamp(0.0, 1.0);
        faded.min(limit)
    }

    /// Returns the distance of an object's size from its nearer limit, relative to the limit.
    fn relative_margin(&self, query: &SizeQuery, rules: &Rules) -> f64 {
        let margin = |size: f64, limit: f64| if limit > 0.0 { 1.0 - size / limit } else { 1.0 };
        let limited = if rules.limit == SizeLimit::Own { query.sigma } else { query.displayed };
        margin(limited, rules.reference).min(margin(query.curve_size, self.greatest()))
    }
}
