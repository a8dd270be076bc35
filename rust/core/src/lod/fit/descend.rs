//! Descent to the nearest local minimum of the residual. The best a and d follow from a given line τ (variable
//! projection: Golub, Pereyra 1973). Two unknowns remain, for which Newton's method with exact second derivatives
//! needs few steps.

use super::logistic::{self, Line, LogisticScratch, LogisticSums, Samples};

/// Maximum number of steps of one descent; ten are usual.
const MAX_STEPS: usize = 60;
/// Minimum predicted gain of a step, relative to the residual.
const MIN_PREDICTED_GAIN: f64 = 1e-11;
/// Squared residual per sample, for values of size 1, that is due to rounding.
const ROUNDING: f64 = 1e-31;
/// Maximum length of a step, in units of τ and of the logarithm of its rise.
const MAX_STEP: f64 = 4.0;
/// |τ| beyond which samples lie on a plateau to 4 digits.
const PLATEAU_TAU: f64 = 9.0;
/// Relative difference of τ below which two lines lead to the same minimum.
const SAME_DESCENT: f64 = 0.03;
/// Upper bound of the gain of a descent, as a multiple of the gain that its next step predicts.
const GAIN_LIMIT: f64 = 8.0;
/// Maximum |τ| if all samples lie on one side. The second plateau is then e²⁵ times as far away as the samples reach.
pub(super) const MAX_TAU: f64 = 25.0;
/// Minimum rise over half of the samples' range; below it a curve is a straight line over ln x to ten digits.
pub(super) const MIN_RISE: f64 = 1e-4;

/// Bounds of lines; within them all numbers stay finite.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// Maximum rise.
    pub(super) steepest: f64,
    /// Maximum distance between the line's middle and the middle of the samples, in the kernels' frame.
    pub(super) farthest: f64,
}

impl Limits {
    /// Returns the nearest allowed line, in the form that keeps digits in tails: σ exceeds ½ in at most half of the
    /// samples' range.
    fn apply(&self, line: Line) -> Line {
        let mut line = if line.value(0.0) > 0.0 { line.complement() } else { line };
        line.rise = line.rise.signum() * line.rise.abs().clamp(MIN_RISE, self.steepest);
        let steepness = line.rise.abs();
        // τ at the middle of the samples is at most 0. At the end of their range it is larger by the steepness.
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

    /// Returns whether only rounding is left, so that no other line is better.
    pub(super) fn is_exact(&self, samples: &Samples<'_>) -> bool {
        self.sums.residual <= samples.count * ROUNDING
    }

    /// Returns whether a descent would end at the rival's minimum.
    pub(super) fn leads_to(&self, rival: &Self) -> bool {
        let is_close = |v: f64| {
            let (value, rival_value) = (self.line.value(v), rival.line.value(v));
            (value - rival_value).abs() < SAME_DESCENT * (1.0 + rival_value.abs().min(PLATEAU_TAU))
        };
        is_close(-1.0) && is_close(1.0)
    }

    /// Returns whether `GAIN_LIMIT` times the gain predicted by Newton's step cannot improve on the rival.
    fn is_lost(&self, promise: f64, rival: &Self) -> bool {
        self.sums.residual - GAIN_LIMIT * promise > rival.sums.residual
    }
}

/// Gradient and second derivatives of half the residual by (level, ln |rise|), with the best a and d for each line.
pub(super) struct LocalModel {
    /// Line whose parameters the derivatives refer to.
    pub(super) line: Line,
    pub(super) gradient: [f64; 2],
    /// Second derivatives: by level twice, mixed, by ln |rise| twice.
    pub(super) hessian: [f64; 3],
}

impl LocalModel {
    pub(super) fn new(current: &EvaluatedLine, count: f64) -> Self {
        let EvaluatedLine { mut line, sums } = *current;
        let LogisticSums { q, square, mut plain, mut along, mut slope, mut squared, mut bend, .. } = sums;
        let shift = sums.center();
        line = line.seen_from(line.origin + shift);
        for pair in [&mut plain, &mut along, &mut slope] {
            pair[1] -= shift * pair[0];
        }
        for three in [&mut squared, &mut bend] {
            three[2] += shift * (shift * three[0] - 2.0 * three[1]);
            three[1] -= shift * three[0];
        }
        // For r = y − d − q p: ∂r/∂d = −1, ∂r/∂q = −g, ∂r/∂level = −q p′, ∂r/∂rise = −q p′u. The mixed derivative by d
        // and q is 0.
        let mixed = |i: usize| [q * plain[i], q * along[i] - slope[i]];
        let (by_level, by_rise) = (mixed(0), mixed(1));
        // d and q are eliminated by the Schur complement of their 2 × 2 block, which is diagonal.
        let per_square = if square > 0.0 { 1.0 / square } else { 0.0 };
        let schur = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] / count + a[1] * b[1] * per_square;
        let second = |i: usize| q * (q * squared[i] - bend[i]);
        let rise = line.rise;
        let along_rise = -q * slope[1] * rise;
        Self {
            line,
            gradient: [-q * slope[0], along_rise],
            hessian: [
                second(0) - schur(by_level, by_level),
                (second(1) - schur(by_level, by_rise)) * rise,
                (second(2) - schur(by_rise, by_rise)) * rise * rise + along_rise,
            ],
        }
    }

    /// Returns Newton's step and the predicted decrease of half the residual. Along each eigenvector of the second
    /// derivatives the step leads downhill and is at most `radius` long.
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

/// Descends from the line `found` until no step gains, or until it cannot improve on `rival`.
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
        if rival.is_some_and(|rival| current.leads_to(rival) || current.is_lost(promise, rival)) {
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
