//! Headset lenses: the radial distortion polynomial and its inverse.
//!
//! r_d = f(r) = r (1 + k₁r² + k₂r⁴ + …) with r = tan α / tan ω. Here α is the angle from the axis and ω half the
//! horizontal field of view: r = 1 at the screen's edge (Liebisch 2021, Eq. 4.10). `points` adds Brown's tangential
//! terms.

mod exact;
mod inverse;
mod mesh;
mod points;
mod polynomial;
mod radial;
mod size;
mod solve;
mod stretch;
mod table;
#[cfg(test)]
mod tests;
mod warp;

pub use inverse::InverseMethod;
pub use mesh::{WarpMesh, warp_mesh};
pub use radial::{Magnification, RadialLens};
pub use size::{Sizes, corrected_solid_angles};
pub use stretch::{SPHERES_PER_BLOCK, Spheres};
pub use warp::{Image, WarpFilter, WarpPixel, WarpView, warp};
