//! Values of a cube map along many directions.

use std::sync::atomic::{AtomicUsize, Ordering};

use glam::DVec3;
use rayon::prelude::*;

use super::Taps;
use super::blocks::{self, BLOCK, Inner, Lanes, Placed};
use super::cubic::Rim;
use super::faces::{Faces, Number, Real, refuse};
use crate::base::Result;

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

/// Lookups in one map with one filter.
pub(super) struct Sampler<'a, T> {
    faces: Faces<'a, T>,
    filter: Filter,
    rim: Rim<'a, T>,
}

impl<'a, T: Number> Sampler<'a, T> {
    /// Prepares for about `count` lookups.
    pub fn new(faces: Faces<'a, T>, filter: Filter, count: usize) -> Self {
        // What lies beyond edges is worth a table where more would be looked up than it holds.
        let many = filter == Filter::Cubic && count > (faces.size as usize).pow(2);
        Self { faces, filter, rim: Rim::new(faces, many) }
    }

    /// Writes values along directions; the index of the first one that is zero or not finite.
    pub fn sample<D: Number>(&self, directions: &[[D; 3]], out: &mut [T]) -> Option<usize> {
        let mut placed = Placed::new();
        let reach = if self.filter == Filter::Cubic { [1, 2] } else { [0, 1] };
        let inner = Inner::new(self.faces.size, reach[0], reach[1]);
        in_blocks(directions, out, self.faces.channels, |block, out| {
            let wrong = D::find_places(block, self.faces.size, inner, &mut placed);
            if wrong == 0 {
                self.inside(&placed, out);
                self.at_seams(block, &placed.seam, out);
            }
            wrong
        })
    }

    /// Values of a block; those of directions at seams mean nothing.
    fn inside(&self, placed: &Placed, out: &mut [T]) {
        let mut texels = [Lanes([T::from_f64(0.0); BLOCK]); 4];
        if self.filter != Filter::Cubic {
            let weights = blocks::bilinear(placed);
            let mut values = texels[0];
            for channel in 0..self.faces.channels {
                gather_square(&self.faces, &placed.first, channel, &mut texels);
                match self.filter {
                    Filter::Min => T::least(&texels, &weights, &mut values),
                    Filter::Max => T::greatest(&texels, &weights, &mut values),
                    _ => T::mix(&texels, &weights, &mut values),
                }
                scatter(&values.0, channel, self.faces.channels, out);
            }
        } else if self.faces.size >= 4 {
            let (across, down) = (blocks::cubic(&placed.s), blocks::cubic(&placed.t));
            for channel in 0..self.faces.channels {
                let mut sums = Lanes([0.0; BLOCK]);
                for (row, weights) in down.iter().enumerate() {
                    gather_row(&self.faces, &placed.first, row, channel, &mut texels);
                    T::add_row(&texels, &across, weights, &mut sums);
                }
                scatter(&sums.0.map(T::from_f64), channel, self.faces.channels, out);
            }
        }
    }

    fn at_seams<D: Real>(&self, block: &[[D; 3]; BLOCK], seam: &Lanes<u8>, out: &mut [T]) {
        for (eight, flags) in seam.0.as_chunks::<8>().0.iter().enumerate() {
            if u64::from_ne_bytes(*flags) == 0 {
                continue;
            }
            for lane in (0..8).filter(|&lane| flags[lane] != 0).map(|lane| 8 * eight + lane) {
                // Blocks at the end are not full.
                let Some(values) = out.chunks_exact_mut(self.faces.channels).nth(lane) else { return };
                self.one(DVec3::from_array(block[lane].map(Real::to_f64)), values);
            }
        }
    }

    /// Writes the value along one direction (finite, not zero): what blocks must agree with.
    fn one(&self, d: DVec3, out: &mut [T]) {
        if self.filter == Filter::Cubic {
            return self.rim.sample(d, out);
        }
        let taps = Taps::new(d, self.faces.size);
        let rows = taps.texel.map(|number| self.faces.texel(number));
        for (channel, value) in out.iter_mut().enumerate() {
            let texels = rows.map(|row| row[channel]);
            *value = match self.filter {
                Filter::Min => extreme(texels, &taps, |a, b| a < b),
                Filter::Max => extreme(texels, &taps, |a, b| a > b),
                _ => mean(texels, &taps),
            };
        }
    }
}

/// Weighted mean. Texels without weight are left out, because 0 times infinity is NaN.
fn mean<T: Real>(texels: [T; 4], taps: &Taps) -> T {
    let term = |i: usize| if taps.weight[i] > 0.0 { texels[i].to_f64() * taps.weight[i] } else { 0.0 };
    T::from_f64((term(0) + term(1)) + (term(2) + term(3)))
}

/// The texel that comes before all others that have weight.
fn extreme<T: Real>(texels: [T; 4], taps: &Taps, before: impl Fn(T, T) -> bool) -> T {
    let (mut chosen, mut found) = (texels[0], taps.weight[0] > 0.0);
    for (&texel, &weight) in texels.iter().zip(&taps.weight).skip(1) {
        if weight > 0.0 && (!found || before(texel, chosen)) {
            (chosen, found) = (texel, true);
        }
    }
    chosen
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

/// Texel numbers as the four corners of squares, one channel of each.
fn gather_square<T: Copy>(faces: &Faces<'_, T>, first: &Lanes<u32>, channel: usize, texels: &mut [Lanes<T>; 4]) {
    let channels = faces.channels;
    // A single texel is its own neighbour.
    let (right, down) = if faces.size > 1 { (channels, faces.size as usize * channels) } else { (0, 0) };
    for i in 0..BLOCK {
        let start = first.0[i] as usize * channels + channel;
        texels[0].0[i] = faces.values[start];
        texels[1].0[i] = faces.values[start + right];
        texels[2].0[i] = faces.values[start + down];
        texels[3].0[i] = faces.values[start + down + right];
    }
}

/// One row of the 4 × 4 texels around each direction, one channel of each.
fn gather_row<T: Copy>(
    faces: &Faces<'_, T>,
    first: &Lanes<u32>,
    row: usize,
    channel: usize,
    texels: &mut [Lanes<T>; 4],
) {
    let (channels, size) = (faces.channels, faces.size as usize);
    for i in 0..BLOCK {
        // Inside a face there are a row and a column before the first texel.
        let start = (first.0[i] as usize + row * size - size - 1) * channels + channel;
        for (k, texel) in texels.iter_mut().enumerate() {
            texel.0[i] = faces.values[start + k * channels];
        }
    }
}

/// Writes one channel of as many values as `out` has room for.
fn scatter<T: Copy>(values: &[T; BLOCK], channel: usize, channels: usize, out: &mut [T]) {
    if channels == 1 {
        let count = out.len();
        return out.copy_from_slice(&values[..count]);
    }
    for (texel, &value) in out.chunks_exact_mut(channels).zip(values) {
        texel[channel] = value;
    }
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
    let sampler = Sampler::new(faces, filter, directions.len());
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
    let d = DVec3::from_array(d.map(Real::to_f64));
    !d.is_finite() || d == DVec3::ZERO
}
