//! Look-ups of many directions in a cube map.

use glam::DVec3;

use super::super::faces::{CubeFaces, check_out};
use super::blocks::{self, BLOCK, BlockValues, Inner, MIN_WEIGHT, Positions};
use super::chunks::{process_blocks, process_chunks};
use super::cubic::BorderedFaces;
use super::sampler::{SampledPicture, Sampler, TexelFilter, extreme};
use super::taps::Taps;
use crate::base::{Progress, Real, Result};

/// A cube map as a sampler reads it.
pub(in crate::cubemap) struct Cube<'a, T> {
    faces: CubeFaces<'a, T>,
    bordered: BorderedFaces<'a, T>,
}

/// Prepares about `count` look-ups in a cube map.
pub(in crate::cubemap) fn cube_sampler<T: Real>(
    faces: CubeFaces<'_, T>,
    filter: TexelFilter,
    count: usize,
) -> Result<Sampler<'_, T, Cube<'_, T>>> {
    // With this many look-ups, a table of the values beyond the edges saves time.
    let use_table = filter == TexelFilter::Cubic && count > (faces.size as usize).pow(2);
    let cube = Cube { faces, bordered: BorderedFaces::new(faces, use_table)? };
    Ok(Sampler::new((faces.values, faces.size, faces.channels), faces.size, filter, cube))
}

impl<T: Real> SampledPicture<T> for Cube<'_, T> {
    fn locate<D: Real>(
        &self,
        block: &[[D; 3]; BLOCK],
        [texels_before, texels_after]: [u32; 2],
        out: &mut Positions,
    ) -> u32 {
        blocks::locate(block, self.faces.size, Inner::new(self.faces.size, texels_before, texels_after), out)
    }

    fn sample(&self, d: DVec3, filter: TexelFilter, out: &mut [T]) {
        if filter == TexelFilter::Cubic {
            return self.bordered.sample(d, out);
        }
        let taps = Taps::new(d, self.faces.size);
        let rows = taps.texel.map(|number| self.faces.texel(number));
        for (channel, value) in out.iter_mut().enumerate() {
            let texels = (0..4).filter(|&i| taps.weight[i] > MIN_WEIGHT).map(|i| rows[i][channel]);
            *value = match filter {
                TexelFilter::Min => extreme(texels, |a, b| a < b),
                TexelFilter::Max => extreme(texels, |a, b| a > b),
                _ => mean(rows.map(|row| row[channel]), &taps),
            };
        }
    }
}

/// Returns the weighted mean. Texels without weight are skipped, because 0 × ∞ is NaN.
fn mean<T: Real>(texels: [T; 4], taps: &Taps) -> T {
    let term = |i: usize| if taps.weight[i] > 0.0 { texels[i].wide() * taps.weight[i] } else { 0.0 };
    T::narrow((term(0) + term(1)) + (term(2) + term(3)))
}

/// Writes the map's values in each direction, one per channel. Fails if a direction is zero or not finite.
pub fn lookup<T: Real, D: Real>(
    faces: CubeFaces<'_, T>,
    directions: &[[D; 3]],
    filter: TexelFilter,
    out: &mut [T],
    progress: &Progress,
) -> Result<()> {
    check_out(out, directions.len() * faces.channels)?;
    let sampler = cube_sampler(faces, filter, directions.len())?;
    process_chunks(directions, out, faces.channels, progress, |directions, out| sampler.sample(directions, out))
}

/// Writes the texel that each direction hits, for values of any type. Fails like `lookup`.
pub fn nearest<T: Copy + Send + Sync, D: Real>(
    faces: CubeFaces<'_, T>,
    directions: &[[D; 3]],
    out: &mut [T],
    progress: &Progress,
) -> Result<()> {
    check_out(out, directions.len() * faces.channels)?;
    process_chunks(directions, out, faces.channels, progress, |directions, out| {
        let mut numbers = BlockValues([0; BLOCK]);
        process_blocks(directions, out, faces.channels, |block, out| {
            let invalid_count = blocks::find_texels(block, faces.size, &mut numbers);
            copy_texels(faces.values, faces.channels, &numbers, out);
            invalid_count
        })
    })
}

/// Copies the texels with these numbers to `out`, as many as it has room for.
pub(in crate::cubemap) fn copy_texels<T: Copy>(
    values: &[T],
    channels: usize,
    numbers: &BlockValues<u32>,
    out: &mut [T],
) {
    fn copy<T: Copy, const CHANNELS: usize>(values: &[T], numbers: &[u32; BLOCK], out: &mut [T]) {
        let texels = values.as_chunks::<CHANNELS>().0;
        for (texel, &number) in out.as_chunks_mut::<CHANNELS>().0.iter_mut().zip(numbers) {
            *texel = texels[number as usize];
        }
    }
    match channels {
        1 => copy::<T, 1>(values, &numbers.0, out),
        3 => copy::<T, 3>(values, &numbers.0, out),
        4 => copy::<T, 4>(values, &numbers.0, out),
        _ => {
            for (texel, &number) in out.chunks_exact_mut(channels).zip(&numbers.0) {
                texel.copy_from_slice(&values[number as usize * channels..][..channels]);
            }
        }
    }
}
