//! Background behind near geometry: the environment map, for the ideal picture the hits of rays from the centre, or the
//! sky if there is no far part.

use glam::{DVec3, Vec3};

use super::super::frame::{Channels, Sample};
use super::super::limits::{Limits, Segment};
use super::super::shade::background;
use super::super::surface::Surface;
use super::super::tiles::PIXELS;
use crate::camera::Footprint;
use crate::cubemap::EnvironmentMap;
use crate::morph::Morph;
use crate::scene::Scene;
use crate::trace::{AcceptAll, AlphaFilter, Hit, Ray, closest_hits};

/// Relative range by which a fragment may lie behind the map before it counts as hidden. It covers the rounding of half
/// floats, and the difference over half a texel of a map of 512 texels on a surface at 45°.
const BIAS: f32 = 4e-3;

/// Source of the far part.
#[derive(Clone, Copy)]
pub(super) enum Far<'a> {
    /// There is no far part.
    Nothing,
    /// Picture of the far part from the centre.
    Map(&'a EnvironmentMap),
    /// The static scene itself, beyond a radius in metres, along rays from the centre.
    Traced(&'a Scene, f64),
}

#[derive(Clone, Copy)]
pub(super) struct Backdrop<'a> {
    pub far: Far<'a>,
    /// Centre O, relative to the scene's origin.
    pub center: DVec3,
    /// Morph, which gives the displayed distances of far points; without it, these are the distances from O.
    pub morph: Option<Morph>,
    /// Volume in which the map is visible.
    pub visible: VisibleVolume,
}

/// Volume in which surfaces are visible from an eye. Both are relative to the scene's origin.
#[derive(Clone, Copy)]
pub(super) struct VisibleVolume {
    pub limits: Limits,
    pub eye: DVec3,
}

impl VisibleVolume {
    /// Returns the visible segment of the eye's ray in a direction.
    fn clip_direction(&self, direction: Vec3) -> Segment {
        self.limits.clip_ray(self.eye, direction.as_dvec3())
    }
}

