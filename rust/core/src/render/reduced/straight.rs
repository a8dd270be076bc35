//! Near geometry as it is, up to a radius: the conventional method, and every method where the user stands at the
//! centre. The scene's own trees are traced, and nothing is copied.

use glam::{DVec2, DVec3};

use super::super::frame::{Channels, Sample};
use super::super::surface::{Surface, add_colors};
use super::super::tiles::{Picture, Spots};
use super::backdrop::{Backdrop, sample_of};
use super::moving::Moving;
use crate::base::{Progress, Result};
use crate::camera::Footprint;
use crate::scene::Scene;
use crate::trace::{All, AlphaFilter, Hit, Ray, closest_hits};

pub(super) struct Straight<'a> {
    scene: &'a Scene,
    moving: Option<Moving>,
    cutouts: bool,
    backdrop: Backdrop<'a>,
    radius: f64,
}

impl<'a> Straight<'a> {
    pub fn new(scene: &'a Scene, backdrop: Backdrop<'a>, radius: f64, progress: &Progress) -> Result<Self> {
        scene.build(progress)?;
        Ok(Self { scene, moving: Moving::of(scene), cutouts: scene.has_cutouts(), backdrop, radius })
    }

    /// Moving triangles that are looked at for every ray.
    pub fn moving_triangles(&self) -> u64 {
        self.moving.as_ref().map_or(0, Moving::triangles)
    }
}

impl Picture for Straight<'_> {
    fn trace(&self, rays: &mut [Ray], hits: &mut [Hit], _spots: &Spots<'_>) {
        for ray in rays.iter_mut() {
            let (enter, leave) = within_cylinder(ray, self.backdrop.center, self.radius);
            (ray.t_min, ray.t_max) = (ray.t_min.max(enter), ray.t_max.min(leave));
        }
        if self.cutouts {
            closest_hits(self.scene, rays, &AlphaFilter { scene: self.scene, inner: All }, hits);
        } else {
            closest_hits(self.scene, rays, &All, hits);
        }
        if let Some(moving) = &self.moving {
            moving.trace_beyond(&self.backdrop, self.radius, rays, hits);
        }
    }

    fn color(&self, ray: &Ray, hit: &Hit, footprint: Footprint) -> [f32; 3] {
        if hit.is_miss() {
            return self.backdrop.color(ray.direction, footprint);
        }
        Surface::of_hit(self.scene, ray, hit).color(self.scene, footprint.at(hit.t))
    }

    fn add_colors(&self, rays: &[Ray], hits: &[Hit], footprint: impl Fn(usize) -> Footprint, sums: &mut [[f32; 3]]) {
        let missed = |n: usize| self.backdrop.color(rays[n].direction, footprint(n));
        add_colors(self.scene, rays, hits, &footprint, missed, sums);
    }

    fn sample(&self, ray: &Ray, hit: &Hit, _wanted: Channels) -> Sample {
        if hit.is_miss() {
            return self.backdrop.sample(ray.direction);
        }
        sample_of(&Surface::of_hit(self.scene, ray, hit), self.scene, hit.t)
    }
}

/// The part of a ray inside the upright cylinder about a centre; one that ends before it begins where there is none.
fn within_cylinder(ray: &Ray, center: DVec3, radius: f64) -> (f32, f32) {
    let nowhere = (f32::INFINITY, f32::NEG_INFINITY);
    let from_axis = ray.origin.as_dvec3() - center;
    let (p, d) = (DVec2::new(from_axis.x, from_axis.z), ray.direction.as_dvec3());
    let d = DVec2::new(d.x, d.z);
    let (a, b, c) = (d.length_squared(), p.dot(d), p.length_squared() - radius * radius);
    if a == 0.0 {
        return if c <= 0.0 { (0.0, f32::INFINITY) } else { nowhere };
    }
    let discriminant = b * b - a * c;
    if discriminant < 0.0 {
        return nowhere;
    }
    // Both roots in the form that does not cancel.
    let q = -(b + discriminant.sqrt().copysign(b));
    let (one, other) = if q == 0.0 { (0.0, 0.0) } else { (q / a, c / q) };
    let (enter, leave) = (one.min(other), one.max(other));
    if leave < 0.0 { nowhere } else { (enter.max(0.0) as f32, leave as f32) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn points_of_the_interval_are_inside(
            x in -20.0..20.0f32, z in -20.0..20.0f32, dx in -1.0..1.0f32, dy in -1.0..1.0f32, dz in -1.0..1.0f32,
            radius in 0.1..15.0f64, s in 0.0..60.0f64,
        ) {
            let direction = Vec3::new(dx, dy, dz).normalize_or(Vec3::Y);
            let ray = Ray { origin: Vec3::new(x, 1.0, z), direction, t_min: 0.0, t_max: f32::INFINITY };
            let center = DVec3::new(1.0, 5.0, -2.0);
            let (enter, leave) = within_cylinder(&ray, center, radius);
            let p = ray.origin.as_dvec3() + direction.as_dvec3() * s - center;
            let rho = p.x.hypot(p.z);
            let inside = (f64::from(enter)..=f64::from(leave)).contains(&s);
            // Interval ends are rounded to float32: 60 m times 6e-8.
            prop_assert!(inside == (rho <= radius) || (rho - radius).abs() < 1e-5);
        }
    }

    #[test]
    fn upright_rays_are_inside_for_ever_or_never() {
        let up = |x| Ray { origin: Vec3::new(x, 0.0, 0.0), direction: Vec3::Y, t_min: 0.0, t_max: f32::INFINITY };
        assert_eq!(within_cylinder(&up(3.0), DVec3::ZERO, 3.0), (0.0, f32::INFINITY));
        let (enter, leave) = within_cylinder(&up(3.5), DVec3::ZERO, 3.0);
        assert!(enter > leave);
    }
}
