//! Exact morph per pixel: each ray is bent and traced leg by leg through the unchanged scene up to the morph's r₂.
//! Beyond r₂ the centre's ray is traced through the rest of the near part, and past that only to moving objects.

use glam::{DVec3, Vec2, Vec3, Vec3Swizzles};

use super::super::frame::{Channels, Sample};
use super::super::limits::Segment;
use super::super::surface::add_colors;
use super::super::tiles::{PIXELS, Picture, RayPixels};
use super::backdrop::{Backdrop, closest, hit_color};
use super::cell::Cell;
use super::lattice::Lattice;
use super::moving::Moving;
use crate::base::{Aabb, Progress, Result};
use crate::bend::{RayCurve, on_ground, within_cylinder};
use crate::camera::{Camera, Footprint};
use crate::morph::{Kind, Morph};
use crate::scene::Scene;
use crate::trace::{Hit, Ray, touches};

/// Relative lengthening of each leg, so that rounding leaves no gap to the next leg.
const OVERLAP: f32 = 1e-5;

/// Number of legs skipped together if nothing lies near them.
const SPAN: usize = 8;

pub(super) struct Exact<'a> {
    scene: &'a Scene,
    morph: Morph,
    /// Radius at which the near part ends, metres; at least the morph's r₂.
    boundary: f64,
    /// The user's position inside r₁, up to which rays are straight; `None` if they bend from the start.
    inside: Option<Inside>,
    backdrop: Backdrop<'a>,
    pub moving: Option<Moving>,
    lattice: Lattice,
    /// Angular tolerance of bent rays, radians.
    tolerance: f64,
}

impl<'a> Exact<'a> {
    /// Creates the picture. The morph is relative to the scene's origin; `boundary` is the radius, in metres, at which
    /// the near part ends.
    pub fn new(
        scene: &'a Scene,
        camera: &Camera,
        (morph, boundary): (Morph, f64),
        backdrop: Backdrop<'a>,
        tolerance_px: f64,
        progress: &Progress,
    ) -> Result<Self> {
        scene.build_to_shade(progress)?;
        let lattice = Lattice::new(camera, &morph, tolerance_px)?;
        let tolerance = tolerance_px * camera.least_pixel_angle();
        let (inside, moving) = (Inside::new(&morph), Moving::from_scene(scene));
        Ok(Self { scene, morph, boundary, inside, backdrop, moving, lattice, tolerance })
    }

    /// Traces all rays of a tile together: first their straight parts, then the legs of those without a hit. Returns
    /// false if these cannot be bent together.
    fn trace_tile(&self, inside: &Inside, rays: &mut [Ray], hits: &mut [Hit], pixels: &RayPixels<'_>) -> bool {
        let mut ends = [Vec3::ZERO; PIXELS];
        for (ray, end) in rays.iter_mut().zip(&mut ends) {
            let distance = inside.distance_to_r1(ray.direction);
            (ray.t_min, ray.t_max) = (0.0, distance * (1.0 + OVERLAP));
            *end = ray.direction * distance;
        }
        closest(self.scene, rays, hits);
        let misses: Vec<usize> = (0..rays.len()).filter(|&n| hits[n].is_miss()).collect();
        if misses.is_empty() {
            return true;
        }
        let is_near = |bounds: &Aabb| touches(self.scene, bounds);
        self.lattice.for_each_cell(pixels.tile(), is_near, |cell| {
            let (mut positions, mut misses_in_cell) = ([[0.0; 2]; PIXELS], Vec::with_capacity(misses.len()));
            for &n in &misses {
                if let Some(position) = cell.to_part(pixels.position_in_tile(n)) {
                    positions[n] = position;
                    misses_in_cell.push(n);
                }
            }
            self.trace_legs(cell, misses_in_cell, &positions, &mut ends, rays, hits);
        })
    }

