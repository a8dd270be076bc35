//! Bent rays of a whole view, interpolated from the rays through the corners of its tiles.
//!
//! A bend of a ray between the corners is P = U + s d + offset, where d is the ray's own direction. Only the positions
//! s and the offsets are interpolated; both change little across a tile. Where they change too much (steep rays, users
//! outside r₁), rays are bent one by one. A corner is bent when a tile first needs it, because most rays hit a surface
//! before they bend.

use std::sync::OnceLock;

use glam::{Vec4, Vec4Swizzles};

use super::super::tiles::TILE;
use super::cell::{Cell, TilePart, bounds};
use super::corner::{Corner, MIN_LEGS};
use crate::base::memory::try_list;
use crate::base::{Aabb, Result};
use crate::bend::RayCurve;
use crate::camera::{Camera, Rays};
use crate::morph::Morph;

/// Fraction of the tolerance for the chords between bends.
const CHORD_SHARE: f64 = 0.6;
/// Fraction of the tolerance for the interpolation between corners.
const INTERPOLATION_SHARE: f64 = 0.25;
/// Maximum error of a quadratic polynomial between the second and the third of its points, relative to the third
/// difference: the maximum of |t (t² − 1)|/6 is √3/27.
const QUADRATIC_ERROR: f64 = 0.064_150_029_909_958_42;

/// Bends at the corners of all tiles.
pub(super) struct Lattice {
    morph: Morph,
    rays: Rays,
    tolerance_px: f64,
    columns: usize,
    lines: usize,
    corners: Vec<OnceLock<Option<Corner>>>,
}

impl Lattice {
    /// Creates a lattice. The tolerance is in pixels, whose angular size depends on the ray.
    pub fn new(camera: &Camera, morph: &Morph, tolerance_px: f64) -> Result<Self> {
        let [columns, lines] = [camera.width, camera.height].map(|pixels| (pixels as usize).div_ceil(TILE) + 1);
        let corners = try_list((0..columns * lines).map(|_| OnceLock::new()))?;
        Ok(Self { morph: *morph, rays: camera.rays(), tolerance_px, columns, lines, corners })
    }

    /// Calls `trace` with the bends of a tile's rays: for each part of the tile if they change too much across the
    /// whole tile, and not at all if nothing lies near their bounding box. Returns false if rays must be bent one by
    /// one.
    pub fn for_each_cell(
        &self,
        (column, row): (usize, usize),
        is_near: impl Fn(&Aabb) -> bool,
        mut trace: impl FnMut(&Cell<'_>),
    ) -> bool {
        let Some(error) = self.linear_error(column, row) else { return false };
        let allowed = INTERPOLATION_SHARE * self.tolerance(column as f64, row as f64);
        let user = self.morph.user.as_vec3();
        let corner = |x, y| self.corner(column + x, row + y);
        if let (Some(a), Some(b), Some(c), Some(d)) = (corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)) {
            let corners = [a, b, c, d];
            let linear = || Cell::linear(corners, user, TilePart::WHOLE);
            let quadratic = if error <= allowed { None } else { self.quadratic_corners(column, row, allowed) };
            if error <= allowed || quadratic.is_some() {
                if is_near(&bounds(corners, user)) {
                    trace(&quadratic.map_or_else(linear, |(corners, first)| Cell::quadratic(corners, first, user)));
                }
                return true;
            }
        }
        // Second differences are proportional to the square of a part's side.
        let Some(parts) = [2, 4].into_iter().find(|&parts| error <= allowed * (parts * parts) as f64) else {
            return false;
        };
        let corners_per_row = parts + 1;
        let corner_at = |i: usize| {
            let position = |cell: usize, part: usize| cell as f64 + part as f64 / parts as f64;
            self.bend_corner(position(column, i % corners_per_row), position(row, i / corners_per_row))
        };
        let Some(corners) = (0..corners_per_row * corners_per_row).map(corner_at).collect::<Option<Vec<Corner>>>()
        else {
            return false;
        };
        for part in 0..parts * parts {
            let (x, y) = (part % parts, part / parts);
            let first = y * corners_per_row + x;
            let around = [first, first + 1, first + corners_per_row, first + corners_per_row + 1].map(|i| &corners[i]);
            trace(&Cell::linear(around, user, TilePart { parts, x, y }));
        }
        true
    }

