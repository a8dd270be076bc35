//! Views: position, orientation, projection (the mapping from image points to ray directions) and pixels.

use glam::{DMat3, DQuat, DVec2, DVec3};
use rayon::prelude::*;

use super::cube_face::direction_from_face;
use super::rays::Rays;
use crate::base::mapped::write_mapped;
use crate::base::{Progress, Result, ensure, memory::room_for, number};

/// Bounds of a view: tangents of angles from the axis for a perspective view, metres for an orthographic view. They
/// need not be symmetric; in a symmetric view left and down are negative.
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

impl Projection {
    /// Returns the bounds; for a cube face they are tangents.
    pub(super) fn fov(self) -> Fov {
        match self {
            Self::Perspective(fov) | Self::Orthographic(fov) => fov,
            Self::CubeFace(_) => Fov { left: -1.0, right: 1.0, down: -1.0, up: 1.0 },
        }
    }
}

impl Fov {
    /// Returns the image-plane point at the fractions s from the left and t from the top.
    #[inline]
    pub fn point(&self, s: f64, t: f64) -> DVec2 {
        DVec2::new(self.left + (self.right - self.left) * s, self.up + (self.down - self.up) * t)
    }

    fn area(&self) -> f64 {
        (self.right - self.left) * (self.up - self.down)
    }

    pub(super) fn validate(&self) -> Result<()> {
        let finite = [self.left, self.right, self.down, self.up].iter().all(|x| x.is_finite() && x.abs() < 1e9);
        let is_valid = finite && self.left < self.right && self.down < self.up;
        let [left, right, down, up] = [self.left, self.right, self.down, self.up].map(number);
        let got = format!("left {left}, right {right}, down {down}, up {up}");
        ensure!(is_valid, "fov", "bounds within ±1e9 with left < right and down < up", got);
        Ok(())
    }
}

/// A view. In its own frame it looks along −z, with y up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// World position, metres.
    pub position: DVec3,
    /// Unit quaternion camera→world.
    pub orientation: DQuat,
    /// Projection, with the bounds of the view.
    pub projection: Projection,
    /// Width of the image, pixels.
    pub width: u32,
    /// Height of the image, pixels.
    pub height: u32,
}

/// Maximum width or height of an image, pixels.
pub const MAX_SIZE: u32 = 1 << 16;

impl Camera {
    /// Creates a view; fails unless the position is finite, the quaternion a unit, and image and bounds not empty.
    pub fn new(position: DVec3, orientation: DQuat, projection: Projection, width: u32, height: u32) -> Result<Self> {
        ensure!(position.is_finite(), "position", "three finite numbers", position);
        let is_unit = orientation.is_finite() && (orientation.length() - 1.0).abs() <= 1e-6;
        ensure!(is_unit, "orientation", "a unit quaternion (x, y, z, w)", orientation);
        let has_pixels = [width, height].iter().all(|size| (1..=MAX_SIZE).contains(size));
        ensure!(has_pixels, "size", format!("1 to {MAX_SIZE} pixels each way"), format!("({width}, {height})"));
        if let Projection::CubeFace(face) = projection {
            ensure!(face <= 5 && width == height, "fov", "a cube face 0 to 5 with a square image", face);
        }
        projection.fov().validate()?;
        Ok(Self { position, orientation: orientation.normalize(), projection, width, height })
    }

    /// Returns the start (relative to `position`) and direction (not normalised) of the ray through image position (x,
    /// y) in pixels; (0.5, 0.5) is the centre of the top left pixel.
    #[inline]
    pub fn ray(&self, x: f64, y: f64) -> (DVec3, DVec3) {
        let (s, t) = (x / f64::from(self.width), y / f64::from(self.height));
        match self.projection {
            Projection::Perspective(fov) => (DVec3::ZERO, self.orientation * fov.point(s, t).extend(-1.0)),
            Projection::Orthographic(fov) => {
                (self.orientation * fov.point(s, t).extend(0.0), self.orientation * DVec3::NEG_Z)
            }
            Projection::CubeFace(face) => (DVec3::ZERO, direction_from_face(face, 2.0 * s - 1.0, 2.0 * t - 1.0)),
        }
    }

    /// Prepares all rays of the view.
    pub fn rays(&self) -> Rays {
        let (start, direction) = self.ray(0.0, 0.0);
        let (right, down) = (self.ray(1.0, 0.0), self.ray(0.0, 1.0));
        Rays {
            start,
            start_steps: [right.0 - start, down.0 - start],
            direction,
            direction_steps: [right.1 - direction, down.1 - direction],
            parallel: self.is_parallel(),
            pixel_size: self.pixel_size(),
        }
    }

    /// Writes world starts and unit directions of the rays through all pixel centres, in row-major order.
    pub fn pixel_rays(&self, starts: &mut [[f64; 3]], directions: &mut [[f64; 3]], progress: &Progress) -> Result<()> {
        let (rays, width) = (self.rays(), self.width as usize);
        let rows = starts.par_chunks_mut(width).zip(directions.par_chunks_mut(width)).enumerate();
        rows.try_for_each(|(row, (starts, directions))| {
            for (column, (start, direction)) in starts.iter_mut().zip(directions).enumerate() {
                let (from, to) = rays.ray(column as f64 + 0.5, row as f64 + 0.5);
                (*start, *direction) = ((self.position + from).to_array(), to.to_array());
            }
            progress.check()
        })
    }

