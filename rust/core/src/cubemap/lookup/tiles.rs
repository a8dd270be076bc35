//! Processing of directions in blocks, one per kernel call, and in tiles, one per task.

use std::sync::atomic::{AtomicUsize, Ordering};

use glam::DVec3;
use rayon::prelude::*;

use super::blocks::BLOCK;
use crate::base::{Error, Progress, Real, Result};

/// Number of directions in one task.
const TILE: usize = 1 << 13;

/// Runs a kernel over directions, block by block; the last block is padded. The kernel returns how many of its
/// directions are zero or not finite. Returns the index of the first such direction.
pub(in crate::cubemap) fn in_blocks<T, D: Real>(
    directions: &[[D; 3]],
    out: &mut [T],
    channels: usize,
    mut kernel: impl FnMut(&[[D; 3]; BLOCK], &mut [T]) -> u32,
) -> Option<usize> {
    let (full, rest) = directions.as_chunks::<BLOCK>();
    let (out_full, out_rest) = out.split_at_mut(full.len() * BLOCK * channels);
    let mut wrong = 0;
    for (block, out) in full.iter().zip(out_full.chunks_exact_mut(BLOCK * channels)) {
        wrong += kernel(block, out);
    }
    if let Some(&first) = rest.first() {
        let mut block = [first; BLOCK];
        block[..rest.len()].copy_from_slice(rest);
        wrong += kernel(&block, out_rest);
    }
    if wrong == 0 { None } else { directions.iter().position(is_wrong) }
}

/// Runs a kernel over tiles of directions on the current thread pool. Fails at the first direction that is zero or not
/// finite.
pub(in crate::cubemap) fn in_tiles<T: Send, D: Real>(
    directions: &[[D; 3]],
    out: &mut [T],
    channels: usize,
    progress: &Progress,
    kernel: impl Fn(&[[D; 3]], &mut [T]) -> Option<usize> + Sync,
) -> Result<()> {
    if channels == 0 {
        return refuse(directions.iter().position(is_wrong).unwrap_or(usize::MAX));
    }
    let wrong = AtomicUsize::new(usize::MAX);
    out.par_chunks_mut(TILE * channels).zip(directions.par_chunks(TILE)).enumerate().try_for_each(
        |(tile, (out, directions))| {
            if let Some(index) = kernel(directions, out) {
                wrong.fetch_min(tile * TILE + index, Ordering::Relaxed);
            }
            progress.check()
        },
    )?;
    refuse(wrong.into_inner())
}

/// Returns the error for a direction that is zero or not finite, given its index; no error for `usize::MAX`.
pub(in crate::cubemap) fn refuse(wrong: usize) -> Result<()> {
    if wrong == usize::MAX {
        return Ok(());
    }
    Err(Error::value("directions", "finite vectors other than zero", format!("something else at index {wrong}")))
}

/// Returns whether a direction is zero or not finite.
pub(in crate::cubemap) fn is_wrong<D: Real>(d: &[D; 3]) -> bool {
    let d = DVec3::from_array(d.map(Real::wide));
    !d.is_finite() || d == DVec3::ZERO
}
