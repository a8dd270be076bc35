//! Traversal of both levels of trees by a single ray.

use std::mem::MaybeUninit;

use glam::Vec3;

use super::lanes::{Isa, Lanes};
use super::ray::{FaceHits, Hit, HitFilter, Ray};
use super::slab::Slabs;
use super::triangle::{self, Shear};
use crate::base::Aabb;
use crate::bvh::{Block, Bvh, LEAF, Tlas, WIDTH, Wide};
use crate::scene::Instance;

/// A ray prepared for one frame: the scene's or an instance's.
#[derive(Clone, Copy)]
pub(crate) struct Local {
    pub(crate) origin: Vec3,
    pub(crate) shear: Shear,
    pub(crate) slabs: Slabs,
    pub(crate) t_min: f32,
    pub(crate) t_max: f32,
    /// Parameter at which the ray enters the instance's box in scene space. Nearer hits are moved to it, so that they
    /// agree with culling by the box.
    pub(crate) floor: f32,
}

impl Local {
    /// Prepares a ray for trees inside `bounds`.
    #[inline(always)]
    pub(crate) fn new(ray: &Ray, bounds: &Aabb) -> Self {
        Self {
            origin: ray.origin,
            shear: Shear::new(ray.direction),
            slabs: Slabs::new(ray.origin, ray.direction, bounds),
            t_min: ray.t_min,
            // A hit at an infinite parameter would be a miss.
            t_max: ray.t_max.min(f32::MAX),
            floor: f32::NEG_INFINITY,
        }
    }
}

impl Ray {
    /// Returns the ray in an instance's own frame, with the same parameter.
    #[inline(always)]
    pub(crate) fn in_object(&self, instance: &Instance) -> Self {
        let origin = instance.to_object.transform_point3(self.origin.as_dvec3()).as_vec3();
        let direction = instance.to_object.transform_vector3(self.direction.as_dvec3()).as_vec3();
        Self { origin, direction, ..*self }
    }
}

/// State of one ray's search.
pub(crate) struct Search<'a> {
    /// The ray in scene space.
    pub(crate) ray: &'a Ray,
    pub(crate) filter: &'a dyn HitFilter,
    pub(crate) best: Hit,
    /// Whether any hit ends the search.
    pub(crate) stops_at_first: bool,
}

impl Search<'_> {
    #[inline(always)]
    pub(crate) fn is_done(&self) -> bool {
        self.stops_at_first && !self.best.is_miss()
    }

    #[inline(always)]
    fn accepts(&self, candidate: &Hit) -> bool {
        match self.filter.face_hits(candidate.instance, candidate.face) {
            FaceHits::None => false,
            FaceHits::Accepted => self.filter.accepts(self.ray, candidate),
            FaceHits::All => true,
        }
    }
}

/// Returns the tree of the mesh if a set has a single instance, in place.
#[inline(always)]
pub(super) fn sole_mesh<'a>(tlas: &Tlas, instances: &'a [Instance]) -> Option<&'a Bvh> {
    let [instance] = instances else { return None };
    if instance.in_place && !tlas.wide.nodes.is_empty() { instance.mesh.bvh() } else { None }
}

/// Traverses a tree over all or some instances of a set with a ray prepared for the whole set; `first` is the number of
/// its first instance.
#[inline(always)]
pub(crate) fn walk_instances<I: Isa>(
    isa: I,
    tlas: &Tlas,
    (instances, first): (&[Instance], u32),
    local: &Local,
    search: &mut Search<'_>,
) {
    match sole_mesh(tlas, instances) {
        Some(bvh) => walk_mesh(isa, bvh, local, first, search),
        None => walk(isa, &tlas.wide, local, search, &Instances { tlas, instances, first }),
    }
}

/// Action at a leaf. A trait instead of a closure, because only code that is certainly inlined is compiled with the
/// caller's instruction set.
trait Leaves<I> {
    fn visit(&self, isa: I, leaf: u32, local: &Local, search: &mut Search<'_>);
}

struct Instances<'a> {
    tlas: &'a Tlas,
    instances: &'a [Instance],
    first: u32,
}

impl<I: Isa> Leaves<I> for Instances<'_> {
    #[inline(always)]
    fn visit(&self, isa: I, leaf: u32, local: &Local, search: &mut Search<'_>) {
        let Some(slot) = self.tlas.instance(leaf) else { return };
        let instance = &self.instances[slot as usize];
        let Some(bvh) = instance.mesh.bvh() else { return };
        if instance.in_place {
            return walk_mesh(isa, bvh, local, self.first + slot, search);
        }
        let (floor, leave) = local.slabs.enter_leave(&instance.bounds);
        if floor <= leave && floor <= local.t_max && local.t_min <= leave {
            let ray = search.ray.in_object(instance);
            let placed = Local { floor, ..Local::new(&ray, &bvh.bounds) };
            walk_mesh(isa, bvh, &placed, self.first + slot, search);
        }
    }
}

struct Triangles<'a> {
    bvh: &'a Bvh,
    instance: u32,
}

impl<I: Isa> Leaves<I> for Triangles<'_> {
    #[inline(always)]
    fn visit(&self, isa: I, leaf: u32, local: &Local, search: &mut Search<'_>) {
        for block in self.bvh.leaf(leaf) {
            test_block(isa, block, local, self.instance, search);
        }
    }
}

/// Traverses one mesh.
#[inline(always)]
pub(crate) fn walk_mesh<I: Isa>(isa: I, bvh: &Bvh, local: &Local, instance: u32, search: &mut Search<'_>) {
    walk(isa, &bvh.wide, local, search, &Triangles { bvh, instance });
}

