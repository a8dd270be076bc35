//! Tracing of tiles: what a layer's centre sees in each texel, and which texels the layer keeps.

use glam::DVec3;

use super::layer::{Layer, Patch};
use super::plane::{Bound, Plane};
use super::probe::Probe;
use super::tile::{APRON, Place, SIDE, Texel, Tile, WIDE};
use super::world::World;
use crate::camera::direction_from_face;
use crate::render::Facet;
use crate::trace::{Hit, Ray};

/// Texels of the smallest group that a further layer keeps.
const MIN_GROUP: usize = 3;
/// Width of a block of neighbouring rays.
const BLOCK: usize = 8;
/// Cosine between ray and surface below which the surface's own plane is no guide to the depths around the texel.
const MIN_COSINE: f64 = 1e-3;

impl Tile {
    /// Traces a tile from a centre and chooses the texels to keep: far surfaces that no earlier layer shows and that
    /// the centre or a probe sees.
    pub fn trace(
        world: &World<'_>,
        center: DVec3,
        size: usize,
        place: Place,
        earlier: &[Layer],
        probes: &[Probe],
    ) -> Self {
        let mut tile = Self::blank(place, size);
        let across = WIDE.div_ceil(BLOCK);
        for block in 0..across * across {
            tile.trace_block(world, center, (block % across * BLOCK, block / across * BLOCK), probes);
        }
        tile.drop_shown(center, earlier);
        if !earlier.is_empty() {
            tile.drop_specks();
        }
        tile
    }

    /// Traces the texels of a block from its first column and row.
    fn trace_block(&mut self, world: &World<'_>, center: DVec3, (x, y): (usize, usize), probes: &[Probe]) {
        let bound = world.bound(center);
        let (mut rays, mut slots) = (Vec::with_capacity(BLOCK * BLOCK), Vec::with_capacity(BLOCK * BLOCK));
        for row in y..(y + BLOCK).min(WIDE) {
            for column in x..(x + BLOCK).min(WIDE) {
                rays.push(self.ray(center, column as f64 - 0.5, row as f64 - 0.5));
                slots.push(row * WIDE + column);
            }
        }
        let mut hits = [Hit::MISS; BLOCK * BLOCK];
        world.trace(&rays, false, &mut hits[..rays.len()]);
        let (mut behind, mut hidden) = (Vec::new(), Vec::new());
        for ((&slot, ray), hit) in slots.iter().zip(&rays).zip(hits) {
            if world.note(&hit) {
                self.set(world, &bound, center, slot, ray, hit);
            } else if !hit.is_miss() {
                let (u, v) = self.position(slot);
                self.texels[slot].w = direction_from_face(self.place.face, u, v).length() / f64::from(hit.t);
                behind.push(*ray);
                hidden.push(slot);
            }
        }
        world.trace(&behind, true, &mut hits[..behind.len()]);
        for ((&slot, ray), hit) in hidden.iter().zip(&behind).zip(hits) {
            let point = || ray.origin.as_dvec3() + ray.direction.as_dvec3() * f64::from(hit.t);
            if !hit.is_miss() && probes.iter().any(|probe| probe.sees(point())) {
                world.insert(hit.instance, hit.face);
                self.set(world, &bound, center, slot, ray, hit);
            }
        }
    }

    /// Drops connected groups of fewer than `MIN_GROUP` kept texels, whose quads cost more than they show.
    fn drop_specks(&mut self) {
        let mut seen = vec![false; WIDE * WIDE];
        for first in 0..WIDE * WIDE {
            if seen[first] || !self.texels[first].kept {
                continue;
            }
            seen[first] = true;
            let mut group = vec![first];
            let mut next = 0;
            while next < group.len() {
                let (x, y) = (group[next] % WIDE, group[next] / WIDE);
                next += 1;
                for (dx, dy) in [(0, 1), (1, 0), (1, 2), (2, 1)] {
                    let (x, y) = (x + dx - 1, y + dy - 1);
                    let slot = y * WIDE + x;
                    if !seen[slot] && self.texels[slot].kept {
                        seen[slot] = true;
                        group.push(slot);
                    }
                }
            }
            if group.len() < MIN_GROUP {
                group.iter().for_each(|&slot| self.texels[slot].kept = false);
            }
        }
    }

    /// Drops kept texels outside the face or tile, and those that earlier layers show.
    fn drop_shown(&mut self, center: DVec3, earlier: &[Layer]) {
        let is_inside = |at: usize, first: usize| (APRON..SIDE + APRON).contains(&at) && first + at - APRON < self.size;
        for slot in 0..self.texels.len() {
            let texel = &self.texels[slot];
            let is_kept =
                texel.kept && is_inside(slot % WIDE, self.place.left) && is_inside(slot / WIDE, self.place.top) && {
                    let (u, v) = self.position(slot);
                    let patch = Patch::new(center, self.place.face, (u, v), texel, self.size);
                    !earlier.iter().any(|layer| layer.shows(&patch))
                };
            self.texels[slot].kept = is_kept;
        }
    }

    /// Keeps the far surface in a texel.
    pub(super) fn set(&mut self, world: &World<'_>, bound: &Bound, center: DVec3, slot: usize, ray: &Ray, hit: Hit) {
        let (u, v) = self.position(slot);
        let direction = direction_from_face(self.place.face, u, v);
        let (secant, unit) = (direction.length(), direction.normalize());
        let surface = Facet::new(world.scene, hit.instance, hit.face).surface((hit.u, hit.v), ray.direction);
        let (point, normal) = (surface.point.as_dvec3() - center, surface.normal.as_dvec3());
        let seen = secant / f64::from(hit.t);
        let own =
            if normal.dot(unit).abs() > MIN_COSINE { Plane::through(self.place.face, point, normal) } else { None };
        let plane = own.unwrap_or(Plane::frontal(seen));
        let w = plane.w(u, v);
        let (plane, w) =
            if w > 0.0 && (w / seen - 1.0).abs() < 1e-2 { (plane, w) } else { (Plane::frontal(seen), seen) };
        let [nearest, farthest] = bound.distances(unit, secant / w);
        // A plane's value at its own texel may be off by its rounding.
        let (least, greatest) = (secant / farthest * (1.0 - 1e-9), secant / nearest * (1.0 + 1e-9));
        self.texels[slot] = Texel { hit, plane, w, least, greatest, kept: true };
    }
}
