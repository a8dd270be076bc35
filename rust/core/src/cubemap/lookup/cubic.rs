//! Seamless cubic filtering where the filter needs texels beyond one face.
//!
//! Each face is extended by a border of two texels (`BorderTexel`), so that Keys' cubic reconstructs the map up to half
//! a texel beyond the face's edges. Within half a texel of an edge or corner, the reconstructions of the adjacent faces
//! are blended symmetrically. So the filtered map and its first derivative across edges are continuous.

use glam::DVec3;
use rayon::prelude::*;

use super::super::faces::{CubeFaces, center_of, texel_from_direction};
use super::blocks::keys;
use super::taps::axes_by_size;
use crate::base::{Real, Result, memory::try_vec};
use crate::camera::{along_face, direction_from_face};

/// Width of the border around each face, texels.
const BORDER: i32 = 2;

/// Faces with a border around each of them.
pub(super) struct BorderedFaces<'a, T> {
    faces: CubeFaces<'a, T>,
    /// Values in the border of each face, channels innermost; empty if they are computed on demand.
    table: Vec<f64>,
}

impl<'a, T: Real> BorderedFaces<'a, T> {
    pub fn new(faces: CubeFaces<'a, T>, use_table: bool) -> Result<Self> {
        let mut table = Vec::new();
        if use_table && faces.channels > 0 {
            let border = border_positions(faces.size);
            table = try_vec(0.0, 6 * border.len() * faces.channels)?;
            table.par_chunks_mut(faces.channels).with_min_len(64).enumerate().for_each(|(index, values)| {
                let (row, column) = border[index % border.len()];
                let taps = BorderTexel::new((index / border.len()) as u8, row, column, faces.size);
                for (channel, value) in values.iter_mut().enumerate() {
                    *value = taps.value(&faces, channel);
                }
            });
        }
        Ok(Self { faces, table })
    }

    /// Writes the value in a direction (finite, not zero).
    pub fn sample(&self, d: DVec3, out: &mut [T]) {
        let size = self.faces.size;
        let m = d.abs() / d.abs().max_element();
        let face_weights = m.to_array().map(|x| face_weight(x, size));
        let total = face_weights[0] + face_weights[1] + face_weights[2];
        // Four channels at a time, so that the sums fit in an array of fixed size.
        for (group, out) in out.chunks_mut(4).enumerate() {
            let mut sums = [0.0; 4];
            for axis in (0..3).filter(|&axis| face_weights[axis] > 0.0) {
                self.add_face(d, axis, face_weights[axis] / total, 4 * group, &mut sums[..out.len()]);
            }
            for (value, sum) in out.iter_mut().zip(sums) {
                *value = T::narrow(sum);
            }
        }
    }

    /// Adds the reconstruction of an axis' face, times `face_weight`, to the sums of the channels from `first` on.
    fn add_face(&self, d: DVec3, axis: usize, face_weight: f64, first: usize, sums: &mut [f64]) {
        let size = self.faces.size;
        let (face, u, v) = project_to_axis(d, axis);
        let (column, across) = taps(u, size);
        let (row, down) = taps(v, size);
        for (j, weight_down) in down.into_iter().enumerate() {
            for (i, weight_across) in across.into_iter().enumerate() {
                let weight = face_weight * weight_down * weight_across;
                let position = (row - 1 + j as i32, column - 1 + i as i32);
                let inside = (0..size as i32).contains(&position.0) && (0..size as i32).contains(&position.1);
                if inside {
                    let number = (u32::from(face) * size + position.0 as u32) * size + position.1 as u32;
                    for (sum, value) in sums.iter_mut().zip(&self.faces.texel(number)[first..]) {
                        *sum += weight * value.wide();
                    }
                } else if self.table.is_empty() {
                    let taps = BorderTexel::new(face, position.0, position.1, size);
                    for (channel, sum) in sums.iter_mut().enumerate() {
                        *sum += weight * taps.value(&self.faces, first + channel);
                    }
                } else {
                    let number = usize::from(face) * border_count(size) + border_index(position.0, position.1, size);
                    let values = &self.table[number * self.faces.channels..][first..];
                    for (sum, value) in sums.iter_mut().zip(values) {
                        *sum += weight * value;
                    }
                }
            }
        }
    }
}