/// Maximum stack size, in entries, that needs no allocation.
pub(super) const LOCAL_STACK: usize = 256;

/// Visits leaves whose boxes the ray enters within its segment and before the best hit, nearest leaf first.
#[inline(always)]
fn walk<I: Isa>(isa: I, tree: &Wide, local: &Local, search: &mut Search<'_>, leaves: &impl Leaves<I>) {
    if tree.nodes.is_empty() {
        return;
    }
    let mut array = [const { MaybeUninit::<(f32, u32)>::uninit() }; LOCAL_STACK];
    let mut heap;
    let stack = if tree.stack <= LOCAL_STACK {
        &mut array[..]
    } else {
        heap = Box::new_uninit_slice(tree.stack);
        &mut heap[..]
    };
    stack[0].write((f32::NEG_INFINITY, 0));
    let mut size = 1;
    while size > 0 {
        size -= 1;
        // SAFETY: all entries below the former `size` have been written.
        let (near, mut reference) = unsafe { stack[size].assume_init() };
        if near > search.best.t {
            continue;
        }
        while reference & LEAF == 0 {
            let node = &tree.nodes[reference as usize];
            let (near, far) = local.slabs.intersect_node(isa, node);
            let near = near.max(I::Eight::splat(isa, local.t_min));
            let limit = if search.best.t < local.t_max { search.best.t } else { local.t_max };
            let mut mask = near.le(far.min(I::Eight::splat(isa, limit)));
            if mask == 0 {
                break;
            }
            let slot = mask.trailing_zeros() as usize;
            mask &= mask - 1;
            if mask == 0 {
                reference = node.children[slot];
                continue;
            }
            let mut distances = [0.0; WIDTH];
            near.store(&mut distances);
            // The nearest child is opened next; the others go on the stack, sorted, the nearest on top.
            let mut nearest = (distances[slot], node.children[slot]);
            let base = size;
            while mask != 0 {
                let slot = mask.trailing_zeros() as usize;
                mask &= mask - 1;
                let mut entry = (distances[slot], node.children[slot]);
                if entry.0 < nearest.0 {
                    std::mem::swap(&mut entry, &mut nearest);
                }
                let mut index = size;
                while index > base {
                    // SAFETY: this loop has written the entry, because `base <= index - 1 < size`.
                    let lower = unsafe { stack[index - 1].assume_init() };
                    if lower.0 >= entry.0 {
                        break;
                    }
                    stack[index].write(lower);
                    index -= 1;
                }
                stack[index].write(entry);
                size += 1;
            }
            reference = nearest.1;
        }
        if reference & LEAF != 0 {
            leaves.visit(isa, reference, local, search);
            if search.is_done() {
                return;
            }
        }
    }
}

/// Intersects one ray with the triangles of a block.
#[inline(always)]
fn test_block<I: Isa>(isa: I, block: &Block, local: &Local, instance: u32, search: &mut Search<'_>) {
    type Four<I> = <I as Isa>::Four;
    let corners = [gather(isa, block, local, 0), gather(isa, block, local, 1), gather(isa, block, local, 2)];
    let [sx, sy, sz] = local.shear.scale;
    let scale = [Four::<I>::splat(isa, sx), Four::<I>::splat(isa, sy), Four::<I>::splat(isa, sz)];
    let Some(crossing) = triangle::intersect(isa, corners, scale, 0b1111) else { return };
    let (mut first, mut last) = (scale, scale);
    for axis in 0..3 {
        let a = Four::<I>::load(isa, &block.corners[0][axis]);
        let b = Four::<I>::load(isa, &block.corners[1][axis]);
        let c = Four::<I>::load(isa, &block.corners[2][axis]);
        (first[axis], last[axis]) = (a.min(b).min(c), a.max(b).max(c));
        if local.slabs.first[axis] & 1 == 1 {
            (first[axis], last[axis]) = (last[axis], first[axis]);
        }
    }
    let (near, far) = local.slabs.intersect(isa, first, last);
    let (t_min, t_max) = (Four::<I>::splat(isa, local.t_min), Four::<I>::splat(isa, local.t_max));
    let t = crossing.t.max(near).max(Four::<I>::splat(isa, local.floor));
    let limit = Four::<I>::splat(isa, search.best.t);
    let inside = near.le(far) & t_min.le(far) & t_min.le(t) & t.le(t_max) & t.le(limit);
    let mut mask = crossing.mask & inside;
    if mask == 0 {
        return;
    }
    let mut lanes = [[0.0; 4]; 3];
    t.store(&mut lanes[0]);
    crossing.u.store(&mut lanes[1]);
    crossing.v.store(&mut lanes[2]);
    while mask != 0 {
        let lane = mask.trailing_zeros() as usize;
        mask &= mask - 1;
        let [t, u, v] = lanes.map(|row| row[lane]);
        let candidate = Hit { t, u, v, instance, face: block.faces[lane] };
        if candidate.is_before(&search.best) && search.accepts(&candidate) {
            search.best = candidate;
        }
    }
}

/// Loads one corner of each triangle of a block, relative to the ray's origin, with axes in the shear's order.
#[inline(always)]
fn gather<I: Isa>(isa: I, block: &Block, local: &Local, corner: usize) -> [I::Four; 3] {
    let rows = &block.corners[corner];
    let [x, y, z] = local.shear.axes;
    let x = I::Four::load(isa, &rows[x]).sub(I::Four::splat(isa, local.origin[x]));
    let y = I::Four::load(isa, &rows[y]).sub(I::Four::splat(isa, local.origin[y]));
    let z = I::Four::load(isa, &rows[z]).sub(I::Four::splat(isa, local.origin[z]));
    [x, y, z]
}
