//! Query for the whole triangles that touch a box, through the trees.
//!
//! Comparisons with the trees' boxes are exact: float32 numbers lie between float64 sides if and only if they lie
//! between the sides rounded inwards. Subtrees entirely inside are taken without tests of their triangles.

use std::sync::Arc;

use glam::{DVec3, Vec3};
use rayon::prelude::*;

use super::instance::{Instance, InstanceSet};
use super::world::Scene;
use crate::base::mapped::filtered;
use crate::base::memory::{try_append, try_with_capacity};
use crate::base::sort::sort_by_key;
use crate::base::{Aabb, Progress, Result, ensure};
use crate::bvh::{Bvh, LEAF, NO_CHILD, Node, WIDTH};

/// Number of pending nodes from which the search runs in parallel.
const PARALLEL_NODES: usize = 1 << 9;

/// Tolerance, relative to the largest coordinate, by which a box is widened before a separation test, so that rounding
/// never separates touching shapes.
const SLACK: f64 = 32.0 * f64::EPSILON;

/// A closed box; sides may be infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Region {
    min: DVec3,
    max: DVec3,
    /// Largest float32 box inside this box.
    inner: Aabb,
}

/// Result of a query.
pub struct Queried {
    /// Whole triangles that touch the box.
    pub scene: Scene,
    /// Indices of its moving instances in the queried scene; `None` if it has all of them.
    pub moving: Option<Vec<u32>>,
}

impl Region {
    /// Creates a box between two corners.
    pub fn new(min: DVec3, max: DVec3) -> Result<Self> {
        ensure!(min.cmple(max).all(), "aabb", "a minimum that is not above the maximum", format!("{min}, {max}"));
        Ok(Self { min, max, inner: Aabb::from_f64_inside(min, max) })
    }

    /// Returns whether a triangle touches the box. A triangle that does not, but is at most `SLACK` times its largest
    /// coordinate away, may be reported, too.
    ///
    /// Tests the thirteen potential separating axes of a triangle and a box: Akenine-Möller, Fast 3D triangle–box
    /// overlap testing, 2001. The box is first clipped to the triangle's bounds, which makes its sides finite.
    pub fn touches(&self, corners: [Vec3; 3]) -> bool {
        let bounds = Aabb::of_points(corners);
        if !self.inner.touches(&bounds) {
            return false;
        }
        if self.inner.contains(&bounds) {
            return true;
        }
        let (min, max) = (self.min.max(bounds.min.as_dvec3()), self.max.min(bounds.max.as_dvec3()));
        let center = min * 0.5 + max * 0.5;
        let slack = SLACK * f64::from(bounds.max_coordinate());
        let half = (max - min) * 0.5 + DVec3::splat(slack);
        let corners = corners.map(Vec3::as_dvec3);
        let [a, b, c] = corners.map(|corner| corner - center);
        let edges = [corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2]];
        let normal = edges[0].cross(edges[1]);
        // The cross product of nearly parallel edges is small, but its error is not.
        let error = slack * edges[0].abs().max_element() * edges[1].abs().max_element();
        if normal.dot(a).abs() > normal.abs().dot(half) + error {
            return false;
        }
        let separates = |axis: DVec3| {
            let (p, q, r) = (axis.dot(a), axis.dot(b), axis.dot(c));
            let reach = axis.abs().dot(half);
            p.min(q).min(r) > reach || p.max(q).max(r) < -reach
        };
        let crossed = |edge: DVec3| {
            [DVec3::new(0.0, -edge.z, edge.y), DVec3::new(edge.z, 0.0, -edge.x), DVec3::new(-edge.y, edge.x, 0.0)]
        };
        !edges.into_iter().flat_map(crossed).any(separates)
    }

    /// Returns two bit masks of a node's children: boxes that touch this box, and boxes that lie inside it.
    #[inline]
    fn classify(&self, node: &Node) -> (u32, u32) {
        let (mut touching, mut inside) = ([true; WIDTH], [true; WIDTH]);
        for axis in 0..3 {
            let (low, high) = (self.inner.min[axis], self.inner.max[axis]);
            let (min, max) = (&node.planes[2 * axis], &node.planes[2 * axis + 1]);
            for slot in 0..WIDTH {
                touching[slot] &= (min[slot] <= high) & (max[slot] >= low);
                inside[slot] &= (min[slot] >= low) & (max[slot] <= high);
            }
        }
        let bits = |flags: [bool; WIDTH]| (0..WIDTH).fold(0, |all, slot| all | u32::from(flags[slot]) << slot);
        (bits(touching), bits(inside))
    }
}

