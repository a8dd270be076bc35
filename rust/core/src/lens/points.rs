//! Distortion of points, with the tangential terms of decentred lenses.
//!
//! Brown (1966): x_d = x (1 + k₁r² + …) + 2p₁xy + p₂(r² + 2x²), y_d = y (1 + k₁r² + …) + p₁(r² + 2y²) + 2p₂xy.

use glam::{DMat2, DVec2};
use rayon::prelude::*;

use super::inverse::LANES;
use super::polynomial;
use super::radial::RadialLens;
use crate::base::simd::vectorized;
use crate::base::{Error, Progress, Real, Result};

/// Number of points in one task; their data fits in the first-level cache.
pub(super) const CHUNK: usize = 1 << 9;
/// Bound of a radius' relative rounding error: two squares, their sum, its root, and the scaling of points.
pub(super) const ROUNDINGS: f64 = 8.0 * f64::EPSILON;
/// Maximum number of steps of Newton's method, which needs five from a good start.
const NEWTON_STEPS: u32 = 40;
/// Number of steps from the disc's centre to the target, for points at which Newton's method fails from its start.
const PATH_PARTS: u32 = 64;

/// Points of a task as arrays: x, y, radius, and radius after the distortion or its inverse.
#[repr(align(64))]
pub(super) struct PointChunk {
    x: [f64; CHUNK],
    y: [f64; CHUNK],
    radius: [f64; CHUNK],
    mapped_radius: [f64; CHUNK],
}

impl PointChunk {
    pub(super) fn new<T: Real>(points: &[[T; 2]]) -> Self {
        let mut chunk = Self { x: [0.0; CHUNK], y: [0.0; CHUNK], radius: [0.0; CHUNK], mapped_radius: [0.0; CHUNK] };
        for (n, [x, y]) in points.iter().enumerate() {
            (chunk.x[n], chunk.y[n]) = (x.wide(), y.wide());
        }
        measure(&mut chunk, points.len().next_multiple_of(LANES));
        chunk
    }

    /// Moves points along their radii to the radii that `radii` computes.
    pub(super) fn scale_radii<T: Real>(&mut self, to: &mut [[T; 2]], radii: impl FnOnce(&mut [f64])) {
        let count = to.len().next_multiple_of(LANES);
        radii(&mut self.mapped_radius[..count]);
        scale(self, count);
        for (n, to) in to.iter_mut().enumerate() {
            *to = [T::narrow(self.x[n]), T::narrow(self.y[n])];
        }
    }
}

vectorized! {
    fn measure(chunk: &mut PointChunk, count: usize) = measure_all;
    fn scale(chunk: &mut PointChunk, count: usize) = scale_all;
}

#[inline(always)]
fn measure_all(chunk: &mut PointChunk, count: usize) {
    for n in 0..count.min(CHUNK) {
        chunk.radius[n] = (chunk.x[n] * chunk.x[n] + chunk.y[n] * chunk.y[n]).sqrt();
    }
    chunk.mapped_radius = chunk.radius;
}

#[inline(always)]
fn scale_all(chunk: &mut PointChunk, count: usize) {
    for n in 0..count.min(CHUNK) {
        let factor = if chunk.radius[n] == 0.0 { 1.0 } else { chunk.mapped_radius[n] / chunk.radius[n] };
        chunk.x[n] *= factor;
        chunk.y[n] *= factor;
    }
}

impl RadialLens {
    /// Writes the distorted points. Points outside the disc of radius `reach` give NaN, or an error if `refuse`.
    pub fn distort_points<T: Real>(
        &self,
        points: &[[T; 2]],
        to: &mut [[T; 2]],
        refuse: bool,
        progress: &Progress,
    ) -> Result<()> {
        let radii = |radii: &mut [f64]| self.distort_blocks(radii);
        let tangential =
            |p: DVec2, _, _| if p.length() <= self.reach { self.value_and_jacobian(p).0 } else { DVec2::NAN };
        self.each_point(points, to, refuse, progress, radii, tangential)
    }

    /// Writes the undistorted points. NaN, or an error if `refuse`, if no point in the disc of radius `reach` is distorted to
    /// the given one.
    pub fn undistort_points<T: Real>(
        &self,
        points: &[[T; 2]],
        to: &mut [[T; 2]],
        refuse: bool,
        progress: &Progress,
    ) -> Result<()> {
        let radii = |radii: &mut [f64]| self.undistort_blocks(radii, true, ROUNDINGS + 2.0 * T::SLACK);
        let tangential = |p, radius, root| self.undistort_point(p, radius, root);
        self.each_point(points, to, refuse, progress, radii, tangential)
    }

