//! Bindings of `cubemap`.

pub mod directions;
pub mod layouts;
pub mod lookup;
