//! Bounding spheres (the smallest, and faster, larger ones) and the solid angles of spheres.

mod approximate;
mod bounding;
mod exact;
mod scan;
mod solid_angle;
mod sphere;
mod support;
#[cfg(test)]
mod tests;

pub use bounding::{bounding_sphere, bounding_spheres};
pub use solid_angle::{Seen, check, each_tile, solid_angles};
pub use sphere::{Sphere, SphereMethod};