    /// Fails if the results of `pixel_rays` do not fit into memory.
    pub fn room_for_rays(&self) -> Result<()> {
        room_for(2 * size_of::<DVec3>() as u64 * u64::from(self.width) * u64::from(self.height))
    }

    /// Projects many points; NaN for points behind the camera.
    pub fn project_all(&self, points: &[[f64; 3]], projected: &mut [[f64; 3]], progress: &Progress) -> Result<()> {
        let project = |point: &[f64; 3]| self.project((*point).into()).unwrap_or(DVec3::NAN).to_array();
        write_mapped(points, projected, project, progress)
    }

    /// Returns the image position (x, y) in pixels and the distance along the viewing axis; `None` behind the camera.
    pub fn project(&self, point: DVec3) -> Option<DVec3> {
        let offset = point - self.position;
        let axes = match self.projection {
            Projection::CubeFace(face) => {
                let forward = direction_from_face(face, 0.0, 0.0);
                let (right, down) = (direction_from_face(face, 1.0, 0.0), direction_from_face(face, 0.0, 1.0));
                DMat3::from_cols(right - forward, forward - down, -forward)
            }
            _ => DMat3::from_quat(self.orientation),
        };
        let local = axes.transpose() * offset;
        let depth = -local.z;
        let plane = local.truncate();
        let fov = self.projection.fov();
        let point = if self.is_parallel() { plane } else { plane / depth };
        let s = (point.x - fov.left) / (fov.right - fov.left);
        let t = (fov.up - point.y) / (fov.up - fov.down);
        (depth > 0.0).then(|| DVec3::new(s * f64::from(self.width), t * f64::from(self.height), depth))
    }

    /// Returns the geometric mean of a pixel's sides: metres for parallel rays, otherwise tangents.
    pub fn pixel_size(&self) -> f64 {
        let pixels = f64::from(self.width) * f64::from(self.height);
        match self.projection {
            Projection::Perspective(fov) | Projection::Orthographic(fov) => (fov.area() / pixels).sqrt(),
            Projection::CubeFace(_) => 2.0 / f64::from(self.width),
        }
    }

    /// Returns a lower bound of the angle between neighbouring pixels, in radians; for parallel rays, of their distance
    /// in metres. Pixels at the view's corner subtend the smallest angle.
    pub fn least_pixel_angle(&self) -> f64 {
        let (width, height) = (f64::from(self.width), f64::from(self.height));
        match self.projection {
            Projection::Perspective(fov) => {
                let (x, y) = (fov.left.abs().max(fov.right.abs()), fov.down.abs().max(fov.up.abs()));
                let narrowest = ((fov.right - fov.left) / width).min((fov.up - fov.down) / height);
                // At an angle θ from the axis, a small change of the tangent turns the ray by cos² θ times the change;
                // at the corner cos² θ = 1/(1 + x² + y²).
                narrowest / (1.0 + x * x + y * y)
            }
            Projection::Orthographic(fov) => ((fov.right - fov.left) / width).min((fov.up - fov.down) / height),
            Projection::CubeFace(_) => 2.0 / width / 3.0,
        }
    }

    /// Returns whether all rays are parallel.
    pub fn is_parallel(&self) -> bool {
        matches!(self.projection, Projection::Orthographic(_))
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
    fn prepared_rays_and_projection_agree_with_single_rays() {
        let turned = DQuat::from_euler(glam::EulerRot::YXZ, 0.7, -0.3, 1.1);
        let faces = (0..6).map(Projection::CubeFace);
        let position = DVec3::new(1e5, -3.0, 7.0);
        for projection in faces.chain([Projection::Perspective(FOV), Projection::Orthographic(FOV)]) {
            let camera = Camera::new(position, turned, projection, 24, 24).unwrap();
            let rays = camera.rays();
            for (x, y) in [(0.0, 0.0), (24.0, 0.0), (3.25, 20.5), (12.0, 12.0)] {
                let (start, direction) = camera.ray(x, y);
                let (fast_start, fast_direction) = rays.ray(x, y);
                // A few float64 roundings of numbers near 1.
                assert!((fast_start - start).length() < 1e-14);
                assert!((fast_direction - direction.normalize()).length() < 1e-14);
                let back = camera.project(position + start + direction * 5.0).unwrap();
                // The world position at 10⁵ m is rounded to 1.5e-11 m, times 24 pixels per 1.5 units at 5 m.
                assert!((back - DVec3::new(x, y, 5.0)).length() < 1e-9, "{projection:?} {back}");
                assert!(camera.project(position + start - direction).is_none());
            }
        }
    }

    #[test]
    fn footprints_add_up_to_the_solid_angle() {
        let camera = Camera::new(DVec3::ZERO, DQuat::IDENTITY, Projection::CubeFace(2), 64, 64).unwrap();
        let rays = camera.rays();
        let pixels = (0..64 * 64).map(|i| (f64::from(i % 64) + 0.5, f64::from(i / 64) + 0.5));
        let sum: f64 = pixels.map(|(x, y)| f64::from(rays.footprint(x, y, 1.0).spread).powi(2)).sum();
        // The error of the midpoint rule over 64² pixels is 1/(24 · 64²) times the curvature, about 1e-4.
        assert!((sum - 4.0 * std::f64::consts::PI / 6.0).abs() < 3e-4, "{sum}");
    }

    #[test]
    fn invalid_views_are_refused() {
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
