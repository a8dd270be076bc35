//! Depth buffers: distances from the eye by their values.
//!
//! A perspective view's buffer holds t, which 1/z is linear in: 1/z = (1 − t)/z₀ + t/z₁ with z the distance along the
//! viewing axis and z₀, z₁ its values where the buffer is 0 and 1: the near and the far plane, or the far and the near
//! one where z is reversed. 1/z₀ or 1/z₁ is 0 for a far plane at infinity. A parallel view's z itself is linear in t.
//! Both terms of the sums are positive, so nothing cancels: z is as exact as t is. The distance from the eye is
//! z √(1 + x² + y²) with the tangents x, y of the pixel's centre.

mod block;
mod buffer;
#[cfg(test)]
mod tests;

pub use block::{Depth, Ranged};
pub use buffer::{DepthBuffer, Planes};
