//! A camera as three linear functions of a point, and a float32 order of what is nearer.

use glam::{DMat3, DVec3};

use super::splats::{Extent, Splats};
use crate::camera::Camera;
use crate::render::Limits;

/// Three linear functions (X, Y, W) of points. A perspective camera shows a point at X/W, Y/W, and W is its distance along
/// the axis; one with parallel rays shows it at X, Y, and W is its distance from the image plane.
///
/// *Nearness* orders points along a ray: 1/W or −W, which on a plane are linear in the place in the picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Projector {
    eye: DVec3,
    /// The functions' gradients, pixels and metres.
    pub rows: [DVec3; 3],
    pub is_parallel: bool,
}

/// A rectangle of pixels: first columns and rows, and those after the last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Rect {
    pub low: [i32; 2],
    pub high: [i32; 2],
}

impl Rect {
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

/// The part of the picture that may show a part of a view, and the nearness of its nearest point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    pub rect: Rect,
    pub nearness: f32,
}

/// Least distance along the axis at which a perspective camera shows splats, in extents of a pixel of their view: nearer
/// ones would cover the whole picture.
const LEAST_DISTANCE: f64 = 1.0;

impl Projector {
    /// The functions of a camera.
    pub fn new(camera: &Camera) -> Self {
        let (start, direction) = camera.ray(0.0, 0.0);
        let (right, down) = (camera.ray(1.0, 0.0), camera.ray(0.0, 1.0));
        let is_parallel = camera.is_parallel();
        // A point at (x, y) and a distance w: perspective w (x right + y down + direction), parallel
        // start + x right + y down + w direction.
        let (eye, columns) = if is_parallel {
            (camera.position + start, [right.0 - start, down.0 - start, direction])
        } else {
            (camera.position, [right.1 - direction, down.1 - direction, direction])
        };
        let [x, y, z] = columns;
        let inverse = DMat3::from_cols(x, y, z).inverse();
        Self { eye, rows: [0, 1, 2].map(|n| inverse.row(n)), is_parallel }
    }

    /// The functions at a world position.
    pub fn at(&self, place: DVec3) -> [f64; 3] {
        self.rows.map(|row| row.dot(place - self.eye))
    }

    /// The functions' changes along a vector.
    pub fn along(&self, vector: DVec3) -> [f64; 3] {
        self.rows.map(|row| row.dot(vector))
    }

    /// Least W of splats that are shown; −∞ for parallel rays.
    pub fn least_distance(&self, splats: &Splats) -> f64 {
        if self.is_parallel { f64::NEG_INFINITY } else { LEAST_DISTANCE * splats.pitch().truncate().max_element() }
    }

    /// The part of a picture that may show a part of a view; `None` if it lies behind the camera.
    pub fn seen(&self, splats: &Splats, extent: &Extent, whole: &Rect) -> Option<Seen> {
        let margin = splats.margin();
        let low: [f64; 3] = std::array::from_fn(|axis| f64::from(extent.low[axis]) - margin[axis]);
        let high: [f64; 3] = std::array::from_fn(|axis| f64::from(extent.high[axis]) + margin[axis]);
        let start = self.at(splats.place(low[0], low[1], low[2]));
        let steps = splats.steps().map(|step| self.along(step));
        let corner = |n: usize| -> [f64; 3] {
            let parts: [f64; 3] =
                std::array::from_fn(|axis| if n >> axis & 1 == 1 { high[axis] - low[axis] } else { 0.0 });
            std::array::from_fn(|of| start[of] + (0..3).map(|axis| parts[axis] * steps[axis][of]).sum::<f64>())
        };
        let corners: [[f64; 3]; 8] = std::array::from_fn(corner);
        let (nearest, farthest) =
            corners.iter().fold((f64::MAX, f64::MIN), |(low, high), corner| (low.min(corner[2]), high.max(corner[2])));
        let least = self.least_distance(splats);
        if farthest < least {
            return None;
        }
        if nearest < least && !self.is_parallel {
            return Some(Seen { rect: *whole, nearness: f32::INFINITY });
        }
        let mut rect = Rect { low: [i32::MAX; 2], high: [i32::MIN; 2] };
        for corner in &corners {
            let divisor = if self.is_parallel { 1.0 } else { corner[2] };
            for axis in 0..2 {
                let place = corner[axis] / divisor;
                rect.low[axis] = rect.low[axis].min((place - 1.0).floor() as i32);
                rect.high[axis] = rect.high[axis].max((place + 1.0).ceil() as i32);
            }
        }
        // Rounded upwards, so that no splat is nearer.
        let nearness = (self.nearness(nearest) as f32).next_up();
        Some(Seen { rect: rect.overlap(whole), nearness })
    }

    /// Whether something at a world position is seen within limits.
    pub fn is_seen(&self, place: DVec3, limits: &Limits) -> bool {
        let range = if self.is_parallel { self.at(place)[2] } else { place.distance(self.eye) } as f32;
        (limits.segment.t_min..=limits.segment.t_max).contains(&range)
            && limits.planes().iter().all(|plane| plane.truncate().dot(place) + plane.w >= 0.0)
    }

    /// The nearness of a distance W.
    pub fn nearness(&self, distance: f64) -> f64 {
        if self.is_parallel { -distance } else { 1.0 / distance }
    }

    /// The distance W of a nearness.
    pub fn distance(&self, nearness: f64) -> f64 {
        if self.is_parallel { -nearness } else { 1.0 / nearness }
    }
}

/// A number that is greater for a greater float, and never 0.
#[inline(always)]
pub(super) fn ordered(value: f32) -> u32 {
    let bits = value.to_bits() as i32;
    // Of negative numbers all bits turn, of others the sign.
    (bits ^ ((bits >> 31) | i32::MIN)) as u32
}

/// The float of `ordered`.
pub(super) fn unordered(number: u32) -> f32 {
    let bits = number as i32;
    f32::from_bits((bits ^ (!(bits >> 31) | i32::MIN)) as u32)
}