    /// Traces the legs of the rays `misses`; `ends` holds the ends of their straight parts.
    fn trace_legs(
        &self,
        cell: &Cell<'_>,
        mut misses: Vec<usize>,
        positions: &[[f32; 2]; PIXELS],
        ends: &mut [Vec3; PIXELS],
        rays: &mut [Ray],
        hits: &mut [Hit],
    ) {
        if misses.is_empty() || !touches(self.scene, &cell.region(0, cell.legs)) {
            return;
        }
        let user = self.morph.user.as_vec3();
        let mut legs = [Ray { origin: user, direction: Vec3::NEG_Z, t_min: 0.0, t_max: 1.0 + OVERLAP }; PIXELS];
        let mut leg_hits = [Hit::MISS; PIXELS];
        // `ends` holds the rays' points at bend `ends_at`; 0 is the end of the straight part.
        let mut ends_at = 0;
        let mut next = 1;
        while next <= cell.legs && !misses.is_empty() {
            let k = next;
            let span = (k - 1) % SPAN == 0 && cell.legs > SPAN;
            if span && !touches(self.scene, &cell.region(k - 1, (k - 1 + SPAN).min(cell.legs))) {
                next += SPAN;
                continue;
            }
            next += 1;
            if !touches(self.scene, &cell.region(k - 1, k)) {
                continue;
            }
            let before = (ends_at < k - 1).then(|| cell.bend(k - 1));
            let after = cell.bend(k);
            for (leg, &n) in legs.iter_mut().zip(&misses) {
                let direction = rays[n].direction;
                let start = before.as_ref().map_or(ends[n], |bend| bend.evaluate(direction, positions[n]));
                ends[n] = after.evaluate(direction, positions[n]);
                leg.origin = user + start;
                leg.direction = ends[n] - start;
            }
            ends_at = k;
            closest(self.scene, &legs[..misses.len()], &mut leg_hits[..misses.len()]);
            for (i, &n) in misses.iter().enumerate() {
                self.accept(&legs[i], &leg_hits[i], &mut rays[n], &mut hits[n]);
            }
            misses.retain(|&n| hits[n].is_miss());
        }
    }

    /// Traces one ray with its individually computed bends.
    fn trace_alone(&self, ray: &mut Ray, hit: &mut Hit) {
        let curve = RayCurve::new(&self.morph, ray.direction.as_dvec3().normalize());
        let points = curve.polyline(self.tolerance);
        let end = curve.end().map(|(s, _)| s);
        // The curve may begin at a user outside r₂, where the morph displays nothing, so legs are clipped to r₂.
        let radius = self.morph.r2 * (1.0 + f64::from(OVERLAP));
        let mut trace = |from: DVec3, to: DVec3, t_max: f32| {
            let inside = within_cylinder(on_ground(from - self.morph.center), on_ground(to - from), radius);
            let Some((enter, leave)) = inside else { return false };
            let (t_min, t_max) = (enter as f32, t_max.min(leave as f32));
            let leg = Ray { origin: from.as_vec3(), direction: (to - from).as_vec3(), t_min, t_max };
            if leg.direction == Vec3::ZERO || t_min > t_max {
                return false;
            }
            let mut leg_hit = [Hit::MISS];
            closest(self.scene, &[leg], &mut leg_hit);
            self.accept(&leg, &leg_hit[0], ray, hit);
            !leg_hit[0].is_miss()
        };
        for leg in points.windows(2) {
            if trace(leg[0], leg[1], 1.0 + OVERLAP) {
                return;
            }
        }
        // Straight curves: rays along the line through user and centre, and vertical rays within r₁.
        let straight = match end {
            Some(s) if curve.ray_distance == 0.0 => Some((s - curve.start()) as f32).filter(|&t_max| t_max > 0.0),
            None if points.len() == 1 => Some(f32::INFINITY),
            _ => None,
        };
        if let Some(t_max) = straight {
            trace(points[0], points[0] + curve.direction, t_max);
        }
    }

    /// Traces the centre's rays, for rays without a hit, from the morph's r₂ to the end of the near part.
    fn trace_outside(&self, rays: &mut [Ray], hits: &mut [Hit]) {
        let (from, to) = (self.morph.r2, self.boundary);
        let (mut legs, mut leg_hits) = ([Ray::EMPTY; PIXELS], [Hit::MISS; PIXELS]);
        for (leg, (ray, _)) in legs.iter_mut().zip(rays.iter().zip(&*hits)).filter(|(_, (_, hit))| hit.is_miss()) {
            let ray =
                Ray { t_max: self.backdrop.ray(to, ray.direction).t_min, ..self.backdrop.ray(from, ray.direction) };
            *leg = Ray { t_min: if from > 0.0 { ray.t_min } else { 0.0 }, t_max: ray.t_max * (1.0 + OVERLAP), ..ray };
        }
        legs[..rays.len()].iter_mut().filter(|leg| !leg.t_min.is_finite()).for_each(|leg| *leg = Ray::EMPTY);
        closest(self.scene, &legs[..rays.len()], &mut leg_hits[..rays.len()]);
        for (n, (ray, hit)) in rays.iter_mut().zip(hits).enumerate() {
            self.accept(&legs[n], &leg_hits[n], ray, hit);
        }
    }

