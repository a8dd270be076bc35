//! Nearest points on a scene's surface: branch and bound over both levels of trees.
//!
//! Boxes are culled by float32 lower bounds of their distances. Distances of triangles are computed in float64 from the
//! float32 corners, as the minimum over the plane and the three edges, so slivers need no special case.

use glam::{DVec3, Vec3};
use rayon::prelude::*;

use super::cast::{CHUNK, Points};
use super::closest::{closest, squared_distance};
use crate::base::memory::try_vec;
use crate::base::{Progress, Result, ensure};
use crate::bvh::{Block, LEAF, NO_CHILD, Node, WIDTH, Wide};
use crate::scene::{Instance, Scene};

/// Nearest surface points, one entry per query point.
#[derive(Debug, Default)]
pub struct Nearest {
    /// Distance in metres; infinite if no triangle faces the given direction.
    pub distance: Vec<f64>,
    /// Triangle number in the scene; −1 if there is none.
    pub triangle_index: Vec<i64>,
    /// Weights of the second and third corner; NaN if there is none.
    pub barycentric: Vec<[f64; 2]>,
}

/// Returns the nearest surface point of each world position. `facing` gives a direction for each point; only triangles
/// whose outward normal is within 90° of it count.
pub fn nearest(scene: &Scene, points: Points<'_>, facing: Option<&[[f32; 3]]>, progress: &Progress) -> Result<Nearest> {
    let count = points.len();
    let facing_count = facing.map_or(count, <[_]>::len);
    ensure!(facing_count == count, "facing", format!("one row for each of {count} points"), facing_count);
    points.check_positions("points", scene)?;
    scene.build(progress)?;
    progress.expect(count as u64);
    let mut nearest = Nearest {
        distance: try_vec(f64::INFINITY, count)?,
        triangle_index: try_vec(-1, count)?,
        barycentric: try_vec([f64::NAN; 2], count)?,
    };
    let chunks = nearest
        .distance
        .par_chunks_mut(CHUNK)
        .zip(nearest.triangle_index.par_chunks_mut(CHUNK))
        .zip(nearest.barycentric.par_chunks_mut(CHUNK))
        .enumerate();
    chunks.try_for_each(|(chunk, ((distance, triangle), weights))| {
        let mut stack = Vec::new();
        let mut last = Candidate::NOTHING;
        for row in 0..distance.len() {
            let index = chunk * CHUNK + row;
            let facing = facing.map(|rows| Vec3::from_array(rows[index]).as_dvec3());
            let search = NearestSearch { point: points.get(index) - scene.origin, facing, best: Candidate::NOTHING };
            last = search.run(scene, last, &mut stack);
            if last.instance == u32::MAX {
                continue;
            }
            let corners = scene.instance(last.instance).corners(last.face);
            let near = closest(corners.map(|corner| corner.as_dvec3() - (points.get(index) - scene.origin)));
            distance[row] = near.square.sqrt();
            triangle[row] = scene.triangle_offset(last.instance) + i64::from(last.face);
            weights[row] = [near.u, near.v];
        }
        progress.report(distance.len() as u64)
    })?;
    Ok(nearest)
}

/// A triangle and its squared distance.
#[derive(Clone, Copy)]
struct Candidate {
    square: f64,
    instance: u32,
    face: u32,
}

impl Candidate {
    const NOTHING: Self = Self { square: f64::INFINITY, instance: u32::MAX, face: u32::MAX };

    /// Returns whether this triangle is nearer. Ties go to the lower (instance, face), so the result depends neither on
    /// the tree nor on the initial bound.
    fn is_before(&self, other: &Self) -> bool {
        self.square < other.square
            || (self.square == other.square && (self.instance, self.face) < (other.instance, other.face))
    }
}

struct NearestSearch {
    /// The query point relative to the scene's origin.
    point: DVec3,
    facing: Option<DVec3>,
    best: Candidate,
}

/// Stack of pending boxes: lower bound of the squared distance, and child reference.
type Stack = Vec<(f32, u32)>;

/// Query point in the frame of a tree's boxes, and the relation of the frame's distances to those in scene space.
struct TreeFrame {
    point: Vec3,
    /// Maximum error, in metres, that rounding the point to float32 adds to a distance.
    slack: f32,
    /// Square of the minimum factor by which the transform to scene space stretches lengths.
    scale: f64,
}

impl TreeFrame {
    fn new(point: DVec3, scale: f64) -> Self {
        let rounded = point.as_vec3();
        Self { point: rounded, slack: rounded.abs().max_element() * f32::EPSILON, scale }
    }

