//! Bindings of the GPU back end.

pub mod compute;
pub mod device;
pub mod frame;
