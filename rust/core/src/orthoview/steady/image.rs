//! Pictures with the distances of their surfaces, and homogeneous points, which include the sky.

use glam::{DVec2, DVec3};

use crate::base::{Result, ensure};
use crate::camera::Camera;
use crate::orthoview::splat::Projector;

/// Linear RGB.
pub type Color = [f32; 3];

/// A picture with the distances of its surfaces.
#[derive(Clone, Copy, Debug)]
pub struct Image<'a> {
    /// Its camera.
    pub camera: &'a Camera,
    /// Linear RGB.
    pub color: &'a [Color],
    /// Distance from the camera, metres; +∞ for the sky.
    pub range: &'a [f32],
}

impl Image<'_> {
    pub(super) fn check(&self, name: &'static str) -> Result<()> {
        let count = self.camera.width as usize * self.camera.height as usize;
        for length in [self.color.len(), self.range.len()] {
            ensure!(length == count, name, format!("{count} pixels"), length);
        }
        Ok(())
    }
}

impl Projector {
    /// Evaluates the functions X, Y and W at the homogeneous point (`offset`, `inverse`): the point at
    /// `offset`/`inverse` from the eye, or the sky in the direction of `offset` if `inverse` is 0. Here W is 1 for
    /// parallel rays, so that the camera always shows a point at X/W, Y/W.
    pub(super) fn homogeneous(&self, offset: DVec3, inverse: f64) -> DVec3 {
        let [x, y, w] = self.derivative(offset);
        DVec3::new(x, y, if self.is_parallel { inverse } else { w })
    }

    /// Returns the distance of a point, given its offset from the eye; along the axis for parallel rays.
    pub(super) fn distance_of(&self, offset: DVec3) -> f64 {
        if self.is_parallel { self.rows[2].dot(offset) } else { offset.length() }
    }
}

/// Returns the image position X/W, Y/W in pixels; `None` behind the camera, and for the sky along parallel rays.
pub(super) fn image_position(point: DVec3) -> Option<DVec2> {
    (point.z > 0.0).then(|| point.truncate() / point.z)
}
