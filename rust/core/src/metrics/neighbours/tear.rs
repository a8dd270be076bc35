//! Tear map of a frame: residuals of the least-squares affine maps of neighbourhoods.

use std::ops::Range;

use glam::{DMat2, DVec2, DVec3};
use rayon::prelude::*;

use super::points::{BANDS, LANES, REPORTED_POINTS, Target, TruthPoints};
use crate::base::memory::{try_vec, try_with_capacity};
use crate::base::simd::vectorized;
use crate::base::{Progress, Real, Result};
use crate::camera::Camera;

/// Root-mean-square residual of the best affine map of a unit disc that is torn by one pixel along a diameter. The step
/// and x have variances of ¼ and a covariance of 2/(3π), so a fit to x leaves √(¼ − 4 (2/(3π))²).
const UNIT_STEP: f64 = 0.264_335_868_4;

/// Neighbours summed per vector operation.
const WIDE: usize = 8;
/// Ratio of the variances across and along a line below which neighbours count as collinear up to float32's rounding.
const COLLINEAR_SPREAD: f64 = 1e-9;

/// Per-pixel flags that select pixels and mark the border.
#[derive(Clone, Copy, Default)]
pub struct Border<'a> {
    /// Side of a border that each pixel's surface lies on, such as whether ρ > r₂.
    pub side: Option<&'a [bool]>,
    /// Pixels to compute; by default all.
    pub mask: Option<&'a [bool]>,
}

/// Tears of a frame's pixels.
pub struct Tears {
    /// Tear in pixels, rows of the frame's width; NaN for pixels outside the mask, without a surface, behind the
    /// truth's camera, or without neighbours.
    pub tear: Vec<f32>,
    /// Whether a pixel's neighbourhood has surfaces on both sides of the border; empty if no sides were given.
    pub spans_sides: Vec<bool>,
}

/// Computes the tear of each pixel of a frame. Positions are relative to `origin`; ε is in pixels of the truth.
pub fn tear(
    position: &[[f32; 3]],
    origin: DVec3,
    width: usize,
    truth: &Camera,
    epsilon: f64,
    border: Border<'_>,
    progress: &Progress,
) -> Result<Tears> {
    let points = TruthPoints::new(position, origin, width, truth, epsilon, progress)?;
    progress.expect(points.len() as u64);
    // With padding for a vector's lanes, as in the points.
    let mut sides = try_vec(0.0f32, points.len() + LANES)?;
    if let Some(side) = border.side {
        points.pixel.iter().zip(&mut sides).for_each(|(&pixel, slot)| *slot = f32::from(side[pixel as usize]));
    }
    let band_moments = |band: usize| {
        let own = points.bands[band].1.clone();
        let (before, behind) = points.bands.split_at(band);
        let near = before.iter().rev().take(BANDS + 1).chain(behind.iter().take(BANDS + 2));
        let targets = points.targets(band, near, epsilon);
        let mut moments = try_with_capacity(own.len())?;
        for from in own.clone().step_by(REPORTED_POINTS) {
            let source = from..own.end.min(from + REPORTED_POINTS);
            progress.report(source.len() as u64)?;
            gather(&points, &sides, border.mask, source, &targets, epsilon as f32, &mut moments);
        }
        Ok(moments)
    };
    let moments: Vec<Vec<Moments>> =
        (0..points.bands.len()).into_par_iter().map(band_moments).collect::<Result<_>>()?;
    let mut tears = Tears {
        tear: try_vec(f32::NAN, position.len())?,
        spans_sides: try_vec(false, if border.side.is_some() { position.len() } else { 0 })?,
    };
    for (n, moments) in moments.iter().flatten().enumerate() {
        let pixel = points.pixel[n] as usize;
        if moments.count > 1.0 {
            tears.tear[pixel] = (moments.residual() / UNIT_STEP) as f32;
        }
        if let Some(spans_sides) = tears.spans_sides.get_mut(pixel) {
            *spans_sides = moments.side > 0.0 && moments.side < moments.count;
        }
    }
    Ok(tears)
}

vectorized! {
    fn gather(
        points: &TruthPoints,
        sides: &[f32],
        mask: Option<&[bool]>,
        source: Range<usize>,
        targets: &[Target],
        epsilon: f32,
        moments: &mut Vec<Moments>,
    ) = fused moments_kernel;
}

/// Computes the moments of some of a band's points.
#[inline(always)]
fn moments_kernel<const FUSED: bool>(
    points: &TruthPoints,
    sides: &[f32],
    mask: Option<&[bool]>,
    source: Range<usize>,
    targets: &[Target],
    epsilon: f32,
    moments: &mut Vec<Moments>,
) {
    for n in source {
        if mask.is_some_and(|mask| !mask[points.pixel[n] as usize]) {
            moments.push(Moments::default());
            continue;
        }
        let truth = points.truth_x[n];
        let mut sums = [[0.0; WIDE]; TERMS];
        for target in targets {
            let near = &points.truth_x[target.range.clone()];
            // Widened by more than float32's rounding, which matters at positions of millions of pixels.
            let reach = target.reach + 1e-6 * truth.abs();
            let from = target.range.start + near.partition_point(|&x| x < truth - reach);
            let to = target.range.start + near.partition_point(|&x| x <= truth + reach);
            let mut start = from;
            while start < to {
                add_terms::<FUSED>(&mut sums, points, sides, [start, to - start, n], epsilon * epsilon);
                start += WIDE;
            }
        }
        moments.push(Moments::new(sums));
    }
}

