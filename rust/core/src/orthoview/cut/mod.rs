//! Cuts through the octree: which cells a viewer sees at which level, from which directions, and which leaves as geometry.

mod cells;
mod frustum;
mod lift;
mod rule;
mod traverse;

pub use cells::{Cells, Grid, Known};
pub use lift::Lift;
pub use rule::{Gaze, Rule};
pub use traverse::{Cut, Drawn, View, cut};
