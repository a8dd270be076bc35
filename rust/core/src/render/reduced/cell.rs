//! Bent rays of a tile, interpolated by polynomials from the bent rays of its corners.

use glam::{Vec3, Vec4, Vec4Swizzles};

use super::corner::Corner;
use crate::base::Aabb;

/// Fraction of a tile's width by which rays inside the tile may leave the box of its corner rays. Unit directions
/// bulge between corners by at most an eighth of the tile's angle.
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

/// Bends of the rays of a tile, or of a part of it.
pub(super) struct Cell<'a> {
    part: TilePart,
    corners: Corners<'a>,
    /// Number of legs between the radii.
    pub legs: usize,
    /// Bounding box of each bend over all rays of the tile.
    boxes: Vec<Aabb>,
}

/// Corner rays for interpolation, in row order.
enum Corners<'a> {
    /// The tile's own corners.
    Four([&'a Corner; 4]),
    /// 3 × 3 corners that include the tile's, and the column and row (0 or 1) of the tile's first corner.
    Nine([&'a Corner; 9], [usize; 2]),
}

/// Offset and position along the ray of a bend, as coefficients of a polynomial in x and y across the tile.
pub(super) enum Bend {
    /// Coefficients of 1, x, y and xy.
    Linear([Vec4; 4]),
    /// Coefficients of 1, x, x², each times 1, y and y².
    Quadratic([[Vec4; 3]; 3]),
}

impl Bend {
    /// Returns a ray's bend relative to the user, from the ray's direction and its position in the part.
    #[inline]
    pub fn evaluate(&self, direction: Vec3, [x, y]: [f32; 2]) -> Vec3 {
        let v = match self {
            Self::Linear([one, right, down, both]) => *one + *right * x + (*down + *both * x) * y,
            Self::Quadratic(rows) => {
                let row = |n: usize| rows[n][0] + (rows[n][1] + rows[n][2] * x) * x;
                row(0) + (row(1) + row(2) * y) * y
            }
        };
        direction * v.w + v.xyz()
    }
}

impl<'a> Cell<'a> {
    /// Interpolates bilinearly between four corners in row order.
    pub fn linear(corners: [&'a Corner; 4], user: Vec3, part: TilePart) -> Self {
        let legs = max_legs(&corners);
        Self { part, corners: Corners::Four(corners), legs, boxes: bend_boxes(corners, legs, user) }
    }

    /// Interpolates biquadratically between nine corners in row order; `first` is the column and row (0 or 1) of the
    /// tile's first corner.
    pub fn quadratic(corners: [&'a Corner; 9], first: [usize; 2], user: Vec3) -> Self {
        let legs = max_legs(&corners);
        let index = first[1] * 3 + first[0];
        let boxes = bend_boxes([0, 1, 3, 4].map(|offset| corners[index + offset]), legs, user);
        Self { part: TilePart::WHOLE, corners: Corners::Nine(corners, first), legs, boxes }
    }

    /// Converts a position in the tile to one in this part; `None` outside of it.
    #[inline]
    pub fn to_part(&self, position: [f32; 2]) -> Option<[f32; 2]> {
        let TilePart { parts, x, y } = self.part;
        let [u, v] = position.map(|fraction| fraction * parts as f32);
        // Positions are below 1, so each lies in exactly one part.
        ((u as usize, v as usize) == (x, y)).then_some([u - x as f32, v - y as f32])
    }

    /// Returns the k-th bend of all rays.
    pub fn bend(&self, k: usize) -> Bend {
        match &self.corners {
            Corners::Four(corners) => {
                let [a, b, c, d] = corners.map(|corner| corner.bend(k, self.legs));
                Bend::Linear([a, b - a, c - a, (d - c) - (b - a)])
            }
            Corners::Nine(corners, [column, row]) => {
                let row_parabola = |n: usize| {
                    let bend = |i: usize| corners[3 * n + i].bend(k, self.legs);
                    parabola([bend(0), bend(1), bend(2)], *column)
                };
                let rows = [row_parabola(0), row_parabola(1), row_parabola(2)];
                let column_parabola = |n: usize| parabola([rows[0][n], rows[1][n], rows[2][n]], *row);
                let columns = [column_parabola(0), column_parabola(1), column_parabola(2)];
                let power = |n: usize| [columns[0][n], columns[1][n], columns[2][n]];
                Bend::Quadratic([power(0), power(1), power(2)])
            }
        }
    }

    /// Returns the bounding box of the tile's rays between two bends.
    pub fn region(&self, from: usize, to: usize) -> Aabb {
        self.boxes[from..=to].iter().fold(Aabb::EMPTY, |region, bends| region.union(bends))
    }
}

fn max_legs(corners: &[&Corner]) -> usize {
    corners.iter().map(|corner| corner.legs).max().unwrap_or_default()
}

/// Returns the coefficients of the parabola through three values, at x = 0, 1, 2 (`first` = 0) or −1, 0, 1.
fn parabola([a, b, c]: [Vec4; 3], first: usize) -> [Vec4; 3] {
    let square = 0.5 * (a + c) - b;
    match first {
        0 => [a, b - a - square, square],
        _ => [b, 0.5 * (c - a), square],
    }
}

/// Returns the bounding box of each bend of all rays between the four corners of a tile, given in row order.
fn bend_boxes(corners: [&Corner; 4], legs: usize, user: Vec3) -> Vec<Aabb> {
    let bend_box = |k: usize| {
        let points = corners.map(|corner| {
            let bend = corner.bend(k, legs);
            user + corner.direction * bend.w + bend.xyz()
        });
        let mut bend_box = Aabb::EMPTY;
        points.into_iter().for_each(|point| bend_box.extend(point));
        widen(bend_box, (points[3] - points[0]).abs().max((points[2] - points[1]).abs()))
    };
    (0..=legs).map(bend_box).collect()
}

/// Returns the bounding box of all bends of all rays between four corners.
pub(super) fn bounds(corners: [&Corner; 4], user: Vec3) -> Aabb {
    let placed = |bounds: &Aabb| Aabb { min: user + bounds.min, max: user + bounds.max };
    let bounds = corners.iter().fold(Aabb::EMPTY, |all, corner| all.union(&placed(&corner.bounds)));
    // Rays of a tile are farthest apart at one of their ends.
    let ends = corners.map(Corner::ends);
    let diagonal = |a: usize, b: usize, end: usize| (ends[b][end] - ends[a][end]).abs();
    widen(bounds, diagonal(0, 3, 0).max(diagonal(1, 2, 0)).max(diagonal(0, 3, 1)).max(diagonal(1, 2, 1)))
}

/// Widens the bounding box of corner rays for the rays between them; `diagonal` is the distance of the corner rays.
fn widen(bounds: Aabb, diagonal: Vec3) -> Aabb {
    let margin = Vec3::splat(BULGE * diagonal.max_element());
    Aabb { min: bounds.min - margin, max: bounds.max + margin }
}

#[cfg(test)]
mod tests {
    use glam::Vec4;

    use super::parabola;

    #[test]
    fn parabolas_pass_through_their_points() {
        let f = |x: f32| Vec4::splat(3.0 - 2.0 * x + 0.5 * x * x);
        for (first, xs) in [(0, [0.0, 1.0, 2.0]), (1, [-1.0, 0.0, 1.0])] {
            let [one, x, square] = parabola(xs.map(f), first);
            assert_eq!((one, x, square), (Vec4::splat(3.0), Vec4::splat(-2.0), Vec4::splat(0.5)));
        }
    }
}
