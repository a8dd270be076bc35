//! Bindings of `lod`.

pub mod select;
pub mod simplify;
