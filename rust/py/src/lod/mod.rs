//! Bindings of `lod`.

pub mod budget;
pub mod fit;
mod inputs;
mod outputs;
pub mod select;
pub mod simplify;
