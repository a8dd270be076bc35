//! Spheres, and the ways to find one about points.

use glam::DVec3;

/// A centre and a radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its centre.
    pub center: DVec3,
    /// Its radius, at least 0.
    pub radius: f64,
}

/// Method that finds a sphere about points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SphereMethod {
    /// The smallest one.
    Exact,
    /// Two far points, and then every point that lies outside. Ritter: An efficient bounding sphere, 1990.
    Ritter,
    /// About the mean of the points.
    Average,
    /// About the middle of their box.
    MinMax,
    /// The smaller of the last two, as Liebisch (2021) has it.
    Best,
}
