//! Cut-out materials: rays pass through their holes.

use super::ray::{Hit, HitFilter, Ray};
use crate::scene::Scene;

/// Rejects hits in the holes of cut-out materials; `inner` decides about the others.
pub struct AlphaFilter<'a, F> {
    /// The scene whose materials are looked up.
    pub scene: &'a Scene,
    /// The filter for hits outside holes.
    pub inner: F,
}

impl<F: HitFilter> HitFilter for AlphaFilter<'_, F> {
    #[inline(always)]
    fn shows(&self, instance: u32, face: u32) -> bool {
        self.inner.shows(instance, face)
    }

    #[inline]
    fn accepts(&self, ray: &Ray, candidate: &Hit) -> bool {
        let mesh = &self.scene.instance(candidate.instance).mesh;
        self.scene.is_solid(mesh, candidate.face, (candidate.u, candidate.v)) && self.inner.accepts(ray, candidate)
    }
}
