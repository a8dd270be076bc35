//! Start points for curves so steep that they are steps between two samples, or steps with one sample on the slope.

use super::frame::SampleFrame;
use super::logistic::Line;

/// Product of rise and the narrower gap: the samples beside the step lie on the plateaus to 4 digits, and a descent
/// still has a gradient.
const STEEP: f64 = 8.0;
/// Maximum gap, in v, that a step may span: x = 0 lies at v = −10³⁰.
const FIRST_STEP: f64 = 2.0;

/// Start of a descent, and the fraction of y that is explained there or nearby.
#[derive(Clone, Copy, Debug)]
pub(super) struct Start {
    pub(super) explained: f64,
    pub(super) line: Line,
}

/// Returns the best step and the best step with a sample on its slope. `y`, by ascending x, has mean 0 and length 1.
pub(super) fn best(frame: &SampleFrame, y: &[f64]) -> [Option<Start>; 2] {
    let (ends, places) = (&frame.ends, &frame.places);
    let count = y.len() as f64;
    let mut steps: [Option<Start>; 2] = [None; 2];
    let mut keep = |n: usize, explained: f64, line: &dyn Fn() -> Line| {
        if steps[n].is_none_or(|step| step.explained < explained) {
            steps[n] = Some(Start { explained, line: line() });
        }
    };
    let (mut sum_before, mut start) = (0.0, 0);
    for k in 0..places.len() - 1 {
        let inside: f64 = y[start..ends[k]].iter().sum();
        let (left, width, right) = (start as f64, (ends[k] - start) as f64, count - ends[k] as f64);
        let sum_after = -(sum_before + inside);
        if k > 0 {
            let (low, middle, high) = (sum_before / left, inside / width, sum_after / right);
            let fraction = (middle - high) / (low - high);
            if fraction > 0.0 && fraction < 1.0 {
                let explained = sum_before * low + inside * middle + sum_after * high;
                let gap = (places[k] - places[k - 1]).min(places[k + 1] - places[k]);
                keep(1, explained, &|| {
                    let level = (fraction / (1.0 - fraction)).ln();
                    Line { level, rise: -2.0 * (STEEP + level.abs()) / gap, origin: places[k] }
                });
            }
        }
        sum_before += inside;
        start = ends[k];
        let explained = sum_before * sum_before / start as f64 + sum_after * sum_after / right;
        let gap = (places[k + 1] - places[k]).min(FIRST_STEP);
        keep(0, explained, &|| Line { level: 0.0, rise: -STEEP / gap, origin: places[k + 1] - 0.5 * gap });
    }
    steps
}
