//! Views of a leaf, drawn at twice their size and reduced like those of parents. The second layer has only surfaces
//! that are visible along certain lines of sight.

use glam::DVec3;
use rayon::prelude::*;

use super::cell::{Cell, OrthoCamera};
use super::direction::Direction;
use super::reduce::{Sample, reach, reduce_view};
use super::surfaces::{Drawing, Start, Surfaces};
use super::view::{Format, Texel, View, Views};
use crate::base::memory::room_for;
use crate::base::{Progress, Result};
use crate::render::{Limits, Segment};
use crate::scene::Scene;
use crate::trace::{AcceptAll, AlphaFilter, Ray, any_hits};

/// Method that finds the surfaces of a leaf.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SurfaceMethod {
    /// Triangle by triangle.
    Triangles,
    /// Ray by ray.
    Rays,
}

/// Bytes per drawn pixel of a thread: hits or images of a layer, and the start of the second. Views of 1024² pixels of
/// 500,000 triangles took up to 27; half as many more are a margin.
const DRAWN_BYTES: usize = 40;

/// Triangles per pixel up to which rasterisation is faster than rays; measured by the benchmark `orthoview.views`.
const MAX_TRIANGLES_PER_PIXEL: f64 = 0.5;

impl Views {
    /// Creates the views of a cell of a scene, with a second layer if `behind`. Surfaces outside the cell and moving
    /// instances are excluded. Without a `method`, the faster one is chosen.
    pub fn of_cell(
        scene: &Scene,
        cell: &Cell,
        directions: &[Direction],
        format: &Format,
        method: Option<SurfaceMethod>,
        behind: bool,
        progress: &Progress,
    ) -> Result<Self> {
        let scene = &scene.posed(Vec::new());
        let max_triangles = MAX_TRIANGLES_PER_PIXEL * (4 * format.pixels()) as f64;
        let faster =
            if scene.triangle_count() as f64 <= max_triangles { SurfaceMethod::Triangles } else { SurfaceMethod::Rays };
        if behind {
            scene.build(progress)?;
        }
        let (pixels, layer_count) = (format.pixels(), directions.len() * (1 + usize::from(behind)));
        let drawn_bytes = DRAWN_BYTES * 4 * pixels * rayon::current_num_threads();
        room_for((layer_count * pixels * size_of::<Texel>() + drawn_bytes) as u64)?;
        let draw_direction = |&direction: &Direction| {
            let ortho = &OrthoCamera::new(cell, direction.frame(), 2 * format.size);
            let lines = behind.then(|| Lines::new(scene, cell, ortho, directions)).transpose()?;
            let drawing = Drawing { scene, cell, ortho, step: step(ortho, format) as f32, progress };
            match method.unwrap_or(faster) {
                SurfaceMethod::Triangles => {
                    draw_layers(|start| drawing.by_triangles(start), lines.as_ref(), &drawing, format)
                }
                SurfaceMethod::Rays => draw_layers(|start| drawing.by_rays(start), lines.as_ref(), &drawing, format),
            }
        };
        let layers: Vec<(View, Option<View>)> = directions.par_iter().map(draw_direction).collect::<Result<_>>()?;
        let (views, second): (_, Vec<_>) = layers.into_iter().unzip();
        Ok(Self::from_layers(directions, *format, (views, second.into_iter().collect())))
    }
}

/// Draws a view and, if there are lines of sight, its second layer.
fn draw_layers<S: Surfaces>(
    draw: impl Fn(Option<&Start>) -> Result<S>,
    lines: Option<&Lines<'_>>,
    drawing: &Drawing<'_>,
    format: &Format,
) -> Result<(View, Option<View>)> {
    let first = draw(None)?;
    let view = encode_view(&first, None, drawing, format);
    if lines.is_none() {
        return Ok((view, None));
    }
    let step = step(drawing.ortho, format);
    let gap = f64::from(reach(drawing.ortho.pixel(), step)) * step;
    let start = Start::from_first_distances((0..4 * format.pixels()).map(|pixel| first.distance(pixel)), gap as f32);
    drop(first);
    let behind = encode_view(&draw(Some(&start))?, lines, drawing, format);
    drawing.progress.check()?;
    Ok((view, Some(behind)))
}

/// Returns the length of a depth step of a picture, metres.
fn step(ortho: &OrthoCamera, format: &Format) -> f64 {
    ortho.extents.z / f64::from(format.steps)
}

/// Encodes a view; with `lines`, only surfaces visible along them. After a cancellation the view is incomplete.
///
/// One function for both layers, because the compiler inlines a sampler with a single call site, which saves a tenth
/// of a leaf's time.
#[inline(never)]
fn encode_view<S: Surfaces>(surfaces: &S, lines: Option<&Lines<'_>>, drawing: &Drawing<'_>, format: &Format) -> View {
    let Drawing { ortho, progress, .. } = *drawing;
    let samplers = || {
        let mut sample = surfaces.sampler();
        move |pixel| {
            let sample = sample(pixel)?;
            let is_seen =
                lines.is_none_or(|lines| progress.check().is_ok() && lines.sees(pixel, &sample, drawing.step));
            is_seen.then_some(sample)
        }
    };
    // A depth at the end of the range, or rounded beyond it, belongs to the last step.
    let depth = |sample: &Sample| (sample.depth as u32).saturating_add(1).min(format.steps);
    reduce_view(samplers, reach(ortho.pixel(), step(ortho, format)), depth, format)
}

