//! Conversion of pictures between layouts; directions of a layout's texels, and texels that directions hit.

use glam::DVec3;
use rayon::prelude::*;

use super::super::faces::{CubeFaces, check_out};
use super::super::lookup::{
    BLOCK, BlockValues, SampledPicture, Sampler, TexelFilter, copy_texels, cube_sampler, find_texels,
    is_zero_or_not_finite, process_blocks, process_chunks,
};
use super::flat;
use super::layout::{Grid, GridRows, Layout};
use super::picture::{Panorama, flat_sampler};
use crate::base::{Progress, Real, Result, ensure, memory::room_for};

/// Number of texels whose directions are computed and looked up together.
const SEGMENT: usize = 512;

/// Converts a picture to another layout. A texel is the mean, minimum or maximum (depending on the filter) of
/// `samples`² evenly spaced look-ups.
pub fn convert<T: Real>(
    picture: Panorama<'_, T>,
    target: Grid,
    filter: TexelFilter,
    samples: u32,
    out: &mut [T],
    progress: &Progress,
) -> Result<()> {
    let channels = picture.channels;
    check_out(out, target.texels() * channels)?;
    if channels == 0 {
        return Ok(());
    }
    let rows = GridRows::new(target, samples)?;
    // Arrays of each thread in `resample`.
    room_for(((size_of::<T>() + size_of::<f64>()) * SEGMENT * channels * rayon::current_num_threads()) as u64)?;
    if picture.grid.layout == Layout::Cube {
        let faces = CubeFaces::new(picture.values, picture.grid.width, channels)?;
        let count = target.texels().saturating_mul(rows.samples() as usize);
        return resample(&cube_sampler(faces, filter, count)?, target, &rows, out, progress);
    }
    resample(&flat_sampler(picture, filter), target, &rows, out, progress)
}

/// Writes all texels of a layout.
fn resample<T: Real, S: SampledPicture<T> + Sync>(
    source: &Sampler<'_, T, S>,
    target: Grid,
    rows: &GridRows,
    out: &mut [T],
    progress: &Progress,
) -> Result<()> {
    let (channels, filter) = (source.texels.channels, source.texels.filter);
    // Progress counts segments, not rows: with many samples a row takes minutes.
    progress.expect(u64::from(target.rows()) * (target.width as usize).div_ceil(SEGMENT) as u64);
    out.par_chunks_mut(target.width as usize * channels).zip(0..target.rows()).try_for_each(|(out, row)| {
        let mut directions = [[0.0; 3]; SEGMENT];
        let mut values = vec![T::narrow(0.0); SEGMENT * channels];
        let mut sums = vec![0.0; SEGMENT * channels];
        for (segment, out) in out.chunks_mut(SEGMENT * channels).enumerate() {
            let directions = &mut directions[..out.len() / channels];
            let (values, sums) = (&mut values[..out.len()], &mut sums[..out.len()]);
            for sample in 0..rows.samples() {
                rows.write(sample, row, (segment * SEGMENT) as u32, directions);
                source.sample(directions, values);
                for (sum, value) in sums.iter_mut().zip(&*values) {
                    let value = value.wide();
                    *sum = match filter {
                        _ if sample == 0 => value,
                        TexelFilter::Min => sum.min(value),
                        TexelFilter::Max => sum.max(value),
                        _ => *sum + value,
                    };
                }
            }
            let is_mean = matches!(filter, TexelFilter::Linear | TexelFilter::Cubic);
            let divisor = if is_mean { f64::from(rows.samples()) } else { 1.0 };
            for (value, sum) in out.iter_mut().zip(&*sums) {
                *value = T::narrow(sum / divisor);
            }
            progress.report(1)?;
        }
        Ok(())
    })
}

/// Converts a picture with values of any type: each texel takes the source texel that contains its centre.
pub fn convert_nearest<T: Copy + Send + Sync>(
    picture: Panorama<'_, T>,
    target: Grid,
    out: &mut [T],
    progress: &Progress,
) -> Result<()> {
    let channels = picture.channels;
    check_out(out, target.texels() * channels)?;
    if channels == 0 {
        return Ok(());
    }
    let rows = GridRows::new(target, 1)?;
    progress.expect(target.rows().into());
    out.par_chunks_mut(target.width as usize * channels).zip(0..target.rows()).try_for_each(|(out, row)| {
        let mut directions = [[0.0; 3]; SEGMENT];
        let mut texels = BlockValues([0; BLOCK]);
        for (segment, out) in out.chunks_mut(SEGMENT * channels).enumerate() {
            let directions = &mut directions[..out.len() / channels];
            rows.write(0, row, (segment * SEGMENT) as u32, directions);
            process_blocks(directions, out, channels, |block, out| {
                match picture.grid.layout {
                    Layout::Cube => drop(find_texels(block, picture.grid.width, &mut texels)),
                    _ => flat::find_texels(block, picture.grid, &mut texels),
                }
                copy_texels(picture.values, channels, &texels, out);
                0
            });
        }
        progress.report(1)
    })
}

/// Writes the number of the texel that each direction hits.
pub fn grid_texels<D: Real>(grid: Grid, directions: &[[D; 3]], out: &mut [i64], progress: &Progress) -> Result<()> {
    ensure!(out.len() == directions.len(), "out", format!("{} numbers", directions.len()), out.len());
    process_chunks(directions, out, 1, progress, |directions, out| {
        for (d, number) in directions.iter().zip(out) {
            if !is_zero_or_not_finite(d) {
                *number = grid.texel(DVec3::from_array(d.map(Real::wide))).into();
            }
        }
        directions.iter().position(is_zero_or_not_finite)
    })
}

/// Writes the directions of all texel centres, row by row. The longest component of a cube's directions is ±1,
/// equirectangular directions are unit vectors, and octahedral directions have an L1 norm of 1.
pub fn grid_directions(grid: Grid, out: &mut [[f64; 3]], progress: &Progress) -> Result<()> {
    check_out(out, grid.texels())?;
    let rows = GridRows::new(grid, 1)?;
    out.par_chunks_mut(grid.width as usize).zip(0..grid.rows()).try_for_each(|(out, row)| {
        rows.write(0, row, 0, out);
        progress.check()
    })
}
