//! Views of a leaf: its surfaces at twice the size, reduced by the kernel of parents.

use rayon::prelude::*;

use super::cell::{Cell, Sight};
use super::direction::Direction;
use super::format::Format;
use super::raster;
use super::reduce::{Sample, reach, reduced_view};
use super::view::{View, Views};
use crate::base::{Progress, Result};
use crate::render::{Channels, Facet, Pixels, truth};
use crate::scene::Scene;

/// How the surfaces of a leaf are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Triangle by triangle.
    Triangles,
    /// Ray by ray.
    Rays,
}

/// Triangles for each pixel of a picture up to which drawing them one by one takes less time than rays; measured by the
/// benchmark `orthoview.views`.
const TRIANGLES_A_PIXEL: f64 = 0.5;

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

impl Views {
    /// The views of a cell of a scene. Surfaces beyond its sides are not seen, nor is what moves. Without a `way` the
    /// faster one is taken.
    pub fn of_cell(
        scene: &Scene,
        cell: &Cell,
        directions: &[Direction],
        format: &Format,
        way: Option<Way>,
        progress: &Progress,
    ) -> Result<Self> {
        let scene = &scene.posed(Vec::new());
        let most = TRIANGLES_A_PIXEL * (4 * format.pixels()) as f64;
        let faster = if scene.triangle_count() as f64 <= most { Way::Triangles } else { Way::Rays };
        let view = |direction: &Direction| {
            let sight = Sight::new(cell, direction.frame(), 2 * format.size);
            match way.unwrap_or(faster) {
                Way::Triangles => by_triangles(scene, cell, &sight, format, progress),
                Way::Rays => by_rays(scene, cell, &sight, format, progress),
            }
        };
        let views = directions.par_iter().map(view).collect::<Result<_>>()?;
        Ok(Self { directions: directions.to_vec(), format: *format, views })
    }
}

fn by_rays(scene: &Scene, cell: &Cell, sight: &Sight, format: &Format, progress: &Progress) -> Result<View> {
    let picture =
        truth::render(scene, &sight.camera()?, CHANNELS, 1, cell.limits(scene.origin)?, Pixels::default(), progress)?;
    let step = (sight.extents.z / f64::from(format.steps)) as f32;
    let sample = |at: usize| {
        let range = picture.range[at];
        range.is_finite().then(|| Sample {
            depth: range / step,
            color: picture.albedo[at].into(),
            normal: picture.normal[at].into(),
        })
    };
    Ok(coded(|| sample, sight, format))
}

fn by_triangles(scene: &Scene, cell: &Cell, sight: &Sight, format: &Format, progress: &Progress) -> Result<View> {
    let hits = raster::first_hits(scene, cell, sight, progress)?;
    let direction = sight.direction().as_vec3();
    let width = sight.camera()?.rays().footprint(0.0, 0.0, 1.0).width;
    let step = (sight.extents.z / f64::from(format.steps)) as f32;
    let sampler = || {
        // Neighbouring pixels usually show the same face.
        let mut last: Option<Facet> = None;
        let (hits, step) = (&hits, step);
        move |at: usize| {
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
    };
    Ok(coded(sampler, sight, format))
}

fn coded<S: FnMut(usize) -> Option<Sample>>(samplers: impl Fn() -> S + Sync, sight: &Sight, format: &Format) -> View {
    let step = sight.extents.z / f64::from(format.steps);
    // A depth at the end of the range, or rounded beyond it, belongs to the last step.
    let depth = |sample: &Sample| (sample.depth as u32).saturating_add(1).min(format.steps);
    reduced_view(samplers, reach(sight.pixel(), step), depth, format)
}
