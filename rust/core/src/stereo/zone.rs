//! The zone between m₁ and m₂: an eye's rays are bent, so that each surface point appears at its displaced position.
//!
//! Up to m₁ a ray is straight. Beyond, its point at depth z lies on the line from the third camera through the ray's
//! own point at the depth d at which z is shown. These points are joined by straight legs. The ray ends at m₂, on the
//! third camera's ray through the same image position.

use glam::{DVec3, Vec3};

use super::error::{Axis, tangents};
use super::head::{Axes, Head};
use super::rig::{Rig, Side};
use crate::base::{Aabb, Progress, Result};
use crate::camera::Footprint;
use crate::render::frame::{Channels, Frame, Sample};
use crate::render::tiles::{PIXELS, Picture, RenderView, Spots, draw};
use crate::render::truth::Truth;
use crate::scene::Scene;
use crate::trace::{All, AlphaFilter, Hit, Ray, closest_hits, touches};

/// Relative lengthening of each leg, so that rounding leaves no gap to the next one.
const OVERLAP: f32 = 1e-5;
/// Maximum distance in pixels of a bent ray from its legs.
const TOLERANCE: f64 = 0.02;
/// Maximum number of legs.
const MAX_LEGS: usize = 64;
/// Number of legs skipped together if nothing lies near them.
const SPAN: usize = 8;

impl Rig {
    /// Renders an eye's view before m₂. The view's limits exclude everything before m₁; `head` gives the end of its
    /// depths.
    pub fn render_zone(
        &self,
        side: Side,
        scene: &Scene,
        view: &RenderView<'_>,
        head: &Head,
        progress: &Progress,
    ) -> Result<Frame> {
        scene.build(progress)?;
        let (axes, depths) = (Axes::new(self, scene, head), self.leg_depths(head.far)?);
        let pixels = self.pixels_per_tangent(side).min_element();
        let aside = self.max_error(self.planes().end, Axis::Both)? / pixels;
        let truth = Truth { scene, filter: &AlphaFilter::new(scene, All) };
        draw(view, &Zone { rig: self, side, axes, depths, aside, truth }, progress)
    }

    /// Returns the depths of the corners of bent rays, from m₁ to m₂ or the maximum depth, evenly spaced in 1/z.
    ///
    /// In the picture, a bent ray is a parabola with a maximum distance of D pixels from the straight ray, at m₂: n
    /// legs reduce it to D/(4 n²) pixels.
    fn leg_depths(&self, far: f64) -> Result<Vec<f64>> {
        let planes = self.planes();
        let end = planes.end.min(far);
        if end <= planes.begin {
            return Ok(vec![planes.begin]);
        }
        let moved = self.max_error(planes.end, Axis::Both)?;
        let legs = ((0.25 * moved / TOLERANCE).sqrt().ceil() as usize).clamp(1, MAX_LEGS);
        let (first, last) = (planes.begin.recip(), end.recip());
        Ok((0..=legs)
            .map(|k| match k {
                0 => planes.begin,
                k if k == legs => end,
                k => (first + (last - first) * (k as f64 / legs as f64)).recip(),
            })
            .collect())
    }

    /// Returns the point at depth z that an eye is shown in a direction; both in head axes, the point relative to the
    /// middle.
    fn point_shown(&self, side: Side, direction: DVec3, z: f64) -> DVec3 {
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
    aside: f64,
    truth: Truth<'a>,
}

impl Zone<'_> {
    /// Returns the k-th corner of a ray, relative to the scene's origin.
    fn corner(&self, ray: &Ray, k: usize) -> Vec3 {
        let direction = self.axes.to_head(ray.direction.as_dvec3());
        self.axes.place_from_middle(self.rig.point_shown(self.side, direction, self.depths[k])).as_vec3()
    }

    /// Returns whether anything may lie near several legs of some rays, from one corner to another. Between these,
    /// legs deviate by no more than the zone's maximum displacement.
    fn reaches(&self, open: &[usize], rays: &[Ray], from: usize, to: usize) -> bool {
        let mut region = Aabb::EMPTY;
        for &n in open {
            region.extend(self.corner(&rays[n], from));
            region.extend(self.corner(&rays[n], to));
        }
        let aside = Vec3::splat((self.aside * self.depths[to]) as f32);
        region.extend(region.min - aside);
        region.extend(region.max + aside);
        touches(self.truth.scene, &region)
    }

    /// Traces the rays without a hit along their next leg; returns how many still have none.
    fn follow(&self, open: &mut [usize], ends: &[Vec3; PIXELS], starts: &[Vec3; PIXELS], pixels: Tile<'_>) -> usize {
        let Tile { rays, hits } = pixels;
        let mut legs = [Ray { origin: Vec3::ZERO, direction: Vec3::Z, t_min: 0.0, t_max: 1.0 + OVERLAP }; PIXELS];
        let mut found = [Hit::MISS; PIXELS];
        for (leg, &n) in legs.iter_mut().zip(&*open) {
            (leg.origin, leg.direction) = (starts[n], ends[n] - starts[n]);
        }
        closest_hits(self.truth.scene, &legs[..open.len()], self.truth.filter, &mut found[..open.len()]);
        let mut left = 0;
        for i in 0..open.len() {
            let n = open[i];
            if found[i].is_miss() {
                open[left] = n;
                left += 1;
                continue;
            }
            let point = legs[i].origin + legs[i].direction * found[i].t;
            hits[n] = Hit { t: (point - rays[n].origin).length(), ..found[i] };
            rays[n].direction = legs[i].direction.normalize();
        }
        left
    }
}

