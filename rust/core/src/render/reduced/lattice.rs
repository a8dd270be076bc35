//! Bent rays of a whole view, from those through the corners of its tiles.
//!
//! A ray between the corners is bent at places and by offsets that are interpolated: P = U + s d + offset with its own
//! d, so that only the bend itself is interpolated, which changes little across a tile. Tiles across which it changes
//! too much (steep rays, users outside r₁) have no bends here, and their rays are bent one by one.

use glam::Vec3;
use rayon::prelude::*;

use super::super::tiles::TILE;
use crate::base::{Progress, Result};
use crate::bend::{Curve, Stretch};
use crate::camera::Camera;
use crate::morph::Morph;
use crate::scene::Aabb;

/// Most legs between the radii; tiles that need more are bent one by one.
const MOST_LEGS: usize = 32;
/// Rays that are looked at to choose how many legs a view's rays have.
const PROBES: usize = 512;
/// Shares of the tolerance for the chords and for the interpolation.
const CHORD: f64 = 0.7;
const BETWEEN: f64 = 0.25;
/// Of a bend's offset, as a share of the greatest: its square is what float32 tells apart.
const PRECISION: f64 = 1e-4;
/// Share of a tile's width by which rays inside it may leave the box about those through its corners.
const BULGE: f32 = 0.1;

/// Where a ray bends.
#[derive(Clone, Copy, Debug, Default)]
struct Node {
    /// Along the ray, metres.
    s: f32,
    /// From the ray to the curve.
    offset: Vec3,
}

/// Bends at the corners of all tiles.
pub(super) struct Lattice {
    columns: usize,
    /// Bends of a ray: one more than it has legs between the radii.
    bends: usize,
    nodes: Vec<Node>,
    /// Directions of the rays through the corners.
    directions: Vec<Vec3>,
    /// For each tile, every how many bends suffice; 0 where its rays are bent one by one.
    strides: Vec<u8>,
    tiles: usize,
}

/// The bends of one tile's rays.
pub(super) struct Cell<'a> {
    corners: [&'a [Node]; 4],
    directions: [Vec3; 4],
    /// Every how many bends suffice.
    pub stride: usize,
}

impl Lattice {
    /// The tolerance is in pixels, each as large as it is where its ray passes.
    pub fn new(camera: &Camera, morph: &Morph, tolerance_px: f64, progress: &Progress) -> Result<Self> {
        let (tiles, rows) = ((camera.width as usize).div_ceil(TILE), (camera.height as usize).div_ceil(TILE));
        let (columns, lines) = (tiles + 1, rows + 1);
        let rays = camera.rays();
        let position = |corner: usize| ((corner % columns * TILE) as f64, (corner / columns * TILE) as f64);
        let curve = |corner: usize| {
            let (x, y) = position(corner);
            Curve::new(morph, rays.at(x, y).1)
        };
        let tolerance = |corner: usize| {
            let (x, y) = position(corner);
            tolerance_px * rays.pixel_angle(x, y)
        };
        let corners = columns * lines;
        let step = corners.div_ceil(PROBES).max(1);
        let legs = (0..corners)
            .into_par_iter()
            .step_by(step)
            .map(|corner| legs_for(&curve(corner), CHORD * tolerance(corner)))
            .max()
            .unwrap_or(1);
        let bends = legs + 1;
        progress.check()?;
        let mut nodes = vec![Node::default(); corners * bends];
        let strides: Vec<u8> = nodes
            .par_chunks_mut(bends)
            .enumerate()
            .map(|(corner, nodes)| {
                let curve = curve(corner);
                let Some(stretch) = between_radii(&curve) else { return 0 };
                place(&curve, &stretch, nodes);
                stride_for(&curve, nodes, CHORD * tolerance(corner))
            })
            .collect();
        progress.check()?;
        let directions = (0..corners).into_par_iter().map(|corner| curve(corner).direction.as_vec3()).collect();
        let mut lattice = Self { columns, bends, nodes, directions, strides: Vec::new(), tiles };
        let stride = |tile: usize| {
            let (column, row) = (tile % tiles, tile / tiles);
            let least = lattice.corners(column, row).map(|corner| strides[corner]).into_iter().min().unwrap_or(0);
            let allowed = BETWEEN * tolerance(lattice.corners(column, row)[0]);
            let is_smooth = least > 0 && lattice.turn(column, row, lines, &strides) <= allowed;
            if is_smooth { least } else { 0 }
        };
        lattice.strides = (0..tiles * rows).into_par_iter().map(stride).collect();
        Ok(lattice)
    }

