//! Bounding spheres (the smallest, and faster, larger ones) and the solid angles of spheres.

mod bounding;
mod scan;
mod solid_angle;
#[cfg(test)]
mod tests;

pub use bounding::{SphereMethod, bounding_sphere, bounding_spheres};
pub use scan::Sphere;
pub use solid_angle::{Seen, check, each_tile, solid_angles};
