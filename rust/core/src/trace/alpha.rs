//! Cut-out materials: rays pass through their holes.

use super::ray::{FaceHits, Hit, HitFilter, Ray};
use crate::scene::Scene;

/// Rejects hits in the holes of cut-out materials; `inner` decides about all other hits.
pub struct AlphaFilter<'a, F> {
    /// Scene whose materials are looked up; `None` if no material has holes.
    cutouts: Option<&'a Scene>,
    inner: F,
}

impl<'a, F: HitFilter> AlphaFilter<'a, F> {
    /// Creates a filter for hits on a scene.
    pub fn new(scene: &'a Scene, inner: F) -> Self {
        Self { cutouts: scene.has_cutouts().then_some(scene), inner }
    }
}

impl<F: HitFilter> HitFilter for AlphaFilter<'_, F> {
    fn face_hits(&self, instance: u32, face: u32) -> FaceHits {
        let hits = self.inner.face_hits(instance, face);
        match self.cutouts {
            Some(scene) if hits == FaceHits::All && scene.may_have_hole(&scene.instance(instance).mesh, face) => {
                FaceHits::Accepted
            }
            _ => hits,
        }
    }

    fn accepts(&self, ray: &Ray, candidate: &Hit) -> bool {
        let is_solid = self.cutouts.is_none_or(|scene| {
            scene.is_solid(&scene.instance(candidate.instance).mesh, candidate.face, (candidate.u, candidate.v))
        });
        is_solid && self.inner.accepts(ray, candidate)
    }
}
