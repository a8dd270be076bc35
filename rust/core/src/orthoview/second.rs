//! Second surfaces: for each pixel the nearest viewer-facing surface more than a gap behind the first. Back faces, the
//! insides of closed surfaces, are skipped.

use glam::DVec3;

use super::cell::Sight;
use crate::camera::Footprint;
use crate::render::truth::Truth;
use crate::render::{Channels, Picture, Sample, Spots};
use crate::scene::Scene;
use crate::trace::{FaceHits, Hit, HitFilter, Ray};

/// Start of the search for each pixel's second surface.
pub struct Start {
    /// Minimum distance from the front of the range, metres; infinite for pixels without a first surface.
    least: Vec<f32>,
    /// Whether a pixel has a first surface.
    mask: Vec<bool>,
}

impl Start {
    /// Starts more than a gap behind the first surfaces, given their distances; metres.
    pub fn from_first_ranges(first: impl Iterator<Item = f32>, gap: f32) -> Self {
        let least: Vec<f32> = first.map(|range| (range + gap).next_up()).collect();
        let mask = least.iter().map(|least| least.is_finite()).collect();
        Self { least, mask }
    }

    /// Returns whether a distance is beyond a pixel's start.
    #[inline]
    pub fn holds(&self, pixel: usize, distance: f32) -> bool {
        distance >= self.least[pixel]
    }

    /// Returns whether each pixel has a first surface.
    pub fn mask(&self) -> &[bool] {
        &self.mask
    }
}

/// Filter for faces whose corners are counter-clockwise for the viewer.
pub struct Fronts<'a> {
    scene: &'a Scene,
    toward: DVec3,
}

impl<'a> Fronts<'a> {
    /// Creates the filter for a scene and a view.
    pub fn new(scene: &'a Scene, sight: &Sight) -> Self {
        Self { scene, toward: -sight.direction() }
    }

    /// Returns whether a face faces the view.
    #[inline]
    pub fn holds(&self, instance: u32, face: u32) -> bool {
        let [a, b, c] = self.scene.instance(instance).corners(face).map(|corner| corner.as_dvec3());
        (b - a).cross(c - a).dot(self.toward) > 0.0
    }
}

impl HitFilter for Fronts<'_> {
    fn face_hits(&self, instance: u32, face: u32) -> FaceHits {
        if self.holds(instance, face) { FaceHits::All } else { FaceHits::None }
    }
}

/// A picture along rays that start behind the first surfaces.
pub struct StartingLate<'a> {
    truth: Truth<'a>,
    start: &'a Start,
}

impl<'a> StartingLate<'a> {
    /// Creates a picture of a scene's surfaces that a filter accepts; the scene must have been built.
    pub fn new(scene: &'a Scene, filter: &'a dyn HitFilter, start: &'a Start) -> Self {
        Self { truth: Truth { scene, filter }, start }
    }
}

impl Picture for StartingLate<'_> {
    fn trace(&self, rays: &mut [Ray], hits: &mut [Hit], spots: &Spots<'_>) {
        for (n, ray) in rays.iter_mut().enumerate() {
            ray.t_min = ray.t_min.max(self.start.least[spots.index(n)]);
        }
        self.truth.trace(rays, hits, spots);
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
    use super::*;

    #[test]
    fn second_surfaces_lie_more_than_a_gap_behind_first_ones() {
        let start = Start::from_first_ranges([2.0, f32::INFINITY].into_iter(), 0.5);
        assert_eq!(start.mask(), [true, false]);
        assert!(!start.holds(0, 2.5) && start.holds(0, 2.5f32.next_up()) && !start.holds(1, f32::MAX));
    }
}
