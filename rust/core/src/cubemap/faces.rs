//! Values of a cube map's six faces, and the directions of texels. Texels are numbered face by face, row by row:
//! `(face * size + row) * size + column`.

use std::ops::Range;

use glam::DVec3;

use crate::base::{Real, Result, ensure};
use crate::camera::{direction_from_face, face_from_direction};

/// Maximum width of a face, texels: 6 × 16384² texels have numbers below 2³².
pub const MAX_SIZE: u32 = 1 << 14;

/// Returns the centre of a row or column, −1 to 1.
#[inline]
pub fn center_of(index: u32, size: u32) -> f64 {
    (f64::from(index) + 0.5) * 2.0 / f64::from(size) - 1.0
}

/// Returns the direction of a texel's centre; its longest component is ±1.
#[inline]
pub fn direction_from_texel(texel: u32, size: u32) -> DVec3 {
    let (row, column) = (texel / size, texel % size);
    direction_from_face((row / size) as u8, center_of(column, size), center_of(row % size, size))
}

/// Returns the number of the texel that a direction hits.
#[inline]
pub fn texel_from_direction(d: DVec3, size: u32) -> u32 {
    let (face, u, v) = face_from_direction(d);
    // Float casts saturate at 0; only u = 1 needs the upper bound.
    let index = |x: f64| (((x + 1.0) * 0.5 * f64::from(size)) as u32).min(size - 1);
    (u32::from(face) * size + index(v)) * size + index(u)
}

/// Six faces of `size` × `size` texels with `channels` values each.
#[derive(Clone, Copy, Debug)]
pub struct CubeFaces<'a, T> {
    /// Values of all texels.
    pub values: &'a [T],
    /// Texels across a face.
    pub size: u32,
    /// Values per texel.
    pub channels: usize,
}

impl<'a, T: Copy> CubeFaces<'a, T> {
    /// Creates faces; checks that the values fill them.
    pub fn new(values: &'a [T], size: u32, channels: usize) -> Result<Self> {
        check_size(size)?;
        let expected = 6 * size as usize * size as usize * channels;
        ensure!(values.len() == expected, "faces", format!("{expected} values for size {size}"), values.len());
        Ok(Self { values, size, channels })
    }

    #[inline]
    pub(super) fn texel(&self, number: u32) -> &'a [T] {
        &self.values[number as usize * self.channels..][..self.channels]
    }
}

pub(super) fn check_out<T>(out: &[T], expected: usize) -> Result<()> {
    ensure!(out.len() == expected, "out", format!("{expected} values"), out.len());
    Ok(())
}

/// Fails for faces without texels, or with more texels than texel numbers can address.
pub(super) fn check_size(size: u32) -> Result<()> {
    ensure!((1..=MAX_SIZE).contains(&size), "faces", format!("1 to {MAX_SIZE} texels across a face"), size);
    Ok(())
}

/// Returns whether a number is not NaN. Minima and maxima skip NaN, which marks an unknown value.
#[inline(always)]
#[allow(clippy::eq_op)]
pub(super) fn is_known<T: PartialEq + Copy>(value: T) -> bool {
    value == value
}

/// Writes, for each channel, the first value in the order `before` within some columns of rows of `width` texels: with
/// `a < b` the minimum, with `a > b` the maximum. NaN if all values are NaN.
#[inline(always)]
pub(super) fn first_of_block<T: Real>(
    rows: &[T],
    width: usize,
    columns: Range<usize>,
    before: impl Fn(T, T) -> bool,
    out: &mut [T],
) {
    let channels = out.len();
    let values = columns.start * channels..columns.end * channels;
    out.copy_from_slice(&rows[values.start..][..channels]);
    for row in rows.chunks_exact(width * channels) {
        for texel in row[values.clone()].chunks_exact(channels) {
            for (best, &value) in out.iter_mut().zip(texel) {
                *best = if before(value, *best) | !is_known(*best) { value } else { *best };
            }
        }
    }
}
