//! Surfaces shown by a picture of a cell, found by rasterisation or by rays.
//!
//! A pixel's second surface is the nearest one that faces the viewer and lies more than a gap behind the first. Back
//! faces are skipped, because they are the insides of closed surfaces.

use glam::DVec3;

use super::cell::{Cell, OrthoCamera};
use super::raster;
use super::reduce::Sample;
use crate::base::{Progress, Result};
use crate::camera::Footprint;
use crate::render::truth::{self, Truth};
use crate::render::{self, Channels, Facet, Frame, Picture, Pixels, RayPixels, RenderView, draw};
use crate::scene::Scene;
use crate::trace::{AlphaFilter, FaceHits, Hit, HitFilter, Ray};

/// Returns the channels that a view needs.
#[inline(always)]
fn channels() -> Channels {
    Channels { range: true, normal: true, albedo: true, ..Channels::default() }
}

/// Scene and cell to draw, and the camera.
pub struct Drawing<'a> {
    pub scene: &'a Scene,
    pub cell: &'a Cell,
    pub ortho: &'a OrthoCamera,
    /// Length of a depth step, metres.
    pub step: f32,
    pub progress: &'a Progress,
}

/// Hits of a picture's pixels.
pub trait Surfaces: Sync {
    /// Returns the distance of a pixel's surface from the near plane of the cell's camera, metres; infinite without a
    /// surface.
    fn distance(&self, pixel: usize) -> f32;

    /// Creates a function that returns the surface of a pixel.
    fn sampler(&self) -> impl FnMut(usize) -> Option<Sample>;
}

/// Surfaces found by rays.
pub struct ByRays {
    picture: Frame,
    step: f32,
}

/// Surfaces found by rasterisation.
pub struct ByTriangles<'a> {
    drawing: &'a Drawing<'a>,
    /// Width of a pixel, metres.
    width: f32,
    hits: Vec<Hit>,
}

impl<'a> Drawing<'a> {
    /// Finds the first surfaces or, with `start`, the first ones beyond each pixel's start that face the viewer. Without
    /// `start` this builds the scene's BVH, which must exist with `start`.
    pub fn by_rays(&self, start: Option<&Start>) -> Result<ByRays> {
        let Self { scene, cell, ortho, step, progress } = *self;
        let (camera, limits) = (&ortho.camera()?, cell.limits(scene.origin)?);
        let Some(start) = start else {
            let picture = truth::render(scene, camera, channels(), 1, limits, Pixels::default(), progress)?;
            return Ok(ByRays { picture, step });
        };
        let pixels = Pixels { mask: Some(&start.mask), ..Pixels::default() };
        let view = RenderView { camera, origin: scene.origin, channels: channels(), samples: 1, limits, pixels };
        let filter = AlphaFilter::new(scene, FrontFaces::new(scene, ortho));
        let picture = draw(&view, &SecondSurfaces { truth: Truth { scene, filter: &filter }, start }, progress)?;
        Ok(ByRays { picture, step })
    }

    /// Finds the same surfaces by rasterisation, which needs no BVH.
    pub fn by_triangles(&'a self, start: Option<&Start>) -> Result<ByTriangles<'a>> {
        let Self { scene, cell, ortho, progress, .. } = *self;
        let hits = match start {
            None => raster::first_hits(scene, cell, ortho, |_, _| true, |_, _| true, progress)?,
            Some(start) => {
                let fronts = FrontFaces::new(scene, ortho);
                let is_front = |instance, face| fronts.contains(instance, face);
                raster::first_hits(
                    scene,
                    cell,
                    ortho,
                    is_front,
                    |pixel, distance| start.accepts(pixel, distance),
                    progress,
                )?
            }
        };
        let width = ortho.camera()?.rays().footprint(0.0, 0.0, 1.0).width;
        Ok(ByTriangles { drawing: self, width, hits })
    }
}

impl Surfaces for ByRays {
    fn distance(&self, pixel: usize) -> f32 {
        self.picture.range[pixel]
    }

