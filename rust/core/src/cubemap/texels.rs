//! Cube maps: six square faces +x −x +y −y +z −z in the Vulkan/WebGPU orientation.
//!
//! | face | right (u) | down (v) |
//! | --- | --- | --- |
//! | +x | −z | −y |
//! | −x | +z | −y |
//! | +y | +x | +z |
//! | −y | +x | −z |
//! | +z | +x | −y |
//! | −z | −x | −y |
//!
//! Texels are numbered face by face, row by row: `(face * size + row) * size + column`.

mod angles;
mod blocks;
mod cone;
mod convert;
mod cubic;
mod environment;
mod faces;
mod flat;
mod footprint;
mod layout;
mod lookup;
mod mips;
mod sampler;
mod solid;
mod taps;
#[cfg(test)]
mod tests;

use glam::DVec3;

pub use convert::{Picture, convert, convert_nearest, grid_directions, grid_texels};
pub use environment::EnvironmentMap;
pub use faces::{Faces, Number};
pub use footprint::footprint;
pub use layout::{Grid, Layout};
pub use lookup::{Filter, lookup, nearest};
pub use mips::{Reduction, next_level, next_size};
pub use solid::solid_angles;
pub use taps::Taps;

/// Greatest edge of a face in texels: 6 × 16384² texels still have numbers below 2³².
pub const MAX_SIZE: u32 = 1 << 14;

/// Direction (not normalised; its longest component is ±1) of a point on a face; u to the right, v down, each −1..1.
#[inline]
pub fn direction_from_face(face: u8, u: f64, v: f64) -> DVec3 {
    match face {
        0 => DVec3::new(1.0, -v, -u),
        1 => DVec3::new(-1.0, -v, u),
        2 => DVec3::new(u, 1.0, v),
        3 => DVec3::new(u, -1.0, -v),
        4 => DVec3::new(u, -v, 1.0),
        _ => DVec3::new(-u, -v, -1.0),
    }
}

/// Components of a vector to the right, down and out of a face.
#[inline]
pub fn along_face(face: u8, d: DVec3) -> (f64, f64, f64) {
    match face {
        0 => (-d.z, -d.y, d.x),
        1 => (d.z, -d.y, -d.x),
        2 => (d.x, d.z, d.y),
        3 => (d.x, -d.z, -d.y),
        4 => (d.x, -d.y, d.z),
        _ => (-d.x, -d.y, -d.z),
    }
}

/// Face, u and v of a direction of any length: the inverse of `direction_from_face`. Edges belong to the axis that
/// comes first in the alphabet.
#[inline]
pub fn face_from_direction(d: DVec3) -> (u8, f64, f64) {
    // Tables instead of branches, which random directions would make the processor guess wrongly.
    let size = d.abs();
    let not_x = (size.x < size.y) | (size.x < size.z);
    let axis = usize::from(not_x) + usize::from(not_x & (size.y < size.z));
    let major = [d.x, d.y, d.z][axis];
    let sign = 1.0f64.copysign(major);
    let u = [-sign * d.z, d.x, sign * d.x][axis] / major.abs();
    let v = [-d.y, sign * d.z, -d.y][axis] / major.abs();
    (2 * axis as u8 + u8::from(major < 0.0), u, v)
}

/// Position −1..1 of the centre of a row or column.
#[inline]
pub fn center_of(index: u32, size: u32) -> f64 {
    (f64::from(index) + 0.5) * 2.0 / f64::from(size) - 1.0
}

/// Direction (longest component ±1) of a texel's centre.
#[inline]
pub fn direction_from_texel(texel: u32, size: u32) -> DVec3 {
    let (row, column) = (texel / size, texel % size);
    direction_from_face((row / size) as u8, center_of(column, size), center_of(row % size, size))
}

/// Number of the texel that a direction passes through.
#[inline]
pub fn texel_from_direction(d: DVec3, size: u32) -> u32 {
    let (face, u, v) = face_from_direction(d);
    // Casts of floats saturate: u = 1 is the only value that needs the upper bound.
    let index = |x: f64| (((x + 1.0) * 0.5 * f64::from(size)) as u32).min(size - 1);
    (u32::from(face) * size + index(v)) * size + index(u)
}
