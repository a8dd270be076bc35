//! Maps of a scene whose objects become geometry ring after ring: map i shows the objects of all rings after i.
//!
//! Each ray is traced once for all maps, from the last map back to the first: through the geometry beyond all rings,
//! then through the objects of the last ring up to the hit found so far, and so on. With the objects of ring i, the hit
//! belongs to map i − 1. Each hit is shaded once for all maps that show it.

use super::bake::{Bake, without_moving};
use super::frame::{Band, Channels, Frame};
use super::ring_layers::RingLayers;
use super::tiles::{CENTER, Caster, ImageTile, NO_RAYS, PIXELS, Picture, TILE};
use super::truth::Truth;
use crate::base::mapped::set_bits;
use crate::base::memory::try_extend;
use crate::base::{Progress, Result, ensure};
use crate::scene::Scene;
use crate::trace::{AcceptAll, Hit, Layer, LayerHits, Ray, closest_hits_by_layer};

/// Maps of all rings.
#[derive(Debug)]
pub struct RingMaps {
    /// Map 0: six faces, one after the other.
    pub first: Frame,
    /// Difference of each map, from ring 1 on, to the previous one.
    pub changes: Vec<Change>,
}

/// Texels that differ from the previous map, because a sample or the centre shows an object of the ring there.
#[derive(Debug, Default)]
pub struct Change {
    /// Texel numbers in the six faces, ascending.
    pub texels: Vec<i64>,
    /// New values of these texels.
    pub frame: Frame,
}

/// Bakes the static objects of a scene; `settings.radius` is ignored.
///
/// `rings` has the ring of each object, and as last entry that of faces without one. Maps 0 to `count` are baked.
pub fn bake_rings(scene: &Scene, settings: &Bake, rings: &[u16], count: u16, progress: &Progress) -> Result<RingMaps> {
    settings.check(scene)?;
    ensure!(!rings.is_empty(), "rings", "a ring for faces without an object", "none");
    settings.channels().check_room(6 * settings.texels() as u64)?;
    let scene = &without_moving(scene, progress)?;
    let layers = RingLayers::new(scene, rings, count, progress)?;
    let layers = &layers.layers();
    let mut maps =
        RingMaps { first: Frame::with_capacity(settings.channels(), 6 * settings.texels())?, changes: vec![] };
    maps.changes.resize_with(layers.len() - 1, Change::default);
    for face in 0..6 {
        let camera = settings.camera(face)?;
        let view = settings.view(scene, &camera);
        let truth = Truth { scene, filter: &AcceptAll };
        let baker = Baker { truth, layers, caster: Caster::new(&view)?, channels: view.channels };
        let mut frame = Frame::new(view.channels, settings.texels())?;
        let bands =
            baker.caster.for_each_tile(&mut frame, progress, |tile, band, rows| baker.bake(tile, band, rows))?;
        maps.first.append(&frame)?;
        let first = (usize::from(face) * settings.texels()) as i64;
        for rows in bands {
            for (change, rows) in maps.changes.iter_mut().zip(rows.chunks(TILE)) {
                for row in rows {
                    try_extend(&mut change.texels, row.texels.iter().map(|texel| first + texel))?;
                    change.frame.append(&row.frame)?;
                }
            }
        }
    }
    Ok(maps)
}

struct Baker<'a> {
    truth: Truth<'a>,
    /// Layer beyond all rings, then the rings from the last to the first.
    layers: &'a [Layer<'a>],
    caster: Caster<'a>,
    channels: Channels,
}

/// Pixels of a tile in one map.
#[derive(Clone)]
struct TileMap {
    /// Sums of the samples' colours.
    sums: [[f32; 3]; PIXELS],
    /// Bit mask of the pixels with a sample or centre that shows the layer's own objects.
    own_pixels: u64,
}

