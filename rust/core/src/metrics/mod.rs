//! Image quality against a reference: structural similarity, squared differences, object completion, and
//! discontinuities of neighbourhoods.

mod batch;
mod object_completion;
mod neighbours;
mod extremes;
mod pair;
mod pixel_rows;
mod plane;
mod similarity;

pub use batch::{Comparison, SquaredError, Stacks};
pub use extremes::ValueRange;
pub use neighbours::{Border, Neighbourhood, Tears, discontinuity, tear};
pub use object_completion::object_completion;
pub use pair::Pair;
pub use pixel_rows::PixelRows;
pub use plane::{Pixel, Plane, RoundingLimits};
pub use similarity::{Similarity, SimilaritySums, Window};
