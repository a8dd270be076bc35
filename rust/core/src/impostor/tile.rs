//! Square tiles of a layer's cube faces: what the layer's centre sees in each texel, and which texels the layer keeps.

use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;

use super::layer::{Layer, Patch};
use super::plane::{Bound, Plane};
use super::probe::Probe;
use crate::base::Result;
use crate::base::memory::try_with_capacity;
use crate::camera::direction_from_face;
use crate::partition::{Partition, Zone};
use crate::render::Facet;
use crate::scene::Scene;
use crate::trace::{All, AlphaFilter, FaceHits, Hit, HitFilter, Ray, closest_hits};

/// Width of a tile, texels.
pub const SIDE: usize = 64;
/// Texels around a tile that are traced as well, for masks that grow.
pub const APRON: usize = 1;
/// Width of a tile with its apron, texels.
pub const WIDE: usize = SIDE + 2 * APRON;
/// Texels of the smallest group that a further layer keeps.
const MIN_GROUP: usize = 3;
/// Width of a block of neighbouring rays.
const BLOCK: usize = 8;
/// Cosine between ray and surface below which the surface's own plane is no guide to the depths around the texel.
const MIN_COSINE: f64 = 1e-3;

/// Returns column and row of a texel by its number, `row * SIDE + column`.
pub fn column_and_row(texel: u16) -> (usize, usize) {
    (usize::from(texel) % SIDE, usize::from(texel) / SIDE)
}

/// Filter for triangles that are far as a whole; all others are drawn as geometry.
pub struct FarOnly<'a>(pub &'a Partition);

impl HitFilter for FarOnly<'_> {
    fn face_hits(&self, instance: u32, face: u32) -> FaceHits {
        if self.0.zone(instance, face) == Zone::Far { FaceHits::All } else { FaceHits::None }
    }
}

/// The static part of a scene, its partition, and the users' region.
pub struct World<'a> {
    /// The scene without moving objects, built.
    pub scene: &'a Scene,
    /// Partition of the scene at r₂.
    pub partition: &'a Partition,
    /// O relative to the scene's origin.
    pub eye: DVec3,
    /// Radius of the users' region about O, metres.
    pub reach: f64,
    /// Greatest error, radians.
    pub angle: f64,
    /// Near triangles that a ray from the region hit.
    pub seen: Seen,
}

/// Set of triangles by number, filled by several threads.
pub struct Seen(Vec<AtomicU64>);

impl Seen {
    /// Creates an empty set of the triangles of a scene.
    pub fn new(scene: &Scene) -> Result<Self> {
        let words = (scene.triangle_count() as usize).div_ceil(64);
        let mut bits = try_with_capacity(words)?;
        bits.resize_with(words, AtomicU64::default);
        Ok(Self(bits))
    }

    /// Returns the numbers in ascending order.
    pub fn numbers(&self) -> impl Iterator<Item = i64> {
        let is_set = |n: &usize| self.0[n / 64].load(Ordering::Relaxed) >> (n % 64) & 1 == 1;
        (0..64 * self.0.len()).filter(is_set).map(|n| n as i64)
    }

    fn insert(&self, number: i64) {
        let (word, bit) = (&self.0[number as usize / 64], 1 << (number % 64));
        if word.load(Ordering::Relaxed) & bit == 0 {
            word.fetch_or(bit, Ordering::Relaxed);
        }
    }
}

impl World<'_> {
    /// Traces rays in order; only far triangles count if `far_only`.
    pub fn trace(&self, rays: &[Ray], far_only: bool, hits: &mut [Hit]) {
        if far_only {
            closest_hits(self.scene, rays, &AlphaFilter::new(self.scene, FarOnly(self.partition)), hits);
        } else {
            closest_hits(self.scene, rays, &AlphaFilter::new(self.scene, All), hits);
        }
    }

    /// Returns whether a hit is on a triangle that is far as a whole.
    pub fn is_far(&self, hit: &Hit) -> bool {
        !hit.is_miss() && self.partition.zone(hit.instance, hit.face) == Zone::Far
    }

    /// Returns whether a hit of a ray from the region is far, and notes the triangle as seen if it is near.
    pub fn note(&self, hit: &Hit) -> bool {
        let is_far = self.is_far(hit);
        if !is_far && !hit.is_miss() {
            self.seen.insert(self.scene.triangle_offset(hit.instance) + i64::from(hit.face));
        }
        is_far
    }

    /// Returns the bound of a layer baked from a centre.
    pub fn bound(&self, center: DVec3) -> Bound {
        Bound::new(center, self.eye, self.reach, self.angle)
    }
}

