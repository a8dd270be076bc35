//! Enumeration of all pairs of neighbours, each once.

use std::ops::Range;

use super::neighbourhood::Neighbourhood;
use super::points::{BANDS, LANES, TruthPoints, reach};
use crate::base::simd::vectorized;
use crate::base::{Progress, Real, Result};

/// Points between two reports of progress.
const REPORTED_POINTS: usize = 1 << 10;

/// Sums over the pairs of a task's points with later points, for both points of each pair.
pub(super) struct PairSums {
    /// The task's points; the sums also cover later points that its pairs reach.
    pub own: Range<usize>,
    /// Sums of |p − q| / |p₀(p) − p₀(q)| − 1.
    excess: Vec<f32>,
    count: Vec<f32>,
}

impl PairSums {
    pub fn new(points: &TruthPoints, bands: Range<usize>, around: Neighbourhood, progress: &Progress) -> Result<Self> {
        let own = points.bands[bands.start].1.start..points.bands[bands.end - 1].1.end;
        let last = points.bands.len().min(bands.end + BANDS) - 1;
        let room = points.bands[last].1.end - own.start + LANES;
        let mut sums = Self { own, excess: vec![0.0; room], count: vec![0.0; room] };
        for band in bands {
            let (targets, count) = targets(points, band, around.epsilon);
            let limits = [around.epsilon, around.least].map(|limit| (limit * limit) as f32);
            let band = points.bands[band].1.clone();
            // One band may hold all points of a picture, so progress is reported, and cancellation checked, within it.
            for from in band.clone().step_by(REPORTED_POINTS) {
                let source = from..band.end.min(from + REPORTED_POINTS);
                add_pairs(points, source.clone(), &targets[..count], limits, &mut sums);
                progress.report(source.len() as u64)?;
            }
        }
        Ok(sums)
    }

    /// Returns the end of the points that have sums.
    pub fn end(&self) -> usize {
        self.own.start + self.excess.len() - LANES
    }

    /// Returns the sum over a point's pairs and their number.
    pub fn point_sums(&self, n: usize) -> (f32, f32) {
        (self.excess[n - self.own.start], self.count[n - self.own.start])
    }
}

/// Points of a band that may be neighbours: their x in the truth differs by at most `reach`.
#[derive(Clone, Default)]
struct Target {
    range: Range<usize>,
    reach: f32,
}

/// Returns the bands that may contain neighbours of a band's points: itself and later ones.
fn targets(points: &TruthPoints, band: usize, epsilon: f64) -> ([Target; BANDS + 1], usize) {
    let mut targets: [Target; BANDS + 1] = Default::default();
    let mut count = 0;
    let number = points.bands[band].0;
    for (other, range) in points.bands[band..].iter().take(BANDS + 1) {
        let Some(reach) = reach(other.abs_diff(number), epsilon) else { break };
        targets[count] = Target { range: range.clone(), reach };
        count += 1;
    }
    (targets, count)
}

vectorized! {
    fn add_pairs(points: &TruthPoints, source: Range<usize>, targets: &[Target], limits: [f32; 2], sums: &mut PairSums) = fused pairs;
}

