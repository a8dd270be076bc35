//! Depth buffers: conversion between stored values and distances from the eye.
//!
//! For a perspective view, the inverse distance is linear in the buffer's value t: 1/z = (1 − t)/z₀ + t/z₁. Here z is
//! the distance along the viewing axis, and z₀, z₁ are the distances at t = 0 and t = 1: the near and the far plane, or
//! the far and the near plane for reversed depth. For a far plane at infinity its inverse distance is 0. For a parallel
//! view z itself is linear in t. Both terms of each sum are positive, so there is no cancellation: z has the relative
//! precision of t. The distance from the eye is z √(1 + x² + y²), with x, y the tangents of the pixel's centre.

mod block;
mod buffer;
#[cfg(test)]
mod tests;

pub use block::{Depth, Ranged};
pub use buffer::{DepthBuffer, Planes};
