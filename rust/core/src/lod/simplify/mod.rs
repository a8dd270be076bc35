//! Coarser surfaces: edges are collapsed, and attributes of the base are carried over.

mod carry;
mod collapse;
mod surface;

pub use carry::{Charts, SurfacePlace};
pub use collapse::{Allowance, Vertices, collapse};
pub use surface::{first_alike, pieces};
