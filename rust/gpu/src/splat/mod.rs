//! Splatting of orthoviews: a rasteriser in compute shaders.
//!
//! Views stay on the device, losslessly packed into words. A thread projects a splat and raises the keys of the
//! samples that it covers, by 64-bit atomics if the adapter has them, otherwise in two passes of 32 bits. Pieces of
//! views are drawn nearest first in a few batches; between them the farthest depth of each tile of samples is
//! computed, and pieces behind it are culled.

mod arena;
mod calls;
mod draw;
mod layout;

pub use arena::{keep, kept_bytes};
pub use draw::draw;
