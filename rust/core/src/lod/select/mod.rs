//! Selection of the coarsest sufficient level (Liebisch 2021, Sec. 4.3–4.5), for many objects and few eyes.
//!
//! Stages, in order: visibility, sizes, the lens, a table of levels, curves. Each stage processes only objects that are
//! still open: no earlier stage has decided their level.

mod curves;
mod objects;
mod rules;
mod sizes;
mod table;
mod chunk;
mod view;

pub use chunk::select;
pub(super) use curves::score;
pub use curves::{Model, Parameters};
pub(super) use objects::CHUNK;
pub use objects::{COLUMNS, Objects, SelectionCounts};
pub use rules::{Acuity, Apparent, EyeLens, Rules, SizeLimit, ThresholdLine};
pub(super) use sizes::{EyeSizes, OpenSizes};
pub use view::{Eye, Frustum};
pub(super) use view::{HIDDEN, Sight};
