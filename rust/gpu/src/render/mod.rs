//! Pictures of `nearfar_core::render`, drawn by a device.

mod scene;
mod near_far;
pub mod reduced;

pub use scene::{bake, begin_truth};
