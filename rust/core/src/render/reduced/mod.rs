//! Frames of a thin client: near geometry, morphed for the user's position, in front of an environment map.

mod backdrop;
mod bent;
mod cell;
mod corner;
mod exact;
mod folding;
mod lattice;
mod moving;
mod near_geometry;
mod pieces;
mod reduced_scene;
mod straight;

pub use moving::ConventionalDynamic;
pub use reduced_scene::{Drawing, FrameCounts, Growth, Join, MorphMethod, Reduced};
