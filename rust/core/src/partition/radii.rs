//! Minimum and maximum distance of triangles from a vertical axis.
//!
//! The minimum distance is measured to the triangle in the ground plane, not to its corners: a large ground triangle
//! around the axis has all corners far away. All arithmetic is in float64. Edges are differences of the given
//! coordinates, which are exact for float32, so short edges far from the axis lose no digits.

use std::ops::Range;

use glam::DVec3;

use crate::base::simd::{greater, lesser, vectorized};
use crate::base::{Real, Result, ensure};
use crate::scene::{Instance, Scene};

/// Number of triangles in one task.
pub(super) const CHUNK: usize = 1 << 14;
/// Number of triangles in a block; its temporaries fit in the first-level cache.
pub(super) const BLOCK: usize = 64;
/// Determinant, relative to its terms, above which its sign is certain. Each term has three roundings of 2⁻⁵³.
const CERTAIN: f64 = 1.0 / (1u64 << 50) as f64;

/// Ground coordinates of triangles: `corners[2 k][i]` is x and `corners[2 k + 1][i]` is z of corner k of triangle i.
type Corners<T> = [[T; BLOCK]; 6];

vectorized! {
    /// Writes the minimum and maximum ρ of a block, computed in float64 and rounded once.
    fn evaluate<T: Real>(corners: &Corners<T>, axis: [f64; 2], radii: &mut [[T; 2]; BLOCK]) = evaluate_kernel;
}

#[inline(always)]
fn evaluate_kernel<T: Real>(corners: &Corners<T>, axis: [f64; 2], radii: &mut [[T; 2]; BLOCK]) {
    for i in 0..BLOCK {
        let a = [corners[0][i].wide(), corners[1][i].wide()];
        let b = [corners[2][i].wide(), corners[3][i].wide()];
        let c = [corners[4][i].wide(), corners[5][i].wide()];
        radii[i] = radii_of(a, b, c, axis).map(T::narrow);
    }
}

/// Returns the minimum and maximum ρ of one triangle, given (x, z) of its corners and of the axis. Degenerate
/// triangles are measured as segments or points; a vertical wall is a segment in the ground plane. NaN if a coordinate
/// is not finite.
#[inline(always)]
pub fn radii_of(a: [f64; 2], b: [f64; 2], c: [f64; 2], axis: [f64; 2]) -> [f64; 2] {
    let (from_a, from_b, from_c) = (minus(a, axis), minus(b, axis), minus(c, axis));
    let (square_a, square_b, square_c) = (dot(from_a, from_a), dot(from_b, from_b), dot(from_c, from_c));
    let (ab, bc, ca) = (Edge::new(from_a, minus(b, a)), Edge::new(from_b, minus(c, b)), Edge::new(from_c, minus(a, c)));
    let corner = lesser(lesser(square_a, square_b), square_c);
    let outside = lesser(lesser(ab.distance_squared, bc.distance_squared), lesser(ca.distance_squared, corner));
    // The axis intersects the triangle if it lies on the same side of all edges. If a side is uncertain, the axis is
    // within rounding of that edge, and the distance to the edge is used.
    let is_pierced = (ab.left & bc.left & ca.left) | (ab.right & bc.right & ca.right);
    let min = if is_pierced { 0.0 } else { outside };
    let max = greater(greater(square_a, square_b), square_c);
    // Zero, or NaN if a coordinate is not finite.
    let poison = 0.0 * (square_a + square_b + square_c);
    [min.sqrt() + poison, max.sqrt() + poison]
}

/// An edge in the ground plane, relative to the axis.
struct Edge {
    /// Squared distance from the axis if its perpendicular meets the edge, otherwise infinite.
    distance_squared: f64,
    /// Whether the axis certainly lies to the left.
    left: bool,
    /// Whether the axis certainly lies to the right.
    right: bool,
}