impl Backdrop<'_> {
    pub fn color(&self, direction: Vec3, footprint: impl FnOnce() -> Footprint) -> [f32; 3] {
        match self.far {
            Far::Map(map) if self.is_visible(map, direction) => map.color(direction),
            Far::Nothing | Far::Map(_) => background(direction),
            Far::Traced(scene, radius) => {
                let (ray, hit) = self.cast(scene, radius, direction);
                hit_color(scene, &ray, &hit, footprint)
            }
        }
    }

    /// Returns the channels of a ray: those of its hit on near geometry or, for a miss, those of the far part. The map
    /// shows what O sees in the ray's direction; its range gives the point.
    pub fn sample(
        &self,
        near: &Scene,
        ray: &Ray,
        hit: &Hit,
        footprint: impl FnOnce() -> Footprint,
        channels: Channels,
    ) -> Sample {
        if !hit.is_miss() {
            return Surface::of_hit(near, ray, hit).sample(near, hit.t, || footprint().width_at(hit.t), channels);
        }
        let direction = ray.direction;
        match self.far {
            Far::Map(map) if self.is_visible(map, direction) => {
                let (range, object_id) = map.surface(direction);
                let mut sample =
                    Sample { range: self.displayed_distance(direction, range), object_id, ..Sample::default() };
                if range.is_finite() {
                    sample.position = (self.center + direction.as_dvec3() * f64::from(range)).as_vec3().to_array();
                }
                sample
            }
            Far::Nothing | Far::Map(_) => Sample::default(),
            Far::Traced(scene, radius) => {
                let (ray, hit) = self.cast(scene, radius, direction);
                if hit.is_miss() {
                    return Sample::default();
                }
                let (surface, range) = (Surface::of_hit(scene, &ray, &hit), self.displayed_distance(direction, hit.t));
                surface.sample(scene, range, || footprint().width_at(hit.t), channels)
            }
        }
    }

    /// Returns whether the map is visible: the ray's segment is unbounded, and the map's surface is not nearer than its
    /// start. Maps without ranges are infinitely far away.
    fn is_visible(&self, map: &EnvironmentMap, direction: Vec3) -> bool {
        let Segment { t_min, t_max } = self.visible.clip_direction(direction);
        let is_behind = || map.range.is_none() || self.displayed_distance(direction, map.surface(direction).0) >= t_min;
        t_max.is_infinite() && (t_min == 0.0 || is_behind())
    }

    /// Returns the distance from O beyond which the far part hides other points beyond the near part; infinite if the
    /// map has no range or its surface is nearer than the segment's start. Points of the near part need no test,
    /// because they precede all far points along their bent ray.
    pub fn range_limit(&self, direction: Vec3) -> f32 {
        let limit = match self.far {
            Far::Map(map) if map.range.is_some() => map.farthest(direction) * (1.0 + BIAS),
            Far::Traced(scene, radius) => self.cast(scene, radius, direction).1.t,
            _ => f32::INFINITY,
        };
        let t_min = self.visible.clip_direction(direction).t_min;
        if t_min > 0.0 && self.displayed_distance(direction, limit) < t_min { f32::INFINITY } else { limit }
    }

    /// Returns the displayed distance |Q−U| of a point that O sees at `range`.
    pub fn displayed_distance(&self, direction: Vec3, range: f32) -> f32 {
        self.morph.map_or(range, |morph| morph.far_distance(direction.as_dvec3(), f64::from(range)) as f32)
    }

    /// Returns a ray from the centre that starts where it leaves the near part.
    pub fn ray(&self, radius: f64, direction: Vec3) -> Ray {
        let slope = f64::from(direction.x).hypot(f64::from(direction.z));
        Ray { origin: self.center.as_vec3(), direction, t_min: (radius / slope) as f32, t_max: f32::INFINITY }
    }

    /// Traces a tile's rays without a hit into the far part as one packet. Returns the rays from the centre and their
    /// hits beyond the near part; `None` unless the far part is traced.
    pub fn trace_far(&self, rays: &[Ray], hits: &[Hit]) -> Option<([Ray; PIXELS], [Hit; PIXELS])> {
        let Far::Traced(scene, radius) = self.far else { return None };
        let (mut far_rays, mut far_hits) = ([self.ray(radius, Vec3::Y); PIXELS], [Hit::MISS; PIXELS]);
        for (far_ray, (ray, hit)) in far_rays.iter_mut().zip(rays.iter().zip(hits)) {
            *far_ray = self.ray(radius, ray.direction);
            if !hit.is_miss() || !far_ray.t_min.is_finite() {
                (far_ray.t_min, far_ray.t_max) = (1.0, 0.0);
            }
        }
        closest(scene, &far_rays[..rays.len()], &mut far_hits[..rays.len()]);
        Some((far_rays, far_hits))
    }

    fn cast(&self, scene: &Scene, radius: f64, direction: Vec3) -> (Ray, Hit) {
        let ray = self.ray(radius, direction);
        if !ray.t_min.is_finite() {
            return (ray, Hit::MISS);
        }
        let mut hits = [Hit::MISS];
        closest(scene, &[ray], &mut hits);
        (ray, hits[0])
    }
}

/// Returns the linear RGB of a hit, or that of the sky for a miss.
pub(super) fn hit_color(scene: &Scene, ray: &Ray, hit: &Hit, footprint: impl FnOnce() -> Footprint) -> [f32; 3] {
    if hit.is_miss() {
        return background(ray.direction);
    }
    Surface::of_hit(scene, ray, hit).color(scene, footprint().width_at(hit.t))
}

/// Finds the closest opaque points along rays.
pub(super) fn closest(scene: &Scene, rays: &[Ray], hits: &mut [Hit]) {
    closest_hits(scene, rays, &AlphaFilter::new(scene, AcceptAll), hits);
}
