//! Bindings of `lod`.

pub mod budget;
pub mod fit;
pub mod select;
pub mod simplify;