/// Sums over a pixel and its neighbours of positions in the truth and of shifts from the picture to the truth, both
/// relative to the pixel's own. An affine fit has the same residual for the shifts as for the positions in the picture.
#[derive(Clone, Copy, Debug, Default)]
struct Moments {
    count: f64,
    /// Number of points on the far side of the border.
    side: f64,
    position: DVec2,
    shift: DVec2,
    /// u², uv, v² of positions.
    position_squares: [f64; 3],
    /// |shift|².
    shift_squares: f64,
    /// Shifts times u, and times v.
    mixed: [DVec2; 2],
}

impl Moments {
    /// Creates moments from terms summed per lane.
    fn new(sums: [[f64; WIDE]; TERMS]) -> Self {
        let [count, side, u, v, x, y, uu, uv, vv, shift_squares, ux, uy, vx, vy] = sums.map(|lanes| lanes.iter().sum());
        let (position, shift) = (DVec2::new(u, v), DVec2::new(x, y));
        let mixed = [DVec2::new(ux, uy), DVec2::new(vx, vy)];
        Self { count, side, position, shift, position_squares: [uu, uv, vv], shift_squares, mixed }
    }

    /// Returns the root-mean-square residual of the best affine map.
    fn residual(&self) -> f64 {
        let (mean, mean_shift) = (self.position / self.count, self.shift / self.count);
        let [uu, uv, vv] = self.position_squares.map(|sum| sum / self.count);
        let [uu, uv, vv] = [uu - mean.x * mean.x, uv - mean.x * mean.y, vv - mean.y * mean.y];
        let covariance = DMat2::from_cols_array(&[uu, uv, uv, vv]);
        let variance = self.shift_squares / self.count - mean_shift.length_squared();
        let [by_u, by_v] = [0, 1].map(|axis| self.mixed[axis] / self.count - mean[axis] * mean_shift);
        let mixed = [DVec2::new(by_u.x, by_v.x), DVec2::new(by_u.y, by_v.y)];
        let explained: f64 = mixed.map(|mixed| mixed.dot(solve(covariance, mixed))).iter().sum();
        (variance - explained).max(0.0).sqrt()
    }
}

/// Returns the minimum-norm x with S x = c; S is symmetric, and c lies in its range.
fn solve(covariance: DMat2, mixed: DVec2) -> DVec2 {
    let (trace, determinant) = (covariance.x_axis.x + covariance.y_axis.y, covariance.determinant());
    if trace <= 0.0 {
        return DVec2::ZERO;
    }
    if determinant > COLLINEAR_SPREAD * trace * trace {
        return covariance.inverse() * mixed;
    }
    // All points are collinear: S = trace · e eᵀ.
    mixed / trace
}

/// Number of terms of moments: count, side, u, v, x, y, u², uv, v², x² + y², ux, uy, vx, vy, with (u, v) a position and
/// (x, y) a shift.
const TERMS: usize = 14;

/// Adds the terms of the points among `length` points from `start` on whose squared distance from point `n` is below
/// `max_squared`.
#[inline(always)]
fn add_terms<const FUSED: bool>(
    sums: &mut [[f64; WIDE]; TERMS],
    points: &TruthPoints,
    sides: &[f32],
    [start, length, n]: [usize; 3],
    max_squared: f32,
) {
    let lanes =
        [&points.x, &points.y, &points.shift_x, &points.shift_y].map(|values| values[start..].first_chunk::<WIDE>());
    let ([Some(x), Some(y), Some(shift_x), Some(shift_y)], Some(side)) = (lanes, sides[start..].first_chunk::<WIDE>())
    else {
        return;
    };
    let (own_x, own_y, own_shift) = (points.x[n], points.y[n], [points.shift_x[n], points.shift_y[n]]);
    for lane in 0..WIDE {
        let (dx, dy) = (shift_x[lane] - own_shift[0], shift_y[lane] - own_shift[1]);
        let (u, v) = ((x[lane] - own_x) + dx, (y[lane] - own_y) + dy);
        let is_near = (f32::fuse::<FUSED>(u, u, v * v) < max_squared) & (lane < length);
        let weight = if is_near { 1.0 } else { 0.0 };
        let [u, v, x, y] = [u, v, dx, dy].map(|value| if is_near { f64::from(value) } else { 0.0 });
        let side = weight * f64::from(side[lane]);
        let terms = [weight, side, u, v, x, y, u * u, u * v, v * v, x * x + y * y, u * x, u * y, v * x, v * y];
        for (sum, term) in sums.iter_mut().zip(terms) {
            sum[lane] += term;
        }
    }
}
