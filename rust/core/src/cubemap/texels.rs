//! Texels and their directions. Texels are numbered face by face, row by row: `(face * size + row) * size + column`.

use glam::DVec3;

use crate::camera::{direction_from_face, face_from_direction};

/// Maximum width of a face, texels: 6 × 16384² texels have numbers below 2³².
pub const MAX_SIZE: u32 = 1 << 14;

/// Returns the position, −1 to 1, of the centre of a row or column.
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
