//! Camera as three linear functions of a point, rectangles of pixels, and a float32 depth order.

use glam::{DMat3, DVec3};

use super::splats::{Extent, Splats};
use crate::camera::Camera;
use crate::render::Limits;

/// Three linear functions (X, Y, W) of points. A perspective camera shows a point at (X/W, Y/W), and W is its distance
/// along the axis. A camera with parallel rays shows it at (X, Y), and W is its distance from the image plane.
///
/// *Nearness* orders points along a ray: 1/W with perspective, −W for parallel rays. It is linear on a plane's image.
#[derive(Clone, Copy, Debug)]
pub(in crate::orthoview) struct Projector {
    /// World position of the eye or, for parallel rays, of the corner of the image plane.
    pub eye: DVec3,
    /// Gradients of X, Y, W by world position.
    pub rows: [DVec3; 3],
    pub is_parallel: bool,
}

/// A rectangle of pixels: first and end columns and rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Rect {
    pub low: [i32; 2],
    pub high: [i32; 2],
}

impl Rect {
    /// Returns the whole picture of a camera.
    pub fn of_camera(camera: &Camera) -> Self {
        Self { low: [0, 0], high: [camera.width as i32, camera.height as i32] }
    }

    /// Divides the rectangle into tiles of at most `side` pixels along each axis, row by row.
    pub fn tiles(&self, side: i32) -> Vec<Self> {
        let starts = |axis: usize| (self.low[axis]..self.high[axis]).step_by(side as usize);
        let tile = |x: i32, y: i32| Self { low: [x, y], high: [x + side, y + side] }.overlap(self);
        starts(1).flat_map(|y| starts(0).map(move |x| tile(x, y))).collect()
    }

    pub fn overlap(&self, other: &Self) -> Self {
        Self {
            low: [0, 1].map(|axis| self.low[axis].max(other.low[axis])),
            high: [0, 1].map(|axis| self.high[axis].min(other.high[axis])),
        }
    }

    pub fn is_empty(&self) -> bool {
        (0..2).any(|axis| self.low[axis] >= self.high[axis])
    }
}

/// Bounds of a part of a view: the image rectangle that may show it, and the nearness of its nearest point.
#[derive(Clone, Copy, Debug)]
pub(super) struct ScreenBounds {
    pub rect: Rect,
    pub nearness: f32,
}

/// Minimum distance along the axis at which a perspective camera shows splats, in pixel extents of their view: nearer
/// splats would cover the whole picture.
const MIN_DISTANCE: f64 = 1.0;

impl Projector {
    /// Creates the projector of a camera.
    pub fn new(camera: &Camera) -> Self {
        let (rays, is_parallel) = (camera.rays(), camera.is_parallel());
        // A point at (x, y) and a distance w: perspective w (x right + y down + ray), parallel start + x right +
        // y down + w ray.
        let [x, y] = if is_parallel { rays.start_steps } else { rays.direction_steps };
        let inverse = DMat3::from_cols(x, y, rays.direction).inverse();
        Self { eye: camera.position + rays.start, rows: [0, 1, 2].map(|n| inverse.row(n)), is_parallel }
    }

    /// Evaluates X, Y, W at a world position.
    pub fn evaluate(&self, place: DVec3) -> [f64; 3] {
        self.rows.map(|row| row.dot(place - self.eye))
    }

    /// Returns the changes of X, Y, W along a vector.
    pub fn derivative(&self, vector: DVec3) -> [f64; 3] {
        self.rows.map(|row| row.dot(vector))
    }

    /// Returns whether a world position lies within limits.
    pub fn is_seen(&self, place: DVec3, limits: &Limits) -> bool {
        let range = if self.is_parallel { self.evaluate(place)[2] } else { place.distance(self.eye) } as f32;
        (limits.segment.t_min..=limits.segment.t_max).contains(&range)
            && limits.planes().iter().all(|plane| plane.truncate().dot(place) + plane.w >= 0.0)
    }

    /// Returns the nearness of a distance W.
    pub fn nearness(&self, distance: f64) -> f64 {
        if self.is_parallel { -distance } else { 1.0 / distance }
    }

