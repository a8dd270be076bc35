//! Surfaces shown by a picture of a cell, found by rasterisation or by rays.

use super::cell::{Cell, Sight};
use super::raster;
use super::reduce::Sample;
use super::second::{Fronts, Start, StartingLate};
use crate::base::{Progress, Result};
use crate::render::{Channels, Facet, Frame, Pixels, RenderView, draw, truth};
use crate::scene::Scene;
use crate::trace::{AlphaFilter, Hit};

const CHANNELS: Channels = Channels {
    color: false,
    coverage: false,
    range: true,
    object_id: false,
    face_id: false,
    position: false,
    normal: true,
    albedo: true,
    shading_normal: false,
};

/// Scene, cell and picture to draw.
pub struct Drawing<'a> {
    pub scene: &'a Scene,
    pub cell: &'a Cell,
    pub sight: &'a Sight,
    /// Length of a depth step, metres.
    pub step: f32,
    pub progress: &'a Progress,
}

/// Hits of a picture's pixels.
pub trait Surfaces: Sync {
    /// Returns the distance of a pixel's surface from the front of the range, metres; infinite without a surface.
    fn range(&self, at: usize) -> f32;

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
    /// Finds the first surfaces or, with `start`, the first viewer-facing ones beyond each pixel's start. The scene
    /// must have been built for the latter.
    pub fn by_rays(&self, start: Option<&Start>) -> Result<ByRays> {
        let Self { scene, cell, sight, step, progress } = *self;
        let (camera, limits) = (sight.camera()?, cell.limits(scene.origin)?);
        let Some(start) = start else {
            let picture = truth::render(scene, &camera, CHANNELS, 1, limits, Pixels::default(), progress)?;
            return Ok(ByRays { picture, step });
        };
        let pixels = Pixels { mask: Some(start.mask()), ..Pixels::default() };
        let view = RenderView { camera: &camera, origin: scene.origin, channels: CHANNELS, samples: 1, limits, pixels };
        let filter = AlphaFilter::new(scene, Fronts::new(scene, sight));
        let picture = draw(&view, &StartingLate::new(scene, &filter, start), progress)?;
        Ok(ByRays { picture, step })
    }

    /// Finds the same surfaces by rasterisation; the scene need not be built.
    pub fn by_triangles(&'a self, start: Option<&Start>) -> Result<ByTriangles<'a>> {
        let Self { scene, cell, sight, progress, .. } = *self;
        let hits = match start {
            None => raster::first_hits(scene, cell, sight, |_, _| true, |_, _| true, progress)?,
            Some(start) => {
                let fronts = Fronts::new(scene, sight);
                let counts = |pixel, depth| start.holds(pixel, depth);
                raster::first_hits(scene, cell, sight, |instance, face| fronts.holds(instance, face), counts, progress)?
            }
        };
        let width = sight.camera()?.rays().footprint(0.0, 0.0, 1.0).width;
        Ok(ByTriangles { drawing: self, width, hits })
    }
}

impl Surfaces for ByRays {
    fn range(&self, at: usize) -> f32 {
        self.picture.range[at]
    }

    fn sampler(&self) -> impl FnMut(usize) -> Option<Sample> {
        |at| {
            let range = self.picture.range[at];
            range.is_finite().then(|| Sample {
                depth: range / self.step,
                color: self.picture.albedo[at].into(),
                normal: self.picture.normal[at].into(),
            })
        }
    }
}

impl Surfaces for ByTriangles<'_> {
    fn range(&self, at: usize) -> f32 {
        self.hits[at].t
    }

    fn sampler(&self) -> impl FnMut(usize) -> Option<Sample> {
        let Drawing { scene, sight, step, .. } = *self.drawing;
        let (hits, width, direction) = (&self.hits[..], self.width, sight.direction().as_vec3());
        // Neighbouring pixels usually show the same face.
        let mut last: Option<Facet> = None;
        move |at| {
            let hit = hits[at];
            if hit.is_miss() {
                return None;
            }
            let facet = match last {
                Some(facet) if facet.holds(&hit) => facet,
                _ => *last.insert(Facet::new(scene, hit.instance, hit.face)),
            };
            let shown = facet.surface((hit.u, hit.v), direction).sample(scene, hit.t, || width, CHANNELS);
            Some(Sample { depth: hit.t / step, color: shown.albedo.into(), normal: shown.normal.into() })
        }
    }
}
