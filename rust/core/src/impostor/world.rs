//! The static part of a scene as users of the region see it.

use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;

use super::plane::Bound;
use crate::base::Result;
use crate::base::memory::try_with_capacity;
use crate::partition::{Partition, Zone};
use crate::scene::Scene;
use crate::trace::{AcceptAll, AlphaFilter, FaceHits, Hit, HitFilter, Ray, closest_hits};

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
    /// Triangles that users of the region see.
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
        (0..64 * self.0.len() as i64).filter(|&n| self.contains(n))
    }

    fn contains(&self, number: i64) -> bool {
        self.0[number as usize / 64].load(Ordering::Relaxed) >> (number % 64) & 1 == 1
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
            closest_hits(self.scene, rays, &AlphaFilter::new(self.scene, AcceptAll), hits);
        }
    }

    /// Returns whether a hit is on a triangle that is far as a whole.
    pub fn is_far(&self, hit: &Hit) -> bool {
        !hit.is_miss() && self.partition.zone(hit.instance, hit.face) == Zone::Far
    }

    /// Notes the triangle that a ray from the region hits as seen, and returns whether it is far.
    pub fn note(&self, hit: &Hit) -> bool {
        if !hit.is_miss() {
            self.insert(hit.instance, hit.face);
        }
        self.is_far(hit)
    }

    /// Notes a triangle as seen.
    pub fn insert(&self, instance: u32, face: u32) {
        self.seen.insert(self.scene.triangle_offset(instance) + i64::from(face));
    }

    /// Returns whether a triangle was noted as seen.
    pub fn is_noted(&self, instance: u32, face: u32) -> bool {
        self.seen.contains(self.scene.triangle_offset(instance) + i64::from(face))
    }

    /// Returns the bound of a layer baked from a centre.
    pub fn bound(&self, center: DVec3) -> Bound {
        Bound::new(center, self.eye, self.reach, self.angle)
    }
}
