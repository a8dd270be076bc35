//! The zone between m₁ and m₂: an eye's rays are bent, so that each surface point appears at its displaced position.
//!
//! Up to m₁ a ray is straight. Beyond, let d be the depth at which a surface at depth z is displayed. The bent ray's
//! point at z lies on the line from the third camera through the unbent ray's point at d. Straight legs join such
//! points. The ray ends at m₂, on the third camera's ray through the same image position.

use glam::{DVec3, Vec3};

use super::error::{Axis, tangents};
use super::head::{Axes, Head};
use super::rig::{Rig, Side};
use crate::base::{Aabb, Progress, Result};
use crate::camera::Footprint;
use crate::render::frame::{Channels, Frame, Sample};
use crate::render::tiles::{PIXELS, Picture, RayPixels, RenderView, draw};
use crate::render::truth::Truth;
use crate::scene::Scene;
use crate::trace::{AcceptAll, AlphaFilter, Hit, Ray, closest_hits, touches};

/// Relative lengthening of each leg, so that rounding leaves no gap to the next one.
const OVERLAP: f32 = 1e-5;
/// Maximum distance in pixels of a bent ray from its legs.
pub(super) const TOLERANCE: f64 = 0.02;
/// Maximum number of legs.
const MAX_LEGS: usize = 64;
/// Number of legs skipped together if nothing lies near them.
const SPAN: usize = 8;

impl Rig {
    /// Renders an eye's view up to m₂ and the depth `head.far`. The view's limits must end at m₁; they apply to the
    /// straight part of each ray.
    pub fn render_zone(
        &self,
        side: Side,
        scene: &Scene,
        view: &RenderView<'_>,
        head: &Head,
        progress: &Progress,
    ) -> Result<Frame> {
        scene.build_to_shade(progress)?;
        let (axes, depths) = (Axes::new(self, scene.origin, head), self.leg_depths(head.far)?);
        let pixels = self.pixels_per_tangent(side).min_element();
        let max_tangent = self.max_error(self.planes.end, Axis::Both)? / pixels;
        let truth = Truth { scene, filter: &AlphaFilter::new(scene, AcceptAll) };
        draw(view, &Zone { rig: self, side, axes, depths, max_tangent, truth }, progress)
    }

    /// Returns the depths of the corners of bent rays, from m₁ to m₂ or the maximum depth, evenly spaced in 1/z.
    ///
    /// In the picture, a bent ray is a parabola whose distance from the straight ray grows to D pixels at m₂. With n
    /// legs, its distance from the legs is at most D/(4 n²) pixels.
    pub(super) fn leg_depths(&self, far: f64) -> Result<Vec<f64>> {
        let planes = self.planes;
        let end = planes.end.min(far);
        if end <= planes.begin {
            return Ok(vec![planes.begin]);
        }
        let displacement = self.max_error(planes.end, Axis::Both)?;
        let legs = ((0.25 * displacement / TOLERANCE).sqrt().ceil() as usize).clamp(1, MAX_LEGS);
        let (first, last) = (planes.begin.recip(), end.recip());
        let mut depths: Vec<f64> =
            (0..=legs).map(|k| (first + (last - first) * (k as f64 / legs as f64)).recip()).collect();
        (depths[0], depths[legs]) = (planes.begin, end);
        Ok(depths)
    }

    /// Returns the point at depth z that an eye sees in a direction. Direction and point are in head axes; the point
    /// is relative to the middle of the eyes.
    pub(super) fn point_shown(&self, side: Side, direction: DVec3, z: f64) -> DVec3 {
        let (p, d) = (self.eye(side).position, self.depth_shown(z));
        self.place_shown(p + (tangents(direction) * (d + p.z)).extend(-d - p.z), z)
    }
}

/// Scene before m₂ as displaced for an eye.
struct Zone<'a> {
    rig: &'a Rig,
    side: Side,
    axes: Axes,
    /// Depths of the corners of bent rays; the first is m₁.
    depths: Vec<f64>,
    /// Maximum displacement of points, as a tangent.
    max_tangent: f64,
    truth: Truth<'a>,
}

