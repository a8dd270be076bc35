//! Ground truth: rendering of the unchanged scene.

use super::frame::{Channels, Frame, Sample};
use super::limits::Limits;
use super::shade::background;
use super::surface::{Surface, add_colors};
use super::tiles::{Picture, Pixels, RayPixels, RenderView, draw};
use crate::base::{Progress, Result};
use crate::camera::{Camera, Footprint};
use crate::scene::Scene;
use crate::trace::{AcceptAll, AlphaFilter, Hit, HitFilter, Ray, closest_hits};

/// Renders a scene. Range is the distance from the camera or, for parallel rays, from the image plane.
pub fn render(
    scene: &Scene,
    camera: &Camera,
    channels: Channels,
    samples: u32,
    limits: Limits,
    pixels: Pixels<'_>,
    progress: &Progress,
) -> Result<Frame> {
    scene.build_to_shade(progress)?;
    let view = RenderView { camera, origin: scene.origin, channels, samples, limits, pixels };
    draw(&view, &Truth { scene, filter: &AlphaFilter::new(scene, AcceptAll) }, progress)
}

/// A scene along straight rays: the surfaces that a filter accepts, in front of the sky.
pub struct Truth<'a> {
    /// The scene, which must have been built.
    pub scene: &'a Scene,
    /// Filter for intersections.
    pub filter: &'a dyn HitFilter,
}

impl Picture for Truth<'_> {
    fn trace(&self, rays: &mut [Ray], hits: &mut [Hit], _pixels: &RayPixels<'_>) {
        closest_hits(self.scene, rays, self.filter, hits);
    }

    fn add_colors(&self, rays: &[Ray], hits: &[Hit], footprint: impl Fn(usize) -> Footprint, sums: &mut [[f32; 3]]) {
        let miss_color = |n: usize| background(rays[n].direction);
        add_colors(self.scene, rays, hits, footprint, |&hit| hit, miss_color, sums);
    }

    fn sample(&self, ray: &Ray, hit: &Hit, footprint: impl FnOnce() -> Footprint, channels: Channels) -> Sample {
        if hit.is_miss() {
            return Sample::default();
        }
        if channels.needs_surface() {
            return Surface::of_hit(self.scene, ray, hit).sample(
                self.scene,
                hit.t,
                || footprint().width_at(hit.t),
                channels,
            );
        }
        let mut sample = Sample { range: hit.t, ..Sample::default() };
        if channels.object_id {
            sample.object_id = self.scene.instance(hit.instance).object_of(hit.face);
        }
        if channels.face_id {
            sample.face_id = self.scene.triangle_offset(hit.instance) + i64::from(hit.face);
        }
        sample
    }
}
