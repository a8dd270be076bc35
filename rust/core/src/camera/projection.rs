//! Projections: mappings from image points to ray directions.

use glam::DVec2;

use crate::base::{Error, Result};

/// Bounds of a view: tangents of half angles for a perspective view, metres for an orthographic view. They need not be
/// symmetric; in the symmetric case left and down are negative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fov {
    /// Leftmost x.
    pub left: f64,
    /// Rightmost x.
    pub right: f64,
    /// Lowest y.
    pub down: f64,
    /// Highest y.
    pub up: f64,
}

/// The projection of a view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// Pinhole camera; the bounds are tangents.
    Perspective(Fov),
    /// Parallel rays along the viewing direction; the bounds are metres.
    Orthographic(Fov),
    /// Face 0 to 5 of a cube map (+x −x +y −y +z −z) in world axes; the camera's orientation is not used.
    CubeFace(u8),
}

impl Fov {
    /// Returns the image-plane point at the fractions s from the left and t from the top.
    #[inline]
    pub(super) fn point(&self, s: f64, t: f64) -> DVec2 {
        DVec2::new(self.left + (self.right - self.left) * s, self.up + (self.down - self.up) * t)
    }

    pub(super) fn area(&self) -> f64 {
        (self.right - self.left) * (self.up - self.down)
    }

    pub(super) fn validate(&self) -> Result<()> {
        let finite = [self.left, self.right, self.down, self.up].iter().all(|x| x.is_finite() && x.abs() < 1e9);
        if finite && self.left < self.right && self.down < self.up {
            return Ok(());
        }
        Err(Error::value("fov", "bounds within ±1e9 with left < right and down < up", format!("{self:?}")))
    }
}
