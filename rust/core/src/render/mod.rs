//! Pictures: ground truth from the scene, environment maps baked from the centre, and what a thin client would show.

pub mod frame;
pub mod shade;

pub use frame::{Channels, Frame};
