//! Pictures of the stages of `nearfar_core::render`, drawn by a device.

pub mod bake;
pub mod reduced;
pub mod truth;
