//! Rendering: ground truth of a scene, environment maps baked from the centre, and frames of a thin client.

pub mod frame;
pub mod shade;
pub mod surface;
pub mod limits;
pub mod mask;
pub mod tiles;
pub mod truth;
pub mod surrounding_views;
pub mod temporal;
pub mod bake;
pub mod bake_rings;
mod ring_layers;
pub mod reduced;

pub use frame::{Channels, Frame, Sample};
pub use limits::{Limits, MAX_PLANES, Segment};
pub use mask::MaskPyramid;
pub use surface::{Facet, Surface};
pub use surrounding_views::{Luma, SurroundingViews};
pub use temporal::Moving;
pub use tiles::{Picture, Pixels, RayPixels, RenderView, draw};
