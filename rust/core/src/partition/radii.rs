//! Least and greatest distance of triangles from a vertical axis.
//!
//! The least one is taken to the triangle in the ground plane, not to its corners: a large ground triangle around the
//! axis has all corners far away. All arithmetic is in float64; edges are differences of the given coordinates, which
//! are exact where these are float32, so that short edges far from the axis lose nothing.

use crate::base::simd::widest;

/// Triangles that are evaluated together; their temporaries stay in the first-level cache.
pub(super) const BLOCK: usize = 64;
/// A side test is certain where its determinant exceeds this share of its terms: each has three roundings of 2⁻⁵³.
const CERTAIN: f64 = 1.0 / (1u64 << 50) as f64;

/// Float32 or float64 coordinates.
pub trait Coordinate: Copy + Send + Sync + Default + Into<f64> {
    /// Rounds to the nearest.
    fn narrow(value: f64) -> Self;
    /// The block kernel for these coordinates.
    #[doc(hidden)]
    fn evaluate(block: &Corners<Self>, axis: [f64; 2], radii: &mut [[f64; BLOCK]; 2]);
}

/// Ground coordinates (x, z) of the corners of a block of triangles: `corners[k][0][i]` is x of corner k of triangle i.
pub type Corners<T> = [[[T; BLOCK]; 2]; 3];

macro_rules! coordinate {
    ($float:ty, $name:ident) => {
        widest! {
            fn $name(block: &Corners<$float>, axis: [f64; 2], radii: &mut [[f64; BLOCK]; 2]) = evaluate::<$float>;
        }
        impl Coordinate for $float {
            #[inline(always)]
            fn narrow(value: f64) -> Self {
                value as Self
            }
            fn evaluate(block: &Corners<Self>, axis: [f64; 2], radii: &mut [[f64; BLOCK]; 2]) {
                $name(block, axis, radii);
            }
        }
    };
}

coordinate!(f32, evaluate_f32);
coordinate!(f64, evaluate_f64);

#[inline(always)]
fn evaluate<T: Coordinate>(block: &Corners<T>, axis: [f64; 2], radii: &mut [[f64; BLOCK]; 2]) {
    for i in 0..BLOCK {
        let corners = [0, 1, 2].map(|k| [block[k][0][i], block[k][1][i]]);
        let [least, greatest] = radii_of(corners, axis);
        radii[0][i] = least;
        radii[1][i] = greatest;
    }
}

/// Least and greatest ρ of one triangle, given (x, z) of its corners and of the axis. Degenerate ones (vertical walls are segments in
/// the ground plane) are measured as what they are. NaN where a coordinate is not finite.
#[inline(always)]
pub fn radii_of<T: Into<f64>>(corners: [[T; 2]; 3], axis: [f64; 2]) -> [f64; 2] {
    let raw = corners.map(|corner| corner.map(Into::into));
    let from_axis: [[f64; 2]; 3] = raw.map(|[x, z]| [x - axis[0], z - axis[1]]);
    let squares = from_axis.map(|[x, z]| x * x + z * z);
    let mut least = less(less(squares[0], squares[1]), squares[2]);
    let greatest = more(more(squares[0], squares[1]), squares[2]);
    let (mut left, mut right) = (true, true);
    for (start, end) in [(0, 1), (1, 2), (2, 0)] {
        let edge = [raw[end][0] - raw[start][0], raw[end][1] - raw[start][1]];
        let [x, z] = from_axis[start];
        let (first, second) = (x * edge[1], z * edge[0]);
        let determinant = first - second;
        let doubt = (first.abs() + second.abs()) * CERTAIN;
        left &= determinant > doubt;
        right &= determinant < -doubt;
        // The foot of the perpendicular lies on the edge: its distance is |corner × edge| / |edge|.
        let length_squared = edge[0] * edge[0] + edge[1] * edge[1];
        let foot = -(x * edge[0] + z * edge[1]);
        let distance_squared = determinant * (determinant / length_squared);
        let on_edge = (foot > 0.0) & (foot < length_squared);
        least = if on_edge & (distance_squared < least) { distance_squared } else { least };
    }
    // On the same side of all edges: the axis pierces the triangle. In doubt it is within rounding of an edge, and the
    // distance to that edge stands.
    least = if left | right { 0.0 } else { least };
    // A sum with every coordinate in it is NaN or infinite where one of them is.
    let all = squares[0] + squares[1] + squares[2];
    let poison = 0.0 * all;
    [least.sqrt() + poison, greatest.sqrt() + poison]
}

#[inline(always)]
fn less(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

#[inline(always)]
fn more(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// Evaluates triangles in blocks: `corners(i)` gives (x, z) of triangle i of `count`, `take` receives its number and radii.
#[inline(always)]
pub(super) fn measure<T: Coordinate>(
    count: usize,
    axis: [f64; 2],
    corners: impl Fn(usize) -> [[T; 2]; 3],
    mut take: impl FnMut(usize, [f64; 2]),
) {
    let mut block = [[[T::default(); BLOCK]; 2]; 3];
    let mut radii = [[0.0; BLOCK]; 2];
    for first in (0..count).step_by(BLOCK) {
        let filled = BLOCK.min(count - first);
        for i in 0..filled {
            for (lanes, corner) in block.iter_mut().zip(corners(first + i)) {
                lanes[0][i] = corner[0];
                lanes[1][i] = corner[1];
            }
        }
        T::evaluate(&block, axis, &mut radii);
        for (i, (&least, &greatest)) in radii[0].iter().zip(&radii[1]).enumerate().take(filled) {
            take(first + i, [least, greatest]);
        }
    }
}
