//! The bent rays of a tile: polynomials in the position within the tile, through the bent rays of its corners.

use glam::{Vec3, Vec4, Vec4Swizzles};

use super::corner::Corner;
use crate::base::Aabb;

/// Share of a tile's width by which rays inside the tile may leave the box about its corner rays. Unit directions bulge
/// between corners by at most an eighth of the tile's angle.
const BULGE: f32 = 0.1;

/// One of `parts` × `parts` parts of a tile.
#[derive(Clone, Copy)]
pub(super) struct TilePart {
    pub parts: usize,
    pub x: usize,
    pub y: usize,
}

impl TilePart {
    pub const WHOLE: Self = Self { parts: 1, x: 0, y: 0 };
}

/// The bends of the rays of a tile, or of a part of it.
pub(super) struct Cell {
    part: TilePart,
    /// Number of legs between the radii.
    pub legs: usize,
    bends: Bends,
    /// Bounding box of each bend over all rays of the tile.
    boxes: Vec<Aabb>,
}

/// Offset of each bend and its position along the ray, as coefficients of powers of x and y across the tile.
enum Bends {
    /// Of 1, x, y and xy.
    Linear(Vec<[Vec4; 4]>),
    /// Of 1, x, x² and the same times y and times y².
    Quadratic(Vec<[Vec4; 9]>),
}

impl Cell {
    /// Between four corners in row order.
    pub fn linear(corners: [&Corner; 4], user: Vec3, part: TilePart) -> Self {
        let legs = legs_of(&corners);
        let (mut bends, mut boxes) = (Vec::with_capacity(legs + 1), Vec::with_capacity(legs + 1));
        for k in 0..=legs {
            let around = corners.map(|corner| corner.bend(k, legs));
            let [a, b, c, d] = around;
            bends.push([a, b - a, c - a, (d - c) - (b - a)]);
            boxes.push(hull(corners, around, user));
        }
        Self { part, legs, bends: Bends::Linear(bends), boxes }
    }

    /// Through nine corners in row order; the tile's first one stands in this column and row of them, 0 or 1.
    pub fn quadratic(corners: &[&Corner; 9], first: [usize; 2], user: Vec3) -> Self {
        let legs = legs_of(corners);
        let (mut bends, mut boxes) = (Vec::with_capacity(legs + 1), Vec::with_capacity(legs + 1));
        let at = first[1] * 3 + first[0];
        let own = [at, at + 1, at + 3, at + 4];
        for k in 0..=legs {
            let all = corners.map(|corner| corner.bend(k, legs));
            let rows = [0, 3, 6].map(|n| parabola([all[n], all[n + 1], all[n + 2]], first[0]));
            let [ones, xs, squares] = [0, 1, 2].map(|n| parabola(rows.map(|row| row[n]), first[1]));
            bends.push([ones[0], xs[0], squares[0], ones[1], xs[1], squares[1], ones[2], xs[2], squares[2]]);
            boxes.push(hull(own.map(|n| corners[n]), own.map(|n| all[n]), user));
        }
        Self { part: TilePart::WHOLE, legs, bends: Bends::Quadratic(bends), boxes }
    }

    /// Position within this part of a position in the tile; `None` for positions in other parts.
    #[inline]
    pub fn within(&self, spot: [f32; 2]) -> Option<[f32; 2]> {
        let TilePart { parts, x, y } = self.part;
        let [u, v] = spot.map(|share| share * parts as f32);
        // Positions in a tile are below 1, so each lies in exactly one part.
        ((u as usize, v as usize) == (x, y)).then_some([u - x as f32, v - y as f32])
    }

    /// Position of the k-th bend of a ray relative to the user, from its direction and its position in the part.
    #[inline]
    pub fn bend(&self, k: usize, direction: Vec3, [x, y]: [f32; 2]) -> Vec3 {
        let v = match &self.bends {
            Bends::Linear(bends) => {
                let [one, right, down, both] = bends[k];
                one + right * x + (down + both * x) * y
            }
            Bends::Quadratic(bends) => {
                let [a, b, c, d, e, f, g, h, i] = bends[k];
                let row = |one: Vec4, x1: Vec4, x2: Vec4| one + (x1 + x2 * x) * x;
                row(a, b, c) + (row(d, e, f) + row(g, h, i) * y) * y
            }
        };
        direction * v.w + v.xyz()
    }

    /// Bounding box of the tile's rays between two bends.
    pub fn region(&self, from: usize, to: usize) -> Aabb {
        let mut region = Aabb::EMPTY;
        for bends in &self.boxes[from..=to] {
            region.extend(bends.min);
            region.extend(bends.max);
        }
        region
    }
}

fn legs_of(corners: &[&Corner]) -> usize {
    corners.iter().map(|corner| corner.legs).max().unwrap_or_default()
}

/// Coefficients of 1, x and x² of the parabola through three values, x being 0 at the `first` of them and 1 at the next.
fn parabola([a, b, c]: [Vec4; 3], first: usize) -> [Vec4; 3] {
    let square = 0.5 * (a + c) - b;
    match first {
        0 => [a, b - a - square, square],
        _ => [b, 0.5 * (c - a), square],
    }
}

/// Bounding box of a bend of all rays between four corners.
fn hull(corners: [&Corner; 4], bends: [Vec4; 4], user: Vec3) -> Aabb {
    around(&[0, 1, 2, 3].map(|n| user + corners[n].direction * bends[n].w + bends[n].xyz()))
}

/// Bounding box of the rays between the four corners of a tile, given in row order.
fn around(points: &[Vec3; 4]) -> Aabb {
    let mut region = Aabb::EMPTY;
    points.iter().for_each(|&point| region.extend(point));
    let widest = (points[3] - points[0]).abs().max((points[2] - points[1]).abs()).max_element();
    let margin = Vec3::splat(BULGE * widest);
    Aabb { min: region.min - margin, max: region.max + margin }
}

#[cfg(test)]
mod tests {
    use glam::Vec4;

    use super::parabola;

    #[test]
    fn parabolas_meet_their_points() {
        let f = |x: f32| Vec4::splat(3.0 - 2.0 * x + 0.5 * x * x);
        for (first, at) in [(0, [0.0, 1.0, 2.0]), (1, [-1.0, 0.0, 1.0])] {
            let [one, x, square] = parabola(at.map(f), first);
            assert_eq!((one, x, square), (Vec4::splat(3.0), Vec4::splat(-2.0), Vec4::splat(0.5)));
        }
    }
}
