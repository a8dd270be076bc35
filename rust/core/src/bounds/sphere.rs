//! Spheres, and the methods that find a bounding sphere.

use glam::DVec3;

/// A centre and a radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// The centre.
    pub center: DVec3,
    /// The radius, at least 0.
    pub radius: f64,
}

/// Method that finds a bounding sphere of points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SphereMethod {
    /// The smallest sphere.
    Exact,
    /// Two distant points, then each point that lies outside. Ritter: An efficient bounding sphere, 1990.
    Ritter,
    /// The sphere about the mean of the points.
    Average,
    /// The sphere about the middle of the bounding box.
    MinMax,
    /// The smaller of `Average` and `MinMax`, after Liebisch (2021).
    Best,
}
