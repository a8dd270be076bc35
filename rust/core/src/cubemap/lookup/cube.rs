//! Values of a cube map along many directions.

use std::sync::atomic::{AtomicUsize, Ordering};

use glam::DVec3;
use rayon::prelude::*;

use super::blocks::{BLOCK, Lanes};
use super::faces::{Faces, Number, refuse};
use super::sampler::Sampler;
use crate::base::{Real, Result};

/// Directions handled by one task.
pub(super) const TILE: usize = 1 << 13;

/// How texels around a direction become one value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Filter {
    /// Seamless bilinear.
    Linear,
    /// Seamless bicubic.
    Cubic,
    /// The least of the texels that `Linear` would mix.
    Min,
    /// The greatest of the texels that `Linear` would mix.
    Max,
}

/// Runs a kernel over directions block by block, the last one filled up; the kernel says how many of its directions
/// are zero or not finite, and the index of the first one comes back.
pub(super) fn in_blocks<T, D: Real>(
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

/// Runs a kernel over tiles of directions on the current pool; fails at the first direction that it finds wrong.
pub(super) fn in_tiles<T: Send, D: Number>(
    directions: &[[D; 3]],
    out: &mut [T],
    channels: usize,
    kernel: impl Fn(&[[D; 3]], &mut [T]) -> Option<usize> + Sync,
) -> Result<()> {
    if channels == 0 {
        return refuse(directions.iter().position(is_wrong).unwrap_or(usize::MAX));
    }
    let wrong = AtomicUsize::new(usize::MAX);
    out.par_chunks_mut(TILE * channels).zip(directions.par_chunks(TILE)).enumerate().for_each(
        |(tile, (out, directions))| {
            if let Some(index) = kernel(directions, out) {
                wrong.fetch_min(tile * TILE + index, Ordering::Relaxed);
            }
        },
    );
    refuse(wrong.into_inner())
}

/// The map's value along each direction of any length, as many as faces have channels. Fails at a direction that is
/// zero or not finite.
pub fn lookup<T: Number, D: Number>(
    faces: Faces<'_, T>,
    directions: &[[D; 3]],
    filter: Filter,
    out: &mut [T],
) -> Result<()> {
    faces.check_out(out, directions.len())?;
    let sampler = Sampler::cube(faces, filter, directions.len())?;
    in_tiles(directions, out, faces.channels, |directions, out| sampler.sample(directions, out))
}

/// The texel that each direction of any length passes through, of faces of anything. Fails as `lookup`.
pub fn nearest<T: Copy + Send + Sync, D: Number>(
    faces: Faces<'_, T>,
    directions: &[[D; 3]],
    out: &mut [T],
) -> Result<()> {
    faces.check_out(out, directions.len())?;
    in_tiles(directions, out, faces.channels, |directions, out| match faces.channels {
        1 => nearest_of::<T, D, 1>(faces, directions, out),
        3 => nearest_of::<T, D, 3>(faces, directions, out),
        4 => nearest_of::<T, D, 4>(faces, directions, out),
        channels => {
            let mut texel = Lanes([0; BLOCK]);
            in_blocks(directions, out, channels, |block, out| {
                let wrong = D::find_texels(block, faces.size, &mut texel);
                for (value, &number) in out.chunks_exact_mut(channels).zip(&texel.0) {
                    value.copy_from_slice(faces.texel(number));
                }
                wrong
            })
        }
    })
}

fn nearest_of<T: Copy, D: Number, const CHANNELS: usize>(
    faces: Faces<'_, T>,
    directions: &[[D; 3]],
    out: &mut [T],
) -> Option<usize> {
    let texels = faces.values.as_chunks::<CHANNELS>().0;
    let mut texel = Lanes([0; BLOCK]);
    in_blocks(directions, out, CHANNELS, |block, out| {
        let wrong = D::find_texels(block, faces.size, &mut texel);
        for (value, &number) in out.as_chunks_mut::<CHANNELS>().0.iter_mut().zip(&texel.0) {
            *value = texels[number as usize];
        }
        wrong
    })
}

/// Whether a direction is zero or not finite.
pub(super) fn is_wrong<D: Real>(d: &[D; 3]) -> bool {
    let d = DVec3::from_array(d.map(Real::wide));
    !d.is_finite() || d == DVec3::ZERO
}
