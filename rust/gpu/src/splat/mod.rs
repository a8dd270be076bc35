//! Views of orthoviews as splats: a raster in compute shaders.
//!
//! Views stay on the device as words without loss. A thread projects a splat and raises the keys of the samples that it
//! covers, by atomic integers of 64 bits where the adapter has them and else by two passes of 32 bits. Pieces of views are
//! drawn nearest first in a few batches; between them the farthest order of each tile of samples is taken, and pieces that
//! lie behind it are left out.

mod arena;
mod calls;
mod draw;
mod layout;
mod programs;
mod residents;
mod room;
mod uniforms;

pub use draw::draw;
pub use residents::{keep, kept_bytes};
