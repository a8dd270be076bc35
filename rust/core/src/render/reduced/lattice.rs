//! Bent rays of a whole view, interpolated from the rays through the corners of its tiles.
//!
//! A ray between the corners is P = U + s d + offset with its own direction d. Only the positions s and the offsets of
//! its bends are interpolated; both change little across a tile. Tiles across which they change too much (steep rays,
//! users outside r₁) are not interpolated, and their rays are bent one by one. A corner is bent when a tile first needs
//! it, because most rays hit a surface before they bend.

use std::sync::OnceLock;

use glam::{Vec3, Vec4, Vec4Swizzles};

use super::super::tiles::TILE;
use super::corner::{Corner, LEAST_LEGS, MOST_LEGS};
use crate::base::Aabb;
use crate::bend::RayCurve;
use crate::camera::{Camera, Rays};
use crate::morph::Morph;

/// Shares of the tolerance that the chords and the interpolation may use.
const CHORD: f64 = 0.6;
const BETWEEN: f64 = 0.25;
/// Share of a tile's width by which rays inside the tile may leave the box about its corner rays. Unit directions bulge
/// between corners by at most an eighth of the tile's angle.
const BULGE: f32 = 0.1;

/// Bends at the corners of all tiles.
pub(super) struct Lattice {
    morph: Morph,
    rays: Rays,
    tolerance_px: f64,
    columns: usize,
    lines: usize,
    corners: Vec<OnceLock<Option<Box<Corner>>>>,
}

/// One of `parts` × `parts` parts of a tile.
#[derive(Clone, Copy)]
struct TilePart {
    parts: usize,
    x: usize,
    y: usize,
}

impl TilePart {
    const WHOLE: Self = Self { parts: 1, x: 0, y: 0 };
}

/// The bends of the rays of a tile, or of a part of it.
pub(super) struct Cell {
    part: TilePart,
    /// Number of legs between the radii.
    pub legs: usize,
    /// Offset of each bend and its position along the ray, as coefficients of 1, x, y and xy across the tile.
    bends: [[Vec4; 4]; MOST_LEGS + 1],
    /// Bounding box of each bend over all rays of the tile.
    boxes: [Aabb; MOST_LEGS + 1],
}

impl Lattice {
    /// The tolerance is in pixels, with the angular size of a pixel at each ray.
    pub fn new(camera: &Camera, morph: &Morph, tolerance_px: f64) -> Self {
        let (columns, lines) =
            ((camera.width as usize).div_ceil(TILE) + 1, (camera.height as usize).div_ceil(TILE) + 1);
        let corners = std::iter::repeat_with(OnceLock::new).take(columns * lines).collect();
        Self { morph: *morph, rays: camera.rays(), tolerance_px, columns, lines, corners }
    }

    /// Calls `trace` with the bends of a tile's rays, part by part if they change too much across the tile. Returns
    /// false if rays must be bent one by one.
    pub fn for_each_cell(&self, (column, row): (usize, usize), mut trace: impl FnMut(&Cell)) -> bool {
        let Some(turn) = self.turn(column, row) else { return false };
        let allowed = BETWEEN * self.tolerance(column, row);
        // Second differences are proportional to the square of a part's side.
        let Some(parts) = [1, 2, 4].into_iter().find(|&parts| turn <= allowed * (parts * parts) as f64) else {
            return false;
        };
        let user = self.morph.user.as_vec3();
        if parts == 1 {
            let at = |x, y| self.corner(column + x, row + y);
            let (Some(a), Some(b), Some(c), Some(d)) = (at(0, 0), at(1, 0), at(0, 1), at(1, 1)) else { return false };
            trace(&Cell::new([a, b, c, d], user, TilePart::WHOLE));
            return true;
        }
        let across = parts + 1;
        let at = |i: usize| {
            let share = |cell: usize, part: usize| cell as f64 + part as f64 / parts as f64;
            self.bent(share(column, i % across), share(row, i / across))
        };
        let Some(corners) = (0..across * across).map(at).collect::<Option<Vec<Corner>>>() else { return false };
        for part in 0..parts * parts {
            let (x, y) = (part % parts, part / parts);
            let first = y * across + x;
            let around = [first, first + 1, first + across, first + across + 1].map(|i| &corners[i]);
            trace(&Cell::new(around, user, TilePart { parts, x, y }));
        }
        true
    }

    /// Tolerance in radians at a position in units of tiles.
    fn tolerance_at(&self, column: f64, row: f64) -> f64 {
        self.tolerance_px * self.rays.pixel_angle(column * TILE as f64, row * TILE as f64)
    }

    fn tolerance(&self, column: usize, row: usize) -> f64 {
        self.tolerance_at(column as f64, row as f64)
    }