    /// Moves points along their radii to the radii that `radii` computes. If the lens has tangential terms,
    /// `tangential` computes the result from the point, its radius, and the radius that `radii` computed.
    fn each_point<T: Real>(
        &self,
        points: &[[T; 2]],
        to: &mut [[T; 2]],
        refuse: bool,
        progress: &Progress,
        radii: impl Fn(&mut [f64]) + Sync,
        tangential: impl Fn(DVec2, f64, f64) -> DVec2 + Sync,
    ) -> Result<()> {
        let is_undefined = |[x, y]: &[T; 2]| (x.wide() + y.wide()).is_nan();
        let chunks = points.par_chunks(CHUNK).zip(to.par_chunks_mut(CHUNK)).map(|(from, to)| {
            let mut chunk = PointChunk::new(from);
            chunk.scale_radii(to, &radii);
            if self.tangential != [0.0; 2] {
                for (n, to) in to.iter_mut().enumerate() {
                    let p = DVec2::new(from[n][0].wide(), from[n][1].wide());
                    *to = tangential(p, chunk.radius[n], chunk.mapped_radius[n]).to_array().map(T::narrow);
                }
            }
            progress.check().map(|()| refuse && to.iter().any(is_undefined))
        });
        let is_refused = chunks.try_reduce(|| false, |a, b| Ok(a | b))?;
        let first = if is_refused { to.iter().position(is_undefined) } else { None };
        let Some(index) = first else { return Ok(()) };
        let expected = format!("points of the lens's image, within r = {}", self.reach);
        let [x, y] = points[index];
        Err(Error::value("points", expected, format!("({}, {}) at index {index}", x.wide(), y.wide())))
    }

    /// Returns the displacement of a point by the tangential terms.
    fn tangential_at(&self, p: DVec2) -> DVec2 {
        let [p1, p2] = self.tangential;
        let (square, product) = (p.length_squared(), 2.0 * p.x * p.y);
        DVec2::new(p1 * product + p2 * (square + 2.0 * p.x * p.x), p1 * (square + 2.0 * p.y * p.y) + p2 * product)
    }

    /// Returns the distorted point, and the Jacobian there.
    fn value_and_jacobian(&self, p: DVec2) -> (DVec2, DMat2) {
        let square = p.length_squared();
        let factor = 1.0 + square * polynomial::value(&self.radial.k, square);
        // With s = r² and F(s) = f(r)/r: f′(r) = F + 2 s dF/ds.
        let growth = if square > 0.0 { (polynomial::value(&self.radial.slope, square) - factor) / square } else { 0.0 };
        let [p1, p2] = self.tangential;
        let mixed = growth * p.x * p.y + 2.0 * (p1 * p.x + p2 * p.y);
        let columns = DMat2::from_cols_array(&[
            factor + growth * p.x * p.x + 2.0 * p1 * p.y + 6.0 * p2 * p.x,
            mixed,
            mixed,
            factor + growth * p.y * p.y + 6.0 * p1 * p.y + 2.0 * p2 * p.x,
        ]);
        (p * factor + self.tangential_at(p), columns)
    }

    /// Returns the root in the disc, of which there is at most one; NaN if there is none. The search begins at `root`,
    /// the radius without tangential terms.
    fn undistort_point(&self, target: DVec2, r: f64, root: f64) -> DVec2 {
        if !target.is_finite() {
            return DVec2::NAN;
        }
        let max_radius = 0.999 * self.reach.min(f64::MAX);
        let root = if root.is_nan() { max_radius } else { root };
        let start = if r == 0.0 { target } else { target * (root / r) }.clamp_length_max(max_radius);
        // If Newton's method fails from the start, the target moves in steps from the disc's centre, whose root is 0.
        let target_at = |part: u32| target * (f64::from(part) / f64::from(PATH_PARTS));
        let follow_path = || (1..=PATH_PARTS).try_fold(DVec2::ZERO, |p, part| self.descend(p, target_at(part)));
        self.descend(start, target).or_else(follow_path).unwrap_or(DVec2::NAN)
    }

    /// Finds a root by Newton's method. Steps are shortened until they reduce the residual and stay in the disc.
    fn descend(&self, mut p: DVec2, target: DVec2) -> Option<DVec2> {
        let (mut image, mut jacobian) = self.value_and_jacobian(p);
        'steps: for _ in 0..NEWTON_STEPS {
            let residual = image - target;
            let step = jacobian.inverse() * residual;
            if step.length() <= f64::EPSILON * p.length() || residual == DVec2::ZERO {
                break;
            }
            let mut fraction = 1.0;
            // If no fraction of the step reduces the residual, the point is a root, or at the disc's border.
            while fraction >= 1e-3 {
                let next = p - fraction * step;
                let (next_image, next_jacobian) = self.value_and_jacobian(next);
                if next.length() <= self.reach && (next_image - target).length() < residual.length() {
                    (p, image, jacobian) = (next, next_image, next_jacobian);
                    continue 'steps;
                }
                fraction *= 0.5;
            }
            break;
        }
        // The residual of a root is below a hundred float64 roundings of the largest term.
        let square = p.length_squared();
        let terms = self.radial.k.iter().rev().fold(0.0, |sum, c| (sum + c.abs()) * square) + 1.0;
        let is_root = (image - target).length() <= 100.0 * f64::EPSILON * terms * p.length().max(target.length());
        is_root.then_some(p)
    }
}
