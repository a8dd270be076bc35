//! Ray tracing through both levels of trees, and nearest points of the scene's surface.

mod beam;
mod cast;
mod closest;
mod dispatch;
mod lanes;
mod nearest;
mod packet;
mod ray;
mod region;
mod single;
mod slab;
#[cfg(test)]
mod tests;
mod triangle;

pub use cast::{Hits, Points, cast};
pub use closest::{Closest, closest};
pub use dispatch::{
    Layer, LayerHits, LayerTree, any_hits, beam_touches, closest_hits, closest_hits_apart, closest_hits_by_layer,
};
pub use lanes::{instruction_sets, use_instruction_set};
pub use nearest::{Nearest, nearest};
pub use ray::{AcceptAll, AlphaFilter, FaceHits, Hit, HitFilter, Ray};
pub use region::touches;
