//! Camera as three linear functions of homogeneous points, which include the sky.

use glam::{DMat3, DVec2, DVec3};

use crate::camera::Camera;

/// Three linear functions (X, Y, W) of points: a camera shows a point at X/W, Y/W. For perspective W is the distance
/// along the axis, for parallel rays it is 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lens {
    /// World position of the eye; for parallel rays that of the corner of the image plane.
    pub eye: DVec3,
    rows: [DVec3; 3],
    pub is_parallel: bool,
}

/// X, Y and W of a homogeneous point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shown {
    pub plane: DVec2,
    pub weight: f64,
}

impl Shown {
    /// Returns the image position, pixels; `None` behind the camera, and for the sky along parallel rays.
    pub fn place(&self) -> Option<DVec2> {
        (self.weight > 0.0).then(|| self.plane / self.weight)
    }
}

impl Lens {
    pub fn new(camera: &Camera) -> Self {
        let (start, direction) = camera.ray(0.0, 0.0);
        let (right, down) = (camera.ray(1.0, 0.0), camera.ray(0.0, 1.0));
        let is_parallel = camera.is_parallel();
        // A point at (x, y) and a distance w: perspective w (x right + y down + direction), parallel start + x right +
        // y down + w direction.
        let columns = if is_parallel {
            [right.0 - start, down.0 - start, direction]
        } else {
            [right.1 - direction, down.1 - direction, direction]
        };
        let inverse = DMat3::from_cols(columns[0], columns[1], columns[2]).inverse();
        Self { eye: camera.position + start, rows: [0, 1, 2].map(|n| inverse.row(n)), is_parallel }
    }

    /// Evaluates the functions at the homogeneous point (`offset`, `inverse`): the point at `offset`/`inverse` from
    /// the eye, or the sky in the direction of `offset` if `inverse` is 0.
    pub fn shows(&self, offset: DVec3, inverse: f64) -> Shown {
        let plane = DVec2::new(self.rows[0].dot(offset), self.rows[1].dot(offset));
        Shown { plane, weight: if self.is_parallel { inverse } else { self.axial_distance(offset) } }
    }

    /// Returns the distance along the axis.
    pub fn axial_distance(&self, offset: DVec3) -> f64 {
        self.rows[2].dot(offset)
    }
}