impl Scene {
    /// Returns the whole triangles that touch a box of the world. Instances entirely inside share their meshes with
    /// this scene; others get new meshes without unused vertices. With `builds`, trees are built first; otherwise each
    /// triangle is tested, which is faster for a single query.
    pub fn query(&self, min: DVec3, max: DVec3, builds: bool, progress: &Progress) -> Result<Queried> {
        let region = Region::new(min - self.origin, max - self.origin)?;
        let (standing, _) = self.standing.query(&region, builds, progress)?;
        let (moving, indices) = self.moving.query(&region, builds, progress)?;
        Ok(Queried { scene: self.with_sets(standing, moving), moving: indices })
    }
}

impl InstanceSet {
    /// Returns the part that touches a box, and the indices of its instances; `None` for both if it is the whole set.
    fn query(&self, region: &Region, builds: bool, progress: &Progress) -> Result<(Option<Self>, Option<Vec<u32>>)> {
        let bounds = match self.tlas() {
            Some(tlas) => tlas.bounds,
            None => self.instances().iter().fold(Aabb::EMPTY, |all, instance| all.union(&instance.bounds)),
        };
        if region.inner.contains(&bounds) {
            return Ok((None, None));
        }
        if !region.inner.touches(&bounds) {
            return Ok((Some(Self::default()), Some(Vec::new())));
        }
        if builds {
            self.build(progress)?;
        }
        let mut touching = self.touching_instances(region);
        sort_by_key(&mut touching, |&(number, _)| number, progress)?;
        let part = |&(number, is_inside): &(u32, bool)| {
            let instance = &self.instances()[number as usize];
            let part = if is_inside { Some(instance.clone()) } else { instance.query(region, progress)? };
            Ok(part.map(|part| (part, number)))
        };
        let parts: Vec<Option<(Instance, u32)>> = match &touching[..] {
            [only] => vec![part(only)?],
            _ => touching.par_iter().map(part).collect::<Result<_>>()?,
        };
        let (instances, indices) = parts.into_iter().flatten().unzip();
        Ok((Some(Self::new(instances)), Some(indices)))
    }

    /// Returns the instances whose boxes touch a box, and whether they lie inside it.
    fn touching_instances(&self, region: &Region) -> Vec<(u32, bool)> {
        let Some(tlas) = self.tlas() else {
            let boxes = (0..).zip(self.instances()).map(|(number, instance)| (number, instance.bounds));
            let touching = boxes.filter(|(_, bounds)| region.inner.touches(bounds));
            return touching.map(|(number, bounds)| (number, region.inner.contains(&bounds))).collect();
        };
        let mut touching = Vec::new();
        let mut stack = vec![(0, false)];
        while let Some((number, is_inside)) = stack.pop() {
            let Some(node) = tlas.wide.nodes.get(number as usize) else { continue };
            for (child, is_inside) in touching_children(node, is_inside, |node| region.classify(node)) {
                if child & LEAF == 0 {
                    stack.push((child, is_inside));
                } else if let Some(instance) = tlas.instance(child) {
                    touching.push((instance, is_inside));
                }
            }
        }
        touching
    }
}

/// Returns a node's children that touch a box, and whether each lies inside it. `classify` returns bit masks like
/// `Region::classify`; it is not called if the node itself lies inside.
#[inline]
fn touching_children(
    node: &Node,
    is_inside: bool,
    classify: impl FnOnce(&Node) -> (u32, u32),
) -> impl Iterator<Item = (u32, bool)> {
    let (touching, inside) = if is_inside { (u32::MAX, u32::MAX) } else { classify(node) };
    let children = node.children.iter().enumerate().filter(move |&(slot, _)| touching >> slot & 1 == 1);
    children.filter(|&(_, &child)| child != NO_CHILD).map(move |(slot, &child)| (child, inside >> slot & 1 == 1))
}

