//! Coarser surfaces: edges are collapsed, and the attributes of the base are transferred.

mod carry;
mod collapse;
mod surface;

pub use carry::{ConnectedSurface, SurfacePlace};
pub use collapse::{Allowance, Vertices, collapse};
pub use surface::{first_alike, pieces};