/// Cosine above which two directions count as equal.
const SAME_DIRECTION: f64 = 1.0 - 1e-9;

/// Lines of sight from a surface towards possible viewers of a view: half-way between the view's direction and each
/// other direction at most 90° away. A line that coincides with another view's direction is omitted.
struct Lines<'a> {
    scene: &'a Scene,
    ortho: &'a OrthoCamera,
    /// Limits of the cell, relative to the scene's origin.
    limits: Limits,
    /// Possible error of surface positions, metres.
    margin: f64,
    /// Unit vectors, those nearest to the view's direction first, because they most often reach the viewer.
    lines: Vec<DVec3>,
}

impl<'a> Lines<'a> {
    /// Creates the lines of one camera; `directions` are those of all views. The scene must have been built.
    fn new(scene: &'a Scene, cell: &Cell, ortho: &'a OrthoCamera, directions: &[Direction]) -> Result<Self> {
        let (toward, all) = (-ortho.direction(), directions.iter().map(|direction| direction.frame().axes()[2]));
        let others = all.clone().filter(|other| toward.dot(*other) > -1e-9 && toward.dot(*other) < SAME_DIRECTION);
        let is_new = |line: &DVec3| all.clone().all(|other| other.dot(*line) < SAME_DIRECTION);
        let mut lines: Vec<DVec3> = others.map(|other| (toward + other).normalize()).filter(is_new).collect();
        lines.sort_by(|a, b| toward.dot(*b).total_cmp(&toward.dot(*a)));
        let limits = cell.limits(scene.origin)?.relative_to(scene.origin);
        Ok(Self { scene, ortho, limits, margin: cell.margin(scene.origin), lines })
    }

    /// Returns whether a pixel's surface is visible along a line that it faces. `step` is a depth step, metres.
    fn sees(&self, pixel: usize, sample: &Sample, step: f32) -> bool {
        let point = self.ortho.point_of_pixel(pixel, f64::from(sample.depth * step)) - self.scene.origin;
        let normal = sample.normal.as_dvec3();
        self.lines.iter().any(|&line| {
            let cosine = normal.dot(line);
            // Up to this distance the line may hit the surface itself.
            cosine > 0.0 && self.is_free(point, line, self.margin / cosine)
        })
    }

    /// Returns whether a line is free between a distance from a point and the cell's side.
    fn is_free(&self, point: DVec3, line: DVec3, distance: f64) -> bool {
        let Segment { t_max, .. } = self.limits.clip_ray(point, line);
        let ray = Ray { origin: point.as_vec3(), direction: line.as_vec3(), t_min: distance as f32, t_max };
        let mut is_hit = [false];
        any_hits(self.scene, &[ray], &AlphaFilter::new(self.scene, AcceptAll), &mut is_hit);
        !is_hit[0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the four sides, the top and the upper edges.
    fn nine_directions() -> Vec<Direction> {
        let sides = [[0, 0, 1], [1, 0, 0], [0, 0, -1], [-1, 0, 0]];
        let edges = sides.map(|[x, _, z]| [x, 1, z]);
        sides.into_iter().chain([[0, 1, 0]]).chain(edges).map(|numbers| Direction::new(numbers).unwrap()).collect()
    }

    #[test]
    fn lines_lean_half_way_to_other_directions_and_none_is_a_direction() {
        let scene = Scene::of_instances(vec![], vec![]);
        let cell = Cell::new(DVec3::ZERO, 1.0).unwrap();
        let lines = |n: usize, directions: &[Direction]| {
            let ortho = OrthoCamera::new(&cell, directions[n].frame(), 8);
            Lines::new(&scene, &cell, &ortho, directions).unwrap().lines
        };
        let all = nine_directions();
        // From the top half-way to the four edges; lines half-way to the sides coincide with the edges.
        let top = lines(4, &all);
        let angles: Vec<f64> = top.iter().map(|line| line.y.acos().to_degrees()).collect();
        assert!(top.len() == 4 && angles.iter().all(|angle| (angle - 22.5).abs() < 1e-9), "{angles:?}");
        // From a side to the edge above it, to two other sides and to the edges above those.
        let side = lines(0, &all);
        assert_eq!(side.len(), 5);
        assert!((side[0] - DVec3::new(0.0, 1.0, 1.0 + 2f64.sqrt()).normalize()).length() < 1e-12);
        assert!(side.iter().any(|line| (*line - DVec3::new(1.0, 0.0, 1.0).normalize()).length() < 1e-12));
        // Without edges, the directions half-way between sides and top have no own view.
        assert_eq!(lines(4, &all[..5]).len(), 4);
        assert_eq!(lines(0, &all[..1]).len(), 0);
    }
}