/// Returns the weight of the face on an axis: 1 on the face itself, falling smoothly to 0 half a texel inside another
/// face. `component` is the direction's absolute component along the axis, relative to the largest.
fn face_weight(component: f64, size: u32) -> f64 {
    let s = 1.0 - (1.0 - component) * f64::from(size);
    if s > 0.0 { s * s * (3.0 - 2.0 * s) } else { 0.0 }
}

/// Returns the face on an axis, and the direction's position on the face's plane, which may lie beyond its edges.
fn project_to_axis(d: DVec3, axis: usize) -> (u8, f64, f64) {
    let face = 2 * axis as u8 + u8::from(d[axis] < 0.0);
    let (right, down, out) = along_face(face, d);
    (face, right / out, down / out)
}

/// Returns the last texel t at or before a position, −1 to `size` − 1, and Keys' weights of the texels t − 1 to t + 2.
fn taps(position: f64, size: u32) -> (i32, [f64; 4]) {
    let x = (position + 1.0) * 0.5 * f64::from(size) - 0.5;
    let before = x.floor().clamp(-1.0, f64::from(size) - 1.0);
    // The neighbouring face's outermost centres lie slightly more than half a texel beyond the edge. There this face's
    // weight is almost 0, so the fraction may be clamped.
    (before as i32, keys((x - before).clamp(0.0, 1.0)))
}

/// Returns row and column of each border texel of a face: two rows above and below, two columns on each side.
fn border_positions(size: u32) -> Vec<(i32, i32)> {
    let size = size as i32;
    let columns = -BORDER..size + BORDER;
    let above = (-BORDER..0).chain(size..size + BORDER);
    let mut positions: Vec<_> = above.flat_map(|row| columns.clone().map(move |column| (row, column))).collect();
    positions
        .extend((0..size).flat_map(|row| (-BORDER..0).chain(size..size + BORDER).map(move |column| (row, column))));
    positions
}

fn border_count(size: u32) -> usize {
    4 * BORDER as usize * (size as usize + BORDER as usize)
}

/// Returns the index of a row and column in `border_positions`.
fn border_index(row: i32, column: i32, size: u32) -> usize {
    let size = size as i32;
    let wide = size + 2 * BORDER;
    let side = |x: i32| if x < 0 { x + BORDER } else { x - size + BORDER };
    let number = if (0..size).contains(&row) {
        2 * BORDER * wide + row * 2 * BORDER + side(column)
    } else {
        side(row) * wide + column + BORDER
    };
    number as usize
}

/// A texel beyond an edge, as numbers and weights of 16 texels of the two faces at the nearest edge.
///
/// Rows parallel to the edge are meridians about the axis parallel to the edge, and the texels of each row are evenly
/// spaced in the tangent of the latitude. On the two outermost rows of each face, four texels are interpolated to the
/// border texel's latitude. The four results are interpolated to its longitude. Both interpolations are cubic
/// polynomials, exact for constants, with an error of fourth order.
struct BorderTexel {
    texel: [u32; 16],
    weight: [f64; 16],
}

