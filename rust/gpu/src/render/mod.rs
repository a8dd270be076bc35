//! Pictures of `nearfar_core::render`, drawn by a device.

pub mod truth;
mod near_far;
pub mod bake;
pub mod reduced;
