//! Seamless linear filtering: the texels around a direction and their weights.
//!
//! Inside a face the filter is bilinear. Clamping at a face's edge would show the seam. Graphics hardware takes the
//! neighbour's nearest texel, which displaces the picture by up to a quarter of a texel, because the gnomonic grids of
//! two faces do not align at their edge. Here the strip between the outermost texel centres of two faces is a bilinear
//! patch in space, symmetric in both faces, and the three outermost texel centres at a corner span a triangle. So the
//! filtered map is continuous, and its error has the same order at seams as inside faces.

use glam::DVec3;

use super::super::faces::{center_of, texel_from_direction};
use crate::camera::face_from_direction;

/// Up to four texels and their weights, which add up to 1. Unused taps have weight 0 and a valid texel number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Taps {
    /// Texel numbers.
    pub texel: [u32; 4],
    /// Weights, 0 to 1.
    pub weight: [f64; 4],
}

impl Taps {
    /// Returns the taps of a direction of any length (finite, not zero) on faces of `size` × `size` texels.
    #[inline]
    pub fn new(d: DVec3, size: u32) -> Self {
        let (face, u, v) = face_from_direction(d);
        // Half a texel in units of u and v: texel centres lie within ±(1 − half).
        let half = 1.0 / f64::from(size);
        if u.abs() > 1.0 - half || v.abs() > 1.0 - half {
            return Self::new_at_seam(d, size);
        }
        let (column, s) = texel_at_or_before(u, size);
        let (row, t) = texel_at_or_before(v, size);
        let first = (u32::from(face) * size + row) * size + column;
        // At the last row or column the fraction is 0, and both taps use the same texel.
        let right = u32::from(column + 1 < size);
        let down = if row + 1 < size { size } else { 0 };
        Self {
            texel: [first, first + right, first + down, first + down + right],
            weight: [(1.0 - s) * (1.0 - t), s * (1.0 - t), (1.0 - s) * t, s * t],
        }
    }

    #[cold]
    fn new_at_seam(d: DVec3, size: u32) -> Self {
        let axes = axes_by_size(d.abs());
        let scale = d.abs()[axes[0]];
        let m = axes.map(|axis| d.abs()[axis] / scale);
        // Returns the texel at a point in the octant of d, given its components along the axes in the order of `axes`.
        let texel = |x: f64, y: f64, z: f64| {
            let mut p = DVec3::ZERO;
            for (axis, value) in axes.into_iter().zip([x, y, z]) {
                p[axis] = value * d[axis].signum();
            }
            texel_from_direction(p, size)
        };
        let half = 1.0 / f64::from(size);
        let row = 1.0 - half;

        // The patch between both faces' outermost rows is P(s, a) = (1−s) (1, 1−half, a) + s (1−half, 1, a). The ray
        // along d meets it at these s and a (`along`).
        let s = (m[1] - row) / (half * (1.0 + m[1]));
        let along = m[2] * (1.0 - s * half);
        if along <= row {
            let (index, t) = texel_at_or_before(along, size);
            let (low, high) = (center_of(index, size), center_of((index + 1).min(size - 1), size));
            return Self {
                texel: [texel(1.0, row, low), texel(1.0, row, high), texel(row, 1.0, low), texel(row, 1.0, high)],
                weight: [(1.0 - s) * (1.0 - t), (1.0 - s) * t, s * (1.0 - t), s * t],
            };
        }

        // The corner triangle is (1, row, row), (row, 1, row), (row, row, 1); `weight` are d's barycentric coordinates.
        let sum = (m[0] + m[1] + m[2]) / (1.0 + 2.0 * row);
        let weight = m.map(|x| ((x / sum - row) / half).max(0.0));
        let total = weight[0] + weight[1] + weight[2];
        let corner = [texel(1.0, row, row), texel(row, 1.0, row), texel(row, row, 1.0)];
        Self {
            texel: [corner[0], corner[1], corner[2], corner[0]],
            weight: [weight[0] / total, weight[1] / total, weight[2] / total, 0.0],
        }
    }
}

/// Returns the texel whose centre lies at or before a position, and the fraction of the way to the next centre.
/// Positions lie within the outermost centres.
#[inline]
fn texel_at_or_before(position: f64, size: u32) -> (u32, f64) {
    let x = ((position + 1.0) * 0.5 * f64::from(size) - 0.5).max(0.0);
    let index = (x as u32).min(size.saturating_sub(1));
    let fraction = if index + 1 < size { x - f64::from(index) } else { 0.0 };
    (index, fraction)
}

