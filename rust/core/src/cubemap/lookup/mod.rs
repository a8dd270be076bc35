//! Look-ups of cube maps by direction and by cone. Vector kernels process blocks of directions, except those at seams.

mod blocks;
mod cone;
mod cube;
mod cubic;
mod footprint;
mod sampler;
mod taps;
mod chunks;

pub(super) use blocks::{
    BLOCK, BlockValues, MIN_WEIGHT, Positions, clamped_floor, find_texels, halve, halve_greatest, halve_least, index,
    keys,
};
pub(super) use chunks::{is_zero_or_not_finite, process_blocks, process_chunks};
pub(super) use cube::{copy_texels, cube_sampler};
pub use cube::{lookup, nearest};
pub use footprint::footprint;
pub use sampler::TexelFilter;
pub(super) use sampler::{SampledPicture, Sampler, extreme};
pub use taps::Taps;
