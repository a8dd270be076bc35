//! Cut-out materials: rays pass through their holes.

use super::ray::{Hit, HitFilter, Ray};
use crate::scene::Scene;

/// Leaves out the holes of cut-out materials; what is solid is up to `inner`.
pub struct AlphaFilter<'a, F> {
    /// Whose materials are looked up.
    pub scene: &'a Scene,
    /// The filter for the rest.
    pub inner: F,
}

impl<F: HitFilter> HitFilter for AlphaFilter<'_, F> {
    #[inline]
    fn accepts(&self, ray: &Ray, candidate: &Hit) -> bool {
        let mesh = &self.scene.instance(candidate.instance).mesh;
        self.scene.is_solid(mesh, candidate.face, (candidate.u, candidate.v)) && self.inner.accepts(ray, candidate)
    }
}
