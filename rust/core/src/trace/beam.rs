//! Traversal of both levels of trees by packets of rays.

use std::mem::MaybeUninit;

use super::lanes::{Isa, Lanes};
use super::packet::{Loader, MIN_PACKET, Packet, RAYS};
use super::ray::{FaceHits, Hit, HitFilter, Ray};
use super::single::{self, LOCAL_STACK, Local, Search, sole_mesh};
use super::triangle::{self, Crossing};
use crate::base::simd::{greater, lesser};
use crate::bvh::{Block, Bvh, LEAF, Tlas, WIDTH, Wide};
use crate::scene::Instance;

/// Query of a packet: its rays and their filter.
pub(crate) struct Query<'a> {
    /// Rays in scene space, in the packet's order.
    pub(crate) rays: &'a [Ray],
    pub(crate) filter: &'a dyn HitFilter,
}

/// Buffers for the rays that enter a placed instance, allocated at the first such instance.
pub(crate) struct BeamScratch {
    packet: Packet,
    /// Rays in the instance's frame.
    rays: Vec<Ray>,
    /// Number of each ray in the scene's packet.
    members: Vec<usize>,
}

impl BeamScratch {
    pub(crate) fn new() -> Self {
        Self { packet: Packet::new(), rays: Vec::with_capacity(RAYS), members: Vec::with_capacity(RAYS) }
    }
}

/// Traverses a tree over all or some instances of a set. The packet must be filled for the bounds of the whole set;
/// `first` is the number of its first instance.
#[inline(always)]
pub(crate) fn walk_instances<I: Isa>(
    isa: I,
    tlas: &Tlas,
    (instances, first): (&[Instance], u32),
    query: &Query<'_>,
    packet: &mut Packet,
    scratch: &mut Option<Box<BeamScratch>>,
) {
    match sole_mesh(tlas, instances) {
        Some(bvh) => walk(isa, &bvh.wide, packet, &mut BeamTriangles { bvh, instance: first, query }),
        None => walk(isa, &tlas.wide, packet, &mut BeamInstances { tlas, instances, first, query, scratch }),
    }
}

/// Returns whether the packet's beam intersects a leaf of a set's trees or the box of a placed instance.
#[inline(always)]
pub(crate) fn touches<I: Isa>(isa: I, tlas: &Tlas, instances: &[Instance], packet: &mut Packet) -> bool {
    match sole_mesh(tlas, instances) {
        Some(bvh) => walk(isa, &bvh.wide, packet, &mut AnyTriangles),
        None => walk(isa, &tlas.wide, packet, &mut AnyLeaf { tlas, instances }),
    }
    packet.is_stopped()
}

/// Stops the packet at the first leaf of a mesh in place, or at the first placed instance.
struct AnyLeaf<'a> {
    tlas: &'a Tlas,
    instances: &'a [Instance],
}

impl<I: Isa> BeamLeaves<I> for AnyLeaf<'_> {
    #[inline(always)]
    fn visit(&mut self, isa: I, leaf: u32, _planes: &[f32; 6], packet: &mut Packet) -> bool {
        let Some(slot) = self.tlas.instance(leaf) else { return false };
        let instance = &self.instances[slot as usize];
        match instance.mesh.bvh() {
            Some(bvh) if instance.in_place => walk(isa, &bvh.wide, packet, &mut AnyTriangles),
            Some(_) => packet.stop(),
            None => {}
        }
        false
    }
}

/// Stops the packet at the first leaf.
struct AnyTriangles;

impl<I: Isa> BeamLeaves<I> for AnyTriangles {
    #[inline(always)]
    fn visit(&mut self, _isa: I, _leaf: u32, _planes: &[f32; 6], packet: &mut Packet) -> bool {
        packet.stop();
        false
    }
}

/// Action at a leaf, given the planes of its box. Returns true if a hit was found.
trait BeamLeaves<I> {
    fn visit(&mut self, isa: I, leaf: u32, planes: &[f32; 6], packet: &mut Packet) -> bool;
}

