//! Pictures with the distances of their surfaces.

use crate::base::{Error, Result};
use crate::camera::Camera;

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
            if length != count {
                return Err(Error::value(name, format!("{count} pixels"), length));
            }
        }
        Ok(())
    }
}