    /// Returns the tolerance in radians at a position in units of tiles.
    fn tolerance(&self, column: f64, row: f64) -> f64 {
        self.tolerance_px * self.rays.pixel_angle(column * TILE as f64, row * TILE as f64)
    }

    fn bend_corner(&self, column: f64, row: f64) -> Option<Corner> {
        let direction = self.rays.ray(column * TILE as f64, row * TILE as f64).1;
        Corner::new(&RayCurve::new(&self.morph, direction), CHORD_SHARE * self.tolerance(column, row))
    }

    fn corner(&self, column: usize, row: usize) -> Option<&Corner> {
        self.corners[row * self.columns + column].get_or_init(|| self.bend_corner(column as f64, row as f64)).as_ref()
    }

    /// Returns the angle by which interpolated rays inside a tile miss their curve. The error of linear interpolation
    /// in each direction is an eighth of the second difference, which follows from the surrounding corners. `None` if
    /// corners cannot be compared.
    fn linear_error(&self, column: usize, row: usize) -> Option<f64> {
        let interior = |i: usize, count: usize| i.clamp(1, count.saturating_sub(2).max(1));
        if self.columns < 3 || self.lines < 3 {
            return None;
        }
        let (column, row) = (interior(column, self.columns), interior(row, self.lines));
        let middle = common_bends(self.corner(column, row)?);
        let mut worst = 0.0f64;
        for (x, y) in [(1, 0), (0, 1), (1, 1)] {
            let before = common_bends(self.corner(column - x, row - y)?);
            let after = common_bends(self.corner(column + x, row + y)?);
            let second = std::array::from_fn(|k| before[k] - 2.0 * middle[k] + after[k]);
            worst = worst.max(angular_error(&second, &before) / 8.0);
        }
        // The factor 2 adds the errors in both directions.
        Some(2.0 * worst)
    }

    /// Returns nine corners for biquadratic interpolation, which include the tile's, and the position of the tile's
    /// first corner among them. `None` if bends would miss their curves by more than the allowed angle: the miss is
    /// `QUADRATIC_ERROR` times the third differences, summed over both directions.
    fn quadratic_corners(&self, column: usize, row: usize, allowed: f64) -> Option<([&Corner; 9], [usize; 2])> {
        if self.columns < 4 || self.lines < 4 {
            return None;
        }
        let first = |i: usize, count: usize| i.clamp(1, count - 3) - 1;
        let (left, top) = (first(column, self.columns), first(row, self.lines));
        let row_bends = [0, 1, 2, 3].map(|n| self.corner(left + n, row).map(common_bends));
        let column_bends = [0, 1, 2, 3].map(|n| self.corner(column, top + n).map(common_bends));
        let mut worst = 0.0;
        for line in [row_bends, column_bends] {
            let [Some(a), Some(b), Some(c), Some(d)] = line else { return None };
            let third = std::array::from_fn(|k| d[k] - a[k] + 3.0 * (b[k] - c[k]));
            worst += QUADRATIC_ERROR * angular_error(&third, &a);
        }
        if worst > allowed {
            return None;
        }
        // The tile's own corners are the second and the third of three, or the first and the second.
        let (x, y) = (column.saturating_sub(1), row.saturating_sub(1));
        let mut corners = [self.corner(x, y)?; 9];
        for (n, corner) in corners.iter_mut().enumerate() {
            *corner = self.corner(x + n % 3, y + n / 3)?;
        }
        Some((corners, [column - x, row - y]))
    }
}

/// Returns the angle by which bends miss their curve if their offsets and positions have these errors. An error δs of
/// a bend's position along the ray moves it across the ray by δs times the curve's slope.
fn angular_error(errors: &[Vec4; MIN_LEGS + 1], bends: &[Vec4; MIN_LEGS + 1]) -> f64 {
    let angle = |k: usize| {
        let next = if k < MIN_LEGS { k + 1 } else { k - 1 };
        let chord = bends[next] - bends[k];
        let slope = chord.xyz().length() / chord.w.abs();
        let miss = errors[k].xyz().length() + slope * errors[k].w.abs();
        f64::from(miss) / f64::from(bends[k].w).max(f64::MIN_POSITIVE)
    };
    (0..=MIN_LEGS).map(angle).fold(0.0, f64::max)
}

/// Returns the bends that all corners have.
fn common_bends(corner: &Corner) -> [Vec4; MIN_LEGS + 1] {
    std::array::from_fn(|k| corner.bend(k * corner.legs / MIN_LEGS, corner.legs))
}
