//! Bounding spheres (the smallest, or larger ones that take less time) and solid angles of spheres.

mod bounding;
mod scan;
mod solid_angle;
#[cfg(test)]
mod tests;

pub use bounding::{SphereMethod, bounding_sphere, bounding_spheres};
pub use scan::Sphere;
pub use solid_angle::{SphereView, check_spheres, each_chunk, solid_angles};