impl Edge {
    /// Creates an edge from the vector axis → edge's start and the vector along the edge.
    #[inline(always)]
    fn new(start: [f64; 2], along: [f64; 2]) -> Self {
        let (first, second) = (start[0] * along[1], start[1] * along[0]);
        let determinant = first - second;
        let doubt = (first.abs() + second.abs()) * CERTAIN;
        let (length_squared, foot) = (dot(along, along), -dot(start, along));
        // (start × along)² / |along|²; not used for a degenerate edge.
        let distance_squared = determinant * (determinant / length_squared);
        let on_edge = (foot > 0.0) & (foot < length_squared);
        let distance_squared = if on_edge { distance_squared } else { f64::INFINITY };
        Self { distance_squared, left: determinant > doubt, right: determinant < -doubt }
    }
}

#[inline(always)]
fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

#[inline(always)]
fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Returns (x, z) of the vertical axis through a centre, relative to the scene's origin. Fails unless it is finite.
pub(super) fn axis_in(scene: &Scene, center: DVec3) -> Result<[f64; 2]> {
    ensure!(center.is_finite(), "center", "three finite numbers", center);
    let local = center - scene.origin;
    Ok([local.x, local.z])
}

/// Source of triangle corners by number.
pub(super) trait TriangleSource<T>: Sync {
    /// Corners of a triangle.
    fn corners(&self, number: usize) -> [&[T; 3]; 3];
}

/// Vertices with faces.
pub(super) struct Indexed<'a, T> {
    pub vertices: &'a [[T; 3]],
    pub faces: &'a [[u32; 3]],
}

impl<T: Sync> TriangleSource<T> for Indexed<'_, T> {
    #[inline(always)]
    fn corners(&self, number: usize) -> [&[T; 3]; 3] {
        let [a, b, c] = self.faces[number];
        [&self.vertices[a as usize], &self.vertices[b as usize], &self.vertices[c as usize]]
    }
}

/// Triangles with three vertices each.
pub(super) struct Soup<'a, T>(pub &'a [[[T; 3]; 3]]);

impl<T: Sync> TriangleSource<T> for Soup<'_, T> {
    #[inline(always)]
    fn corners(&self, number: usize) -> [&[T; 3]; 3] {
        let [a, b, c] = &self.0[number];
        [a, b, c]
    }
}

/// Measures triangles in blocks: `number(i)` is the i-th of `count` triangles; `take` receives the first i of each
/// block, and its radii.
#[inline(always)]
pub(super) fn measure<T: Real>(
    triangles: &impl TriangleSource<T>,
    count: usize,
    axis: [f64; 2],
    number: impl Fn(usize) -> usize,
    mut take: impl FnMut(usize, &[[T; 2]]),
) {
    let mut corners = [[T::default(); BLOCK]; 6];
    let mut radii = [[T::default(); 2]; BLOCK];
    for first in (0..count).step_by(BLOCK) {
        let filled = BLOCK.min(count - first);
        (0..filled).for_each(|i| scatter(&mut corners, i, triangles.corners(number(first + i))));
        evaluate(&corners, axis, &mut radii);
        take(first, &radii[..filled]);
    }
}

#[inline(always)]
fn scatter<T: Copy>(corners: &mut Corners<T>, lane: usize, [a, b, c]: [&[T; 3]; 3]) {
    corners[0][lane] = a[0];
    corners[1][lane] = a[2];
    corners[2][lane] = b[0];
    corners[3][lane] = b[2];
    corners[4][lane] = c[0];
    corners[5][lane] = c[2];
}

/// Measures consecutive faces of a placed mesh; `take` receives each block's position in the range with its radii.
pub(super) fn measure_faces(
    instance: &Instance,
    faces: Range<usize>,
    axis: [f64; 2],
    take: impl FnMut(usize, &[[f32; 2]]),
) {
    let count = faces.len();
    if instance.in_place {
        let faces = &instance.mesh.faces[faces];
        measure(&Indexed { vertices: &instance.mesh.positions, faces }, count, axis, |i| i, take);
    } else {
        let corners = placed_triangles(instance, faces.start as u32..faces.end as u32);
        measure(&Soup(&corners), count, axis, |i| i, take);
    }
}

/// Returns the corners of an instance's faces, relative to the scene's origin, as consecutive triangles.
pub(super) fn placed_triangles(instance: &Instance, faces: impl Iterator<Item = u32>) -> Vec<[[f32; 3]; 3]> {
    faces.map(|face| instance.corners(face).map(|corner| corner.to_array())).collect()
}