impl Baker<'_> {
    /// Bakes a tile: map 0 into its band, the changes into `rows`, `TILE` per ring.
    fn bake(&self, tile: &ImageTile, band: &mut Band<'_>, rows: &mut Vec<Change>) {
        let count = self.layers.len() - 1;
        rows.resize_with(count * TILE, Change::default);
        let mut rays = NO_RAYS;
        let rays = &mut rays[..tile.count];
        let mut hits = vec![LayerHits::default(); self.layers.len()];
        let mut maps = vec![TileMap { sums: [[0.0; 3]; PIXELS], own_pixels: 0 }; self.layers.len()];
        for &offset in &self.caster.offsets {
            self.trace(tile, offset, rays, &mut hits, &mut maps);
            self.add_colors(tile, offset, rays, &hits, &mut maps);
        }
        if self.channels.any_surface() && self.caster.offsets.len() > 1 {
            self.trace(tile, CENTER, rays, &mut hits, &mut maps);
        }
        let mut shown_hits = &MISSES;
        for (layer, layer_hits) in hits.iter().enumerate() {
            if layer_hits.changed != 0 {
                shown_hits = &layer_hits.hits;
            }
            let pixel = |n: usize| {
                let color = maps[layer].sums[n].map(|sum| sum * self.caster.sample_weight());
                let footprint = || self.caster.footprint(tile, n, CENTER, 1.0);
                (color, self.truth.sample(&rays[n], &shown_hits[n], footprint, self.channels))
            };
            let Some(next) = maps.get(layer + 1) else {
                for n in 0..tile.count {
                    let (color, sample) = pixel(n);
                    band.color(tile.slot(n), color);
                    band.set_sample(tile.slot(n), &sample);
                }
                break;
            };
            let rows = &mut rows[(count - layer - 1) * TILE..];
            for n in set_bits(next.own_pixels).map(|n| n as usize) {
                let (color, sample) = pixel(n);
                let row = &mut rows[tile.offset_in_tile(n).1];
                row.texels.push(tile.index(n) as i64);
                row.frame.push(self.channels, color, COVERAGE, &sample);
            }
        }
    }

    fn trace(
        &self,
        tile: &ImageTile,
        offset: [f64; 2],
        rays: &mut [Ray],
        hits: &mut [LayerHits],
        maps: &mut [TileMap],
    ) {
        self.caster.write_rays(tile, offset, rays);
        closest_hits_by_layer(self.truth.scene, rays, self.layers, hits);
        maps.iter_mut().zip(hits).for_each(|(map, hits)| map.own_pixels |= hits.changed);
    }

    /// Adds the colours of traced rays to the sums of all maps.
    fn add_colors(&self, tile: &ImageTile, offset: [f64; 2], rays: &[Ray], hits: &[LayerHits], maps: &mut [TileMap]) {
        let mut colors = [[0.0; 3]; PIXELS];
        let (mut new_rays, mut new_hits) = (NO_RAYS, MISSES);
        for (layer, (layer_hits, map)) in hits.iter().zip(maps).enumerate() {
            if layer == 0 {
                // Includes rays without a hit, which show the sky.
                let shown_hits = if layer_hits.changed == 0 { &MISSES } else { &layer_hits.hits };
                let footprint = |n: usize| self.caster.footprint(tile, n, offset, self.caster.scale);
                self.truth.add_colors(rays, &shown_hits[..rays.len()], footprint, &mut colors[..rays.len()]);
            } else if layer_hits.changed != 0 {
                let (mut pixels, mut count) = ([0; PIXELS], 0);
                for n in set_bits(layer_hits.changed).map(|n| n as usize) {
                    (pixels[count], new_rays[count], new_hits[count]) = (n, rays[n], layer_hits.hits[n]);
                    count += 1;
                }
                let mut new_colors = [[0.0; 3]; PIXELS];
                let footprint = |i: usize| self.caster.footprint(tile, pixels[i], offset, self.caster.scale);
                self.truth.add_colors(&new_rays[..count], &new_hits[..count], footprint, &mut new_colors);
                pixels[..count].iter().zip(new_colors).for_each(|(&n, color)| colors[n] = color);
            }
            for (sum, color) in map.sums.as_flattened_mut().iter_mut().zip(colors.as_flattened()) {
                *sum += color;
            }
        }
    }
}