    fn sampler(&self) -> impl FnMut(usize) -> Option<Sample> {
        |pixel| {
            let distance = self.picture.range[pixel];
            distance.is_finite().then(|| Sample {
                depth: distance / self.step,
                color: self.picture.albedo[pixel].into(),
                normal: self.picture.normal[pixel].into(),
            })
        }
    }
}

impl Surfaces for ByTriangles<'_> {
    fn distance(&self, pixel: usize) -> f32 {
        self.hits[pixel].t
    }

    fn sampler(&self) -> impl FnMut(usize) -> Option<Sample> {
        let Drawing { scene, ortho, step, .. } = *self.drawing;
        let (hits, width, direction) = (&self.hits[..], self.width, ortho.direction().as_vec3());
        // Neighbouring pixels usually show the same face.
        let mut last: Option<Facet> = None;
        move |pixel| {
            let hit = hits[pixel];
            if hit.is_miss() {
                return None;
            }
            let facet = match last {
                Some(facet) if facet.contains(&hit) => facet,
                _ => *last.insert(Facet::new(scene, hit.instance, hit.face)),
            };
            let sample = facet.surface((hit.u, hit.v), direction).sample(scene, hit.t, || width, channels());
            Some(Sample { depth: hit.t / step, color: sample.albedo.into(), normal: sample.normal.into() })
        }
    }
}

/// Start of the search for each pixel's second surface.
pub struct Start {
    /// Minimum distance from the camera's near plane, metres; infinite for pixels without a first surface.
    min_distance: Vec<f32>,
    /// Whether a pixel has a first surface.
    mask: Vec<bool>,
}

impl Start {
    /// Starts more than a gap behind the first surfaces, given their distances; metres.
    pub fn from_first_distances(first: impl Iterator<Item = f32>, gap: f32) -> Self {
        let min_distance: Vec<f32> = first.map(|distance| (distance + gap).next_up()).collect();
        let mask = min_distance.iter().map(|distance| distance.is_finite()).collect();
        Self { min_distance, mask }
    }

    /// Returns whether a distance is beyond a pixel's start.
    #[inline]
    fn accepts(&self, pixel: usize, distance: f32) -> bool {
        distance >= self.min_distance[pixel]
    }
}

/// Filter for faces whose corners are counter-clockwise for the viewer.
struct FrontFaces<'a> {
    scene: &'a Scene,
    toward: DVec3,
}

impl<'a> FrontFaces<'a> {
    fn new(scene: &'a Scene, ortho: &OrthoCamera) -> Self {
        Self { scene, toward: -ortho.direction() }
    }

    #[inline]
    fn contains(&self, instance: u32, face: u32) -> bool {
        let [a, b, c] = self.scene.instance(instance).corners(face).map(|corner| corner.as_dvec3());
        (b - a).cross(c - a).dot(self.toward) > 0.0
    }
}

impl HitFilter for FrontFaces<'_> {
    fn face_hits(&self, instance: u32, face: u32) -> FaceHits {
        if self.contains(instance, face) { FaceHits::All } else { FaceHits::None }
    }
}

/// A picture of second surfaces: its rays start behind the first ones.
struct SecondSurfaces<'a> {
    truth: Truth<'a>,
    start: &'a Start,
}

impl Picture for SecondSurfaces<'_> {
    fn trace(&self, rays: &mut [Ray], hits: &mut [Hit], pixels: &RayPixels<'_>) {
        for (n, ray) in rays.iter_mut().enumerate() {
            ray.t_min = ray.t_min.max(self.start.min_distance[pixels.index(n)]);
        }
        self.truth.trace(rays, hits, pixels);
    }

    fn add_colors(&self, rays: &[Ray], hits: &[Hit], footprint: impl Fn(usize) -> Footprint, sums: &mut [[f32; 3]]) {
        self.truth.add_colors(rays, hits, footprint, sums);
    }

    fn sample(&self, ray: &Ray, hit: &Hit, footprint: impl FnOnce() -> Footprint, images: Channels) -> render::Sample {
        self.truth.sample(ray, hit, footprint, images)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn second_surfaces_lie_more_than_a_gap_behind_first_ones() {
        let start = Start::from_first_distances([2.0, f32::INFINITY].into_iter(), 0.5);
        assert_eq!(start.mask, [true, false]);
        assert!(!start.accepts(0, 2.5) && start.accepts(0, 2.5f32.next_up()) && !start.accepts(1, f32::MAX));
    }
}
