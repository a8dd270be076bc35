//! Quality of a picture against a reference: structural similarity, squared differences, visible
//! objects, torn neighbourhoods.

mod batch;
mod completion;
mod discontinuity;
mod pair;
mod pixel_rows;
mod plane;
mod similarity;
mod squares;
mod vectors;

pub use batch::{Comparison, Stacks};
pub use completion::object_completion;
pub use discontinuity::{Neighbourhood, discontinuity};
pub use pair::Pair;
pub use plane::{Pixel, Plane, RoundingLimits};
pub use similarity::{Similarity, SimilaritySums, Source, Window};
