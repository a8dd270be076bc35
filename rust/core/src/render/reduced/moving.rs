//! Moving objects: geometry at every distance, possibly hidden by the far part.

use std::sync::Arc;

use super::super::limits::Segment;
use super::super::tiles::PIXELS;
use super::backdrop::Backdrop;
use crate::scene::Scene;
use crate::trace::{AcceptAll, AlphaFilter, Hit, HitFilter, Ray, closest_hits};

/// Placement of moving objects beyond the near part by the conventional method.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ConventionalDynamic {
    /// In the direction in which the centre sees them, unless the far part is nearer.
    #[default]
    Center,
    /// In the direction in which the user sees them, in front of the whole far part.
    User,
    /// Not shown.
    Omit,
}

impl ConventionalDynamic {
    /// Returns the public name.
    pub fn name(self) -> &'static str {
        ["center", "user", "omit"][self as usize]
    }
}

/// Moving objects of a scene in one pose, with the number of the first instance in the whole scene.
pub(super) struct Moving {
    scene: Scene,
    first: u32,
}

impl Moving {
    /// Extracts the moving objects; `None` if nothing moves, so that no ray is traced for it.
    pub fn from_scene(scene: &Scene) -> Option<Self> {
        let moves = !scene.moving.instances().is_empty();
        moves.then(|| Self {
            scene: Scene { standing: Arc::default(), ..scene.clone() },
            first: scene.standing.instances().len() as u32,
        })
    }

    pub fn triangles(&self) -> u64 {
        self.scene.triangle_count() as u64
    }

    /// For rays without a hit, finds hits on moving objects beyond the near part that no far surface hides. They appear
    /// in the direction in which the centre sees them (w = 0), so rays from the centre are traced. `segment` returns
    /// the visible segment of the n-th ray.
    pub fn trace_beyond(
        &self,
        backdrop: &Backdrop<'_>,
        radius: f64,
        segment: impl Fn(usize) -> Segment,
        rays: &[Ray],
        hits: &mut [Hit],
    ) {
        let aim = |n: usize, ray: &Ray| {
            let from_center = backdrop.ray(radius, ray.direction);
            // Without a morph the displayed distance is the distance from the centre. With bent rays the segment is
            // the whole ray.
            let Segment { t_min, t_max } = segment(n);
            let is_finite = from_center.t_min.is_finite();
            is_finite.then(|| Ray { t_min: from_center.t_min.max(t_min), t_max, ..from_center })
        };
        let displayed = |ray: &Ray, t: f32| backdrop.displayed_distance(ray.direction, t);
        self.trace_misses(aim, InFrontOfFar { backdrop }, displayed, rays, hits);
    }

    /// For rays without a hit, finds hits on moving objects, in front of the whole far part.
    pub fn trace_in_front(&self, segment: impl Fn(usize) -> Segment, rays: &[Ray], hits: &mut [Hit]) {
        let aim = |n: usize, ray: &Ray| {
            let Segment { t_min, t_max } = segment(n);
            Some(Ray { t_min, t_max, ..*ray })
        };
        self.trace_misses(aim, AcceptAll, |_, t| t, rays, hits);
    }

    /// Traces the rays that `aim` returns for rays without a hit; `displayed` converts the distance of a hit.
    fn trace_misses(
        &self,
        aim: impl Fn(usize, &Ray) -> Option<Ray>,
        filter: impl HitFilter,
        displayed: impl Fn(&Ray, f32) -> f32,
        rays: &[Ray],
        hits: &mut [Hit],
    ) {
        let (mut aimed, mut moving_hits) = ([Ray::EMPTY; PIXELS], [Hit::MISS; PIXELS]);
        let (aimed, moving_hits) = (&mut aimed[..rays.len()], &mut moving_hits[..rays.len()]);
        for (n, ray) in rays.iter().enumerate().filter(|&(n, _)| hits[n].is_miss()) {
            aimed[n] = aim(n, ray).unwrap_or(Ray::EMPTY);
        }
        closest_hits(&self.scene, aimed, &AlphaFilter::new(&self.scene, filter), moving_hits);
        for ((hit, moving), ray) in hits.iter_mut().zip(moving_hits).zip(rays) {
            if !moving.is_miss() {
                *hit = Hit { t: displayed(ray, moving.t), instance: self.first + moving.instance, ..*moving };
            }
        }
    }
}

/// Filter for geometry in front of the far part, on a ray from the centre.
struct InFrontOfFar<'a> {
    backdrop: &'a Backdrop<'a>,
}

impl HitFilter for InFrontOfFar<'_> {
    fn accepts(&self, ray: &Ray, candidate: &Hit) -> bool {
        candidate.t <= self.backdrop.range_limit(ray.direction)
    }
}