impl Instance {
    /// Returns the part that touches a box; `None` if no face does.
    fn query(&self, region: &Region, progress: &Progress) -> Result<Option<Self>> {
        let faces = match self.mesh.bvh() {
            Some(bvh) => self.faces_in(bvh, region, progress)?,
            None => filtered(self.mesh.faces.len() as u32, |face| region.touches(self.corners(face)), progress)?,
        };
        if faces.len() == self.mesh.faces.len() {
            return Ok((!faces.is_empty()).then(|| self.clone()));
        }
        if faces.is_empty() {
            return Ok(None);
        }
        Ok(Some(self.with_mesh(Arc::new(self.mesh.compacted(&faces, progress)?), self.object)))
    }

    /// Returns the faces that touch a box, ascending.
    fn faces_in(&self, bvh: &Bvh, region: &Region, progress: &Progress) -> Result<Vec<u32>> {
        let mut runs = Search { instance: self, bvh, region }.run(progress)?;
        sort_by_key(&mut runs, |&[start, _]| start, progress)?;
        let mut faces = try_with_capacity(runs.iter().map(|[start, end]| (end - start) as usize).sum())?;
        runs.iter().for_each(|&[start, end]| faces.extend(start..end));
        if bvh.add_copies(&mut faces) {
            sort_by_key(&mut faces, |&face| face, progress)?;
        }
        Ok(faces)
    }
}

/// First and end of a run of consecutive faces. Neighbours in space are often consecutive in the mesh, so there are
/// fewer runs than faces to sort.
type Run = [u32; 2];

#[inline]
fn append(runs: &mut Vec<Run>, faces: impl Iterator<Item = u32>) {
    for face in faces {
        match runs.last_mut() {
            Some([_, end]) if *end == face => *end += 1,
            _ => runs.push([face, face + 1]),
        }
    }
}

struct Search<'a> {
    instance: &'a Instance,
    bvh: &'a Bvh,
    region: &'a Region,
}

impl Search<'_> {
    /// Returns the touching faces in the order of the tree, without duplicates.
    fn run(&self, progress: &Progress) -> Result<Vec<Run>> {
        let (mut front, mut runs) = (vec![(0, false)], Vec::new());
        while !front.is_empty() && front.len() < PARALLEL_NODES {
            let mut next = Vec::new();
            front.iter().for_each(|&node| self.open(node, &mut next, &mut runs));
            front = next;
        }
        let subtrees = front.par_iter().map(|&node| {
            progress.check()?;
            let (mut stack, mut runs) = (vec![node], Vec::new());
            while let Some(node) = stack.pop() {
                self.open(node, &mut stack, &mut runs);
            }
            Ok(runs)
        });
        if !front.is_empty() {
            subtrees.collect::<Result<Vec<_>>>()?.iter().try_for_each(|found| try_append(&mut runs, found))?;
        }
        Ok(runs)
    }

    /// Appends the children of a node and the faces of its leaves; the flag says whether the node lies inside the box.
    fn open(&self, (number, is_inside): (u32, bool), nodes: &mut Vec<(u32, bool)>, runs: &mut Vec<Run>) {
        let Some(node) = self.bvh.wide.nodes.get(number as usize) else { return };
        for (child, is_inside) in touching_children(node, is_inside, |node| self.classify(node)) {
            if child & LEAF == 0 {
                nodes.push((child, is_inside));
                continue;
            }
            for block in self.bvh.leaf(child) {
                let all = block.distinct_faces().iter().copied();
                if is_inside {
                    append(runs, all);
                } else {
                    append(runs, all.filter(|&face| self.region.touches(self.instance.corners(face))));
                }
            }
        }
    }

    /// Same as `Region::classify`, for boxes in the mesh's own frame.
    fn classify(&self, node: &Node) -> (u32, u32) {
        if self.instance.in_place {
            return self.region.classify(node);
        }
        let (mut touching, mut inside) = (0, 0);
        for slot in 0..WIDTH {
            let placed = node.bounds(slot).transformed(&self.instance.to_scene);
            // Placed corners and placed boxes are computed in different orders, so they may be rounded differently.
            let slack = Vec3::splat(placed.max_coordinate() * 4.0 * f32::EPSILON);
            let placed = Aabb { min: placed.min - slack, max: placed.max + slack };
            touching |= u32::from(self.region.inner.touches(&placed)) << slot;
            inside |= u32::from(self.region.inner.contains(&placed)) << slot;
        }
        (touching, inside)
    }
}

