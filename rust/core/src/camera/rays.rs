//! The rays of a view, prepared: what depends on the camera alone is computed once.

use glam::DVec3;

/// The rays of a view as functions of the image position.
#[derive(Clone, Copy, Debug)]
pub struct Rays {
    pub(super) start: DVec3,
    pub(super) start_steps: [DVec3; 2],
    pub(super) direction: DVec3,
    pub(super) direction_steps: [DVec3; 2],
    pub(super) parallel: bool,
    pub(super) pixel_size: f64,
}

/// How wide a pixel is across its ray, by the distance along the ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Footprint {
    /// Metres at the ray's start.
    pub width: f32,
    /// Metres for each metre of the ray.
    pub spread: f32,
}

impl Footprint {
    /// Metres across the ray at a distance.
    #[inline]
    pub fn at(&self, distance: f32) -> f32 {
        self.width + self.spread * distance
    }
}

impl Rays {
    /// Start (relative to the camera's position) and unit direction through image position (x, y).
    #[inline]
    pub fn at(&self, x: f64, y: f64) -> (DVec3, DVec3) {
        let start = self.start + self.start_steps[0] * x + self.start_steps[1] * y;
        (start, self.longer(x, y).normalize())
    }

    /// Footprint of a square of `scale` pixels a side at image position (x, y). A pixel of size p at one metre ahead,
    /// seen at angle θ off the axis, covers the solid angle p² cos³ θ; the footprint is its root.
    #[inline]
    pub fn footprint(&self, x: f64, y: f64, scale: f64) -> Footprint {
        let size = (self.pixel_size * scale) as f32;
        if self.parallel {
            return Footprint { width: size, spread: 0.0 };
        }
        let secant = self.longer(x, y).as_vec3().length();
        Footprint { width: 0.0, spread: size / (secant * secant.sqrt()) }
    }

    /// Least angle between neighbouring pixels' rays at image position (x, y), radians: away from the axis, where a
    /// tangent of the angle θ grows with 1/cos² θ. For perspective views.
    #[inline]
    pub fn pixel_angle(&self, x: f64, y: f64) -> f64 {
        self.pixel_size / self.longer(x, y).length_squared()
    }

    #[inline]
    fn longer(&self, x: f64, y: f64) -> DVec3 {
        self.direction + self.direction_steps[0] * x + self.direction_steps[1] * y
    }
}
