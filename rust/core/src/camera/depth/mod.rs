//! Depth buffers: conversion between stored values and distances from the eye.
//!
//! For a perspective view, the inverse distance is linear in the buffer's value t: 1/z = (1 − t)/z₀ + t/z₁. Here z is
//! the distance along the viewing axis, and z₀ and z₁ are its values at t = 0 and t = 1: the near and the far plane, or
//! the far and the near plane for reversed depth. A far plane at infinity has the inverse distance 0. For a parallel
//! view z itself is linear in t. Both terms of the sum are positive, so nothing cancels: z has the relative precision
//! of t. The distance from the eye is z √(1 + x² + y²), where x and y are the tangents of the pixel's centre.

mod block;
mod buffer;
#[cfg(test)]
mod tests;

pub use block::{Depth, Ranged};
pub use buffer::{DepthBuffer, Planes};
