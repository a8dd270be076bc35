//! Descent to the nearest local minimum of the residual. The best a and d for a given line τ are known (variable
//! projection, Golub and Pereyra 1973). Newton's method with exact second derivatives finds the line in few steps.

use super::logistic::{self, Line, LogisticScratch, LogisticSums, Samples};

/// Maximum number of steps of one descent, which usually takes ten.
const MAX_STEPS: usize = 60;
/// Minimum predicted gain of a step, relative to the residual.
const MIN_PREDICTED_GAIN: f64 = 1e-11;
/// Mean squared residual that rounding causes, for values of size 1.
const ROUNDING: f64 = 1e-31;
/// Maximum length of a step, in units of τ and of the logarithm of its rise.
const MAX_STEP: f64 = 4.0;
/// |τ| beyond which samples lie on a plateau to 4 digits.
const PLATEAU_TAU: f64 = 9.0;
/// Relative difference of τ below which two lines lead to the same minimum.
const SAME_DESCENT: f64 = 0.03;
/// Assumed upper bound of the gain of a whole descent, as a multiple of the predicted gain of its next step.
const GAIN_LIMIT: f64 = 8.0;
/// Maximum |τ| if all samples lie on one side of the transition; the other plateau is then e²⁵ times as far away.
pub(super) const MAX_TAU: f64 = 25.0;
/// Minimum rise over half of the samples' range. At smaller rises a curve is a straight line over ln x to ten digits.
pub(super) const MIN_RISE: f64 = 1e-4;

/// Bounds of lines; within them all numbers stay finite.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// Maximum rise.
    pub(super) steepest: f64,
    /// Maximum |v| of the line's middle.
    pub(super) farthest: f64,
}

impl Limits {
    /// Returns the nearest allowed line. Of the line and its complement it takes the one whose σ is at most ½ at the
    /// middle of the samples' range, because small σ keep their digits.
    fn apply(&self, line: Line) -> Line {
        let mut line = if line.value(0.0) > 0.0 { line.complement() } else { line };
        line.rise = line.rise.signum() * line.rise.abs().clamp(MIN_RISE, self.steepest);
        let steepness = line.rise.abs();
        // τ at the middle of the samples is at most 0. At one end of their range it is larger by the steepness.
        let least = (-MAX_TAU - steepness).max(-steepness * self.farthest);
        let missing = least - line.value(0.0);
        if missing > 0.0 {
            line.level += missing;
        }
        line
    }
}

/// A line with its sums over the samples.
#[derive(Clone, Copy, Debug)]
pub(super) struct EvaluatedLine {
    pub(super) line: Line,
    pub(super) sums: LogisticSums,
}

impl EvaluatedLine {
    pub(super) fn evaluate(samples: &Samples<'_>, limits: &Limits, line: Line, scratch: &mut LogisticScratch) -> Self {
        let line = limits.apply(line);
        Self { line, sums: logistic::evaluate(samples, &line, scratch) }
    }

    /// Returns whether only rounding errors remain, so that no other line is better.
    pub(super) fn is_exact(&self, samples: &Samples<'_>) -> bool {
        self.sums.residual <= samples.count * ROUNDING
    }

    /// Returns whether the lines are so close that a descent would end at the rival's minimum.
    pub(super) fn leads_to(&self, rival: &Self) -> bool {
        let is_close = |v: f64| {
            let (value, rival_value) = (self.line.value(v), rival.line.value(v));
            (value - rival_value).abs() < SAME_DESCENT * (1.0 + rival_value.abs().min(PLATEAU_TAU))
        };
        is_close(-1.0) && is_close(1.0)
    }

    /// Returns whether the rival is better even after `GAIN_LIMIT` times the predicted gain.
    fn cannot_beat(&self, promise: f64, rival: &Self) -> bool {
        self.sums.residual - GAIN_LIMIT * promise > rival.sums.residual
    }
}

/// Gradient and second derivatives of half the squared residual by (level, ln |rise|), with the best a and d.
pub(super) struct LocalModel {
    /// Line whose parameters the derivatives refer to.
    pub(super) line: Line,
    pub(super) gradient: [f64; 2],
    /// Second derivatives: (level, level), (level, ln |rise|), (ln |rise|, ln |rise|).
    pub(super) hessian: [f64; 3],
}

