//! Cells, and the orthographic cameras that look at them.

use glam::DVec3;

use super::direction::Frame;
use crate::base::{Result, ensure};
use crate::camera::{Camera, Fov, Projection};
use crate::render::{Limits, Segment};

/// Tolerance for surfaces at a cell's sides, in float32 roundings of the largest coordinate. It covers the roundings of
/// a corner, of a ray's start and of a ray's length (up to √3 sides).
const MARGIN: f64 = 8.0;

/// A cubic cell of the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// Minimum corner, metres.
    pub corner: DVec3,
    /// Side length, metres.
    pub side: f64,
}

impl Cell {
    /// Creates a cell; checks corner and side.
    pub fn new(corner: DVec3, side: f64) -> Result<Self> {
        let is_valid = corner.is_finite() && side.is_finite() && side > 0.0;
        ensure!(is_valid, "cell", "a finite corner and a side above 0", format!("{corner}, {side}"));
        Ok(Self { corner, side })
    }

    /// Returns the maximum error of surface positions in the cell, metres. Kernels round distances, and positions
    /// relative to the scene's `origin`, to float32.
    pub fn margin(&self, origin: DVec3) -> f64 {
        let (low, high) = (self.corner - origin, self.corner + self.side - origin);
        MARGIN * f64::from(f32::EPSILON) * low.abs().max(high.abs()).max_element()
    }

    /// Returns the corners of the cell, grown by the margin so that surfaces on its sides count; world positions.
    pub fn bounds_with_margin(&self, origin: DVec3) -> (DVec3, DVec3) {
        let margin = self.margin(origin);
        (self.corner - margin, self.corner + self.side + margin)
    }

    /// Returns the volume of `bounds_with_margin` as half-spaces (n, d), n·x + d ≥ 0.
    pub fn limits(&self, origin: DVec3) -> Result<Limits> {
        let (low, high) = self.bounds_with_margin(origin);
        let planes: [[f64; 4]; 6] = std::array::from_fn(|n| {
            let axis = n / 2;
            let (sign, offset) = if n % 2 == 0 { (1.0, -low[axis]) } else { (-1.0, high[axis]) };
            let mut plane = [0.0, 0.0, 0.0, offset];
            plane[axis] = sign;
            plane
        });
        Limits::new(Segment::WHOLE, &planes)
    }
}

/// An orthographic camera whose picture covers a cell exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrthoCamera {
    /// Width and height, pixels.
    pub pixels: usize,
    /// Unit vectors to the right, upwards and towards the viewer.
    axes: [DVec3; 3],
    /// Extents of the cell along these axes, metres.
    pub extents: DVec3,
    /// The cell's centre.
    center: DVec3,
    frame: Frame,
}

impl OrthoCamera {
    /// Creates the camera of a cell with the axes of a frame.
    pub fn new(cell: &Cell, frame: Frame, pixels: usize) -> Self {
        let center = cell.corner + cell.side / 2.0;
        Self { pixels, axes: frame.axes(), extents: frame.extents() * cell.side, center, frame }
    }

    /// Returns the direction of all rays.
    pub fn direction(&self) -> DVec3 {
        -self.axes[2]
    }

    /// Returns the larger side of a pixel, metres.
    pub fn pixel(&self) -> f64 {
        self.extents.x.max(self.extents.y) / self.pixels as f64
    }

    /// Returns the camera, located on its near plane, at the front of the depth interval.
    pub fn camera(&self) -> Result<Camera> {
        let half = self.extents / 2.0;
        let fov = Fov { left: -half.x, right: half.x, down: -half.y, up: half.y };
        let (eye, size) = (self.center + self.axes[2] * half.z, self.pixels as u32);
        Camera::new(eye, self.frame.orientation(), Projection::Orthographic(fov), size, size)
    }

    /// Converts a world point to pixels to the right and downwards, and metres behind the front.
    #[inline]
    pub fn project(&self, point: DVec3) -> DVec3 {
        let offset = point - self.center;
        let [right, up, toward] = self.axes.map(|axis| axis.dot(offset));
        let pixels = self.pixels as f64;
        let x = (right / self.extents.x + 0.5) * pixels;
        let y = (0.5 - up / self.extents.y) * pixels;
        DVec3::new(x, y, self.extents.z / 2.0 - toward)
    }

    /// Returns the world point of a pixel's centre at a depth behind the front, metres.
    #[inline]
    pub fn point_of_pixel(&self, pixel: usize, depth: f64) -> DVec3 {
        let (column, row) = (pixel % self.pixels, pixel / self.pixels);
        self.unproject(DVec3::new(column as f64 + 0.5, row as f64 + 0.5, depth))
    }

    /// Converts pixels to the right and downwards, and metres behind the front, to a world point.
    #[inline]
    fn unproject(&self, place: DVec3) -> DVec3 {
        let ([right, up, toward], pixels) = (self.axes, self.pixels as f64);
        let x = (place.x / pixels - 0.5) * self.extents.x;
        let y = (0.5 - place.y / pixels) * self.extents.y;
        self.center + right * x + up * y + toward * (self.extents.z / 2.0 - place.z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::orthoview::Direction;

    #[test]
    fn points_have_the_positions_of_their_cells() {
        let cell = Cell::new(DVec3::new(40.0, -3.0, 7.0), 20.0).unwrap();
        let ortho = OrthoCamera::new(&cell, Direction::new([1, 1, 0]).unwrap().frame(), 64);
        let camera = ortho.camera().unwrap();
        for place in [DVec3::ZERO, DVec3::new(3.25, 60.0, 11.0), DVec3::new(32.0, 32.0, ortho.extents.z / 2.0)] {
            let (start, direction) = camera.rays().ray(place.x, place.y);
            let point = camera.position + start + direction * place.z;
            assert!((ortho.unproject(place) - point).length() < 1e-12, "{place}");
            assert!((ortho.project(point) - place).length() < 1e-12, "{place}");
        }
        assert!((ortho.unproject(DVec3::new(32.0, 32.0, ortho.extents.z / 2.0)) - cell.corner - 10.0).length() < 1e-12);
    }
}
