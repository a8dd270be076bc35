//! Bindings of `lod`.

pub mod fit;
pub mod select;
pub mod simplify;
