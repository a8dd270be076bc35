//! Views of a leaf: its surfaces at twice the size, reduced by the kernel of parents.

use rayon::prelude::*;

use super::cell::{Cell, Sight};
use super::direction::Direction;
use super::format::Format;
use super::lines::Lines;
use super::reduce::{Sample, reach, reduced_view};
use super::second::Start;
use super::surfaces::{Drawing, Surfaces};
use super::view::{View, Views};
use crate::base::{Progress, Result};
use crate::scene::Scene;

/// Method that finds the surfaces of a leaf.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Triangle by triangle.
    Triangles,
    /// Ray by ray.
    Rays,
}

/// Triangles per pixel up to which rasterisation is faster than rays; measured by the benchmark `orthoview.views`.
const TRIANGLES_A_PIXEL: f64 = 0.5;

impl Views {
    /// Creates the views of a cell of a scene, with a second layer if `behind`. Surfaces beyond the cell's sides and
    /// moving instances are excluded. Without a `way` the faster one is used.
    pub fn of_cell(
        scene: &Scene,
        cell: &Cell,
        directions: &[Direction],
        format: &Format,
        way: Option<Way>,
        behind: bool,
        progress: &Progress,
    ) -> Result<Self> {
        let scene = &scene.posed(Vec::new());
        let most = TRIANGLES_A_PIXEL * (4 * format.pixels()) as f64;
        let faster = if scene.triangle_count() as f64 <= most { Way::Triangles } else { Way::Rays };
        if behind {
            scene.build(progress)?;
        }
        let layers = |&direction: &Direction| {
            let sight = &Sight::new(cell, direction.frame(), 2 * format.size);
            let lines = behind.then(|| Lines::new(scene, cell, sight, direction, directions)).transpose()?;
            let drawing = Drawing { scene, cell, sight, step: step(sight, format) as f32, progress };
            match way.unwrap_or(faster) {
                Way::Triangles => layers(|start| drawing.by_triangles(start), lines.as_ref(), &drawing, format),
                Way::Rays => layers(|start| drawing.by_rays(start), lines.as_ref(), &drawing, format),
            }
        };
        let layers: Vec<(View, Option<View>)> = directions.par_iter().map(layers).collect::<Result<_>>()?;
        let (views, second): (_, Vec<_>) = layers.into_iter().unzip();
        Ok(Self::from_layers(directions, format, views, second.into_iter().collect()))
    }
}

/// Draws a view and, if there are lines of sight, its second layer.
fn layers<S: Surfaces>(
    draw: impl Fn(Option<&Start>) -> Result<S>,
    lines: Option<&Lines<'_>>,
    drawing: &Drawing<'_>,
    format: &Format,
) -> Result<(View, Option<View>)> {
    let first = draw(None)?;
    let view = coded(&first, None, drawing, format);
    if lines.is_none() {
        return Ok((view, None));
    }
    let step = step(drawing.sight, format);
    let gap = f64::from(reach(drawing.sight.pixel(), step)) * step;
    let start = Start::from_first_ranges((0..4 * format.pixels()).map(|at| first.range(at)), gap as f32);
    drop(first);
    let behind = coded(&draw(Some(&start))?, lines, drawing, format);
    drawing.progress.check()?;
    Ok((view, Some(behind)))
}

/// Returns the length of a depth step of a picture, metres.
fn step(sight: &Sight, format: &Format) -> f64 {
    sight.extents.z / f64::from(format.steps)
}

/// Encodes a view; with `lines`, only surfaces visible along them. After a cancellation the view is incomplete.
///
/// One function for both layers, because the compiler inlines a sampler with a single call site, which saves a tenth
/// of a leaf's time.
#[inline(never)]
fn coded<S: Surfaces>(surfaces: &S, lines: Option<&Lines<'_>>, drawing: &Drawing<'_>, format: &Format) -> View {
    let Drawing { sight, progress, .. } = *drawing;
    let samplers = || {
        let mut sample = surfaces.sampler();
        move |at| {
            let sample = sample(at)?;
            let is_seen = lines.is_none_or(|lines| progress.check().is_ok() && lines.see(at, &sample, drawing.step));
            is_seen.then_some(sample)
        }
    };
    // A depth at the end of the range, or rounded beyond it, belongs to the last step.
    let depth = |sample: &Sample| (sample.depth as u32).saturating_add(1).min(format.steps);
    reduced_view(samplers, reach(sight.pixel(), step(sight, format)), depth, format)
}
