//! Cameras: where from, which way, and how directions fall on pixels.

use glam::{DQuat, DVec3};

use crate::base::{Error, Result};
use crate::cubemap::direction_from_face;

/// Four bounds of a view: tangents of the half angles for a perspective view, metres for an orthographic one.
/// Left and down are negative in the symmetric case; asymmetric is the general one.
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

/// How a view's directions fall on its image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// Pinhole; bounds are tangents.
    Perspective(Fov),
    /// Parallel rays along the viewing direction; bounds are metres.
    Orthographic(Fov),
    /// Face 0..6 of a cube map (+x −x +y −y +z −z) in world axes; the orientation is not used.
    CubeFace(u8),
}

/// A view: position in the scene's world, orientation camera→world, looking along −z with y up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// World position, metres.
    pub position: DVec3,
    /// Unit quaternion camera→world.
    pub orientation: DQuat,
    /// Bounds of the view.
    pub projection: Projection,
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
}

/// Greatest width or height of an image.
pub const MAX_SIZE: u32 = 1 << 16;

impl Camera {
    /// Checks a view: finite position, unit quaternion, non-empty image and bounds.
    pub fn new(position: DVec3, orientation: DQuat, projection: Projection, width: u32, height: u32) -> Result<Self> {
        if !position.is_finite() {
            return Err(Error::value("position", "three finite numbers", position));
        }
        if !orientation.is_finite() || (orientation.length() - 1.0).abs() > 1e-6 {
            return Err(Error::value("orientation", "a unit quaternion (x, y, z, w)", orientation));
        }
        if !(1..=MAX_SIZE).contains(&width) || !(1..=MAX_SIZE).contains(&height) {
            return Err(Error::value(
                "size",
                format!("1 to {MAX_SIZE} pixels each way"),
                format!("({width}, {height})"),
            ));
        }
        match projection {
            Projection::CubeFace(face) if face > 5 || width != height => {
                return Err(Error::value("fov", "a cube face 0 to 5 with a square image", format!("{face}")));
            }
            Projection::Perspective(fov) | Projection::Orthographic(fov) => fov.validate()?,
            Projection::CubeFace(_) => {}
        }
        Ok(Self { position, orientation: orientation.normalize(), projection, width, height })
    }

    /// Start (relative to `position`) and direction (not normalised) of the ray through image position (x, y) in
    /// pixels: (0.5, 0.5) is the centre of the top left pixel.
    #[inline]
    pub fn ray(&self, x: f64, y: f64) -> (DVec3, DVec3) {
        let (s, t) = (x / f64::from(self.width), y / f64::from(self.height));
        match self.projection {
            Projection::Perspective(fov) => (DVec3::ZERO, self.orientation * fov.at(s, t).extend(-1.0)),
            Projection::Orthographic(fov) => {
                (self.orientation * fov.at(s, t).extend(0.0), self.orientation * DVec3::NEG_Z)
            }
            Projection::CubeFace(face) => (DVec3::ZERO, direction_from_face(face, 2.0 * s - 1.0, 2.0 * t - 1.0)),
        }
    }

    /// Size of a pixel: metres for parallel rays, tangent units (metres at one metre ahead) for the others; the
    /// geometric mean of its sides.
    pub fn pixel_size(&self) -> f64 {
        let pixels = f64::from(self.width) * f64::from(self.height);
        match self.projection {
            Projection::Perspective(fov) | Projection::Orthographic(fov) => (fov.area() / pixels).sqrt(),
            Projection::CubeFace(_) => 2.0 / f64::from(self.width),
        }
    }

    /// True where all rays are parallel.
    pub fn is_parallel(&self) -> bool {
        matches!(self.projection, Projection::Orthographic(_))
    }
}

impl Fov {
    /// Point of the image plane at fractions (s, t) from the left and the top.
    #[inline]
    fn at(&self, s: f64, t: f64) -> glam::DVec2 {
        glam::DVec2::new(self.left + (self.right - self.left) * s, self.up + (self.down - self.up) * t)
    }

    fn area(&self) -> f64 {
        (self.right - self.left) * (self.up - self.down)
    }

    fn validate(&self) -> Result<()> {
        let finite = [self.left, self.right, self.down, self.up].iter().all(|x| x.is_finite() && x.abs() < 1e9);
        if finite && self.left < self.right && self.down < self.up {
            return Ok(());
        }
        Err(Error::value("fov", "finite bounds with left < right and down < up", format!("{self:?}")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FOV: Fov = Fov { left: -1.0, right: 0.5, down: -0.25, up: 0.75 };

    #[test]
    fn corners_of_an_asymmetric_view() {
        let camera = Camera::new(DVec3::ZERO, DQuat::IDENTITY, Projection::Perspective(FOV), 30, 20).unwrap();
        assert_eq!(camera.ray(0.0, 0.0).1, DVec3::new(-1.0, 0.75, -1.0));
        assert_eq!(camera.ray(30.0, 20.0).1, DVec3::new(0.5, -0.25, -1.0));
        assert!((camera.pixel_size() - 0.05).abs() < 1e-15);
    }

    #[test]
    fn refuses_what_is_no_view() {
        let view = |projection, w, h| Camera::new(DVec3::ZERO, DQuat::IDENTITY, projection, w, h);
        assert!(view(Projection::Perspective(FOV), 0, 5).is_err());
        assert!(view(Projection::CubeFace(6), 4, 4).is_err());
        assert!(view(Projection::CubeFace(0), 4, 5).is_err());
        assert!(view(Projection::Perspective(Fov { left: 1.0, ..FOV }), 4, 4).is_err());
        assert!(view(Projection::Orthographic(Fov { up: f64::NAN, ..FOV }), 4, 4).is_err());
        assert!(Camera::new(DVec3::NAN, DQuat::IDENTITY, Projection::CubeFace(0), 4, 4).is_err());
        let double = DQuat::from_xyzw(0.0, 0.0, 0.0, 2.0);
        assert!(Camera::new(DVec3::ZERO, double, Projection::CubeFace(0), 4, 4).is_err());
    }
}
