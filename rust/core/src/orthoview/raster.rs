//! Rasterisation of a cell's first surfaces along parallel rays. For few triangles this is faster than ray tracing,
//! which needs a bounding volume hierarchy and a traversal per pixel.

use std::ops::Range;

use glam::{DVec2, DVec3};

use super::cell::{Cell, OrthoCamera};
use crate::base::{Progress, Result};
use crate::scene::{Instance, Scene};
use crate::trace::Hit;

/// Triangles between two checks for cancellation.
const TRIANGLES_PER_CHECK: u32 = 1 << 12;

/// Returns the first hit of each pixel's ray within the cell; distances begin at the near plane of its camera.
/// `accepts_face` gets the numbers of an instance and a face, `accepts_distance` a pixel and a distance.
pub fn first_hits(
    scene: &Scene,
    cell: &Cell,
    ortho: &OrthoCamera,
    accepts_face: impl Fn(u32, u32) -> bool,
    accepts_distance: impl Fn(usize, f32) -> bool,
    progress: &Progress,
) -> Result<Vec<Hit>> {
    let mut raster = Raster::new(scene, cell, ortho);
    for (number, instance) in (0..).zip(scene.instances()) {
        for face in 0..instance.mesh.faces.len() as u32 {
            if face % TRIANGLES_PER_CHECK == 0 {
                progress.check()?;
            }
            if accepts_face(number, face) {
                raster.draw(number, instance, face, &accepts_distance);
            }
        }
    }
    Ok(raster.hits)
}

struct Raster<'a> {
    scene: &'a Scene,
    ortho: &'a OrthoCamera,
    /// Minimum and maximum corner of the visible volume, relative to the scene's origin.
    low: DVec3,
    high: DVec3,
    has_cutouts: bool,
    hits: Vec<Hit>,
}

/// A triangle in pixels to the right and downwards, with its depth in metres.
struct Projected {
    corners: [DVec2; 3],
    depths: [f64; 3],
    /// Twice the signed area; the sign gives the winding.
    doubled_area: f64,
}

impl<'a> Raster<'a> {
    fn new(scene: &'a Scene, cell: &Cell, ortho: &'a OrthoCamera) -> Self {
        let (low, high) = cell.bounds_with_margin(scene.origin);
        let hits = vec![Hit::MISS; ortho.pixels * ortho.pixels];
        let (low, high) = (low - scene.origin, high - scene.origin);
        Self { scene, ortho, low, high, has_cutouts: scene.has_cutouts(), hits }
    }

    fn draw(&mut self, number: u32, instance: &Instance, face: u32, accepts_distance: &impl Fn(usize, f32) -> bool) {
        let corners = instance.corners(face).map(|corner| corner.as_dvec3());
        let least = corners[0].min(corners[1]).min(corners[2]);
        let greatest = corners[0].max(corners[1]).max(corners[2]);
        if least.cmpgt(self.high).any() || greatest.cmplt(self.low).any() {
            return;
        }
        let is_inside = least.cmpge(self.low).all() && greatest.cmple(self.high).all();
        let triangle = self.project(corners);
        if triangle.doubled_area == 0.0 {
            return;
        }
        let edges = triangle.edges();
        let (rows, columns) = triangle.pixels(self.ortho.pixels);
        for row in rows {
            let row_edges = edges.map(|edge| edge.at_row(row as f64 + 0.5));
            for column in span(&row_edges, &columns) {
                let weights = row_edges.map(|edge| edge.value(column as f64 + 0.5));
                // Their sum is the area up to rounding, and pure rounding for an edge-on triangle.
                let sum = weights.iter().sum::<f64>();
                if sum == 0.0 || weights.iter().any(|&weight| weight < 0.0) {
                    continue;
                }
                let barycentric = weights.map(|weight| weight / sum);
                let depth = (0..3).map(|n| barycentric[n] * triangle.depths[n]).sum::<f64>() as f32;
                let pixel = row * self.ortho.pixels + column;
                // At equal depths the lower triangle number stays: it was drawn first.
                if depth >= self.hits[pixel].t || !accepts_distance(pixel, depth) {
                    continue;
                }
                let point = || (0..3).map(|n| corners[n] * barycentric[n]).sum::<DVec3>();
                if !is_inside && !self.contains(point()) {
                    continue;
                }
                let (u, v) = (barycentric[1] as f32, barycentric[2] as f32);
                if self.has_cutouts && !self.scene.is_solid(&instance.mesh, face, (u, v)) {
                    continue;
                }
                self.hits[pixel] = Hit { t: depth, u, v, instance: number, face };
            }
        }
    }

    fn contains(&self, point: DVec3) -> bool {
        point.cmpge(self.low).all() && point.cmple(self.high).all()
    }

    fn project(&self, corners: [DVec3; 3]) -> Projected {
        let placed = corners.map(|corner| self.ortho.project(corner + self.scene.origin));
        let corners = placed.map(DVec3::truncate);
        let doubled_area = (corners[1] - corners[0]).perp_dot(corners[2] - corners[0]);
        Projected { corners, depths: placed.map(|place| place.z), doubled_area }
    }
}

/// Edge function of two corners: a point's signed distance from the line through them, times the length of the side;
/// positive inside the triangle.
#[derive(Clone, Copy)]
struct Edge {
    from: DVec2,
    vector: DVec2,
}

/// Edge function along one row: start − step · (x − from).
#[derive(Clone, Copy)]
struct EdgeInRow {
    start: f64,
    step: f64,
    from: f64,
}

impl Projected {
    /// Returns the edges opposite each corner. Triangles that share a side compute it from the same corner, so a pixel
    /// centre on or near it belongs to at least one of them.
    fn edges(&self) -> [Edge; 3] {
        let sign = self.doubled_area.signum();
        [(1, 2), (2, 0), (0, 1)].map(|(a, b)| {
            let (a, b) = (self.corners[a], self.corners[b]);
            let is_ordered = (a.x, a.y) <= (b.x, b.y);
            let (from, vector) = if is_ordered { (a, b - a) } else { (b, b - a) };
            Edge { from, vector: sign * vector }
        })
    }

    /// Returns the rows and columns of the pixels whose centres the triangle's box may contain.
    fn pixels(&self, size: usize) -> (Range<usize>, Range<usize>) {
        let [a, b, c] = self.corners;
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let first = |value: f64| (value - 0.5).ceil().clamp(0.0, size as f64) as usize;
        let end = |value: f64| ((value - 0.5).floor() + 1.0).clamp(0.0, size as f64) as usize;
        (first(low.y)..end(high.y), first(low.x)..end(high.x))
    }
}

impl Edge {
    fn at_row(&self, y: f64) -> EdgeInRow {
        EdgeInRow { start: self.vector.x * (y - self.from.y), step: self.vector.y, from: self.from.x }
    }
}

impl EdgeInRow {
    #[inline]
    fn value(&self, x: f64) -> f64 {
        self.start - self.step * (x - self.from)
    }
}

/// Returns the columns in which all edge functions may be positive, and one more at either end due to rounding.
fn span(edges: &[EdgeInRow; 3], columns: &Range<usize>) -> Range<usize> {
    let (mut first, mut end) = (columns.start, columns.end);
    for edge in edges.iter().filter(|edge| edge.step != 0.0) {
        let zero = edge.from + edge.start / edge.step - 0.5;
        if edge.step < 0.0 {
            first = first.max((zero.floor() - 1.0).clamp(0.0, end as f64) as usize);
        } else {
            end = end.min((zero.ceil() + 2.0).clamp(0.0, end as f64) as usize);
        }
    }
    first..end
}
