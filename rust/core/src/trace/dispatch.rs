//! Entry points for tracing many rays, with kernels compiled for the processor's instruction set. A scene's static
//! instances can be traced layer by layer.

use super::beam::{self, Query};
#[cfg(target_arch = "x86_64")]
use super::lanes::{Avx2, Avx512};
use super::lanes::{InstructionSet, Isa, Portable};
use super::packet::{MIN_PACKET, Packet, RAYS};
use super::ray::{AcceptAll, Hit, HitFilter, Ray};
use super::single::{self, Local, Search};
use crate::base::{Aabb, Progress, Result};
use crate::bvh::Tlas;
use crate::scene::{Instance, Scene};

/// A tree over the boxes of some static instances of a scene.
#[derive(Debug)]
pub struct LayerTree(Tlas);

impl LayerTree {
    /// Builds the tree of the static instances whose numbers fulfil a condition.
    pub fn new(scene: &Scene, is_included: impl Fn(usize) -> bool, progress: &Progress) -> Result<Self> {
        let instances = scene.standing.instances().iter().enumerate();
        let boxes = instances.map(|(number, instance)| if is_included(number) { instance.bounds } else { Aabb::EMPTY });
        Ok(Self(Tlas::build(&boxes.collect::<Vec<_>>(), progress)?))
    }
}

/// A subset of a scene's static instances.
pub struct Layer<'a> {
    /// Tree of their boxes.
    pub tree: &'a LayerTree,
    /// Filter for their faces.
    pub filter: Box<dyn HitFilter + 'a>,
}

/// Hits of a packet in a layer and all earlier ones.
#[derive(Clone, Debug)]
pub struct LayerHits {
    /// Nearest hit of each ray; not written if no hit has changed.
    pub hits: [Hit; RAYS],
    /// Bit mask of the rays whose hit differs from the previous layer's.
    pub changed: u64,
}

impl Default for LayerHits {
    fn default() -> Self {
        Self { hits: [Hit::MISS; RAYS], changed: 0 }
    }
}

impl LayerHits {
    /// Stores this layer's hits if they differ from the previous layer's, and updates `last`.
    fn store(&mut self, count: usize, last: &mut [Hit; RAYS], hit: impl Fn(usize) -> Hit) {
        for (i, last) in last.iter_mut().enumerate().take(count) {
            let hit = hit(i);
            if (hit.instance, hit.face) != (last.instance, last.face) {
                *last = hit;
                self.changed |= 1 << i;
            }
        }
        if self.changed != 0 {
            self.hits = *last;
        }
    }
}

/// Writes the nearest hit of each ray; neighbours in the slice are assumed to be coherent. The scene must have been
/// built (`Scene::build`).
pub fn closest_hits(scene: &Scene, rays: &[Ray], filter: &dyn HitFilter, hits: &mut [Hit]) {
    closest_hits_with(InstructionSet::current(), scene, rays, filter, hits);
}

/// Writes the nearest hit of each ray without packets. This is faster if rays are incoherent, or if so many triangles
/// lie between neighbouring rays that a packet's rays visit different nodes.
pub fn closest_hits_apart(scene: &Scene, rays: &[Ray], filter: &dyn HitFilter, hits: &mut [Hit]) {
    closest_hits_apart_with(InstructionSet::current(), scene, rays, filter, hits);
}

