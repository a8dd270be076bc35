//! Unmorphed near geometry up to a radius: the conventional method, and all methods for a user at the centre. The
//! scene's own trees are traced, and nothing is copied.

use super::super::frame::{Channels, Sample};
use super::super::limits::Segment;
use super::super::surface::add_colors;
use super::super::tiles::{PIXELS, Picture, RayPixels};
use super::backdrop::{Backdrop, closest};
use super::moving::{ConventionalDynamic, Moving};
use crate::base::{Progress, Result};
use crate::bend::{on_ground, within_cylinder};
use crate::camera::Footprint;
use crate::scene::Scene;
use crate::trace::{Hit, Ray};

pub(super) struct Straight<'a> {
    scene: &'a Scene,
    pub moving: Option<Moving>,
    backdrop: Backdrop<'a>,
    radius: f64,
    placement: ConventionalDynamic,
}

impl<'a> Straight<'a> {
    /// Creates the picture; `placement` places moving objects farther away than the radius.
    pub fn new(
        scene: &'a Scene,
        backdrop: Backdrop<'a>,
        radius: f64,
        placement: ConventionalDynamic,
        progress: &Progress,
    ) -> Result<Self> {
        scene.build_to_shade(progress)?;
        let moving = if placement == ConventionalDynamic::Omit { None } else { Moving::from_scene(scene) };
        Ok(Self { scene, moving, backdrop, radius, placement })
    }
}

impl Picture for Straight<'_> {
    fn trace(&self, rays: &mut [Ray], hits: &mut [Hit], _pixels: &RayPixels<'_>) {
        let mut segments = [Segment::EMPTY; PIXELS];
        for (ray, segment) in rays.iter_mut().zip(&mut segments) {
            *segment = Segment { t_min: ray.t_min, t_max: ray.t_max };
            let from_axis = on_ground(ray.origin.as_dvec3() - self.backdrop.center);
            let inside = within_cylinder(from_axis, on_ground(ray.direction.as_dvec3()), self.radius);
            let (enter, leave) = inside.unwrap_or((f64::INFINITY, f64::NEG_INFINITY));
            (ray.t_min, ray.t_max) = (ray.t_min.max(enter as f32), ray.t_max.min(leave as f32));
        }
        closest(self.scene, rays, hits);
        match &self.moving {
            Some(moving) if self.placement == ConventionalDynamic::User => {
                moving.trace_in_front(|n| segments[n], rays, hits)
            }
            Some(moving) => moving.trace_beyond(&self.backdrop, self.radius, |n| segments[n], rays, hits),
            None => {}
        }
    }

    fn add_colors(&self, rays: &[Ray], hits: &[Hit], footprint: impl Fn(usize) -> Footprint, sums: &mut [[f32; 3]]) {
        let miss_color = |n: usize| self.backdrop.color(rays[n].direction, || footprint(n));
        add_colors(self.scene, rays, hits, &footprint, |&hit| hit, miss_color, sums);
    }

    fn sample(&self, ray: &Ray, hit: &Hit, footprint: impl FnOnce() -> Footprint, channels: Channels) -> Sample {
        self.backdrop.sample(self.scene, ray, hit, footprint, channels)
    }
}
