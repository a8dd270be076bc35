//! Minimum or maximum of the texels that a cone touches.

use std::f64::consts::FRAC_PI_2;

use glam::DVec3;
use rayon::prelude::*;

use super::super::faces::{CubeFaces, check_out, first_of_block, is_known};
use super::blocks::{halve_greatest, halve_least};
use super::chunks::{check_first_invalid, is_zero_or_not_finite};
use super::cone::{Cone, ConeRows};
use super::sampler::TexelFilter;
use crate::base::{Error, Progress, Real, Result, ensure, memory::room_for};

/// Approximate cone diameter, in texels, above which a level with blocks of twice the size saves time.
const WIDE_CONE: f64 = 8.0;

/// Number of directions in one task.
const CHUNK: usize = 64;

/// Writes the minimum or maximum of all texels that the cone around each direction touches. `radius` is the cone's half
/// angle, at least 0 and below 90°. Fails if a direction is zero or not finite.
pub fn footprint<T: Real, D: Real>(
    faces: CubeFaces<'_, T>,
    directions: &[[D; 3]],
    radius: f64,
    filter: TexelFilter,
    out: &mut [T],
    progress: &Progress,
) -> Result<()> {
    ensure!((0.0..FRAC_PI_2).contains(&radius), "radius", "an angle of at least 0 and below 90°", radius);
    check_out(out, directions.len() * faces.channels)?;
    check_first_invalid(
        directions.par_iter().with_min_len(1 << 13).position_first(is_zero_or_not_finite).unwrap_or(usize::MAX),
    )?;
    if faces.channels == 0 {
        return Ok(());
    }
    match filter {
        TexelFilter::Min => look_up_all::<T, D, false>(faces, directions, radius, out, progress),
        TexelFilter::Max => look_up_all::<T, D, true>(faces, directions, radius, out, progress),
        _ => Err(Error::value("filter", "a minimum or a maximum", "a weighted mean of texels")),
    }
}

fn look_up_all<T: Real, D: Real, const MAX: bool>(
    faces: CubeFaces<'_, T>,
    directions: &[[D; 3]],
    radius: f64,
    out: &mut [T],
    progress: &Progress,
) -> Result<()> {
    let pyramid = Pyramid::new::<MAX>(faces, radius)?;
    let nothing = if MAX { f64::NEG_INFINITY } else { f64::INFINITY };
    out.par_chunks_mut(CHUNK * faces.channels).zip(directions.par_chunks(CHUNK)).try_for_each(|(out, directions)| {
        let mut scratch = Scratch::default();
        for (out, d) in out.chunks_exact_mut(faces.channels).zip(directions) {
            out.fill(T::narrow(nothing));
            let cone = Cone::new(DVec3::from_array(d.map(Real::wide)), radius);
            for face in 0..6 {
                pyramid.visit(&cone, face, &mut scratch, |values| update_extremes::<T, MAX>(out, values));
            }
            if out.iter().any(|value| value.wide() == nothing) {
                let known = pyramid.has_values(&cone, &mut scratch);
                for (value, _) in out.iter_mut().zip(known).filter(|(_, known)| !known) {
                    *value = T::narrow(f64::NAN);
                }
            }
            progress.check()?;
        }
        Ok(())
    })
}

/// Updates the extremes of each channel with the values of some texels; NaN never replaces a value.
#[inline]
fn update_extremes<T: Real, const MAX: bool>(out: &mut [T], values: &[T]) {
    let better = |best: T, value: T| if (MAX && value > best) || (!MAX && value < best) { value } else { best };
    if let [best] = out {
        *best = values.iter().fold(*best, |best, &value| better(best, value));
        return;
    }
    for texel in values.chunks_exact(out.len()) {
        for (best, &value) in out.iter_mut().zip(texel) {
            *best = better(*best, value);
        }
    }
}

/// Extremes of blocks of 1, 2 × 2, 4 × 4 … texels. The last block of a row or column may be smaller.
struct Pyramid<'a, T> {
    faces: CubeFaces<'a, T>,
    /// Number of blocks across a face, and their values, for each level from 2 × 2 on.
    levels: Vec<(usize, Vec<T>)>,
}

/// Rows of one face that a cone touches, on all levels; reused to save allocations.
#[derive(Default)]
struct Scratch {
    texels: ConeRows,
    blocks: Vec<ConeRows>,
}

impl<'a, T: Real> Pyramid<'a, T> {
    fn new<const MAX: bool>(faces: CubeFaces<'a, T>, radius: f64) -> Result<Self> {
        let mut levels: Vec<(usize, Vec<T>)> = Vec::new();
        let mut across = radius * f64::from(faces.size);
        while across > WIDE_CONE {
            across /= 2.0;
            let (size, values) = match levels.last() {
                Some((size, values)) => (*size, values.as_slice()),
                None => (faces.size as usize, faces.values),
            };
            room_for((6 * size.div_ceil(2).pow(2) * faces.channels * size_of::<T>()) as u64)?;
            let halved = halve::<T, MAX>(values, size, faces.channels);
            levels.push((size.div_ceil(2), halved));
        }
        Ok(Self { faces, levels })
    }

