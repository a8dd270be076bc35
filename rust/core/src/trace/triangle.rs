//! Watertight ray–triangle intersection.
//!
//! Woop, Benthin, Wald: Watertight ray/triangle intersection, JCGT 2(1), 2013. Corners are sheared so that the ray
//! becomes the z axis. Both triangles that share an edge then compute the same sign for it, and 0 counts as inside.

use glam::Vec3;

use super::lanes::{Isa, Lanes};

/// Range of determinants that float32 gives correctly. Others come from products that overflow or underflow, and are
/// recomputed in float64.
const MIN_DETERMINANT: f32 = 1e-30;
const MAX_DETERMINANT: f32 = 1e30;
/// Maximum number of lanes of any instruction set.
const MAX_LANES: usize = 16;

/// Shear along a ray direction: the axis that becomes z, and the slopes of the other two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Shear {
    pub(crate) axes: [usize; 3],
    pub(crate) scale: [f32; 3],
}

impl Shear {
    /// Computes the shear; the axis of the longest component becomes z.
    #[inline(always)]
    pub(crate) fn new(direction: Vec3) -> Self {
        let d = direction.to_array();
        let size = direction.abs();
        let z = if size.x > size.y && size.x > size.z {
            0
        } else if size.y > size.z {
            1
        } else {
            2
        };
        // If the ray points towards −z, x and y are exchanged, which preserves the orientation.
        let (x, y) = if d[z] < 0.0 { ((z + 2) % 3, (z + 1) % 3) } else { ((z + 1) % 3, (z + 2) % 3) };
        Self { axes: [x, y, z], scale: [d[x] / d[z], d[y] / d[z], 1.0 / d[z]] }
    }
}

/// Ray parameters and barycentric weights; valid only for the lanes in `mask`.
#[derive(Clone, Copy)]
pub(crate) struct Crossing<L> {
    pub(crate) mask: u32,
    pub(crate) t: L,
    pub(crate) u: L,
    pub(crate) v: L,
}

/// Intersects lanes of rays and triangles. Corners are relative to the origin, with axes already in the shear's order.
#[inline(always)]
pub(crate) fn intersect<I: Isa, L: Lanes<I>>(
    isa: I,
    corners: [[L; 3]; 3],
    scale: [L; 3],
    active: u32,
) -> Option<Crossing<L>> {
    let [a, b, c] = corners;
    let [(ax, ay), (bx, by), (cx, cy)] = [flatten(a, scale), flatten(b, scale), flatten(c, scale)];
    let u = cx.mul(by).sub(cy.mul(bx));
    let v = ax.mul(cy).sub(ay.mul(cx));
    let w = bx.mul(ay).sub(by.mul(ax));
    let zero = L::splat(isa, 0.0);
    let mixed = u.min(v).min(w).lt(zero) & zero.lt(u.max(v).max(w));
    let mut mask = active & !mixed;
    if mask == 0 {
        return None;
    }
    let determinant = u.add(v).add(w);
    let (az, bz, cz) = (scale[2].mul(a[2]), scale[2].mul(b[2]), scale[2].mul(c[2]));
    let t = u.mul(az).add(v.mul(bz)).add(w.mul(cz)).div(determinant);
    let mut crossing = Crossing { mask, t, u: v.div(determinant), v: w.div(determinant) };
    let size = determinant.abs();
    let in_range = L::splat(isa, MIN_DETERMINANT).lt(size) & size.lt(L::splat(isa, MAX_DETERMINANT));
    let special = mask & (u.eq(zero) | v.eq(zero) | w.eq(zero) | !in_range);
    if special != 0 {
        let (mut sheared, mut values) = ([[[0.0; MAX_LANES]; 3]; 3], [[0.0; MAX_LANES]; 3]);
        let corners = [[ax, ay, az], [bx, by, bz], [cx, cy, cz]];
        for corner in 0..3 {
            for axis in 0..3 {
                corners[corner][axis].store(&mut sheared[corner][axis]);
            }
        }
        crossing.t.store(&mut values[0]);
        crossing.u.store(&mut values[1]);
        crossing.v.store(&mut values[2]);
        mask = (mask & !special) | recompute(&sheared, special, &mut values);
        let (t, u, v) = (L::load(isa, &values[0]), L::load(isa, &values[1]), L::load(isa, &values[2]));
        crossing = Crossing { mask, t, u, v };
    }
    (mask != 0).then_some(crossing)
}

/// Applies the shear: projects a corner along the ray onto the plane of x and y.
#[inline(always)]
fn flatten<I, L: Lanes<I>>(p: [L; 3], scale: [L; 3]) -> (L, L) {
    (p[0].sub(scale[0].mul(p[2])), p[1].sub(scale[1].mul(p[2])))
}

/// Recomputes the lanes of `special` in float64, where products of float32 numbers are exact: a remaining zero is
/// exact, and nothing overflows. Writes the values of lanes that hit and returns their mask.
#[cold]
#[inline(never)]
fn recompute(sheared: &[[[f32; MAX_LANES]; 3]; 3], special: u32, values: &mut [[f32; MAX_LANES]; 3]) -> u32 {
    let mut mask = 0;
    for lane in (0..MAX_LANES).filter(|lane| special >> lane & 1 == 1) {
        let [a, b, c] = [0, 1, 2].map(|corner: usize| sheared[corner].map(|axis| f64::from(axis[lane])));
        if let Some(hit) = intersect_exactly(a, b, c) {
            (0..3).for_each(|i| values[i][lane] = hit[i] as f32);
            mask |= 1 << lane;
        }
    }
    mask
}

/// Returns the parameter and the weights of b and c, from sheared corners.
fn intersect_exactly(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> Option<[f64; 3]> {
    let edge = |p: [f64; 3], q: [f64; 3]| p[0] * q[1] - p[1] * q[0];
    let (u, v, w) = (edge(c, b), edge(a, c), edge(b, a));
    if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
        return None;
    }
    let determinant = u + v + w;
    let values = [(u * a[2] + v * b[2] + w * c[2]) / determinant, v / determinant, w / determinant];
    // Triangles seen edge-on and degenerate triangles have no inside.
    (determinant != 0.0 && values.iter().all(|x| x.is_finite())).then_some(values)
}
