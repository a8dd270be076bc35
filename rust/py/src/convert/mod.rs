//! Conversions that all bindings share: arrays, errors, and the way to run a kernel.

pub mod arrays;
pub mod errors;
pub mod run;
