//! Tracing of a scene's static instances layer by layer.

use super::beam::{self, Query};
use super::lanes::Isa;
use super::packet::{MIN_PACKET, Packet, RAYS};
use super::ray::{Hit, HitFilter, Ray};
use super::single::{self, Local, Search};
use crate::base::{Aabb, Progress, Result};
use crate::bvh::Tlas;
use crate::scene::Scene;

/// A tree over the boxes of some static instances of a scene.
#[derive(Debug)]
pub struct LayerTree(Tlas);

impl LayerTree {
    /// Builds the tree of the instances whose numbers fulfil a condition.
    pub fn new(scene: &Scene, holds: impl Fn(usize) -> bool, progress: &Progress) -> Result<Self> {
        let instances = scene.standing.instances().iter().enumerate();
        let boxes = instances.map(|(number, instance)| if holds(number) { instance.bounds } else { Aabb::EMPTY });
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

/// Hits of a packet after a layer.
#[derive(Clone, Debug)]
pub struct LayerHits {
    /// Nearest hit of each ray in this layer and all earlier ones; not written if no hit has changed.
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

/// Implements `closest_hits_by_layer`.
#[inline(always)]
pub(super) fn by_layer<I: Isa>(isa: I, scene: &Scene, rays: &[Ray], layers: &[Layer<'_>], out: &mut [LayerHits]) {
    out.iter_mut().for_each(|out| out.changed = 0);
    let instances = scene.standing.instances();
    let Some(whole) = scene.standing.tlas().filter(|_| !instances.is_empty()) else { return };
    let mut last = [Hit::MISS; RAYS];
    let (mut packet, mut stack) = (Packet::new(), None);
    packet.clear();
    if rays.len() >= MIN_PACKET && packet.fill(isa, rays, &whole.bounds) {
        packet.shorten(isa);
        for (layer, out) in layers.iter().zip(out) {
            let before = packet.changes;
            let query = Query { rays, filter: &*layer.filter };
            beam::walk_subset(isa, &layer.tree.0, instances, &query, &mut packet, &mut stack);
            if packet.changes != before {
                out.store(rays.len(), &mut last, |i| packet.hit(i));
            }
        }
        return;
    }
    for (layer, out) in layers.iter().zip(out) {
        let mut found = last;
        for (ray, best) in rays.iter().zip(&mut found) {
            let mut search = Search { ray, filter: &*layer.filter, best: *best, any: false };
            let local = Local::new(ray, &whole.bounds);
            single::walk_subset(isa, &layer.tree.0, instances, &local, &mut search);
            *best = search.best;
        }
        out.store(rays.len(), &mut last, |i| found[i]);
    }
}