struct BeamInstances<'a> {
    tlas: &'a Tlas,
    instances: &'a [Instance],
    first: u32,
    query: &'a Query<'a>,
    scratch: &'a mut Option<Box<BeamScratch>>,
}

impl<I: Isa> BeamLeaves<I> for BeamInstances<'_> {
    #[inline(always)]
    fn visit(&mut self, isa: I, leaf: u32, planes: &[f32; 6], packet: &mut Packet) -> bool {
        let Some(slot) = self.tlas.instance(leaf) else { return false };
        let (instance, number) = (&self.instances[slot as usize], self.first + slot);
        let Some(bvh) = instance.mesh.bvh() else { return false };
        if instance.in_place {
            walk(isa, &bvh.wide, packet, &mut BeamTriangles { bvh, instance: number, query: self.query });
            return true;
        }
        let scratch = self.scratch.get_or_insert_with(|| Box::new(BeamScratch::new()));
        scratch.members.clear();
        scratch.rays.clear();
        for start in (0..packet.count).step_by(I::Group::N) {
            let mut mask = packet.entering_rays(isa, start, planes);
            if mask == 0 {
                continue;
            }
            let (near, _) = packet.slabs(isa, start, planes);
            let mut floors = [0.0; 16];
            near.store(&mut floors);
            while mask != 0 {
                let lane = mask.trailing_zeros() as usize;
                mask &= mask - 1;
                scratch.packet.floor[scratch.members.len()] = floors[lane];
                scratch.members.push(start + lane);
                scratch.rays.push(self.query.rays[start + lane].in_object(instance));
            }
        }
        if scratch.members.is_empty() {
            return false;
        }
        let before = packet.changes;
        self.enter_instance(isa, bvh, number, packet);
        packet.changes != before
    }
}

impl BeamInstances<'_> {
    /// Traces the rays in `scratch` through a placed instance, as a packet if they still form a beam.
    #[inline(always)]
    fn enter_instance<I: Isa>(&mut self, isa: I, bvh: &Bvh, number: u32, packet: &mut Packet) {
        let Some(scratch) = self.scratch.as_deref_mut() else { return };
        let query = self.query;
        if scratch.members.len() >= MIN_PACKET && scratch.packet.fill(isa, &scratch.rays, &bvh.bounds) {
            let mut scene_rays = [query.rays[0]; RAYS];
            for (i, &member) in scratch.members.iter().enumerate() {
                scratch.packet.set_hit(i, &packet.hit(member));
                scene_rays[i] = query.rays[member];
            }
            let inner = Query { rays: &scene_rays[..scratch.members.len()], filter: query.filter };
            scratch.packet.update_limit(isa);
            let before = scratch.packet.changes;
            walk(isa, &bvh.wide, &mut scratch.packet, &mut BeamTriangles { bvh, instance: number, query: &inner });
            if scratch.packet.changes == before {
                return;
            }
            for (i, &member) in scratch.members.iter().enumerate() {
                packet.set_hit(member, &scratch.packet.hit(i));
            }
            return;
        }
        for (i, &member) in scratch.members.iter().enumerate() {
            let ray = &query.rays[member];
            let mut search = Search { ray, filter: query.filter, best: packet.hit(member), stops_at_first: false };
            let local = Local { floor: scratch.packet.floor[i], ..Local::new(&scratch.rays[i], &bvh.bounds) };
            single::walk_mesh(isa, bvh, &local, number, &mut search);
            if search.best != packet.hit(member) {
                packet.set_hit(member, &search.best);
            }
        }
    }
}

struct BeamTriangles<'a> {
    bvh: &'a Bvh,
    instance: u32,
    query: &'a Query<'a>,
}

