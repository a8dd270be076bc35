//! Fit of curves: scales the values, finds start points, descends from the best ones, and classifies the result.

use rayon::prelude::*;

use super::descend::{self, EvaluatedLine};
use super::frame::{SampleFrame, Unfit};
use super::logistic::{self, LANES, Line, Pack, Samples};
use crate::base::memory::try_vec;
use crate::base::{Progress, Result, ensure};

/// Number of curves in one task.
const TASK: usize = 16;
/// Maximum number of descents for one curve.
const STARTS: usize = 8;
/// Upper bound of the angle, in radians, between any curve and the nearest curve of the grid. It limits how much a
/// descent can improve on its start.
const GRID_ANGLE: f64 = 0.5;
/// Values count as constant if their half range is at most this fraction of their largest absolute value.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// A curve is flat if (S/S₀)^((N−2)/2) is at least this. S and S₀ are the sums of squared residuals of the curve and of
/// the mean, N is the number of samples; with N instead of N−2 it is the likelihood ratio for normal noise. Of curves
/// through pure noise, 97 % are then flat for up to 20 samples, 95 % for 30 to 60, 92 % for 400.
const FLAT_LIKELIHOOD: f64 = 0.01;
/// A curve is open if the distance between its plateaus exceeds this multiple of the values' range.
const OPEN_HEIGHT: f64 = 100.0;
/// A sample lies on a plateau if the slope of the logistic function, at most 1/4, is below this value.
const PLATEAU_SLOPE: f64 = 1e-5;

/// Result of a fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// A curve with both plateaus near the values.
    Fitted,
    /// At most one sample lies on the curve's slope, so many b and c fit equally well.
    Step,
    /// The samples end before a plateau is visible, so a, c or d is far away and arbitrary.
    Open,
    /// All values are equal up to rounding.
    Constant,
    /// The improvement over the mean is within noise.
    Flat,
    /// No curve can be fitted.
    Unfit(Unfit),
}

/// Curve y = d + (a−d)/(1+(x/c)^b) with b > 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LogisticCurve {
    /// Value at x = 0.
    pub a: f64,
    /// Steepness.
    pub b: f64,
    /// x at which y lies halfway between a and d.
    pub c: f64,
    /// Limit of y at infinity.
    pub d: f64,
    /// Root mean squared residual; for constant values an upper bound of it.
    pub rms: f64,
    /// Result of the fit.
    pub status: Status,
}

impl LogisticCurve {
    fn unfit(reason: Unfit) -> Self {
        Self { a: f64::NAN, b: f64::NAN, c: f64::NAN, d: f64::NAN, rms: f64::NAN, status: Status::Unfit(reason) }
    }
}

/// Buffers shared by all fits of one thread.
#[derive(Default)]
struct FitScratch {
    values: Vec<f64>,
    unit: Vec<f32>,
    packed: Vec<Pack>,
    evaluated: logistic::LogisticScratch,
    explained: Vec<f32>,
    starts: Vec<Start>,
}

/// Fits a least-squares curve to each row of `count` samples. `x` is one row for all curves, or as long as `y`. Samples
/// that are not finite are ignored.
pub fn fit_4pl(x: &[f64], y: &[f64], count: usize, progress: &Progress) -> Result<Vec<LogisticCurve>> {
    let are_rows = count > 0 && y.len().is_multiple_of(count) && [count, y.len()].contains(&x.len());
    let got = format!("{} of x and {} of y for {count} each", x.len(), y.len());
    ensure!(are_rows, "x", "as many numbers as y, or one row of them", got);
    let rows = y.len() / count;
    progress.expect(rows as u64);
    let is_shared = x.len() == count && rows > 0;
    let shared_frame = is_shared.then(|| SampleFrame::new(x, |n| x[n].is_finite(), progress)).transpose()?;
    let mut curves = try_vec(LogisticCurve::unfit(Unfit::TooFew), rows)?;
    curves.par_chunks_mut(TASK).enumerate().try_for_each(|(task, curves)| {
        let mut scratch = FitScratch::default();
        for (n, curve) in curves.iter_mut().enumerate() {
            let first = (task * TASK + n) * count;
            let y = &y[first..first + count];
            let x = if is_shared { x } else { &x[first..first + count] };
            let has_finite_y = |frame: &SampleFrame| frame.order.iter().all(|&n| y[n].is_finite());
            *curve = match &shared_frame {
                Some(Ok(frame)) if has_finite_y(frame) => fit(frame, y, &mut scratch, progress)?,
                _ => match SampleFrame::new(x, |n| x[n].is_finite() && y[n].is_finite(), progress)? {
                    Ok(frame) => fit(&frame, y, &mut scratch, progress)?,
                    Err(reason) => LogisticCurve::unfit(reason),
                },
            };
        }
        progress.report(curves.len() as u64)
    })?;
    Ok(curves)
}