/// Adds the pairs of some points; per band, a window of points within reach slides along x.
#[inline(always)]
fn pairs<const FUSED: bool>(
    points: &TruthPoints,
    source: Range<usize>,
    targets: &[Target],
    limits: [f32; 2],
    sums: &mut PairSums,
) {
    let mut windows = [[0usize; 2]; BANDS + 1];
    for (window, target) in windows.iter_mut().zip(targets) {
        let first = points.truth_x[source.start] - target.reach - 1e-6 * points.truth_x[source.start].abs();
        let near = &points.truth_x[target.range.clone()];
        *window = [target.range.start + near.partition_point(|&x| x < first); 2];
    }
    for n in source {
        let of = [points.x[n], points.y[n], points.shift_x[n], points.shift_y[n]];
        let truth = points.truth_x[n];
        // float32 steps at positions of millions of pixels.
        let rounding = 1e-6 * truth.abs();
        let (mut excess, mut count) = ([0.0f32; LANES], [0.0f32; LANES]);
        for (band, target) in targets.iter().enumerate() {
            let [mut from, mut to] = windows[band];
            let reach = target.reach + rounding;
            if band == 0 {
                from = n + 1;
            } else {
                while from < target.range.end && points.truth_x[from] < truth - reach {
                    from += 1;
                }
            }
            to = to.max(from);
            while to < target.range.end && points.truth_x[to] <= truth + reach {
                to += 1;
            }
            windows[band] = [from, to];
            let mut at = from;
            while at + LANES <= to {
                block::<FUSED, true>(points, at, LANES, of, limits, sums, &mut excess, &mut count);
                at += LANES;
            }
            if at < to {
                block::<FUSED, false>(points, at, to - at, of, limits, sums, &mut excess, &mut count);
            }
        }
        let here = n - sums.own.start;
        for lane in 0..LANES {
            sums.excess[here] += excess[lane];
            sums.count[here] += count[lane];
        }
    }
}

/// Adds the pairs of one point with `few` neighbours (a full vector if `WHOLE`).
#[inline(always)]
#[expect(clippy::too_many_arguments, reason = "what stays in registers")]
fn block<const FUSED: bool, const WHOLE: bool>(
    points: &TruthPoints,
    at: usize,
    few: usize,
    of: [f32; 4],
    [farthest, least]: [f32; 2],
    sums: &mut PairSums,
    excess: &mut [f32; LANES],
    count: &mut [f32; LANES],
) {
    let lanes = [
        points.x[at..].first_chunk::<LANES>(),
        points.y[at..].first_chunk::<LANES>(),
        points.shift_x[at..].first_chunk::<LANES>(),
        points.shift_y[at..].first_chunk::<LANES>(),
    ];
    let [Some(x), Some(y), Some(shift_x), Some(shift_y)] = lanes else { return };
    let there = at - sums.own.start;
    let (Some(their_excess), Some(their_count)) =
        (sums.excess[there..].first_chunk_mut::<LANES>(), sums.count[there..].first_chunk_mut::<LANES>())
    else {
        return;
    };
    for lane in 0..LANES {
        let (dx, dy) = (x[lane] - of[0], y[lane] - of[1]);
        let (u, v) = (dx + (shift_x[lane] - of[2]), dy + (shift_y[lane] - of[3]));
        let shown = f32::fuse::<FUSED>(dx, dx, dy * dy);
        let truth = f32::fuse::<FUSED>(u, u, v * v);
        let raised = if truth > least { truth } else { least };
        // √(shown / raised), without a division.
        let torn = f32::fuse::<FUSED>(shown, inverse_root::<FUSED>(shown * raised), -1.0);
        let counts = (truth < farthest) & (WHOLE || lane < few);
        let (torn, one) = (if counts { torn } else { 0.0 }, if counts { 1.0 } else { 0.0 });
        excess[lane] += torn;
        count[lane] += one;
        their_excess[lane] += torn;
        their_count[lane] += one;
    }
}

/// Returns 1/√a to two ulps: a guess from the exponent's bits, and three Newton steps. Vector division and square root
/// take longer.
#[inline(always)]
fn inverse_root<const FUSED: bool>(a: f32) -> f32 {
    let half = -0.5 * a;
    let mut y = f32::from_bits(0x5f37_59df - (a.to_bits() >> 1));
    for _ in 0..3 {
        y *= f32::fuse::<FUSED>(half * y, y, 1.5);
    }
    y
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverse_roots_are_exact_to_two_units() {
        for exponent in -60..60 {
            for step in 0..64 {
                let a = (1.0 + step as f32 / 64.0) * (exponent as f32).exp2();
                let exact = 1.0 / f64::from(a).sqrt();
                for found in [inverse_root::<true>(a), inverse_root::<false>(a)] {
                    assert!((f64::from(found) / exact - 1.0).abs() < 2.0 * f64::from(f32::EPSILON), "{a}");
                }
            }
        }
    }
}
