//! Morphed near geometry in front of the map. A fragment is drawn if its unmorphed point lies within r₂, even if its
//! triangle extends beyond. Behind these, a moving fragment beyond r₂ is drawn if no far surface hides it.

use super::super::frame::{Channels, Sample};
use super::super::surface::add_colors;
use super::super::tiles::{PIXELS, Picture, RayPixels};
use super::backdrop::Backdrop;
use super::near_geometry::Morphed;
use crate::camera::Footprint;
use crate::scene::Scene;
use crate::trace::{Hit, HitFilter, Ray, closest_hits};

pub(super) struct Bent<'a> {
    pub scene: &'a Scene,
    pub near: Morphed,
    pub backdrop: Backdrop<'a>,
    pub radius: f64,
}

/// Filter for fragments within r₂ or, if `draws_beyond`, for moving ones beyond it.
struct FragmentFilter<'a> {
    bent: &'a Bent<'a>,
    static_count: u32,
    cutouts: bool,
    draws_beyond: bool,
}

impl HitFilter for FragmentFilter<'_> {
    fn accepts(&self, ray: &Ray, candidate: &Hit) -> bool {
        let Bent { scene, near, backdrop, radius } = self.bent;
        let piece = near.piece(candidate.instance, candidate.face);
        if self.draws_beyond && (piece.is_within || piece.instance < self.static_count) {
            return false;
        }
        if piece.is_within && !self.cutouts {
            return true;
        }
        let (u, v) = piece.face_weights(candidate.u, candidate.v);
        if !piece.is_within {
            let [a, b, c] = scene.instance(piece.instance).corners(piece.face).map(|corner| corner.as_dvec3());
            let point = a + (b - a) * f64::from(u) + (c - a) * f64::from(v);
            let from_axis = point - backdrop.center;
            let is_beyond = from_axis.x.hypot(from_axis.z) > *radius;
            let far_distance = || backdrop.displayed_distance(ray.direction, backdrop.range_limit(ray.direction));
            if is_beyond != self.draws_beyond || is_beyond && candidate.t > far_distance() {
                return false;
            }
        }
        !self.cutouts || scene.is_solid(&scene.instance(piece.instance).mesh, piece.face, (u, v))
    }
}

impl Bent<'_> {
    /// Converts a hit on a piece to a hit on its source face.
    #[inline]
    fn scene_hit(&self, hit: &Hit) -> Hit {
        let piece = self.near.piece(hit.instance, hit.face);
        let (u, v) = piece.face_weights(hit.u, hit.v);
        Hit { instance: piece.instance, face: piece.face, u, v, ..*hit }
    }
}

impl Picture for Bent<'_> {
    fn trace(&self, rays: &mut [Ray], hits: &mut [Hit], _pixels: &RayPixels<'_>) {
        let static_count = self.scene.standing.instances().len() as u32;
        let cutouts = self.scene.has_cutouts();
        let filter = |draws_beyond| FragmentFilter { bent: self, static_count, cutouts, draws_beyond };
        closest_hits(&self.near.scene, rays, &filter(false), hits);
        if self.near.moving_triangles() == 0 || !hits.iter().any(Hit::is_miss) {
            return;
        }
        // Surfaces within r₂ hide all surfaces beyond it, because they come first along the bent ray, even where their
        // displayed distance is greater.
        let (mut far_rays, mut far_hits) = ([rays[0]; PIXELS], [Hit::MISS; PIXELS]);
        for (far_ray, (ray, hit)) in far_rays.iter_mut().zip(rays.iter().zip(hits.iter())) {
            *far_ray = if hit.is_miss() { *ray } else { Ray { t_max: -1.0, ..*ray } };
        }
        closest_hits(&self.near.scene, &far_rays[..rays.len()], &filter(true), &mut far_hits[..rays.len()]);
        for (hit, far_hit) in hits.iter_mut().zip(far_hits).filter(|(hit, _)| hit.is_miss()) {
            *hit = far_hit;
        }
    }

    fn add_colors(&self, rays: &[Ray], hits: &[Hit], footprint: impl Fn(usize) -> Footprint, sums: &mut [[f32; 3]]) {
        let miss_color = |n: usize| self.backdrop.color(rays[n].direction, || footprint(n));
        add_colors(self.scene, rays, hits, &footprint, |hit| self.scene_hit(hit), miss_color, sums);
    }

    fn sample(&self, ray: &Ray, hit: &Hit, footprint: impl FnOnce() -> Footprint, channels: Channels) -> Sample {
        let hit = if hit.is_miss() { *hit } else { self.scene_hit(hit) };
        self.backdrop.sample(self.scene, ray, &hit, footprint, channels)
    }
}
