//! Moving objects: geometry at every distance, possibly hidden by the far part.

use std::sync::Arc;

use glam::Vec3;

use super::super::limits::Segment;
use super::super::tiles::PIXELS;
use super::backdrop::Backdrop;
use crate::scene::Scene;
use crate::trace::{All, AlphaFilter, Hit, HitFilter, Ray, closest_hits};

/// A ray that hits nothing.
const NOWHERE: Ray = Ray { origin: Vec3::ZERO, direction: Vec3::NEG_Z, t_min: 0.0, t_max: -1.0 };

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
        match self {
            Self::Center => "center",
            Self::User => "user",
            Self::Omit => "omit",
        }
    }
}

/// Moving objects of a scene in one pose, with the number of the first in the whole scene.
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

    /// Finds, for rays that are misses, moving objects beyond the near part that no far surface hides. They are shown
    /// in the direction in which the centre sees them (w = 0), so they are traced along the ray from the centre.
    /// `seen` gives the visible segment of the n-th ray.
    pub fn trace_beyond(
        &self,
        backdrop: &Backdrop<'_>,
        radius: f64,
        seen: impl Fn(usize) -> Segment,
        rays: &[Ray],
        hits: &mut [Hit],
    ) {
        let (mut others, mut found) = ([NOWHERE; PIXELS], [Hit::MISS; PIXELS]);
        let (others, found) = (&mut others[..rays.len()], &mut found[..rays.len()]);
        for (n, ((other, ray), hit)) in others.iter_mut().zip(rays).zip(hits.iter()).enumerate() {
            let from_center = backdrop.ray(radius, ray.direction);
            if hit.is_miss() && from_center.t_min.is_finite() {
                // Without a morph the displayed distance is the distance from the centre. With bent rays the segment
                // is the whole ray.
                let Segment { t_min, t_max } = seen(n);
                *other = Ray { t_min: from_center.t_min.max(t_min), t_max, ..from_center };
            }
        }
        closest_hits(&self.scene, others, &AlphaFilter::new(&self.scene, Before { backdrop }), found);
        for ((hit, found), ray) in hits.iter_mut().zip(found).zip(rays) {
            if !found.is_miss() {
                let instance = self.first + found.instance;
                *hit = Hit { t: backdrop.displayed(ray.direction, found.t), instance, ..*found };
            }
        }
    }

    /// Finds, for rays that are misses, moving objects in front of the far part.
    pub fn trace_before(&self, seen: impl Fn(usize) -> Segment, rays: &[Ray], hits: &mut [Hit]) {
        let (mut others, mut found) = ([NOWHERE; PIXELS], [Hit::MISS; PIXELS]);
        let (others, found) = (&mut others[..rays.len()], &mut found[..rays.len()]);
        for (n, ((other, ray), hit)) in others.iter_mut().zip(rays).zip(hits.iter()).enumerate() {
            if hit.is_miss() {
                let Segment { t_min, t_max } = seen(n);
                *other = Ray { t_min, t_max, ..*ray };
            }
        }
        closest_hits(&self.scene, others, &AlphaFilter::new(&self.scene, All), found);
        for (hit, found) in hits.iter_mut().zip(found).filter(|(_, found)| !found.is_miss()) {
            *hit = Hit { instance: self.first + found.instance, ..*found };
        }
    }
}

/// Filter for geometry in front of the far part, on a ray from the centre.
struct Before<'a> {
    backdrop: &'a Backdrop<'a>,
}

impl HitFilter for Before<'_> {
    fn accepts(&self, ray: &Ray, candidate: &Hit) -> bool {
        candidate.t <= self.backdrop.range_limit(ray.direction)
    }
}