    /// The bends of a tile's rays; none where they are bent one by one.
    pub fn cell(&self, (column, row): (usize, usize)) -> Option<Cell<'_>> {
        let stride = usize::from(self.strides[row * self.tiles + column]);
        let corners = self.corners(column, row);
        (stride > 0).then(|| Cell {
            corners: corners.map(|corner| self.of(corner)),
            directions: corners.map(|corner| self.directions[corner]),
            stride,
        })
    }

    fn corners(&self, column: usize, row: usize) -> [usize; 4] {
        let corner = row * self.columns + column;
        [corner, corner + 1, corner + self.columns, corner + self.columns + 1]
    }

    /// Bends of each ray.
    pub fn bends(&self) -> usize {
        self.bends
    }

    fn of(&self, corner: usize) -> &[Node] {
        &self.nodes[corner * self.bends..][..self.bends]
    }

    /// Angle by which rays inside a tile miss their curve: linear interpolation is off by an eighth of the second
    /// difference each way, which is taken from the corners around; a bend that is misplaced along the ray by δs is
    /// misplaced across it by δs times the curve's slope there.
    fn turn(&self, column: usize, row: usize, lines: usize, strides: &[u8]) -> f64 {
        let at = |column: usize, row: usize| row * self.columns + column;
        let mut worst = 0.0f64;
        let inner = |i: usize, count: usize| i.clamp(1, count.saturating_sub(2).max(1));
        if self.columns < 3 || lines < 3 {
            return f64::INFINITY;
        }
        let (column, row) = (inner(column, self.columns), inner(row, lines));
        let middle = at(column, row);
        for (before, after) in [
            (at(column - 1, row), at(column + 1, row)),
            (at(column, row - 1), at(column, row + 1)),
            (at(column - 1, row - 1), at(column + 1, row + 1)),
        ] {
            if [before, middle, after].into_iter().any(|corner| strides[corner] == 0) {
                return f64::INFINITY;
            }
            let (a, b, c) = (self.of(before), self.of(middle), self.of(after));
            // The bends of a ray differ smoothly from one to the next.
            for k in (0..self.bends).step_by((self.bends / 4).max(1)) {
                let second = |x: f32, y: f32, z: f32| f64::from(x) - 2.0 * f64::from(y) + f64::from(z);
                let along = second(a[k].s, b[k].s, c[k].s).abs() / 8.0;
                let across = (a[k].offset - 2.0 * b[k].offset + c[k].offset).as_dvec3().length() / 8.0;
                let next = if k + 1 < self.bends { k + 1 } else { k - 1 };
                let slope = f64::from((b[next].offset - b[k].offset).length() / (b[next].s - b[k].s).abs());
                worst = worst.max((across + slope * along) / f64::from(b[k].s).max(f64::MIN_POSITIVE));
            }
        }
        // Two ways at once.
        2.0 * worst
    }
}

impl Cell<'_> {
    /// How far a ray is straight: the offset of its first bend is nothing.
    #[inline]
    pub fn straight(&self, spot: [f32; 2]) -> f32 {
        let [a, b, c, d] = self.corners.map(|nodes| nodes[0].s);
        bilinear([a, b, c, d], spot)
    }

    /// Where a ray bends for the kth time, from the user: its direction, and its place in the tile.
    #[inline]
    pub fn bend(&self, k: usize, direction: Vec3, [x, y]: [f32; 2]) -> Vec3 {
        let [a, b, c, d] = self.corners.map(|nodes| nodes[k]);
        let top = a.offset + (b.offset - a.offset) * x;
        let bottom = c.offset + (d.offset - c.offset) * x;
        direction * bilinear([a.s, b.s, c.s, d.s], [x, y]) + top + (bottom - top) * y
    }
}