/// Returns the least-squares curve through the samples of a frame.
fn fit(frame: &SampleFrame, y: &[f64], scratch: &mut FitScratch, progress: &Progress) -> Result<LogisticCurve> {
    let count = frame.order.len() as f64;
    let values = || frame.order.iter().map(|&n| y[n]);
    let (low, high) = values().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| (low.min(y), high.max(y)));
    let scale = 0.5 * high - 0.5 * low;
    let center = if low == high { low } else { 0.5 * low + 0.5 * high };
    // The mean of differences is precise even if the values are large and close together.
    let shift = values().map(|y| (y - center) / count).sum::<f64>();
    let flat = |rms: f64, status: Status| {
        let mean = center + shift;
        LogisticCurve { a: mean, b: 1.0, c: frame.x(0.0), d: mean, rms, status }
    };
    if scale <= ROUNDING * low.abs().max(high.abs()) {
        return Ok(flat(scale, Status::Constant));
    }
    scratch.values.clear();
    scratch.values.extend(values().map(|y| (y - center) / scale - shift / scale));
    let total: f64 = scratch.values.iter().map(|y| y * y).sum();
    scratch.packed.clear();
    scratch.packed.resize(frame.v.len(), [0.0; LANES]);
    scratch.packed.as_flattened_mut()[..scratch.values.len()].copy_from_slice(&scratch.values);
    scratch.evaluated.resize(frame.v.len());
    find_starts(frame, total, scratch);
    let samples = Samples { v: &frame.v, weight: &frame.weight, y: &scratch.packed, count, progress };
    progress.check()?;
    let best = descend_all(frame, &samples, total, &scratch.starts, &mut scratch.evaluated);
    // After a cancellation the sums are 0.
    progress.check()?;
    let rms = scale * (best.sums.residual / count).sqrt();
    if (best.sums.residual / total).powf(0.5 * (count - 2.0)) >= FLAT_LIKELIHOOD {
        return Ok(flat(scale * (total / count).sqrt(), Status::Flat));
    }
    let curve = to_input_units(frame, &best, center + shift, scale);
    let is_finite = [curve.a, curve.c, curve.d - curve.a].iter().all(|number| number.is_finite());
    Ok(if is_finite && curve.c > 0.0 {
        LogisticCurve { rms, status: classify(frame, &best), ..curve }
    } else {
        LogisticCurve::unfit(Unfit::Overflow)
    })
}

/// Fills `scratch.starts`, the most promising start first.
fn find_starts(frame: &SampleFrame, total: f64, scratch: &mut FitScratch) {
    let root = total.sqrt();
    scratch.values.iter_mut().for_each(|y| *y /= root);
    fill_unit(&frame.grid.samples, &scratch.values, &mut scratch.unit);
    frame.grid.explain(&scratch.unit, &mut scratch.explained);
    scratch.starts.clear();
    let starts = &mut scratch.starts;
    frame.grid.peaks(&scratch.explained, |share, line| starts.push(Start { explained: f64::from(share), line }));
    scratch.starts.extend(best_steps(frame, &scratch.values).into_iter().flatten());
    scratch.starts.sort_unstable_by(|a, b| b.explained.total_cmp(&a.explained));
}

/// Writes the values of the grid's samples, shifted to mean 0 and scaled to length 1; 0 if all are equal.
fn fill_unit(samples: &[usize], values: &[f64], unit: &mut Vec<f32>) {
    let sampled = || samples.iter().map(|&n| values[n]);
    let mean = sampled().sum::<f64>() / samples.len() as f64;
    let length = sampled().map(|y| (y - mean).powi(2)).sum::<f64>().sqrt();
    let per_length = if length > 0.0 { 1.0 / length } else { 0.0 };
    unit.clear();
    unit.extend(sampled().map(|y| ((y - mean) * per_length) as f32));
}

