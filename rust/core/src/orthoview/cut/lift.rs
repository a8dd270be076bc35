//! Viewing directions raised towards the zenith.

use glam::DVec3;

use crate::base::{Error, Result};

/// Sine of the angle from straight down within which a direction has no defined azimuth.
const STRAIGHT: f64 = 1e-9;

/// An angle by which directions are raised towards +y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lift {
    sine: f64,
    cosine: f64,
}

impl Lift {
    /// Creates a lift from an angle in degrees, 0 to 90.
    pub fn new(degrees: f64) -> Result<Self> {
        if !(0.0..=90.0).contains(&degrees) {
            return Err(Error::value("lift_deg", "a number from 0 to 90", degrees));
        }
        let (sine, cosine) = degrees.to_radians().sin_cos();
        Ok(Self { sine, cosine })
    }

    /// Rotates a unit vector by the angle towards +y, at most to +y. A vector straight down stays, because it has no
    /// azimuth.
    pub fn raised(self, way: DVec3) -> DVec3 {
        let flat = way.x.hypot(way.z);
        if self.sine == 0.0 || (flat < STRAIGHT && way.y < 0.0) {
            return way;
        }
        let across = flat * self.cosine - way.y * self.sine;
        if across <= 0.0 {
            return DVec3::Y;
        }
        DVec3::new(way.x / flat * across, way.y * self.cosine + flat * self.sine, way.z / flat * across)
    }
}
