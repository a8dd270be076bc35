//! Quads of layers, and which of them another region can use.

use std::sync::Arc;

use glam::DVec3;
use rayon::prelude::*;

use super::layer::{Layer, Patch};
use super::paint::Quad;
use super::plane::Bound;
use super::probe::Probe;
use super::tile::{APRON, Tile, WIDE, column_and_row};
use super::world::World;
use crate::base::{Progress, Result};
use crate::trace::Hit;

/// Quads of a layer.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// Centre of the layer relative to the scene's origin.
    pub center: DVec3,
    /// Width of a face, texels.
    pub size: usize,
    /// The quads, in the order of their tiles.
    pub quads: Vec<Arc<Quad>>,
}

impl Sheet {
    /// Returns the bytes of the quads.
    pub fn bytes(&self) -> usize {
        let bytes = |quad: &Arc<Quad>| size_of::<Quad>() + size_of_val(&quad.own[..]) + size_of_val(&quad.texels[..]);
        self.quads.iter().map(bytes).sum()
    }

    /// Returns the layer that the quads show.
    pub fn layer(&self, world: &World<'_>) -> Layer {
        Layer::new(world, self.center, self.size, &self.quads)
    }

    /// Returns the sheet with those quads that a world's region can use: each of their texels keeps that region's error
    /// bound and is about as fine as a texel of the region's own maps of `size` texels, and a probe sees one of them.
    pub fn shared_with(&self, world: &World<'_>, probes: &[Probe], size: usize, progress: &Progress) -> Result<Self> {
        let bound = world.bound(self.center);
        let tiles: Vec<_> = self.quads.chunk_by(|a, b| a.place == b.place).collect();
        let usable = |quads: &&[Arc<Quad>]| {
            let mut tile = Tile::blank(quads[0].place, self.size);
            let is_usable = |quad: &&Arc<Quad>| self.is_usable(quad, world, &bound, &mut tile, probes, size);
            let usable: Vec<Arc<Quad>> = quads.iter().filter(is_usable).cloned().collect();
            progress.check().map(|()| usable)
        };
        let quads = tiles.par_iter().map(usable).collect::<Result<Vec<_>>>()?;
        Ok(Self { quads: quads.concat(), ..*self })
    }

    /// Returns whether a quad's texels, traced from the layer's centre, keep the bound and are fine enough, and a probe
    /// sees one of them.
    fn is_usable(
        &self,
        quad: &Quad,
        world: &World<'_>,
        bound: &Bound,
        tile: &mut Tile,
        probes: &[Probe],
        size: usize,
    ) -> bool {
        let places: Vec<_> = quad.own.iter().map(|&texel| column_and_row(texel)).collect();
        let ray = |&(column, row): &(usize, usize)| tile.ray(self.center, column as f64 + 0.5, row as f64 + 0.5);
        let rays: Vec<_> = places.iter().map(ray).collect();
        let mut hits = vec![Hit::MISS; rays.len()];
        world.trace(&rays, true, &mut hits);
        let mut is_seen = false;
        for ((ray, hit), (column, row)) in rays.iter().zip(hits).zip(places) {
            if hit.is_miss() {
                return false;
            }
            let slot = (row + APRON) * WIDE + column + APRON;
            tile.set(world, bound, self.center, slot, ray, hit);
            let (texel, (u, v)) = (&tile.texels[slot], tile.position(slot));
            if !(texel.least..=texel.greatest).contains(&quad.plane.w(u, v)) {
                return false;
            }
            let point = ray.origin.as_dvec3() + ray.direction.as_dvec3() * f64::from(hit.t);
            let patch = Patch::new(self.center, quad.place.face, (u, v), texel, self.size);
            if !patch.is_as_fine_as_from(world.eye, size) {
                return false;
            }
            is_seen = is_seen || probes.iter().any(|probe| probe.sees(point));
        }
        is_seen
    }
}
