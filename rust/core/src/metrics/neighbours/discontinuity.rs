//! Discontinuity map δ of a frame.

use std::ops::Range;

use glam::DVec3;
use rayon::prelude::*;

use super::points::{BANDS, LANES, REPORTED_POINTS, Target, TruthPoints, check_pixels};
use crate::base::memory::try_vec;
use crate::base::simd::vectorized;
use crate::base::{Progress, Real, Result};
use crate::camera::Camera;

/// Bands of points per task. Pairs reach as many bands beyond them.
const GROUP: usize = BANDS;

/// Neighbourhood radius, and the resolution of the truth.
#[derive(Clone, Copy, Debug)]
pub struct Neighbourhood {
    /// ε: distance in the truth within which points are neighbours, pixels.
    pub epsilon: f64,
    /// Resolution of the truth: smaller distances are raised to it, pixels.
    pub least: f64,
}

/// Returns δ for each pixel of a frame, rows of `width`; NaN for pixels without a surface, behind the truth's camera,
/// or without neighbours. Positions are relative to `origin`.
pub fn discontinuity(
    position: &[[f32; 3]],
    origin: DVec3,
    width: usize,
    truth: &Camera,
    neighbourhood: Neighbourhood,
    progress: &Progress,
) -> Result<Vec<f32>> {
    let Neighbourhood { epsilon, least } = neighbourhood;
    check_pixels("min_distance", least)?;
    let points = TruthPoints::new(position, origin, width, truth, epsilon, progress)?;
    progress.expect(points.len() as u64);
    let groups: Vec<usize> = (0..points.bands.len()).step_by(GROUP).collect();
    // Each pair is visited once and counts for both points, so a task's sums extend into the next task's bands.
    let sums = |&first: &usize| {
        let bands = first..points.bands.len().min(first + GROUP);
        PairSums::new(&points, bands, neighbourhood, progress)
    };
    let sums: Vec<PairSums> = groups.par_iter().map(sums).collect::<Result<_>>()?;
    let mut image = try_vec(f32::NAN, position.len())?;
    for (number, group) in sums.iter().enumerate() {
        progress.check()?;
        let previous = number.checked_sub(1).map(|number| &sums[number]);
        for n in group.own_points.clone() {
            let (excess, count) = group.point_sums(n);
            let (previous_excess, previous_count) = match previous {
                Some(previous) if n < previous.end() => previous.point_sums(n),
                _ => (0.0, 0.0),
            };
            if previous_count + count > 0.0 {
                image[points.pixel[n] as usize] = (previous_excess + excess) / (previous_count + count);
            }
        }
    }
    Ok(image)
}

/// Sums over the pairs of a task's points with later points, for both points of each pair.
struct PairSums {
    /// The task's points; the sums also cover later points that its pairs reach.
    own_points: Range<usize>,
    /// Sums of |p − q| / |p₀(p) − p₀(q)| − 1.
    excess: Vec<f32>,
    count: Vec<f32>,
}

impl PairSums {
    fn new(points: &TruthPoints, bands: Range<usize>, around: Neighbourhood, progress: &Progress) -> Result<Self> {
        let own_points = points.bands[bands.start].1.start..points.bands[bands.end - 1].1.end;
        let last = points.bands.len().min(bands.end + BANDS) - 1;
        let length = points.bands[last].1.end - own_points.start + LANES;
        let mut sums = Self { own_points, excess: try_vec(0.0, length)?, count: try_vec(0.0, length)? };
        for band in bands {
            // The band itself and later bands; earlier bands count their pairs with this one.
            let targets = points.targets(band, points.bands[band..].iter().take(BANDS + 1), around.epsilon);
            let limits = [around.epsilon, around.least].map(|limit| (limit * limit) as f32);
            let band = points.bands[band].1.clone();
            // A single band may have all points of a picture, so cancellation is checked within bands.
            for from in band.clone().step_by(REPORTED_POINTS) {
                let source = from..band.end.min(from + REPORTED_POINTS);
                add_pairs(points, source.clone(), &targets, limits, &mut sums);
                progress.report(source.len() as u64)?;
            }
        }
        Ok(sums)
    }

    /// Returns the end of the points that have sums.
    fn end(&self) -> usize {
        self.own_points.start + self.excess.len() - LANES
    }

    /// Returns the sum over a point's pairs and their number.
    fn point_sums(&self, n: usize) -> (f32, f32) {
        (self.excess[n - self.own_points.start], self.count[n - self.own_points.start])
    }
}

vectorized! {
    fn add_pairs(points: &TruthPoints, source: Range<usize>, targets: &[Target], limits: [f32; 2], sums: &mut PairSums) = fused pairs;
}

/// Adds the pairs of some points. In each band, the window of points within reach slides along x.
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
        let point = [points.x[n], points.y[n], points.shift_x[n], points.shift_y[n]];
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
            let mut start = from;
            while start + LANES <= to {
                block::<FUSED, true>(points, start, LANES, point, limits, sums, &mut excess, &mut count);
                start += LANES;
            }
            if start < to {
                block::<FUSED, false>(points, start, to - start, point, limits, sums, &mut excess, &mut count);
            }
        }
        let own = n - sums.own_points.start;
        for lane in 0..LANES {
            sums.excess[own] += excess[lane];
            sums.count[own] += count[lane];
        }
    }
}

/// Adds the pairs of one point with `length` neighbours (a full vector if `IS_FULL`).
#[inline(always)]
#[expect(clippy::too_many_arguments, reason = "arguments that stay in registers")]
fn block<const FUSED: bool, const IS_FULL: bool>(
    points: &TruthPoints,
    start: usize,
    length: usize,
    point: [f32; 4],
    [max_squared, min_squared]: [f32; 2],
    sums: &mut PairSums,
    excess: &mut [f32; LANES],
    count: &mut [f32; LANES],
) {
    let lanes = [
        points.x[start..].first_chunk::<LANES>(),
        points.y[start..].first_chunk::<LANES>(),
        points.shift_x[start..].first_chunk::<LANES>(),
        points.shift_y[start..].first_chunk::<LANES>(),
    ];
    let [Some(x), Some(y), Some(shift_x), Some(shift_y)] = lanes else { return };
    let offset = start - sums.own_points.start;
    let (Some(other_excess), Some(other_count)) =
        (sums.excess[offset..].first_chunk_mut::<LANES>(), sums.count[offset..].first_chunk_mut::<LANES>())
    else {
        return;
    };
    for lane in 0..LANES {
        let (dx, dy) = (x[lane] - point[0], y[lane] - point[1]);
        let (u, v) = (dx + (shift_x[lane] - point[2]), dy + (shift_y[lane] - point[3]));
        let picture_squared = f32::fuse::<FUSED>(dx, dx, dy * dy);
        let truth_squared = f32::fuse::<FUSED>(u, u, v * v);
        let raised = if truth_squared > min_squared { truth_squared } else { min_squared };
        // √(picture_squared / raised), without a division.
        let excess_term = f32::fuse::<FUSED>(picture_squared, inverse_root::<FUSED>(picture_squared * raised), -1.0);
        let is_pair = (truth_squared < max_squared) & (IS_FULL || lane < length);
        let (excess_term, count_term) = (if is_pair { excess_term } else { 0.0 }, if is_pair { 1.0 } else { 0.0 });
        excess[lane] += excess_term;
        count[lane] += count_term;
        other_excess[lane] += excess_term;
        other_count[lane] += count_term;
    }
}

/// Returns 1/√a to two ulps by a guess from the exponent's bits and three Newton steps, which take less time than
/// vector division and square root.
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