    /// Returns lower bounds of the squared distances of a node's children, in the frame's own units.
    #[inline(always)]
    fn squares(&self, node: &Node) -> [f32; WIDTH] {
        /// Factor that covers the rounding of the sum.
        const SHRINK: f32 = 1.0 - 8.0 * f32::EPSILON;
        let mut squares = [0.0f32; WIDTH];
        for axis in 0..3 {
            let (low, high) = (&node.planes[2 * axis], &node.planes[2 * axis + 1]);
            for slot in 0..WIDTH {
                let gap = (low[slot] - self.point[axis]).max(self.point[axis] - high[slot]);
                let gap = (gap - self.slack).max(0.0);
                squares[slot] += gap * gap;
            }
        }
        squares.map(|square| square * SHRINK)
    }
}

impl NearestSearch {
    fn run(mut self, scene: &Scene, start: Candidate, stack: &mut Stack) -> Candidate {
        // Successive points are usually close together, so the previous point's triangle gives a good first bound.
        if start.instance != u32::MAX {
            self.try_triangle(scene.instance(start.instance).corners(start.face), start.instance, start.face);
        }
        let mut first = 0;
        for set in scene.sets() {
            if let Some(tlas) = set.tlas() {
                let frame = TreeFrame::new(self.point, 1.0);
                self.walk(&tlas.wide, &frame, stack, |search, leaf, stack| {
                    if let Some(slot) = tlas.instance(leaf) {
                        search.enter(&set.instances()[slot as usize], first + slot, stack);
                    }
                });
            }
            first += set.instances().len() as u32;
        }
        self.best
    }

    fn enter(&mut self, instance: &Instance, number: u32, stack: &mut Stack) {
        let Some(bvh) = instance.mesh.bvh() else { return };
        let frame = if instance.in_place {
            TreeFrame::new(self.point, 1.0)
        } else {
            // The minimum stretch of a transform is the reciprocal of the maximum stretch of its inverse, of which the
            // Frobenius norm is an upper bound.
            let inverse = instance.to_object.matrix3;
            let columns = [inverse.x_axis, inverse.y_axis, inverse.z_axis];
            let norm: f64 = columns.iter().map(|column| column.length_squared()).sum();
            TreeFrame::new(instance.to_object.transform_point3(self.point), (1.0 - 1e-12) / norm)
        };
        self.walk(&bvh.wide, &frame, stack, |search, leaf, _| {
            bvh.leaf(leaf).iter().for_each(|block| search.try_block(block, instance, number));
        });
    }

    /// Visits leaves that may be nearer than the best triangle, nearest leaf first.
    #[inline(always)]
    fn walk(&mut self, tree: &Wide, frame: &TreeFrame, stack: &mut Stack, leaf: impl Fn(&mut Self, u32, &mut Stack)) {
        if tree.nodes.is_empty() {
            return;
        }
        let base = stack.len();
        stack.push((0.0, 0));
        while stack.len() > base {
            let Some((near, reference)) = stack.pop() else { return };
            if f64::from(near) * frame.scale > self.best.square {
                continue;
            }
            if reference & LEAF != 0 {
                leaf(self, reference, stack);
                continue;
            }
            let node = &tree.nodes[reference as usize];
            let squares = frame.squares(node);
            let start = stack.len();
            for (&square, &child) in squares.iter().zip(&node.children) {
                if child == NO_CHILD || f64::from(square) * frame.scale > self.best.square {
                    continue;
                }
                stack.push((square, child));
                let mut index = stack.len() - 1;
                // Insertion sort: nearer boxes go to the top.
                while index > start && stack[index - 1].0 < square {
                    stack.swap(index - 1, index);
                    index -= 1;
                }
            }
        }
    }

    #[inline(always)]
    fn try_block(&mut self, block: &Block, instance: &Instance, number: u32) {
        for (lane, &face) in block.distinct_faces().iter().enumerate() {
            let corner = |corner: usize| Vec3::from_array(block.corners[corner].map(|axis| axis[lane]));
            let corners = if instance.in_place { [corner(0), corner(1), corner(2)] } else { instance.corners(face) };
            self.try_triangle(corners, number, face);
        }
    }

    #[inline(always)]
    fn try_triangle(&mut self, corners: [Vec3; 3], instance: u32, face: u32) {
        let corners = corners.map(|corner| corner.as_dvec3() - self.point);
        if let Some(facing) = self.facing
            && (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(facing) <= 0.0
        {
            return;
        }
        let candidate = Candidate { square: squared_distance(corners), instance, face };
        if candidate.is_before(&self.best) {
            self.best = candidate;
        }
    }
}