    /// Returns the distance W of a nearness.
    pub fn distance(&self, nearness: f64) -> f64 {
        if self.is_parallel { -nearness } else { 1.0 / nearness }
    }
}

/// A view relative to a camera: X, Y, W at its pixels and depth steps.
#[derive(Clone, Copy, Debug)]
pub(super) struct ViewProjection {
    /// X, Y, W at the corner of the first pixel, at depth 0.
    start: [f64; 3],
    /// Changes per column, row and depth step.
    pub steps: [[f64; 3]; 3],
    /// Columns, rows and depth steps by which splats extend beyond their pixels.
    margin: [f64; 3],
    /// Minimum W of visible splats.
    pub min_w: f64,
    is_parallel: bool,
}

impl ViewProjection {
    pub fn new(splats: &Splats, projector: &Projector) -> Self {
        let min_w = MIN_DISTANCE * splats.pitch().truncate().max_element();
        Self {
            start: projector.evaluate(splats.place(0.0, 0.0, 0.0)),
            steps: splats.steps().map(|step| projector.derivative(step)),
            margin: splats.margin(),
            min_w: if projector.is_parallel { 0.0 } else { min_w },
            is_parallel: projector.is_parallel,
        }
    }

    /// Evaluates X, Y, W at a column, a row and a number of depth steps.
    pub fn evaluate(&self, [column, row, depth]: [f64; 3]) -> [f64; 3] {
        let [by_column, by_row, by_depth] = &self.steps;
        [0, 1, 2].map(|n| self.start[n] + column * by_column[n] + row * by_row[n] + depth * by_depth[n])
    }

    /// Returns the bounds of a part of the view on the screen; `None` behind the camera.
    pub fn project_extent(&self, extent: &Extent, picture: &Rect) -> Option<ScreenBounds> {
        let low: [f64; 3] = std::array::from_fn(|axis| f64::from(extent.low[axis]) - self.margin[axis]);
        let high: [f64; 3] = std::array::from_fn(|axis| f64::from(extent.high[axis]) + self.margin[axis]);
        let (mut nearest, mut farthest) = (f64::MAX, f64::MIN);
        let (mut min, mut max) = ([f64::MAX; 2], [f64::MIN; 2]);
        for n in 0..8 {
            let pick = |axis: usize| if n >> axis & 1 == 1 { high[axis] } else { low[axis] };
            let [x, y, w] = self.evaluate([pick(0), pick(1), pick(2)]);
            (nearest, farthest) = (nearest.min(w), farthest.max(w));
            let per_w = if self.is_parallel { 1.0 } else { 1.0 / w };
            (min[0], max[0]) = (min[0].min(x * per_w), max[0].max(x * per_w));
            (min[1], max[1]) = (min[1].min(y * per_w), max[1].max(y * per_w));
        }
        if farthest < self.min_w {
            return None;
        }
        if nearest < self.min_w {
            return Some(ScreenBounds { rect: *picture, nearness: f32::INFINITY });
        }
        // A spare pixel on each side, because the pixel that contains a splat's centre always shows the splat.
        let rect = Rect {
            low: [(min[0] - 1.0) as i32, (min[1] - 1.0) as i32],
            high: [(max[0] + 2.0) as i32, (max[1] + 2.0) as i32],
        };
        let nearness = if self.is_parallel { -nearest } else { 1.0 / nearest };
        // The depth margin is larger than the rounding errors of float32.
        Some(ScreenBounds { rect: rect.overlap(picture), nearness: (nearness as f32).next_up() })
    }
}

/// Returns a number that orders like a float and is never 0.
#[inline(always)]
pub(super) fn sortable_bits(value: f32) -> u32 {
    let bits = value.to_bits() as i32;
    // Flips all bits of negative numbers, otherwise only the sign.
    (bits ^ ((bits >> 31) | i32::MIN)) as u32
}

/// Inverse of `sortable_bits`.
pub(super) fn float_of_bits(number: u32) -> f32 {
    let bits = number as i32;
    f32::from_bits((bits ^ (!(bits >> 31) | i32::MIN)) as u32)
}