/// Rays of a tile and their hits.
struct Tile<'a> {
    rays: &'a mut [Ray],
    hits: &'a mut [Hit],
}

impl Picture for Zone<'_> {
    fn trace(&self, rays: &mut [Ray], hits: &mut [Hit], spots: &Spots<'_>) {
        rays.iter_mut().for_each(|ray| ray.t_max *= 1.0 + OVERLAP);
        self.truth.trace(rays, hits, spots);
        let mut open: [usize; PIXELS] = std::array::from_fn(|n| n);
        let mut count = 0;
        for n in 0..rays.len() {
            if hits[n].is_miss() && rays[n].t_min <= rays[n].t_max {
                open[count] = n;
                count += 1;
            }
        }
        let (mut starts, mut ends) = ([Vec3::ZERO; PIXELS], [Vec3::ZERO; PIXELS]);
        let legs = self.depths.len() - 1;
        let mut next = 0;
        // Corner at which `ends` were computed.
        let mut known = usize::MAX;
        while next < legs && count > 0 {
            let k = next;
            let span = (k + SPAN).min(legs);
            if k.is_multiple_of(SPAN) && span > k + 1 && !self.reaches(&open[..count], rays, k, span) {
                next = span;
                continue;
            }
            next += 1;
            let mut region = Aabb::EMPTY;
            for &n in &open[..count] {
                starts[n] = if known == k { ends[n] } else { self.corner(&rays[n], k) };
                ends[n] = self.corner(&rays[n], k + 1);
                region.extend(starts[n]);
                region.extend(ends[n]);
            }
            known = k + 1;
            if touches(self.truth.scene, &region) {
                count = self.follow(&mut open[..count], &ends, &starts, Tile { rays, hits });
            }
        }
    }

    fn add_colors(&self, rays: &[Ray], hits: &[Hit], footprint: impl Fn(usize) -> Footprint, sums: &mut [[f32; 3]]) {
        self.truth.add_colors(rays, hits, footprint, sums);
    }

    fn sample(&self, ray: &Ray, hit: &Hit, footprint: impl FnOnce() -> Footprint, wanted: Channels) -> Sample {
        self.truth.sample(ray, hit, footprint, wanted)
    }
}

#[cfg(test)]
mod tests {
    use glam::{DQuat, DVec2};

    use super::super::rig::{Eye, Planes};
    use super::*;
    use crate::camera::Fov;

    fn zoned(planes: Planes, degrees: f64) -> Rig {
        let fov = Fov { left: -1.39, right: 1.25, down: -1.46, up: 1.47 };
        let mirrored = Fov { left: -1.25, right: 1.39, ..fov };
        let eye = |fov, x: f64| Eye {
            fov,
            position: DVec3::new(x, 0.01, -0.02),
            orientation: DQuat::from_rotation_y(-x.signum() * degrees.to_radians()),
        };
        Rig::new([eye(fov, -0.031), eye(mirrored, 0.033)], planes, (1344, 1512)).unwrap()
    }

    /// Points on the legs, also between their ends, are shown at the ray's position, and the last ones where the third
    /// camera's picture continues.
    #[test]
    fn legs_stay_close_to_the_bent_ray() {
        for (begin, end, degrees) in [(0.5, 0.6, 0.0), (3.0, 12.0, 5.0), (1.0, 100.0, 0.0), (8.0, 9.0, 10.0)] {
            let rig = zoned(Planes { begin, end }, degrees);
            let depths = rig.leg_depths(f64::INFINITY).unwrap();
            assert_eq!((depths[0], *depths.last().unwrap()), (begin, end));
            let mut greatest: f64 = 0.0;
            for n in 0..169 {
                let share = DVec2::new(f64::from(n % 13) / 12.0, f64::from(n / 13) / 12.0);
                let fov = rig.eye(Side::Left).fov;
                let at =
                    DVec2::new(fov.left + (fov.right - fov.left) * share.x, fov.down + (fov.up - fov.down) * share.y);
                let way = rig.eye(Side::Left).orientation * at.extend(-1.0);
                for leg in depths.windows(2) {
                    let [from, to] = [leg[0], leg[1]].map(|depth| rig.point_shown(Side::Left, way, depth));
                    for t in [0.0, 0.3, 0.5, 0.8, 1.0] {
                        let point = from.lerp(to, t);
                        let shown = rig.place_shown(point, rig.depth_shown(-point.z)) - rig.eye(Side::Left).position;
                        let back = rig.eye(Side::Left).orientation.inverse() * shown;
                        let missed = (tangents(back) - at) * rig.pixels_per_tangent(Side::Left);
                        greatest = greatest.max(missed.length());
                    }
                }
            }
            assert!(greatest < TOLERANCE, "{begin} {end}: {greatest}");
        }
    }

    #[test]
    fn nothing_is_drawn_beyond_the_end() {
        let rig = zoned(Planes { begin: 3.0, end: 12.0 }, 0.0);
        assert_eq!(rig.leg_depths(2.0).unwrap(), [3.0]);
        assert_eq!(*rig.leg_depths(5.0).unwrap().last().unwrap(), 5.0);
        assert!(rig.leg_depths(5.0).unwrap().len() > 2);
    }
}