impl<I: Isa> BeamLeaves<I> for BeamTriangles<'_> {
    #[inline(always)]
    fn visit(&mut self, isa: I, leaf: u32, planes: &[f32; 6], packet: &mut Packet) -> bool {
        let mut has_hit = false;
        for start in (0..packet.count).step_by(I::Group::N) {
            let mask = packet.entering_rays(isa, start, planes);
            if mask != 0 {
                for block in self.bvh.leaf(leaf) {
                    has_hit |= self.test_block(isa, block, packet, start, mask);
                }
            }
        }
        has_hit
    }
}

impl BeamTriangles<'_> {
    /// Intersects a group of rays with the triangles of a block, one triangle at a time.
    #[inline(always)]
    fn test_block<I: Isa>(&self, isa: I, block: &Block, packet: &mut Packet, start: usize, mask: u32) -> bool {
        let load = Loader(isa);
        let (origin, scale) = (load.rows(&packet.origin, start), load.rows(&packet.scale, start));
        let [x, y, z] = packet.axes;
        let mut has_hit = false;
        for lane in 0..block.faces.len() {
            if lane > 0 && block.faces[lane] == block.faces[lane - 1] {
                break;
            }
            let mut corners = [origin; 3];
            for (relative, p) in corners.iter_mut().zip(&block.corners) {
                *relative = [
                    I::Group::splat(isa, p[x][lane]).sub(origin[0]),
                    I::Group::splat(isa, p[y][lane]).sub(origin[1]),
                    I::Group::splat(isa, p[z][lane]).sub(origin[2]),
                ];
            }
            if let Some(crossing) = triangle::intersect(isa, corners, scale, mask) {
                has_hit |= self.accept(isa, block, lane, packet, start, &crossing);
            }
        }
        has_hit
    }

    /// Stores the crossings that are nearer than the best hits, under the same conditions as `single::test_block`.
    #[inline(always)]
    fn accept<I: Isa>(
        &self,
        isa: I,
        block: &Block,
        lane: usize,
        packet: &mut Packet,
        start: usize,
        crossing: &Crossing<I::Group>,
    ) -> bool {
        let mut planes = [0.0; 6];
        for axis in 0..3 {
            let [a, b, c] = [block.corners[0][axis][lane], block.corners[1][axis][lane], block.corners[2][axis][lane]];
            (planes[2 * axis], planes[2 * axis + 1]) = (lesser(lesser(a, b), c), greater(greater(a, b), c));
        }
        let load = Loader(isa);
        let (near, far) = packet.slabs(isa, start, &planes);
        let (t_min, t_max) = (load.row(&packet.t_min, start), load.row(&packet.t_max, start));
        let best = load.row(&packet.best.t, start);
        let t = crossing.t.max(near).max(load.row(&packet.floor, start));
        let inside = near.le(far) & t_min.le(far) & t_min.le(t) & t.le(t_max) & t.le(best);
        let mask = crossing.mask & inside;
        if mask == 0 {
            return false;
        }
        let face = block.faces[lane];
        let hits = self.query.filter.face_hits(self.instance, face);
        if hits == FaceHits::None {
            return false;
        }
        if hits == FaceHits::All && t.eq(best) & mask == 0 {
            packet.changes = packet.changes.wrapping_add(1);
            let rows = &mut packet.best;
            t.select(mask, best).store(&mut rows.t[start..]);
            crossing.u.select(mask, load.row(&rows.u, start)).store(&mut rows.u[start..]);
            crossing.v.select(mask, load.row(&rows.v, start)).store(&mut rows.v[start..]);
            let instance = I::Group::splat(isa, f32::from_bits(self.instance));
            instance.select(mask, load.row(&rows.instance, start)).store(&mut rows.instance[start..]);
            let face = I::Group::splat(isa, f32::from_bits(face));
            face.select(mask, load.row(&rows.face, start)).store(&mut rows.face[start..]);
            return true;
        }
        let mut lanes = [[0.0; 16]; 3];
        t.store(&mut lanes[0]);
        crossing.u.store(&mut lanes[1]);
        crossing.v.store(&mut lanes[2]);
        self.accept_slow(packet, start, mask, (face, hits), &lanes)
    }

    /// Same for ties and filters, one lane after the other.
    #[inline(never)]
    fn accept_slow(
        &self,
        packet: &mut Packet,
        start: usize,
        mut mask: u32,
        (face, hits): (u32, FaceHits),
        lanes: &[[f32; 16]; 3],
    ) -> bool {
        let mut has_hit = false;
        while mask != 0 {
            let lane = mask.trailing_zeros() as usize;
            mask &= mask - 1;
            let [t, u, v] = [lanes[0][lane], lanes[1][lane], lanes[2][lane]];
            let candidate = Hit { t, u, v, instance: self.instance, face };
            let ray = start + lane;
            if candidate.is_before(&packet.hit(ray))
                && (hits == FaceHits::All || self.query.filter.accepts(&self.query.rays[ray], &candidate))
            {
                packet.set_hit(ray, &candidate);
                has_hit = true;
            }
        }
        has_hit
    }
}