impl Cell<'_> {
    /// A box about the tile's rays between two bends, whatever lies between those.
    pub fn region(&self, from: usize, to: usize, user: Vec3) -> Aabb {
        let mut region = Aabb::EMPTY;
        let mut widest = 0.0f32;
        for k in (from..=to).step_by(self.stride) {
            let points: [Vec3; 4] = std::array::from_fn(|i| {
                let node = self.corners[i][k];
                user + self.directions[i] * node.s + node.offset
            });
            points.into_iter().for_each(|point| region.extend(point));
            widest = widest.max((points[3] - points[0]).abs().max((points[2] - points[1]).abs()).max_element());
        }
        // Unit directions bulge between the corners, by an eighth of the tile's angle at most.
        let margin = Vec3::splat(BULGE * widest);
        Aabb { min: region.min - margin, max: region.max + margin }
    }
}

#[inline]
fn bilinear([a, b, c, d]: [f32; 4], [x, y]: [f32; 2]) -> f32 {
    let (top, bottom) = (a + (b - a) * x, c + (d - c) * x);
    top + (bottom - top) * y
}

/// The one stretch between the radii of a ray that a user inside r₁ sees; none for other users and upright rays.
fn between_radii(curve: &Curve<'_>) -> Option<Stretch> {
    match curve.stretches()[..] {
        [within, between] if within.straight && !between.straight => Some(between),
        _ => None,
    }
    .filter(|_| curve.end().is_some())
}

fn place(curve: &Curve<'_>, stretch: &Stretch, nodes: &mut [Node]) {
    let legs = (nodes.len() - 1) as f64;
    let (mut y, mut step) = (0.0, 0.0);
    for (k, node) in nodes.iter_mut().enumerate() {
        let s = stretch.from + (stretch.to - stretch.from) * k as f64 / legs;
        let next = curve.search(s, y + step, PRECISION);
        (y, step) = (next, next - y);
        *node = Node { s: s as f32, offset: (curve.across * y).as_vec3() };
    }
}

/// The greatest power of two of bends that may be passed over; 0 where even all of them miss the curve.
fn stride_for(curve: &Curve<'_>, nodes: &[Node], tolerance: f64) -> u8 {
    let at = |k: usize| (f64::from(nodes[k].s), f64::from(nodes[k].offset.length()));
    let misses = |stride: usize| {
        (0..nodes.len() - 1).step_by(stride).any(|k| {
            let (a, b) = (at(k), at(k + stride));
            curve.miss(0.5 * (a.0 + b.0), 0.5 * (a.1 + b.1)) > tolerance
        })
    };
    let mut stride = 0;
    let mut next = 1;
    while next < nodes.len() && !misses(next) {
        stride = next;
        next *= 2;
    }
    stride as u8
}

/// Legs of equal length that a curve needs, a power of two.
fn legs_for(curve: &Curve<'_>, tolerance: f64) -> usize {
    let Some(stretch) = between_radii(curve) else { return 1 };
    let mut legs = 1;
    while legs < MOST_LEGS && miss_of(curve, &stretch, legs) > tolerance {
        legs *= 2;
    }
    legs
}

/// Greatest angle by which the middle of a chord misses the curve, for so many chords.
fn miss_of(curve: &Curve<'_>, stretch: &Stretch, legs: usize) -> f64 {
    let at = |k: usize| stretch.from + (stretch.to - stretch.from) * k as f64 / legs as f64;
    let mut worst = 0.0f64;
    let mut before = (at(0), curve.offset(at(0), 0.0));
    for k in 1..=legs {
        let s = at(k);
        let here = (s, curve.search(s, before.1 + curve.beside / legs as f64, PRECISION));
        worst = worst.max(curve.miss(0.5 * (before.0 + here.0), 0.5 * (before.1 + here.1)));
        before = here;
    }
    worst
}