#[cfg(test)]
mod tests {
    use glam::DAffine3;
    use proptest::prelude::*;

    use super::*;
    use crate::base::FaceMap;
    use crate::scene::{Material, Mesh};

    const ORIGIN: DVec3 = DVec3::new(40_000.0, 0.0, -7.0);

    fn region(min: [f64; 3], max: [f64; 3]) -> Region {
        Region::new(min.into(), max.into()).unwrap()
    }

    #[test]
    fn sides_belong_to_the_box_and_corners_that_are_cut_off_do_not_touch() {
        let triangle = [Vec3::ZERO, Vec3::X, Vec3::Y];
        assert!(region([1.0, 0.0, 0.0], [2.0, 1.0, 1.0]).touches(triangle));
        assert!(!region([1.0 + 1e-9, 0.0, 0.0], [2.0, 1.0, 1.0]).touches(triangle));
        // The triangle's box reaches (1, 1), but its longest edge only x + y = 1.
        assert!(region([0.5, 0.5, -1.0], [2.0, 2.0, 1.0]).touches(triangle));
        assert!(!region([0.5 + 1e-9, 0.5, -1.0], [2.0, 2.0, 1.0]).touches(triangle));
        let infinite = f64::INFINITY;
        assert!(!region([0.6, 0.6, -infinite], [infinite; 3]).touches(triangle));
        assert!(region([-infinite; 3], [infinite; 3]).touches(triangle));
        // No float32 number lies between these sides, but the triangle crosses them.
        assert!(region([0.1, 0.1, -1.0], [0.1 + 1e-12, 0.1 + 1e-12, 1.0]).touches(triangle));
        assert!(Region::new(DVec3::ONE, DVec3::ZERO).is_err());
        assert!(Region::new(DVec3::NAN, DVec3::ONE).is_err());
    }

    proptest! {
        #[test]
        fn a_triangle_with_a_point_inside_touches(
            corners in prop::array::uniform3(prop::array::uniform3(-9.0f32..9.0)),
            (u, v) in (0.0f64..1.0, 0.0f64..1.0),
            below in prop::array::uniform3(0.0f64..3.0),
            above in prop::array::uniform3(0.0f64..3.0),
        ) {
            let corners = corners.map(Vec3::from_array);
            let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
            let [a, b, c] = corners.map(Vec3::as_dvec3);
            let point = a + (b - a) * u + (c - a) * v;
            let around = |below: [f64; 3], above: [f64; 3]| {
                region((point - DVec3::from(below)).into(), (point + DVec3::from(above)).into())
            };
            prop_assert!(around(below, above).touches(corners));
            // A point beside the triangle along its normal.
            let normal = (b - a).cross(c - a);
            if normal.length() > 1e-3 {
                let off = point + normal.normalize() * 1e-6;
                prop_assert!(!region(off.into(), off.into()).touches(corners));
            }
        }
    }

    /// A row of triangles along x in one mesh with two copies of the first at the end, a rotated instance of a mesh of
    /// two triangles at x = 100, and a moving one at x = 200.
    fn scene() -> Scene {
        let corners = |&x: &f32| [[x, 0.0, 0.0], [x + 0.5, 0.0, 0.0], [x, 0.5, 0.0]];
        let mesh = |starts: &[f32]| {
            let objects = FaceMap::PerFace((0..starts.len() as i32).collect());
            Mesh::of_triangles(&starts.iter().map(corners).collect::<Vec<_>>(), objects)
        };
        let row: Vec<f32> = (0..50).map(|i| i as f32).chain([0.0, 0.0]).collect();
        let pair = mesh(&[0.0, 5.0]);
        let placed = |x: f64| DAffine3::from_translation(DVec3::X * x) * DAffine3::from_rotation_y(0.3);
        let standing = vec![
            Instance::new(mesh(&row), DAffine3::IDENTITY, None).unwrap(),
            Instance::new(Arc::clone(&pair), placed(100.0), Some(7)).unwrap(),
        ];
        let moving = vec![Instance::new(pair, placed(200.0), Some(8)).unwrap()];
        Scene::new(ORIGIN, standing, moving, Arc::new(vec![Material::default()]), Arc::default()).unwrap()
    }