/// A child of a node and the distance at which the beam enters it.
#[derive(Clone, Copy)]
struct Entry {
    near: f32,
    child: u32,
    /// Index of its node and slot, from which its box is read.
    box_index: u32,
}

/// Visits leaves whose boxes the beam intersects, nearest leaf first, up to the packet's limit.
#[inline(always)]
fn walk<I: Isa>(isa: I, tree: &Wide, packet: &mut Packet, leaves: &mut impl BeamLeaves<I>) {
    if tree.nodes.is_empty() {
        return;
    }
    let mut array = [const { MaybeUninit::<Entry>::uninit() }; LOCAL_STACK];
    let mut heap;
    let stack = if tree.stack <= LOCAL_STACK {
        &mut array[..]
    } else {
        heap = Box::new_uninit_slice(tree.stack);
        &mut heap[..]
    };
    stack[0].write(Entry { near: 0.0, child: 0, box_index: 0 });
    let mut size = 1;
    while size > 0 {
        size -= 1;
        // SAFETY: all entries below the former `size` have been written.
        let mut entry = unsafe { stack[size].assume_init() };
        if entry.near > packet.limit() {
            continue;
        }
        while entry.child & LEAF == 0 {
            let node = &tree.nodes[entry.child as usize];
            let (mut mask, near) = packet.intersect_node(isa, node);
            if mask == 0 {
                break;
            }
            let mut distances = [0.0; WIDTH];
            near.store(&mut distances);
            let number = entry.child;
            let base = size;
            let slot = mask.trailing_zeros() as usize;
            mask &= mask - 1;
            entry = Entry { near: distances[slot], child: node.children[slot], box_index: number << 3 | slot as u32 };
            while mask != 0 {
                let slot = mask.trailing_zeros() as usize;
                mask &= mask - 1;
                let mut farther =
                    Entry { near: distances[slot], child: node.children[slot], box_index: number << 3 | slot as u32 };
                if farther.near < entry.near {
                    std::mem::swap(&mut entry, &mut farther);
                }
                let mut index = size;
                while index > base {
                    // SAFETY: this loop has written the entry, because `base <= index - 1 < size`.
                    let lower = unsafe { stack[index - 1].assume_init() };
                    if lower.near >= farther.near {
                        break;
                    }
                    stack[index].write(lower);
                    index -= 1;
                }
                stack[index].write(farther);
                size += 1;
            }
        }
        if entry.child & LEAF != 0 {
            let (node, slot) = (&tree.nodes[(entry.box_index >> 3) as usize], (entry.box_index & 7) as usize);
            let mut planes = [0.0; 6];
            for (plane, row) in planes.iter_mut().zip(&node.planes) {
                *plane = row[slot];
            }
            if leaves.visit(isa, entry.child, &planes, packet) {
                packet.update_limit(isa);
            }
        }
    }
}