    /// Passes all texels of a face that a cone touches to `process`, in runs. Blocks inside the cone replace texels.
    fn visit(&self, cone: &Cone, face: u8, scratch: &mut Scratch, mut process: impl FnMut(&[T])) {
        cone.touch(face, self.faces.size, &mut scratch.texels);
        if scratch.texels.columns.is_empty() {
            return;
        }
        scratch.blocks.resize_with(self.levels.len(), ConeRows::default);
        for level in 0..self.levels.len() {
            let (below, from) = scratch.blocks.split_at_mut(level);
            let finer_rows = below.last().unwrap_or(&scratch.texels);
            coarsen(finer_rows, self.size(level), &mut from[0]);
        }
        for level in 0..=self.levels.len() {
            let rows = if level == 0 { &scratch.texels } else { &scratch.blocks[level - 1] };
            let (size, channels) = (self.size(level), self.faces.channels);
            let values = if level == 0 { self.faces.values } else { &self.levels[level - 1].1 };
            let parents = scratch.blocks.get(level);
            for (row, &(low, high)) in (rows.first..).zip(&rows.columns) {
                let start = (usize::from(face) * size + row) * size;
                let mut piece = |from: usize, to: usize| {
                    if from < to {
                        process(&values[(start + from) * channels..(start + to) * channels]);
                    }
                };
                // Texels inside a block of the next level are skipped.
                match parents.map(|parents| parents.columns[row / 2 - parents.first]) {
                    Some((from, to)) if from < to => {
                        piece(low, (2 * from).min(high));
                        piece((2 * to).max(low), high);
                    }
                    _ => piece(low, high),
                }
            }
        }
    }

    /// Returns, for each channel, whether a cone touches a value other than NaN.
    fn has_values(&self, cone: &Cone, scratch: &mut Scratch) -> Vec<bool> {
        let mut known = vec![false; self.faces.channels];
        for face in 0..6 {
            self.visit(cone, face, scratch, |values| {
                for (channel, known) in known.iter_mut().enumerate().filter(|(_, known)| !**known) {
                    *known = values[channel..].iter().step_by(self.faces.channels).any(|&value| is_known(value));
                }
            });
            if known.iter().all(|&known| known) {
                break;
            }
        }
        known
    }

    fn size(&self, level: usize) -> usize {
        if level == 0 { self.faces.size as usize } else { self.levels[level - 1].0 }
    }
}

/// Finds the blocks of the next level that lie entirely inside `rows`, a region on a level of width `size`.
fn coarsen(rows: &ConeRows, size: usize, blocks: &mut ConeRows) {
    blocks.first = rows.first / 2;
    blocks.columns.clear();
    let end = (rows.first + rows.columns.len()).div_ceil(2);
    let columns = |row: usize| match row.checked_sub(rows.first).and_then(|index| rows.columns.get(index)) {
        Some(&columns) => columns,
        None if row < size => (0, 0),
        // Rows beyond the face count as covered.
        None => (0, size),
    };
    for row in blocks.first..end {
        let (upper, lower) = (columns(2 * row), columns(2 * row + 1));
        let low = upper.0.max(lower.0).div_ceil(2);
        let high = upper.1.min(lower.1);
        blocks.columns.push((low, if high == size { size.div_ceil(2) } else { high / 2 }));
    }
}

/// Returns the extremes of all 2 × 2 blocks of six faces of width `size`.
fn halve<T: Real, const MAX: bool>(values: &[T], size: usize, channels: usize) -> Vec<T> {
    let half = size.div_ceil(2);
    let row_length = size * channels;
    let mut out = vec![T::narrow(0.0); 6 * half * half * channels];
    out.par_chunks_mut(half * channels).enumerate().for_each(|(index, out)| {
        let first = index / half * size + index % half * 2;
        let count = if index % half * 2 + 1 < size { 2 } else { 1 };
        let rows = &values[first * row_length..][..count * row_length];
        if channels == 1 && size.is_multiple_of(2) {
            let (above, below) = rows.split_at(row_length);
            let halve = if MAX { halve_greatest } else { halve_least };
            return halve(above, below, out);
        }
        for (column, block) in out.chunks_exact_mut(channels).enumerate() {
            let columns = 2 * column..(2 * column + 2).min(size);
            first_of_block(rows, size, columns, |a, b| if MAX { a > b } else { a < b }, block);
        }
    });
    out
}
