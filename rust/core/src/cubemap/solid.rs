//! Solid angles of rectangles on a face.

use glam::DVec3;
use rayon::prelude::*;

use super::faces::check_size;
use crate::base::{Error, Result};

/// Solid angle in steradians of a rectangle between two positions across and two down a face, within −1..1.
///
/// Two triangles by van Oosterom and Strackee, "The solid angle of a plane triangle" (1983), Eq. 8. The triple product
/// of corners at distance 1 from the centre is Δu Δv, so that no digits are lost however small the rectangle is: four
/// lengths, six products and a few sums of positive numbers leave some 8 roundings of 1.1e-16.
#[inline]
pub(super) fn solid_angle(u: [f64; 2], v: [f64; 2]) -> f64 {
    let corner = |i: usize, j: usize| {
        let p = DVec3::new(u[i], v[j], 1.0);
        (p, p.length())
    };
    let (a, b, c, d) = (corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1));
    let product = (u[1] - u[0]) * (v[1] - v[0]);
    2.0 * (triangle(product, a, b, c) + triangle(product, a, c, d))
}

/// Half the solid angle of a triangle of three points and their lengths.
#[inline]
fn triangle(product: f64, a: (DVec3, f64), b: (DVec3, f64), c: (DVec3, f64)) -> f64 {
    let below = a.1 * b.1 * c.1 + a.0.dot(b.0) * c.1 + b.0.dot(c.0) * a.1 + c.0.dot(a.0) * b.1;
    let tangent = product / below;
    if tangent < 0.01 {
        // The series of the arc tangent; the first term left out is below 2e-17 of the first.
        let square = tangent * tangent;
        return tangent * (1.0 - square * (1.0 / 3.0 - square * (0.2 - square * (1.0 / 7.0))));
    }
    tangent.atan()
}

/// Position of the line before a row or column.
#[inline]
pub(super) fn edge_of(index: u32, size: u32) -> f64 {
    f64::from(index) * 2.0 / f64::from(size) - 1.0
}

/// Writes the solid angle of each texel of a face, the same for all six, row by row.
pub fn solid_angles(size: u32, out: &mut [f64]) -> Result<()> {
    check_size(size)?;
    let count = (size as usize).pow(2);
    if out.len() != count {
        return Err(Error::value("out", format!("{count} values"), out.len()));
    }
    out.par_chunks_mut(size as usize).zip(0..size).for_each(|(out, row)| {
        // Mirrored texels are equal bit for bit: rows and columns are counted from the nearer edge.
        let near = |index: u32| {
            let index = index.min(size - 1 - index);
            [edge_of(index, size), edge_of(index + 1, size)]
        };
        let down = near(row);
        for (column, value) in out.iter_mut().enumerate() {
            let across = near(column as u32);
            *value = if across[0] < down[0] { solid_angle(across, down) } else { solid_angle(down, across) };
        }
    });
    Ok(())
}
