//! Spheres, and methods for bounding spheres.

use glam::DVec3;

/// A centre and a radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// The centre.
    pub center: DVec3,
    /// The radius, at least 0.
    pub radius: f64,
}

/// Method for the bounding sphere of points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SphereMethod {
    /// The smallest sphere.
    Exact,
    /// Starts from two distant points and grows to contain each outside point. Ritter: An efficient bounding sphere,
    /// 1990.
    Ritter,
    /// The sphere about the mean of the points.
    Average,
    /// The sphere about the middle of the bounding box.
    MinMax,
    /// The smaller of `Average` and `MinMax`, after Liebisch (2021).
    Best,
}
