//! Bindings of `orthoview`.

pub mod cut;
pub mod splat;
pub mod steady;
pub mod views;