impl Zone<'_> {
    /// Returns the k-th corner of a ray, relative to the scene's origin.
    fn corner(&self, ray: &Ray, k: usize) -> Vec3 {
        let direction = self.axes.to_head(ray.direction.as_dvec3());
        self.axes.to_scene(self.rig.middle + self.rig.point_shown(self.side, direction, self.depths[k])).as_vec3()
    }

    /// Returns whether anything may lie near the legs of some rays between two corners, where legs deviate by no more
    /// than the zone's maximum displacement.
    fn may_hit(&self, misses: &[usize], rays: &[Ray], from: usize, to: usize) -> bool {
        let mut region = Aabb::EMPTY;
        for &n in misses {
            region.extend(self.corner(&rays[n], from));
            region.extend(self.corner(&rays[n], to));
        }
        let displacement = Vec3::splat((self.max_tangent * self.depths[to]) as f32);
        region.extend(region.min - displacement);
        region.extend(region.max + displacement);
        touches(self.truth.scene, &region)
    }

    /// Traces rays along their next leg, from `starts` to `ends`.
    fn trace_leg(
        &self,
        numbers: &[usize],
        starts: &[Vec3; PIXELS],
        ends: &[Vec3; PIXELS],
        rays: &mut [Ray],
        hits: &mut [Hit],
    ) {
        let mut legs = [Ray { origin: Vec3::ZERO, direction: Vec3::Z, t_min: 0.0, t_max: 1.0 + OVERLAP }; PIXELS];
        let mut leg_hits = [Hit::MISS; PIXELS];
        for (leg, &n) in legs.iter_mut().zip(numbers) {
            (leg.origin, leg.direction) = (starts[n], ends[n] - starts[n]);
        }
        let count = numbers.len();
        closest_hits(self.truth.scene, &legs[..count], self.truth.filter, &mut leg_hits[..count]);
        for (&n, (leg, hit)) in numbers.iter().zip(legs.iter().zip(leg_hits)).filter(|(_, (_, hit))| !hit.is_miss()) {
            let point = leg.origin + leg.direction * hit.t;
            hits[n] = Hit { t: (point - rays[n].origin).length(), ..hit };
            rays[n].direction = leg.direction.normalize();
        }
    }
}

impl Picture for Zone<'_> {
    fn trace(&self, rays: &mut [Ray], hits: &mut [Hit], pixels: &RayPixels<'_>) {
        rays.iter_mut().for_each(|ray| ray.t_max *= 1.0 + OVERLAP);
        self.truth.trace(rays, hits, pixels);
        let is_open = |n: &usize| hits[*n].is_miss() && rays[*n].t_min <= rays[*n].t_max;
        let mut misses: Vec<usize> = (0..rays.len()).filter(is_open).collect();
        let (mut starts, mut ends) = ([Vec3::ZERO; PIXELS], [Vec3::ZERO; PIXELS]);
        let legs = self.depths.len() - 1;
        let mut next = 0;
        // Number of the corner at which the rays' `ends` lie.
        let mut end_corner = usize::MAX;
        while next < legs && !misses.is_empty() {
            let k = next;
            let span_end = (k + SPAN).min(legs);
            if k.is_multiple_of(SPAN) && span_end > k + 1 && !self.may_hit(&misses, rays, k, span_end) {
                next = span_end;
                continue;
            }
            next += 1;
            let mut region = Aabb::EMPTY;
            for &n in &misses {
                starts[n] = if end_corner == k { ends[n] } else { self.corner(&rays[n], k) };
                ends[n] = self.corner(&rays[n], k + 1);
                region.extend(starts[n]);
                region.extend(ends[n]);
            }
            end_corner = k + 1;
            if touches(self.truth.scene, &region) {
                self.trace_leg(&misses, &starts, &ends, rays, hits);
                misses.retain(|&n| hits[n].is_miss());
            }
        }
    }

    fn add_colors(&self, rays: &[Ray], hits: &[Hit], footprint: impl Fn(usize) -> Footprint, sums: &mut [[f32; 3]]) {
        self.truth.add_colors(rays, hits, footprint, sums);
    }

    fn sample(&self, ray: &Ray, hit: &Hit, footprint: impl FnOnce() -> Footprint, channels: Channels) -> Sample {
        self.truth.sample(ray, hit, footprint, channels)
    }
}
