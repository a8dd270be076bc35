//! Rays of a view. Values that depend only on the camera are computed once.

use glam::DVec3;

/// Rays of a view as functions of the image position.
#[derive(Clone, Copy, Debug)]
pub struct Rays {
    pub(crate) start: DVec3,
    pub(crate) start_steps: [DVec3; 2],
    pub(crate) direction: DVec3,
    pub(crate) direction_steps: [DVec3; 2],
    pub(super) parallel: bool,
    pub(super) pixel_size: f64,
}

/// Width of a pixel, perpendicular to its ray, as a linear function of the distance along the ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Footprint {
    /// Width at the ray's start, metres.
    pub width: f32,
    /// Increase of the width per metre of distance.
    pub spread: f32,
}

impl Footprint {
    /// Returns the width at a distance, metres.
    #[inline]
    pub fn width_at(&self, distance: f32) -> f32 {
        self.width + self.spread * distance
    }
}

impl Rays {
    /// Returns the start, relative to the camera, and the unit direction of the ray through image position (x, y).
    #[inline]
    pub fn ray(&self, x: f64, y: f64) -> (DVec3, DVec3) {
        let start = self.start + self.start_steps[0] * x + self.start_steps[1] * y;
        (start, self.direction_at(x, y).normalize())
    }

    /// Returns the footprint of a square of `scale` × `scale` pixels at image position (x, y). A pixel of size p on the
    /// image plane at distance 1, at an angle θ from the axis, covers the solid angle p² cos³ θ; the footprint per
    /// metre of distance is its square root.
    #[inline]
    pub fn footprint(&self, x: f64, y: f64, scale: f64) -> Footprint {
        let size = (self.pixel_size * scale) as f32;
        if self.parallel {
            return Footprint { width: size, spread: 0.0 };
        }
        let secant = self.direction_at(x, y).as_vec3().length();
        Footprint { width: 0.0, spread: size / (secant * secant.sqrt()) }
    }

    /// Returns the minimum angle in radians between the rays of neighbouring pixels at image position (x, y) of a
    /// perspective view. At an angle θ from the axis it is proportional to cos² θ, the derivative of θ by tan θ.
    #[inline]
    pub fn pixel_angle(&self, x: f64, y: f64) -> f64 {
        self.pixel_size / self.direction_at(x, y).length_squared()
    }

    #[inline]
    fn direction_at(&self, x: f64, y: f64) -> DVec3 {
        self.direction + self.direction_steps[0] * x + self.direction_steps[1] * y
    }
}
