//! Next mipmap level of a cube map, with half as many texels across a face.
//!
//! A texel of the next level covers 2 × 2 texels or, if the size is odd, up to 3 × 3 in part. Means are weighted by the
//! solid angles of the covered parts, so that the mean over the sphere does not change.

use rayon::prelude::*;

use super::faces::{CubeFaces, check_out, first_of_block};
use super::lookup::{self, halve_greatest, halve_least};
use super::solid::{edge_of, edges, row_of_angles, solid_angle};
use crate::base::{Progress, Real, Result};

/// Rule that reduces the covered texels to one texel of the next level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reduction {
    /// Mean weighted by solid angle.
    Mean,
    /// Minimum of all texels that are covered at least in part.
    Min,
    /// Maximum of all texels that are covered at least in part.
    Max,
}

/// Rows (or columns) that one row (or column) of the next level covers.
struct Coverage {
    /// The first covered row or column.
    first: u32,
    /// The covered interval of each covered row or column.
    pieces: Vec<[f64; 2]>,
}

fn coverage(index: u32, size: u32, next: u32) -> Coverage {
    // Sizes are at most 16384, so products stay below 2³².
    let (first, last) = (index * size / next, ((index + 1) * size).div_ceil(next));
    let (low, high) = (edge_of(index, next), edge_of(index + 1, next));
    let pieces = (first..last).map(|i| [edge_of(i, size).max(low), edge_of(i + 1, size).min(high)]).collect();
    Coverage { first, pieces }
}

/// Returns the width of a face of the next level, texels.
pub fn next_size(size: u32) -> u32 {
    (size / 2).max(1)
}

/// Writes the next level.
pub fn next_level<T: Real>(
    faces: CubeFaces<'_, T>,
    reduction: Reduction,
    out: &mut [T],
    progress: &Progress,
) -> Result<()> {
    let (size, next) = (faces.size, next_size(faces.size));
    check_out(out, 6 * (next as usize).pow(2) * faces.channels)?;
    if faces.channels == 0 {
        return Ok(());
    }
    let is_simple = size.is_multiple_of(2) && faces.channels == 1;
    let edges = edges(size);
    let across: Vec<Coverage> = (0..next).map(|column| coverage(column, size, next)).collect();
    let row_length = next as usize * faces.channels;
    // A task computes one row of all six faces, because they share its weights.
    let mut blocks_of_rows = out.chunks_exact_mut(row_length * next as usize);
    let mut face = || blocks_of_rows.next().unwrap_or_default().par_chunks_exact_mut(row_length);
    let rows = (face(), face(), face(), face(), face(), face()).into_par_iter();
    rows.zip(0..next).try_for_each(|((a, b, c, d, e, f), row)| {
        let down = coverage(row, size, next);
        let weights = match reduction {
            Reduction::Mean if is_simple => angles_of_two_rows(row, size, &edges),
            Reduction::Mean => weigh(&across, &down),
            _ => Vec::new(),
        };
        for (face, out) in [a, b, c, d, e, f].into_iter().enumerate() {
            let start = (face * size as usize + down.first as usize) * size as usize * faces.channels;
            let texels = &faces.values[start..][..down.pieces.len() * size as usize * faces.channels];
            match reduction {
                _ if is_simple => halve(texels, &weights, reduction, out),
                Reduction::Mean => mean(texels, &across, &weights, &faces, out),
                Reduction::Min => extremes(texels, &across, &faces, |a, b| a < b, out),
                Reduction::Max => extremes(texels, &across, &faces, |a, b| a > b, out),
            }
        }
        progress.check()
    })
}

/// Writes one row of the next level, for one channel and an even size.
fn halve<T: Real>(texels: &[T], weights: &[f64], reduction: Reduction, out: &mut [T]) {
    let (above, below) = texels.split_at(texels.len() / 2);
    match reduction {
        Reduction::Mean => {
            let (weights_above, weights_below) = weights.split_at(weights.len() / 2);
            lookup::halve(above, below, [weights_above, weights_below], out);
        }
        Reduction::Min => halve_least(above, below, out),
        Reduction::Max => halve_greatest(above, below, out),
    }
}

/// Returns the solid angles of the texels in the two rows that a row of the next level covers, for an even size.
fn angles_of_two_rows(row: u32, size: u32, edges: &[f64]) -> Vec<f64> {
    let mut angles = vec![0.0; 2 * size as usize];
    let (above, below) = angles.split_at_mut(size as usize);
    row_of_angles(2 * row, size, edges, above);
    row_of_angles(2 * row + 1, size, edges, below);
    angles
}

/// Returns the weights of the parts that each texel of a row of the next level covers, in the order of the texels, then
/// of the rows and columns that it covers.
fn weigh(across: &[Coverage], down: &Coverage) -> Vec<f64> {
    let mut weights = Vec::new();
    for column in across {
        let first = weights.len();
        for &v in &down.pieces {
            for &u in &column.pieces {
                weights.push(solid_angle(u, v));
            }
        }
        let total: f64 = weights[first..].iter().sum();
        for weight in &mut weights[first..] {
            *weight /= total;
        }
    }
    weights
}

fn mean<T: Real>(texels: &[T], across: &[Coverage], weights: &[f64], faces: &CubeFaces<'_, T>, out: &mut [T]) {
    let (channels, row_length) = (faces.channels, faces.size as usize * faces.channels);
    let mut next = 0;
    for (column, out) in across.iter().zip(out.chunks_exact_mut(channels)) {
        let (start, count) = (column.first as usize * channels, column.pieces.len());
        let column_weights = &weights[next..next + count * (texels.len() / row_length)];
        next += column_weights.len();
        for (channel, value) in out.iter_mut().enumerate() {
            let mut sum = 0.0;
            for (row, weights) in texels.chunks_exact(row_length).zip(column_weights.chunks_exact(count)) {
                for (k, weight) in weights.iter().enumerate() {
                    sum += row[start + k * channels + channel].wide() * weight;
                }
            }
            *value = T::narrow(sum);
        }
    }
}

fn extremes<T: Real>(
    texels: &[T],
    across: &[Coverage],
    faces: &CubeFaces<'_, T>,
    before: impl Fn(T, T) -> bool,
    out: &mut [T],
) {
    for (column, out) in across.iter().zip(out.chunks_exact_mut(faces.channels)) {
        let first = column.first as usize;
        first_of_block(texels, faces.size as usize, first..first + column.pieces.len(), &before, out);
    }
}