/// Results of a tile whose rays all miss.
const MISSES: [Hit; PIXELS] = [Hit::MISS; PIXELS];
/// Coverage is not computed for maps.
const COVERAGE: f32 = 0.0;

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::{DAffine3, DVec3};

    use super::super::tiles::draw;
    use super::*;
    use crate::base::FaceMap;
    use crate::base::random::uniform;
    use crate::scene::{Instance, Mesh};
    use crate::trace::HitFilter;

    /// 400 triangles of 40 objects around the centre in one mesh, which is placed three times, once as object 7.
    fn scene() -> Scene {
        let random = |n: u64, k| (uniform(7, n, k) * 2.0 - 1.0) as f32;
        let corner = |face: u64, k: u64| {
            let distance = 2.0 + 30.0 * uniform(7, face, 9) as f32;
            let middle = [0, 1, 2].map(|axis| distance * random(face, axis));
            [0, 1, 2].map(|axis| middle[axis as usize] + 3.0 * random(face, 10 + 3 * k + axis))
        };
        let triangles: Vec<_> = (0..400).map(|face| [0, 1, 2].map(|k| corner(face, k))).collect();
        let mesh = Mesh::of_triangles(&triangles, FaceMap::PerFace((0..400).map(|n| n / 10 - 1).collect()));
        let placed =
            |turn: f64, object| Instance::new(Arc::clone(&mesh), DAffine3::from_rotation_y(turn), object).unwrap();
        Scene::of_instances(vec![placed(0.0, None), placed(0.3, Some(7)), placed(2.0, None)], vec![])
    }

    /// Filter for objects of rings after a given one.
    struct LaterRings<'a>(&'a Scene, &'a [u16], u16);

    impl HitFilter for LaterRings<'_> {
        fn accepts(&self, _ray: &Ray, candidate: &Hit) -> bool {
            let object = self.0.instance(candidate.instance).object_of(candidate.face);
            self.1[usize::try_from(object).unwrap_or(40)] > self.2
        }
    }

    #[test]
    fn maps_equal_maps_drawn_one_by_one() {
        let scene = scene();
        // Objects of ring 0 are in no map; rings 3 and 4 lie beyond all.
        let rings: Vec<u16> = (0..41).map(|n| n * 7 % 5).collect();
        for samples in [1, 5] {
            let settings = Bake { center: DVec3::ZERO, radius: 0.0, size: 28, samples, range: true, object_id: true };
            let maps = bake_rings(&scene, &settings, &rings, 2, &Progress::new()).unwrap();
            let mut map = maps.first;
            let mut changed = 0;
            for ring in 0..=2 {
                let filter = &LaterRings(&scene, &rings, ring);
                let mut drawn = Frame::default();
                for face in 0..6 {
                    let camera = settings.camera(face).unwrap();
                    let picture = Truth { scene: &scene, filter };
                    drawn.append(&draw(&settings.view(&scene, &camera), &picture, &Progress::new()).unwrap()).unwrap();
                }
                assert_eq!(map.color, drawn.color);
                assert_eq!(map.range, drawn.range);
                assert_eq!(map.object_id, drawn.object_id);
                let Some(change) = maps.changes.get(usize::from(ring)) else { continue };
                assert!(change.texels.is_sorted_by(|a, b| a < b));
                changed += change.texels.len();
                for (number, &texel) in change.texels.iter().enumerate() {
                    map.color[texel as usize] = change.frame.color[number];
                    map.range[texel as usize] = change.frame.range[number];
                    map.object_id[texel as usize] = change.frame.object_id[number];
                }
            }
            assert!(changed > 100 && changed < 2 * 6 * 28 * 28 * 9 / 10, "{changed}");
        }
    }

    #[test]
    fn impossible_settings_are_refused() {
        let scene = scene();
        let settings = Bake { center: DVec3::ZERO, radius: 0.0, size: 4, samples: 1, range: false, object_id: false };
        assert!(bake_rings(&scene, &settings, &[], 0, &Progress::new()).is_err());
        assert!(bake_rings(&scene, &settings, &[1], 1, &Progress::new()).is_ok());
    }
}
