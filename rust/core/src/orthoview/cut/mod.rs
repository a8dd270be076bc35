//! Cuts through the octree: the cells to draw, with their levels and directions, and the leaves to draw as geometry.

mod cells;
mod rule;
mod traverse;

pub use cells::{Cells, Grid, PARTIAL, UNBUILT};
pub use rule::{Gaze, Lift, Rule};
pub use traverse::{Cut, Drawn, View, cut};