impl BorderTexel {
    fn new(face: u8, row: i32, column: i32, size: u32) -> Self {
        let coordinate = |index: i32| (f64::from(index) + 0.5) * 2.0 / f64::from(size) - 1.0;
        let d = direction_from_face(face, coordinate(column), coordinate(row));
        let axes = axes_by_size(d.abs());
        let m = axes.map(|axis| d.abs()[axis]);
        let tangent = m[2] / m[0].hypot(m[1]);

        // The coordinate across rows, (y − x)/(y + x) of the two larger components x and y, is smooth in the longitude.
        let rows = size.min(2) as usize;
        let mut ratios = [0.0; 4];
        for k in 0..rows {
            let b = center_of(size - 1 - k as u32, size);
            ratios[rows - 1 - k] = (b - 1.0) / (b + 1.0);
            ratios[rows + k] = (1.0 - b) / (1.0 + b);
        }
        let longitude = (m[1] - m[0]) / (m[1] + m[0]);
        let mut taps = Self { texel: [0; 16], weight: [0.0; 16] };
        let points = size.min(4) as usize;
        for n in 0..2 * rows {
            // Components of the row's points along the two larger axes; one of them is 1.
            let (x, y) = if n < rows {
                (1.0, center_of(size - rows as u32 + n as u32, size))
            } else {
                (center_of(size - 1 - (n - rows) as u32, size), 1.0)
            };
            let across = lagrange(&ratios[..2 * rows], n, longitude);
            let position = (tangent * f64::hypot(x, y) + 1.0) * 0.5 * f64::from(size) - 0.5;
            let first = (position.floor() - 1.0).clamp(0.0, f64::from(size) - points as f64);
            for k in 0..points {
                let along = lagrange(&[0.0, 1.0, 2.0, 3.0][..points], k, position - first);
                let mut p = DVec3::ZERO;
                for (axis, value) in axes.into_iter().zip([x, y, center_of(first as u32 + k as u32, size)]) {
                    p[axis] = value * 1.0f64.copysign(d[axis]);
                }
                taps.texel[4 * n + k] = texel_from_direction(p, size);
                taps.weight[4 * n + k] = across * along;
            }
        }
        taps
    }

    fn value<T: Real>(&self, faces: &CubeFaces<'_, T>, channel: usize) -> f64 {
        let mut sum = 0.0;
        for (&texel, weight) in self.texel.iter().zip(self.weight) {
            if weight != 0.0 {
                sum += weight * faces.texel(texel)[channel].wide();
            }
        }
        sum
    }
}

/// Evaluates the Lagrange polynomial that is 1 at node `n` and 0 at the others.
fn lagrange(nodes: &[f64], n: usize, x: f64) -> f64 {
    let mut product = 1.0;
    for (k, node) in nodes.iter().enumerate() {
        if k != n {
            product *= (x - node) / (nodes[n] - node);
        }
    }
    product
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn border_texels_are_numbered_in_order() {
        for size in [1, 2, 3, 8] {
            let positions = border_positions(size);
            assert_eq!(positions.len(), border_count(size));
            for (number, &(row, column)) in positions.iter().enumerate() {
                assert_eq!(border_index(row, column, size), number);
            }
        }
    }

    #[test]
    fn texels_beyond_edges_have_errors_of_the_fourth_order() {
        let f = |d: DVec3| {
            let d = d.normalize();
            (1.7 * d.x - 0.6 * d.y).sin() + 0.8 * (2.1 * d.z + d.y).cos()
        };
        let worst = |size: u32| {
            let directions = crate::cubemap::tests::centers(size);
            let values: Vec<f64> = directions.into_iter().map(|d| f(DVec3::from_array(d))).collect();
            let faces = CubeFaces::new(&values, size, 1).unwrap();
            let mut worst = 0.0f64;
            for face in 0..6 {
                for (row, column) in border_positions(size) {
                    let coordinate = |index: i32| (f64::from(index) + 0.5) * 2.0 / f64::from(size) - 1.0;
                    let truth = f(direction_from_face(face, coordinate(column), coordinate(row)));
                    let taps = BorderTexel::new(face, row, column, size);
                    assert!((taps.weight.iter().sum::<f64>() - 1.0).abs() < 1e-12);
                    worst = worst.max((taps.value(&faces, 0) - truth).abs());
                }
            }
            worst
        };
        let errors = [8, 16, 32, 64].map(worst);
        for pair in errors.windows(2) {
            // The limit for fourth order is 2⁴; an interpolation of third order would give 8.
            assert!(pair[0] / pair[1] > 11.0, "{errors:?}");
        }
    }
}