    fn bent(&self, column: f64, row: f64) -> Option<Corner> {
        let direction = self.rays.at(column * TILE as f64, row * TILE as f64).1;
        Corner::new(&RayCurve::new(&self.morph, direction), CHORD * self.tolerance_at(column, row))
    }

    fn corner(&self, column: usize, row: usize) -> Option<&Corner> {
        let bend = || self.bent(column as f64, row as f64).map(Box::new);
        self.corners[row * self.columns + column].get_or_init(bend).as_deref()
    }

    /// Angle by which interpolated rays inside a tile miss their curve. The error of linear interpolation in each
    /// direction is an eighth of the second difference, which follows from the surrounding corners. An error δs of a
    /// bend's position along the ray moves it across the ray by δs times the curve's slope. `None` if corners cannot be
    /// compared.
    fn turn(&self, column: usize, row: usize) -> Option<f64> {
        let inner = |i: usize, count: usize| i.clamp(1, count.saturating_sub(2).max(1));
        if self.columns < 3 || self.lines < 3 {
            return None;
        }
        let (column, row) = (inner(column, self.columns), inner(row, self.lines));
        let middle = coarse(self.corner(column, row)?);
        let mut worst = 0.0f64;
        for (x, y) in [(1, 0), (0, 1), (1, 1)] {
            let before = coarse(self.corner(column - x, row - y)?);
            let after = coarse(self.corner(column + x, row + y)?);
            for k in 0..=LEAST_LEGS {
                let second = before[k] - 2.0 * middle[k] + after[k];
                let next = if k < LEAST_LEGS { k + 1 } else { k - 1 };
                let chord = before[next] - before[k];
                let slope = chord.xyz().length() / chord.w.abs();
                let miss = (second.xyz().length() + slope * second.w.abs()) / 8.0;
                worst = worst.max(f64::from(miss) / f64::from(before[k].w).max(f64::MIN_POSITIVE));
            }
        }
        // The factor 2 adds the errors in both directions.
        Some(2.0 * worst)
    }
}

impl Cell {
    fn new(corners: [&Corner; 4], user: Vec3, part: TilePart) -> Self {
        let legs = corners.iter().map(|corner| corner.legs).max().unwrap_or(LEAST_LEGS);
        let (bends, boxes) = ([[Vec4::ZERO; 4]; MOST_LEGS + 1], [Aabb::EMPTY; MOST_LEGS + 1]);
        let mut cell = Self { part, legs, bends, boxes };
        for k in 0..=legs {
            let [a, b, c, d] = corners.map(|corner| corner.bend(k, legs));
            let points = [(0, a), (1, b), (2, c), (3, d)].map(|(i, v)| user + corners[i].direction * v.w + v.xyz());
            cell.bends[k] = [a, b - a, c - a, (d - c) - (b - a)];
            cell.boxes[k] = around(&points);
        }
        cell
    }

    /// Position within this part of a position in the tile; `None` for positions in other parts.
    #[inline]
    pub fn within(&self, spot: [f32; 2]) -> Option<[f32; 2]> {
        let TilePart { parts, x, y } = self.part;
        let [u, v] = spot.map(|share| share * parts as f32);
        // Positions in a tile are below 1, so each lies in exactly one part.
        ((u as usize, v as usize) == (x, y)).then_some([u - x as f32, v - y as f32])
    }

    /// Position of the k-th bend of a ray relative to the user, from its direction and its position in the part.
    #[inline]
    pub fn bend(&self, k: usize, direction: Vec3, [x, y]: [f32; 2]) -> Vec3 {
        let [one, right, down, both] = self.bends[k];
        let v = one + right * x + (down + both * x) * y;
        direction * v.w + v.xyz()
    }

    /// Bounding box of the tile's rays between two bends.
    pub fn region(&self, from: usize, to: usize) -> Aabb {
        let mut region = Aabb::EMPTY;
        for bends in &self.boxes[from..=to] {
            region.extend(bends.min);
            region.extend(bends.max);
        }
        region
    }
}

/// Bounding box of the rays between the four corners of a tile, given in row order.
fn around(points: &[Vec3; 4]) -> Aabb {
    let mut region = Aabb::EMPTY;
    points.iter().for_each(|&point| region.extend(point));
    let widest = (points[3] - points[0]).abs().max((points[2] - points[1]).abs()).max_element();
    let margin = Vec3::splat(BULGE * widest);
    Aabb { min: region.min - margin, max: region.max + margin }
}

/// The bends that all corners have.
fn coarse(corner: &Corner) -> [Vec4; LEAST_LEGS + 1] {
    std::array::from_fn(|k| corner.bend(k * corner.legs / LEAST_LEGS, corner.legs))
}
