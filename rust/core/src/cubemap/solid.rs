//! Solid angles of rectangles on a cube face.

use rayon::prelude::*;

use super::faces::{check_out, check_size};
use crate::base::simd::vectorized;
use crate::base::{Progress, Result};

/// Minimum face width, in texels, at which half the solid angle of each triangle is below 0.01 sr, as `fine_row` needs.
const FINE_SIZE: u32 = 32;

/// Returns the solid angle in steradians of the rectangle between two positions u across and two v down a face.
///
/// It is the sum of two triangles (van Oosterom and Strackee, "The solid angle of a plane triangle", 1983, Eq. 8). The
/// triple product of three corners on the face's plane is Δu Δv, so small rectangles lose no digits. Four lengths, six
/// products and some sums of positive numbers cause about 8 roundings of 1.1e-16.
pub(super) fn solid_angle(u: [f64; 2], v: [f64; 2]) -> f64 {
    let [first, second] = tangents(u, v);
    2.0 * (first.atan() + second.atan())
}

/// Returns the tangents of half the solid angles of both triangles. The sum has the same bits after exchanging u and v.
#[inline(always)]
fn tangents(u: [f64; 2], v: [f64; 2]) -> [f64; 2] {
    let (uu, vv) = (u[0] * u[1] + 1.0, v[0] * v[1] + 1.0);
    let (u0, u1, v0, v1) = (u[0] * u[0], u[1] * u[1], v[0] * v[0], v[1] * v[1]);
    // Distances of the corners: a at (u₀, v₀), b at (u₁, v₀), c at (u₁, v₁), d at (u₀, v₁).
    let (a, c) = ((u0 + v0 + 1.0).sqrt(), (u1 + v1 + 1.0).sqrt());
    let (b, d) = ((u1 + v0 + 1.0).sqrt(), (u0 + v1 + 1.0).sqrt());
    let product = (u[1] - u[0]) * (v[1] - v[0]);
    let across = uu + (vv - 1.0);
    [
        product / ((a * c * b + across * b) + ((uu + v0) * c + (vv + u1) * a)),
        product / ((a * c * d + across * d) + ((vv + u0) * c + (uu + v1) * a)),
    ]
}

/// Writes the solid angles of a row of rectangles between neighbouring edges. Each tangent must be below 0.01.
#[inline(always)]
fn fine_row(edges: &[f64], down: [f64; 2], out: &mut [f64]) {
    let (left, right) = (&edges[..out.len()], &edges[1..out.len() + 1]);
    for i in 0..out.len() {
        let t = tangents([left[i], right[i]], down);
        // Series of the arc tangent; the first omitted term is below 2e-17 of the first term.
        let (s0, s1) = (t[0] * t[0], t[1] * t[1]);
        let first = t[0] * (1.0 - s0 * (1.0 / 3.0 - s0 * (0.2 - s0 * (1.0 / 7.0))));
        let second = t[1] * (1.0 - s1 * (1.0 / 3.0 - s1 * (0.2 - s1 * (1.0 / 7.0))));
        out[i] = 2.0 * (first + second);
    }
}

vectorized! { fn fine_row_wide(edges: &[f64], down: [f64; 2], out: &mut [f64]) = fine_row; }

/// Returns the positions of all column edges of a face, from −1 to 1.
pub(super) fn edges(size: u32) -> Vec<f64> {
    (0..=size).map(|index| edge_of(index, size)).collect()
}

/// Writes the solid angles of a row of texels, given the column edges. Mirrored rows and columns have the same bits.
pub(super) fn row_of_angles(row: u32, size: u32, edges: &[f64], out: &mut [f64]) {
    let near = row.min(size - 1 - row) as usize;
    let down = [edges[near], edges[near + 1]];
    let half = out.len().div_ceil(2);
    if size >= FINE_SIZE {
        fine_row_wide(edges, down, &mut out[..half]);
    } else {
        for (column, value) in out[..half].iter_mut().enumerate() {
            *value = solid_angle([edges[column], edges[column + 1]], down);
        }
    }
    let (first, second) = out.split_at_mut(half);
    for (value, mirrored) in second.iter_mut().rev().zip(first) {
        *value = *mirrored;
    }
}

/// Returns the position of the edge before a row or column, −1 to 1.
#[inline]
pub(super) fn edge_of(index: u32, size: u32) -> f64 {
    f64::from(index) * 2.0 / f64::from(size) - 1.0
}

/// Writes the solid angles of the texels of one face, row by row. All six faces have the same values.
pub fn solid_angles(size: u32, out: &mut [f64], progress: &Progress) -> Result<()> {
    check_size(size)?;
    check_out(out, (size as usize).pow(2))?;
    let edges = edges(size);
    out.par_chunks_mut(size as usize).zip(0..size).try_for_each(|(out, row)| {
        row_of_angles(row, size, &edges, out);
        progress.check()
    })
}
