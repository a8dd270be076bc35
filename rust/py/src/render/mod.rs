//! Bindings of `render`.

pub mod bake;
pub mod frame;
pub mod reduced;
