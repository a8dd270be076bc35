//! Shared conversions of all bindings: arrays, errors, names, and the functions that run a kernel.

pub mod arrays;
pub mod errors;
pub mod names;
pub mod one_of;
pub mod run;
