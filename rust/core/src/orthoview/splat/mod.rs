//! Splatting: pictures of views from any viewpoint.
//!
//! A pixel of a view becomes a splat: a piece of a plane (a surfel), drawn as an ellipse, or a ball, drawn as a disc.
//! Threads draw one tile of the screen each: the boxes of the views, the nearest first, without those hidden by splats
//! drawn before. The nearest splat at a sample wins.

mod blend;
mod compressed;
mod draw;
mod lanes;
mod plan;
mod picture;
mod projector;
mod resolve;
mod screen;
mod splats;

pub use blend::{Placed, blended, expected};
pub use compressed::{Compressed, HEAD};
pub use draw::draw;
pub use picture::{Counts, Picture};
pub use plan::{Found, LANE_BITS, Piece, Plan, Rays, ViewUniforms};
pub(super) use projector::Projector;
pub use splats::{BORDER, MIN_COSINE, SQUARED_RADIUS, Splats};