/// Writes for each layer the nearest hits of a packet among the surfaces of that layer and all earlier ones. A packet
/// has at most `RAYS` rays. The scene's moving instances are in no layer.
///
/// The best hits of one layer bound the search in the next, so the hits of distant surfaces are found only if their
/// layer comes first. The hits equal, bit for bit, those of `closest_hits` in a scene without the other faces.
pub fn closest_hits_by_layer(scene: &Scene, rays: &[Ray], layers: &[Layer<'_>], hits: &mut [LayerHits]) {
    closest_hits_by_layer_with(InstructionSet::current(), scene, rays, layers, hits);
}

/// Returns false if no ray between four corner rays from one origin can hit anything. Near misses may return true.
pub fn beam_touches(scene: &Scene, corners: &[Ray; 4]) -> bool {
    let mut touched = [true];
    beam_touches_with(InstructionSet::current(), scene, corners, &AcceptAll, &mut touched);
    touched[0]
}

/// Writes for each ray whether it hits anything within its segment.
pub fn any_hits(scene: &Scene, rays: &[Ray], filter: &dyn HitFilter, hits: &mut [bool]) {
    any_hits_with(InstructionSet::current(), scene, rays, filter, hits);
}

/// Defines one function per instruction set around a generic kernel. The inlined code is compiled with the instructions
/// of that set.
macro_rules! kernels {
    ($name:ident, $kernel:ident, $filter:ty, $out:ty) => {
        pub(super) fn $name(level: InstructionSet, scene: &Scene, rays: &[Ray], filter: $filter, out: &mut [$out]) {
            #[cfg(target_arch = "x86_64")]
            {
                #[target_feature(enable = "avx2")]
                fn avx2(isa: Avx2, scene: &Scene, rays: &[Ray], filter: $filter, out: &mut [$out]) {
                    $kernel(isa, scene, rays, filter, out);
                }
                #[target_feature(enable = "avx2,avx512f,avx512vl,avx512dq")]
                fn avx512(isa: Avx512, scene: &Scene, rays: &[Ray], filter: $filter, out: &mut [$out]) {
                    $kernel(isa, scene, rays, filter, out);
                }
                match level {
                    // SAFETY: the value `isa` proves that the processor has the instructions.
                    InstructionSet::Avx2(isa) => return unsafe { avx2(isa, scene, rays, filter, out) },
                    // SAFETY: as above.
                    InstructionSet::Avx512(isa) => return unsafe { avx512(isa, scene, rays, filter, out) },
                    InstructionSet::Portable => {}
                }
            }
            let _ = level;
            $kernel(Portable, scene, rays, filter, out);
        }
    };
}

kernels!(closest_hits_with, closest, &dyn HitFilter, Hit);
kernels!(closest_hits_apart_with, closest_apart, &dyn HitFilter, Hit);
kernels!(closest_hits_by_layer_with, closest_by_layer, &[Layer<'_>], LayerHits);
kernels!(any_hits_with, any_hit, &dyn HitFilter, bool);
kernels!(beam_touches_with, touches, &dyn HitFilter, bool);

#[inline(always)]
fn closest<I: Isa>(isa: I, scene: &Scene, rays: &[Ray], filter: &dyn HitFilter, hits: &mut [Hit]) {
    if rays.len() < MIN_PACKET {
        return closest_apart(isa, scene, rays, filter, hits);
    }
    let (mut packet, mut scratch) = (Packet::new(), None);
    for (rays, hits) in rays.chunks(RAYS).zip(hits.chunks_mut(RAYS)) {
        let query = Query { rays, filter };
        packet.clear();
        let mut is_beam = false;
        for (tlas, instances, first) in numbered_sets(scene) {
            // Whether rays form a beam does not depend on the set.
            is_beam = packet.fill(isa, rays, &tlas.bounds);
            if !is_beam {
                break;
            }
            packet.update_limit(isa);
            beam::walk_instances(isa, tlas, (instances, first), &query, &mut packet, &mut scratch);
        }
        if is_beam {
            hits.iter_mut().enumerate().for_each(|(i, hit)| *hit = packet.hit(i));
        } else {
            closest_apart(isa, scene, rays, filter, hits);
        }
    }
}

#[inline(always)]
fn touches<I: Isa>(isa: I, scene: &Scene, rays: &[Ray], _filter: &dyn HitFilter, touched: &mut [bool]) {
    let mut packet = Packet::new();
    packet.clear();
    // A loop, because a closure would be compiled without the instruction set.
    for (tlas, instances, _) in numbered_sets(scene) {
        if !packet.fill(isa, rays, &tlas.bounds) {
            return;
        }
        packet.update_limit(isa);
        if beam::touches(isa, tlas, instances, &mut packet) {
            return;
        }
    }
    touched.fill(false);
}

/// Returns the trees of the non-empty sets of instances, each with its instances and the number of the first.
#[inline(always)]
fn numbered_sets(scene: &Scene) -> impl Iterator<Item = (&Tlas, &[Instance], u32)> {
    let moving = scene.standing.instances().len() as u32;
    let sets = [(&scene.standing, 0), (&scene.moving, moving)];
    let occupied = sets.into_iter().filter(|(set, _)| !set.instances().is_empty());
    occupied.filter_map(|(set, first)| Some((set.tlas()?, set.instances(), first)))
}

#[inline(always)]
fn closest_apart<I: Isa>(isa: I, scene: &Scene, rays: &[Ray], filter: &dyn HitFilter, hits: &mut [Hit]) {
    for (ray, hit) in rays.iter().zip(hits) {
        *hit = trace(isa, scene, Search { ray, filter, best: Hit::MISS, stops_at_first: false });
    }
}

#[inline(always)]
fn any_hit<I: Isa>(isa: I, scene: &Scene, rays: &[Ray], filter: &dyn HitFilter, hits: &mut [bool]) {
    for (ray, hit) in rays.iter().zip(hits) {
        *hit = !trace(isa, scene, Search { ray, filter, best: Hit::MISS, stops_at_first: true }).is_miss();
    }
}

#[inline(always)]
fn trace<I: Isa>(isa: I, scene: &Scene, mut search: Search<'_>) -> Hit {
    for (tlas, instances, first) in numbered_sets(scene) {
        let local = Local::new(search.ray, &tlas.bounds);
        single::walk_instances(isa, tlas, (instances, first), &local, &mut search);
        if search.is_done() {
            break;
        }
    }
    search.best
}

#[inline(always)]
fn closest_by_layer<I: Isa>(isa: I, scene: &Scene, rays: &[Ray], layers: &[Layer<'_>], out: &mut [LayerHits]) {
    out.iter_mut().for_each(|out| out.changed = 0);
    let instances = scene.standing.instances();
    let Some(tlas) = scene.standing.tlas().filter(|_| !instances.is_empty()) else { return };
    let mut last = [Hit::MISS; RAYS];
    let (mut packet, mut scratch) = (Packet::new(), None);
    packet.clear();
    if rays.len() >= MIN_PACKET && packet.fill(isa, rays, &tlas.bounds) {
        packet.update_limit(isa);
        for (layer, out) in layers.iter().zip(out) {
            let before = packet.changes;
            let query = Query { rays, filter: &*layer.filter };
            beam::walk_instances(isa, &layer.tree.0, (instances, 0), &query, &mut packet, &mut scratch);
            if packet.changes != before {
                out.store(rays.len(), &mut last, |i| packet.hit(i));
            }
        }
        return;
    }
    for (layer, out) in layers.iter().zip(out) {
        let mut hits = last;
        for (ray, best) in rays.iter().zip(&mut hits) {
            let mut search = Search { ray, filter: &*layer.filter, best: *best, stops_at_first: false };
            let local = Local::new(ray, &tlas.bounds);
            single::walk_instances(isa, &layer.tree.0, (instances, 0), &local, &mut search);
            *best = search.best;
        }
        out.store(rays.len(), &mut last, |i| hits[i]);
    }
}