fn descend_all(
    frame: &SampleFrame,
    samples: &Samples<'_>,
    total: f64,
    starts: &[Start],
    scratch: &mut logistic::LogisticScratch,
) -> EvaluatedLine {
    let descend_from = |start: &Start, rival: Option<&EvaluatedLine>, scratch: &mut logistic::LogisticScratch| {
        let initial = EvaluatedLine::evaluate(samples, &frame.limits, start.line, scratch);
        descend::descend(samples, &frame.limits, initial, rival, scratch)
    };
    let mut best = descend_from(&starts[0], None, scratch);
    for start in &starts[1..starts.len().min(STARTS)] {
        // Curves within GRID_ANGLE of the start are at least at this angle from y.
        let angle = (start.explained.clamp(0.0, 1.0).sqrt().acos() - GRID_ANGLE).max(0.0);
        if best.is_exact(samples) || angle.sin().powi(2) * total >= best.sums.residual {
            break;
        }
        let trial = descend_from(start, Some(&best), scratch);
        if trial.sums.residual < best.sums.residual {
            best = trial;
        }
    }
    best
}

/// Converts a line and its sums to the parameters of a curve in the caller's units.
fn to_input_units(frame: &SampleFrame, best: &EvaluatedLine, mean: f64, scale: f64) -> LogisticCurve {
    let (line, sums) = (best.line, best.sums);
    let (low, high) = (mean - scale * (sums.q * sums.mean), mean + scale * (sums.q * (1.0 - sums.mean)));
    let (a, d) = if line.rise < 0.0 { (high, low) } else { (low, high) };
    let c = frame.x(line.origin - line.level / line.rise);
    LogisticCurve { a, b: frame.over_ln(line.rise.abs()), c, d, rms: 0.0, status: Status::Fitted }
}

fn classify(frame: &SampleFrame, best: &EvaluatedLine) -> Status {
    // Values lie between −1 and 1.
    if best.sums.q.abs() > 2.0 * OPEN_HEIGHT {
        return Status::Open;
    }
    let slope = |&v: &f64| {
        let e = (-best.line.value(v).abs()).exp();
        e / (1.0 + e).powi(2)
    };
    let between = frame.positions.iter().map(slope).filter(|&slope| slope > PLATEAU_SLOPE).count();
    if between <= 1 { Status::Step } else { Status::Fitted }
}

/// Product of a step's rise and the width of its gap. The samples beside the step lie on the plateaus to 4 digits, but
/// a descent still has a gradient.
const STEEPNESS: f64 = 8.0;
/// Maximum gap, in v, that a step spans, because x = 0 lies at v = −10³⁰.
const MAX_GAP: f64 = 2.0;

/// Start of a descent, and the fraction of y's variance that the curve there or nearby explains.
#[derive(Clone, Copy, Debug)]
pub(super) struct Start {
    pub(super) explained: f64,
    pub(super) line: Line,
}

/// Returns starts for curves so steep that they are steps: the best step between two samples, and the best step with
/// one sample on its slope. `y` is sorted by x and has mean 0 and length 1.
pub(super) fn best_steps(frame: &SampleFrame, y: &[f64]) -> [Option<Start>; 2] {
    let (ends, positions) = (&frame.ends, &frame.positions);
    let count = y.len() as f64;
    let mut steps: [Option<Start>; 2] = [None; 2];
    let mut keep = |n: usize, explained: f64, line: &dyn Fn() -> Line| {
        if steps[n].is_none_or(|step| step.explained < explained) {
            steps[n] = Some(Start { explained, line: line() });
        }
    };
    let (mut sum_before, mut start) = (0.0, 0);
    for k in 0..positions.len() - 1 {
        let inside: f64 = y[start..ends[k]].iter().sum();
        let (left, width, right) = (start as f64, (ends[k] - start) as f64, count - ends[k] as f64);
        let sum_after = -(sum_before + inside);
        if k > 0 {
            let (low, middle, high) = (sum_before / left, inside / width, sum_after / right);
            let fraction = (middle - high) / (low - high);
            if fraction > 0.0 && fraction < 1.0 {
                let explained = sum_before * low + inside * middle + sum_after * high;
                let gap = (positions[k] - positions[k - 1]).min(positions[k + 1] - positions[k]);
                keep(1, explained, &|| {
                    let level = (fraction / (1.0 - fraction)).ln();
                    Line { level, rise: -2.0 * (STEEPNESS + level.abs()) / gap, origin: positions[k] }
                });
            }
        }
        sum_before += inside;
        start = ends[k];
        let explained = sum_before * sum_before / start as f64 + sum_after * sum_after / right;
        let gap = (positions[k + 1] - positions[k]).min(MAX_GAP);
        keep(0, explained, &|| Line { level: 0.0, rise: -STEEPNESS / gap, origin: positions[k + 1] - 0.5 * gap });
    }
    steps
}