    /// Converts a hit on a leg to a hit on the displayed ray, with the displayed distance and the leg's direction.
    fn accept(&self, leg: &Ray, leg_hit: &Hit, ray: &mut Ray, hit: &mut Hit) {
        if leg_hit.is_miss() {
            return;
        }
        let point = leg.origin + leg.direction * leg_hit.t;
        *hit = Hit { t: self.distance(point), ..*leg_hit };
        ray.direction = leg.direction.normalize();
    }

    /// Returns the displayed distance |Q−U| of a point.
    fn distance(&self, point: Vec3) -> f32 {
        if self.morph.kind == Kind::Cylinder {
            return (self.morph.apply(point.as_dvec3()) - self.morph.user).length() as f32;
        }
        let (from_user, from_center) = (point - self.morph.user.as_vec3(), point - self.backdrop.center.as_vec3());
        let w = self.morph.weight(f64::from(from_center.x.hypot(from_center.z))) as f32;
        w * from_user.length() + (1.0 - w) * from_center.length()
    }
}

impl Picture for Exact<'_> {
    fn trace(&self, rays: &mut [Ray], hits: &mut [Hit], pixels: &RayPixels<'_>) {
        hits.fill(Hit::MISS);
        let are_traced = self.inside.as_ref().is_some_and(|inside| self.trace_tile(inside, rays, hits, pixels));
        if !are_traced && self.morph.r2 > 0.0 {
            let missing = rays.iter_mut().zip(hits.iter_mut()).filter(|(_, hit)| hit.is_miss());
            missing.for_each(|(ray, hit)| self.trace_alone(ray, hit));
        }
        if self.morph.r2 < self.boundary {
            self.trace_outside(rays, hits);
        }
        if let Some(moving) = &self.moving {
            moving.trace_beyond(&self.backdrop, self.boundary, |_| Segment::WHOLE, rays, hits);
        }
    }

    fn add_colors(&self, rays: &[Ray], hits: &[Hit], footprint: impl Fn(usize) -> Footprint, sums: &mut [[f32; 3]]) {
        let far = self.backdrop.trace_far(rays, hits);
        let miss_color = |n: usize| match &far {
            Some((rays, hits)) => hit_color(self.scene, &rays[n], &hits[n], || footprint(n)),
            None => self.backdrop.color(rays[n].direction, || footprint(n)),
        };
        add_colors(self.scene, rays, hits, &footprint, |&hit| hit, miss_color, sums);
    }

    fn sample(&self, ray: &Ray, hit: &Hit, footprint: impl FnOnce() -> Footprint, channels: Channels) -> Sample {
        self.backdrop.sample(self.scene, ray, hit, footprint, channels)
    }
}

/// Position of a user inside r₁, in the ground plane.
struct Inside {
    /// Position relative to the centre.
    user: Vec2,
    /// |user|² − r₁², which is negative.
    power: f32,
}

impl Inside {
    fn new(morph: &Morph) -> Option<Self> {
        let user = on_ground(morph.user - morph.center);
        let power = user.length_squared() - morph.r1 * morph.r1;
        (power < 0.0 && morph.strength == 1.0).then_some(Self { user: user.as_vec2(), power: power as f32 })
    }

    /// Returns the distance along a direction to r₁, infinite for vertical ones. Neither root suffers cancellation.
    #[inline]
    fn distance_to_r1(&self, direction: Vec3) -> f32 {
        let d = direction.xz();
        let (a, b) = (d.length_squared(), self.user.dot(d));
        let root = (b * b - a * self.power).sqrt();
        if b > 0.0 {
            -self.power / (b + root)
        } else if a > 0.0 {
            (root - b) / a
        } else {
            f32::INFINITY
        }
    }
}