/// Returns the axes in the order of their components, largest first.
pub(super) fn axes_by_size(size: DVec3) -> [usize; 3] {
    let mut axes = [0, 1, 2];
    axes.sort_by(|&a, &b| size[b].total_cmp(&size[a]));
    axes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cubemap::direction_from_texel;
    use proptest::prelude::*;

    fn filtered(d: DVec3, size: u32, f: impl Fn(DVec3) -> f64) -> f64 {
        let taps = Taps::new(d, size);
        taps.texel.iter().zip(taps.weight).map(|(&t, w)| w * f(direction_from_texel(t, size).normalize())).sum()
    }

    #[test]
    fn a_texel_centre_is_its_own_tap() {
        for size in [1, 2, 5, 16] {
            for texel in 0..6 * size * size {
                let taps = Taps::new(direction_from_texel(texel, size), size);
                let own: f64 = (0..4).filter(|&i| taps.texel[i] == texel).map(|i| taps.weight[i]).sum();
                // Weights are differences of numbers near 1, rounded by 1.1e-16, divided by at least 1/16.
                assert!((own - 1.0).abs() < 1e-13, "{size} {texel} {taps:?}");
            }
        }
    }

    #[test]
    fn a_corner_is_the_mean_of_its_three_texels() {
        for size in [1, 4, 9] {
            let taps = Taps::new(DVec3::new(-3.0, 3.0, -3.0), size);
            let mut weights = taps.weight;
            weights.sort_by(f64::total_cmp);
            for (weight, expected) in weights.into_iter().zip([0.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0]) {
                // Barycentric weights of float64 coordinates below 1: some tens of roundings of 1.1e-16.
                assert!((weight - expected).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn errors_at_seams_are_no_larger_than_inside() {
        // Errors of a smooth function in 10⁵ directions: within half a texel of an edge, and elsewhere.
        let f = |d: DVec3| (1.7 * d.x - 0.6 * d.y).sin() + 0.8 * (2.1 * d.z + d.y).cos();
        for size in [8, 32, 128] {
            let (mut seam, mut inside) = (0.0f64, 0.0f64);
            for i in 0..100_000u64 {
                let component = |k| 2.0 * crate::base::random::uniform(3, k, i) - 1.0;
                let d = DVec3::new(component(0), component(1), component(2));
                let m = d.abs() / d.abs().max_element();
                let second = m.x + m.y + m.z - 1.0 - m.min_element();
                let error = (filtered(d, size, f) - f(d.normalize())).abs();
                let worst = if second > 1.0 - 1.0 / f64::from(size) { &mut seam } else { &mut inside };
                *worst = worst.max(error);
            }
            assert!(seam <= inside, "size {size}: {seam} at seams, {inside} inside");
        }
    }

    proptest! {
        #[test]
        fn weights_are_a_partition_of_one(
            x in -1.0..1.0f64, y in -1.0..1.0f64, z in -1.0..1.0f64, size in 1..40u32, flat in 0..4u8,
        ) {
            // Exact edges and corners, where the cases meet.
            let d = match flat {
                0 => DVec3::new(x, y, z),
                1 => DVec3::new(x, x, z),
                2 => DVec3::new(x, -x, x),
                _ => DVec3::new(x, 0.0, z),
            };
            prop_assume!(d.abs().max_element() > 1e-9);
            let taps = Taps::new(d, size);
            // Weights are differences of numbers near 1, with roundings of 1.1e-16, divided by half a texel, at least
            // 1/39. The bound leaves a margin.
            prop_assert!((taps.weight.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            prop_assert!(taps.weight.iter().all(|w| (-1e-12..=1.0 + 1e-12).contains(w)));
            prop_assert!(taps.texel.iter().all(|&t| t < 6 * size * size));
        }

        #[test]
        fn filtered_maps_are_continuous(
            x in -1.0..1.0f64, y in -1.0..1.0f64, z in -1.0..1.0f64, size in 1..40u32, flat in 0..4u8, seed in 0..99u64,
        ) {
            let d = match flat {
                0 => DVec3::new(x, y, z),
                1 => DVec3::new(x, x, z),
                2 => DVec3::new(x, -x, x),
                // The line between the inside of a face and the strip along its edge.
                _ => DVec3::new(1.0, 1.0 - 1.0 / f64::from(size), y),
            };
            prop_assume!(d.abs().max_element() > 1e-3);
            let value = |d: DVec3| {
                let taps = Taps::new(d, size);
                let random = |t: u32| crate::base::random::uniform(seed, 0, t.into());
                taps.texel.iter().zip(taps.weight).map(|(&t, w)| w * random(t)).sum::<f64>()
            };
            let here = value(d);
            let step = 1e-9 * d.abs().max_element();
            for offset in [DVec3::X, DVec3::Y, DVec3::Z, DVec3::new(-1.0, 1.0, -1.0)] {
                // A weight changes by at most about `size` per unit of direction. Two look-ups have eight taps, and no
                // offset is longer than 1.8 steps: 8 × size × 1.8e-9 < 2e-8 × (size + 1).
                prop_assert!((value(d + offset * step) - here).abs() < 2e-8 * f64::from(size + 1));
            }
        }
    }
}