/// Far surface in the centre of a texel, or the nearest other surface.
#[derive(Clone, Copy, Debug)]
pub struct Texel {
    /// The far surface, or a miss.
    pub hit: Hit,
    /// Plane of the surface.
    pub plane: Plane,
    /// Inverse depth of the far surface, or of a near one where no far surface follows it; 0 for the sky.
    pub w: f64,
    /// Least and greatest inverse depth at which the texel may be shown.
    pub least: f64,
    /// See `least`.
    pub greatest: f64,
    kept: bool,
}

impl Texel {
    const SKY: Self = Self { hit: Hit::MISS, plane: Plane([0.0; 3]), w: 0.0, least: 0.0, greatest: 0.0, kept: false };

    /// Returns whether the layer has to show this texel.
    #[inline]
    pub fn is_wanted(&self) -> bool {
        self.kept
    }
}

/// Place of a tile on the faces of a cube.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// Face.
    pub face: u8,
    /// First column.
    pub left: usize,
    /// First row.
    pub top: usize,
}

/// A tile with its apron.
pub struct Tile {
    /// Place on the faces.
    pub place: Place,
    /// Width of a face, texels.
    pub size: usize,
    texels: Vec<Texel>,
}

impl Tile {
    /// Creates a tile that shows nothing.
    pub fn blank(place: Place, size: usize) -> Self {
        Self { place, size, texels: vec![Texel::SKY; WIDE * WIDE] }
    }

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
    fn set(&mut self, world: &World<'_>, bound: &Bound, center: DVec3, slot: usize, ray: &Ray, hit: Hit) {
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

    fn position(&self, slot: usize) -> (f64, f64) {
        let (column, row) = ((slot % WIDE) as f64 - 1.0, (slot / WIDE) as f64 - 1.0);
        (self.edge_u(column + 0.5), self.edge_v(row + 0.5))
    }

    /// Returns the ray from the centre through a position in the tile, in texels from its left and upper edge.
    pub fn ray(&self, center: DVec3, x: f64, y: f64) -> Ray {
        let direction = direction_from_face(self.place.face, self.edge_u(x), self.edge_v(y)).normalize();
        Ray { origin: center.as_vec3(), direction: direction.as_vec3(), t_min: 0.0, t_max: f32::INFINITY }
    }

    /// Returns a texel of the tile; its apron has column and row −1 and `SIDE`.
    #[inline]
    pub fn texel(&self, column: isize, row: isize) -> &Texel {
        &self.texels[(row + 1) as usize * WIDE + (column + 1) as usize]
    }

    /// Returns a texel of the tile.
    #[inline]
    pub fn texel_inside(&self, column: usize, row: usize) -> &Texel {
        &self.texels[(row + APRON) * WIDE + column + APRON]
    }

    /// Returns the position on the face of a column's centre.
    #[inline]
    pub fn u(&self, column: usize) -> f64 {
        self.edge_u(column as f64 + 0.5)
    }

    /// Returns the position on the face of a row's centre.
    #[inline]
    pub fn v(&self, row: usize) -> f64 {
        self.edge_v(row as f64 + 0.5)
    }

    /// Returns the position on the face of a distance in texels from the tile's left edge.
    #[inline]
    pub fn edge_u(&self, x: f64) -> f64 {
        (self.place.left as f64 + x) * 2.0 / self.size as f64 - 1.0
    }

    /// Returns the position on the face of a distance in texels from the tile's upper edge.
    #[inline]
    pub fn edge_v(&self, y: f64) -> f64 {
        (self.place.top as f64 + y) * 2.0 / self.size as f64 - 1.0
    }
}