    /// Returns the part found through trees, after checking that a search without trees finds the same.
    fn part(scene: &Scene, min: f64, max: f64) -> Queried {
        let corner = |x: f64, y: f64| DVec3::new(x + ORIGIN.x, y, y);
        let (min, max) = (corner(min, f64::NEG_INFINITY), corner(max, f64::INFINITY));
        let plain = self::scene().query(min, max, false, &Progress::new()).unwrap();
        let found = scene.query(min, max, true, &Progress::new()).unwrap();
        let corners = |queried: &Queried| {
            let instances = queried.scene.instances();
            let faces = instances.flat_map(|instance| {
                (0..instance.mesh.faces.len() as u32).map(|face| (instance.corners(face), instance.object_of(face)))
            });
            faces.collect::<Vec<_>>()
        };
        assert_eq!((corners(&plain), &plain.moving), (corners(&found), &found.moving));
        found
    }

    #[test]
    fn trees_are_built_only_on_request() {
        let scene = scene();
        let corner = |x: f64, y: f64| DVec3::new(x + ORIGIN.x, y, y);
        let (min, max) = (corner(-1.0, f64::NEG_INFINITY), corner(1.0, f64::INFINITY));
        assert_eq!(scene.query(min, max, false, &Progress::new()).unwrap().scene.triangle_count(), 4);
        assert!(scene.standing.tlas().is_none() && scene.instance(0).mesh.bvh().is_none());
        assert_eq!(scene.query(min, max, true, &Progress::new()).unwrap().scene.triangle_count(), 4);
        assert!(scene.standing.tlas().is_some());
    }

    #[test]
    fn duplicate_faces_are_found_although_trees_omit_them() {
        let scene = scene();
        let found = part(&scene, -1.0, 1.0).scene;
        let mesh = &found.instance(0).mesh;
        assert_eq!((0..4).map(|face| mesh.objects.get(face)).collect::<Vec<_>>(), [0, 1, 50, 51]);
        assert_eq!((found.instance_count(), mesh.faces.len(), mesh.positions.len()), (1, 4, 12));
        assert!(mesh.bvh().is_none() && found.standing.tlas().is_none());
    }

    #[test]
    fn instances_inside_stay_shared_and_others_are_cut() {
        let scene = scene();
        let (inside, cut) = (part(&scene, 90.0, 150.0).scene, part(&scene, 90.0, 101.0).scene);
        assert!(Arc::ptr_eq(&inside.instance(0).mesh, &scene.instance(1).mesh));
        assert_eq!((cut.instance(0).mesh.faces.len(), cut.instance(0).object), (1, Some(7)));
        assert_eq!(cut.instance(0).corners(0), scene.instance(1).corners(0));
        assert!(Arc::ptr_eq(&cut.materials, &scene.materials) && cut.origin == scene.origin);
        let moved = part(&scene, 150.0, f64::INFINITY);
        assert_eq!((moved.scene.standing.instances().len(), moved.moving), (0, None));
        assert!(Arc::ptr_eq(&moved.scene.moving, &scene.moving));
        assert_eq!(part(&scene, 0.0, 9.0).moving, Some(vec![]));
        assert_eq!(part(&scene, 150.0, 200.2).moving, Some(vec![0]));
    }

    #[test]
    fn the_whole_scene_is_returned_without_a_tree() {
        let scene = scene();
        let whole = part(&scene, f64::NEG_INFINITY, f64::INFINITY).scene;
        assert!(Arc::ptr_eq(&whole.standing, &scene.standing) && Arc::ptr_eq(&whole.moving, &scene.moving));
        assert!(scene.standing.tlas().is_none());
        assert_eq!(part(&scene, 1e9, 2e9).scene.triangle_count(), 0);
    }

    #[test]
    fn a_cancelled_query_is_an_error() {
        let progress = Progress::new();
        progress.cancel();
        assert!(scene().query(ORIGIN, ORIGIN + DVec3::ONE, true, &progress).is_err());
    }
}
