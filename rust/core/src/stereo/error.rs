//! Error of hybrid pictures: distance of displayed points beyond the plane from their true image positions.
//!
//! A point P at depth z is displayed at the point of the plane m through which the third camera sees it.
//! For an eye at p without rotation, which would see P at the tangent a, the error is (Fink et al., Fig. 2)
//!
//! Δ = (a s − p) (z − m) / ((z + s) m),
//!
//! linear in a. It grows with the depth, and is largest at the nasal edge. In a zone, a depth d replaces m.

use glam::{DMat3, DVec2, DVec3};
use rayon::prelude::*;

use super::rig::{Rig, Side};
use crate::base::{Progress, Result, ensure};

/// Measured component of an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Horizontal component.
    Horizontal,
    /// Vertical component.
    Vertical,
    /// Length.
    Both,
}

impl Axis {
    fn component(self, error: DVec2) -> f64 {
        match self {
            Self::Horizontal => error.x.abs(),
            Self::Vertical => error.y.abs(),
            Self::Both => error.length(),
        }
    }
}

/// Sample positions across a view for an error that is not linear. Between them it changes by less than a thousandth.
const SAMPLES_PER_AXIS: usize = 33;
/// Sine of half the angle above which an eye counts as rotated; rounding is below it.
const MIN_ROTATION: f64 = 1e-9;

impl Rig {
    /// Returns the tangents at which an eye's picture shows a point whose true position is `true_tangents`, at a depth
    /// in metres from the plane of the eyes; the depth may be infinite.
    pub fn displayed_tangents(&self, side: Side, true_tangents: DVec2, depth: f64) -> DVec2 {
        let eye = self.eye(side);
        let (turn, p) = (DMat3::from_quat(eye.orientation), eye.position);
        let slope = tangents(turn * true_tangents.extend(-1.0));
        let d = self.depth_shown(depth);
        if d == depth {
            return true_tangents;
        }
        let from_eye = if depth.is_finite() {
            self.place_shown(p + (slope * (depth + p.z)).extend(-depth - p.z), d) - p
        } else {
            (slope * (d + self.setback) - p.truncate()).extend(-d - p.z)
        };
        tangents(turn.transpose() * from_eye)
    }

    /// Returns the depth d at which a point of depth z is displayed, on its line to the third camera.
    ///
    /// d is z up to m₁ and m from m₂ on. Between, 1/d = u + (u₁ − u)²/(2 (u₁ − u₂)) with u = 1/z. Image positions are
    /// linear in u, so straight lines become parabolas, which begin and end without a kink.
    pub(super) fn depth_shown(&self, z: f64) -> f64 {
        let planes = self.planes;
        if z <= planes.begin {
            return z;
        }
        if z >= planes.end {
            return planes.mono();
        }
        let [u, first, last] = [z, planes.begin, planes.end].map(f64::recip);
        (u + (first - u).powi(2) / (2.0 * (first - last))).recip()
    }

    /// Returns the point at depth d on the third camera's line through a point; relative to the middle, head axes.
    pub(super) fn place_shown(&self, point: DVec3, d: f64) -> DVec3 {
        let s = self.setback;
        (point.truncate() * ((d + s) / (s - point.z))).extend(-d)
    }

    /// Returns the error in pixels, to the right and upwards, of a point whose true position is `true_tangents`.
    pub fn error(&self, side: Side, true_tangents: DVec2, depth: f64) -> DVec2 {
        (self.displayed_tangents(side, true_tangents, depth) - true_tangents) * self.pixels_per_tangent(side)
    }

    /// Returns the maximum error over both eyes, pixels.
    pub fn max_error(&self, depth: f64, axis: Axis) -> Result<f64> {
        check_depth(depth)?;
        let max_of_eye = |side: Side| {
            let eye = self.eye(side);
            // An error that is linear in the tangents is largest at a corner.
            let is_rotated = eye.orientation.xyz().length() > MIN_ROTATION;
            let count = if is_rotated { SAMPLES_PER_AXIS } else { 2 };
            let fraction = |n: usize| n as f64 / (count - 1) as f64;
            let fov = eye.fov;
            let errors = (0..count * count).map(|n| {
                let x = fov.left + (fov.right - fov.left) * fraction(n % count);
                let y = fov.down + (fov.up - fov.down) * fraction(n / count);
                axis.component(self.error(side, DVec2::new(x, y), depth))
            });
            errors.fold(0.0, f64::max)
        };
        Ok(max_of_eye(Side::Left).max(max_of_eye(Side::Right)))
    }

    /// Writes errors in pixels, to the right and upwards, at the centres of an eye's pixels, in row-major order.
    pub fn error_field(&self, side: Side, depth: f64, field: &mut [[f64; 2]], progress: &Progress) -> Result<()> {
        check_depth(depth)?;
        let (width, height) = self.size;
        let fov = self.eye(side).fov;
        field.par_chunks_mut(width as usize).enumerate().try_for_each(|(row, errors)| {
            let y = fov.up + (fov.down - fov.up) * (row as f64 + 0.5) / f64::from(height);
            for (column, error) in errors.iter_mut().enumerate() {
                let x = fov.left + (fov.right - fov.left) * (column as f64 + 0.5) / f64::from(width);
                *error = self.error(side, DVec2::new(x, y), depth).to_array();
            }
            progress.check()
        })
    }

    /// Returns the pixels of an eye's picture per unit of tangent, horizontally and vertically.
    pub fn pixels_per_tangent(&self, side: Side) -> DVec2 {
        let (fov, (width, height)) = (self.eye(side).fov, self.size);
        DVec2::new(f64::from(width) / (fov.right - fov.left), f64::from(height) / (fov.up - fov.down))
    }
}

/// Returns the tangents of a direction that looks along −z.
pub(super) fn tangents(direction: DVec3) -> DVec2 {
    direction.truncate() / -direction.z
}

fn check_depth(depth: f64) -> Result<()> {
    ensure!(depth > 0.0, "depth", "a distance above 0 metres, or infinity", depth);
    Ok(())
}
