//! Processing of directions in blocks and chunks. A kernel is called once per block; a task processes one chunk.

use glam::DVec3;
use rayon::prelude::*;

use super::blocks::BLOCK;
use crate::base::{Progress, Real, Result, ensure};

/// Number of directions in a chunk.
const CHUNK: usize = 1 << 13;

/// Runs a kernel over directions, block by block; the last block is padded. The kernel returns the number of its
/// directions that are zero or not finite. Returns the index of the first such direction.
pub(in crate::cubemap) fn process_blocks<T, D: Real>(
    directions: &[[D; 3]],
    out: &mut [T],
    channels: usize,
    mut kernel: impl FnMut(&[[D; 3]; BLOCK], &mut [T]) -> u32,
) -> Option<usize> {
    let (full, remaining) = directions.as_chunks::<BLOCK>();
    let (out_full, out_remaining) = out.split_at_mut(full.len() * BLOCK * channels);
    let mut invalid_count = 0;
    for (block, out) in full.iter().zip(out_full.chunks_exact_mut(BLOCK * channels)) {
        invalid_count += kernel(block, out);
    }
    if let Some(&first) = remaining.first() {
        let mut block = [first; BLOCK];
        block[..remaining.len()].copy_from_slice(remaining);
        invalid_count += kernel(&block, out_remaining);
    }
    if invalid_count == 0 { None } else { directions.iter().position(is_zero_or_not_finite) }
}

/// Runs a kernel over chunks of directions on the current thread pool. The kernel returns the index in its chunk of the
/// first direction that is zero or not finite. Fails with the index of the first such direction of all.
pub(in crate::cubemap) fn process_chunks<T: Send, D: Real>(
    directions: &[[D; 3]],
    out: &mut [T],
    channels: usize,
    progress: &Progress,
    kernel: impl Fn(&[[D; 3]], &mut [T]) -> Option<usize> + Sync,
) -> Result<()> {
    if channels == 0 {
        return check_first_invalid(directions.iter().position(is_zero_or_not_finite).unwrap_or(usize::MAX));
    }
    let chunks = out.par_chunks_mut(CHUNK * channels).zip(directions.par_chunks(CHUNK)).enumerate();
    let first_invalid = chunks.map(|(chunk, (out, directions))| {
        let index = kernel(directions, out).map_or(usize::MAX, |index| chunk * CHUNK + index);
        progress.check().map(|()| index)
    });
    check_first_invalid(first_invalid.try_reduce(|| usize::MAX, |a, b| Ok(a.min(b)))?)
}

/// Fails for the index of a direction that is zero or not finite; `usize::MAX` stands for none.
pub(in crate::cubemap) fn check_first_invalid(first_invalid: usize) -> Result<()> {
    let got = format!("zero, infinity or NaN at index {first_invalid}");
    ensure!(first_invalid == usize::MAX, "directions", "finite vectors other than zero", got);
    Ok(())
}

pub(in crate::cubemap) fn is_zero_or_not_finite<D: Real>(d: &[D; 3]) -> bool {
    let d = DVec3::from_array(d.map(Real::wide));
    !d.is_finite() || d == DVec3::ZERO
}