impl LocalModel {
    pub(super) fn new(current: &EvaluatedLine, count: f64) -> Self {
        let EvaluatedLine { mut line, sums } = *current;
        let LogisticSums { q, gg, mut p1, mut g_p1, mut r_p1, mut p1_p1, mut r_p2, .. } = sums;
        // Moves the origin of u.
        let shift = sums.center();
        line = line.with_origin(line.origin + shift);
        for moments in [&mut p1, &mut g_p1, &mut r_p1] {
            moments[1] -= shift * moments[0];
        }
        for moments in [&mut p1_p1, &mut r_p2] {
            moments[2] += shift * (shift * moments[0] - 2.0 * moments[1]);
            moments[1] -= shift * moments[0];
        }
        // r = y − d − q p has the derivatives ∂r/∂d = −1, ∂r/∂q = −g, ∂r/∂level = −q p′, ∂r/∂rise = −q p′u. The mixed
        // derivative with respect to d and q is 0.
        let mixed = |i: usize| [q * p1[i], q * g_p1[i] - r_p1[i]];
        let (by_level, by_rise) = (mixed(0), mixed(1));
        // The Schur complement of the diagonal 2 × 2 block of d and q eliminates them.
        let inverse_gg = if gg > 0.0 { 1.0 / gg } else { 0.0 };
        let schur = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] / count + a[1] * b[1] * inverse_gg;
        let second = |i: usize| q * (q * p1_p1[i] - r_p2[i]);
        let rise = line.rise;
        let along_rise = -q * r_p1[1] * rise;
        Self {
            line,
            gradient: [-q * r_p1[0], along_rise],
            hessian: [
                second(0) - schur(by_level, by_level),
                (second(1) - schur(by_level, by_rise)) * rise,
                (second(2) - schur(by_rise, by_rise)) * rise * rise + along_rise,
            ],
        }
    }

    /// Returns Newton's step and the predicted gain, the decrease of half the squared residual. Along each eigenvector
    /// of the second derivatives the step leads downhill and is at most `radius` long.
    fn step(&self, radius: f64) -> ([f64; 2], f64) {
        let [a, b, c] = self.hessian;
        let half = (a - c) / 2.0;
        let root = (half * half + b * b).sqrt();
        // Eigenvector of the larger eigenvalue, computed without cancellation.
        let axis = if half > 0.0 { [half + root, b] } else { [b, root - half] };
        let length = (axis[0] * axis[0] + axis[1] * axis[1]).sqrt();
        let axis = if length > 0.0 { [axis[0] / length, axis[1] / length] } else { [1.0, 0.0] };
        let middle = (a + c) / 2.0;
        let (mut step, mut promise) = ([0.0; 2], 0.0);
        for (axis, curvature) in [(axis, middle + root), ([-axis[1], axis[0]], middle - root)] {
            let slope = self.gradient[0] * axis[0] + self.gradient[1] * axis[1];
            let bound = slope.abs() / radius;
            let along = if slope == 0.0 { 0.0 } else { -slope / curvature.abs().max(bound) };
            promise -= along * (slope + 0.5 * along * curvature);
            step[0] += along * axis[0];
            step[1] += along * axis[1];
        }
        (step, promise)
    }
}

/// Descends from a line until no step gains anything, or until the descent cannot improve on `rival`.
pub(super) fn descend(
    samples: &Samples<'_>,
    limits: &Limits,
    mut current: EvaluatedLine,
    rival: Option<&EvaluatedLine>,
    scratch: &mut LogisticScratch,
) -> EvaluatedLine {
    let mut radius = 1.0;
    let mut local = LocalModel::new(&current, samples.count);
    for _ in 0..MAX_STEPS {
        let (step, promise) = local.step(radius);
        if current.is_exact(samples) || promise <= MIN_PREDICTED_GAIN * current.sums.residual {
            break;
        }
        if rival.is_some_and(|rival| current.leads_to(rival) || current.cannot_beat(promise, rival)) {
            break;
        }
        let line = Line { level: local.line.level + step[0], rise: local.line.rise * step[1].exp(), ..local.line };
        let trial = EvaluatedLine::evaluate(samples, limits, line, scratch);
        let gain = 0.5 * (current.sums.residual - trial.sums.residual);
        let length = step[0].abs().max(step[1].abs());
        if gain > 0.0 {
            if gain > 0.5 * promise {
                radius = (2.0 * length).clamp(radius, MAX_STEP);
            } else if gain < 0.1 * promise {
                radius = 0.5 * length;
            }
            current = trial;
            local = LocalModel::new(&current, samples.count);
        } else {
            radius = 0.25 * length;
            if radius < 1e-12 {
                break;
            }
        }
    }
    current
}
