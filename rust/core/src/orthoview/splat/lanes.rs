//! Projection of all splats of a block together: positions, ellipses and nearness.

use super::projector::{Projector, Rect, ViewProjection, sortable_bits};
use super::splats::{BLOCK, BORDER, Block, MIN_COSINE, SQUARED_RADIUS, Splats};
use crate::base::simd::vectorized;
use crate::render::Limits;

/// Number of splats per block.
pub(super) const LANES: usize = BLOCK * BLOCK;

/// Number of splats projected at once.
pub(super) const GROUP: usize = 16;

/// One number per splat.
type Lane<T = f32> = [[T; GROUP]; LANES / GROUP];

/// Value of `Lanes::slot` of a hidden splat.
const HIDDEN: i32 = -1;
/// Value of `Lanes::slot` of a splat that more than one pixel may show.
pub(super) const SEVERAL_PIXELS: i32 = -2;

/// Constants of all splats of a view.
#[derive(Clone, Copy, Debug)]
pub(super) struct Constants {
    /// Changes of the projector's X, Y, W per column, row and depth step.
    pub steps: [[f32; 3]; 3],
    /// Gradients of X, Y, W by world position, scaled by (radius of a ball) / (radius of a surfel's ellipse).
    pub gradients: [[f32; 3]; 3],
    /// Axes of the view; right and up in depth steps per pixel.
    pub axes: [[f32; 3]; 3],
    /// Scale of a normal's components to −1 … 1.
    pub scale: f32,
    /// Minimum W of visible splats.
    pub min_w: f32,
    is_parallel: bool,
}

impl Constants {
    pub fn new(splats: &Splats, projector: &Projector, projection: &ViewProjection) -> Self {
        let pitch = splats.pitch();
        let [right, up, toward] = splats.frame.axes();
        let radius = splats.ball_radius() / f64::from(SQUARED_RADIUS).sqrt();
        let single = |values: [f64; 3]| values.map(|value| value as f32);
        Self {
            steps: projection.steps.map(single),
            gradients: projector.rows.map(|row| single((row * radius).to_array())),
            axes: [right * (pitch.x / pitch.z), up * (pitch.y / pitch.z), toward].map(|axis| single(axis.to_array())),
            scale: 2.0 / ((1u32 << splats.format.normal_bits) - 2) as f32,
            min_w: projection.min_w as f32,
            is_parallel: projector.is_parallel,
        }
    }
}

/// Projected splats of a block. An offset p from the centre belongs to a splat if |inverse · p|² ≤ `SQUARED_RADIUS`.
#[derive(Clone, Debug, Default)]
pub(super) struct Lanes {
    pub place: [Lane; 2],
    /// Inverse axes, row by row.
    pub inverse: [Lane; 4],
    /// Nearness at the centre, and its changes along both axes.
    pub nearness: Lane,
    pub slope: [Lane; 2],
    /// Column and row of the centre's pixel.
    pub middle: [Lane<i32>; 2],
    /// First and last column and row of the pixels that may show it.
    pub first: [Lane<i32>; 2],
    pub last: [Lane<i32>; 2],
    /// Index of the centre's key if only that pixel shows the splat, as for most; else `HIDDEN` or `SEVERAL_PIXELS`.
    pub slot: Lane<i32>,
    /// Nearness in that key, as a sortable integer.
    pub order: Lane<u32>,
    column: Lane,
    row: Lane,
    depth: Lane,
    normal: [Lane; 2],
    /// Radius factor of a surfel; 0 for a ball.
    surfel: Lane,
}

impl Lanes {
    /// Loads the splats of a block; returns their number.
    #[inline]
    pub fn gather(&mut self, splats: &Splats, block: &Block) -> usize {
        let (mut shown, mut count) = (block.shown, 0);
        let texels = &splats.texels[block.first as usize..][..shown.count_ones() as usize];
        let radius = |bit: u32| match (block.surfels >> bit & 1, block.inner >> bit & 1) {
            (0, _) => 0.0,
            (_, 0) => BORDER,
            _ => 1.0,
        };
        for texel in texels {
            let bit = shown.trailing_zeros();
            let (group, n) = (count / GROUP, count % GROUP);
            self.column[group][n] = (bit % BLOCK as u32) as f32;
            self.row[group][n] = (bit / BLOCK as u32) as f32;
            self.depth[group][n] = f32::from(texel.depth());
            [self.normal[0][group][n], self.normal[1][group][n]] = texel.normal().map(f32::from);
            self.surfel[group][n] = radius(bit);
            shown &= shown - 1;
            count += 1;
        }
        count
    }

    /// Hides projected splats whose centres lie outside the limits.
    pub fn hide_outside(
        &mut self,
        count: usize,
        splats: &Splats,
        block: &Block,
        projector: &Projector,
        limits: &Limits,
    ) {
        let [left, top] = block.corner.map(f64::from);
        for (group, n) in (0..count).map(|n| (n / GROUP, n % GROUP)) {
            let pixel = [self.column[group][n], self.row[group][n]].map(f64::from);
            let depth = f64::from(self.depth[group][n]) - 0.5;
            let center = splats.place(left + pixel[0] + 0.5, top + pixel[1] + 0.5, depth);
            if !projector.is_seen(center, limits) {
                self.slot[group][n] = HIDDEN;
            }
        }
    }

    /// Projects the loaded splats to a part of the screen with `pitch` keys per row; `start` has X, Y, W at the centre
    /// of the block's first pixel, half a depth step in front of depth 0.
    pub fn project(&mut self, count: usize, start: [f32; 3], constants: &Constants, rect: &Rect, pitch: i32) {
        let groups = count.div_ceil(GROUP);
        if constants.is_parallel {
            project_parallel(self, groups, start, constants, rect, pitch);
        } else {
            project_perspective(self, groups, start, constants, rect, pitch);
        }
    }
}

vectorized! {
    fn project_perspective(
        lanes: &mut Lanes, groups: usize, start: [f32; 3], constants: &Constants, rect: &Rect, pitch: i32,
    ) = project_all::<false>;
    fn project_parallel(
        lanes: &mut Lanes, groups: usize, start: [f32; 3], constants: &Constants, rect: &Rect, pitch: i32,
    ) = project_all::<true>;
}

// Functions, because closures would not be compiled for the vectors of `vectorized!`.

#[inline(always)]
fn dot(axis: &[f32; 3], x: f32, y: f32, z: f32) -> f32 {
    axis[0] * x + axis[1] * y + axis[2] * z
}

/// Evaluates one of the functions X, Y, W at a position in the block.
#[inline(always)]
fn evaluate(start: f32, steps: &[[f32; 3]; 3], function: usize, column: f32, row: f32, depth: f32) -> f32 {
    start + column * steps[0][function] + row * steps[1][function] + depth * steps[2][function]
}

/// Returns the derivative of a position X/W, given the changes of X and W.
#[inline(always)]
fn position_derivative<const PARALLEL: bool>(change: f32, w_change: f32, place: f32, per_w: f32) -> f32 {
    if PARALLEL { change } else { (change - place * w_change) * per_w }
}

/// Returns the derivative of nearness, given the change of W.
#[inline(always)]
fn nearness_derivative<const PARALLEL: bool>(w_change: f32, per_w: f32) -> f32 {
    if PARALLEL { -w_change } else { -w_change * per_w * per_w }
}

/// Returns the squared half extent of a ball along an axis: the squared length of the gradient of X/W or Y/W.
#[inline(always)]
fn squared_ball_extent<const PARALLEL: bool>(gradients: &[[f32; 3]; 3], axis: usize, place: f32, per_w: f32) -> f32 {
    let (gradient, w_gradient) = (&gradients[axis], &gradients[2]);
    let x = position_derivative::<PARALLEL>(gradient[0], w_gradient[0], place, per_w);
    let y = position_derivative::<PARALLEL>(gradient[1], w_gradient[1], place, per_w);
    let z = position_derivative::<PARALLEL>(gradient[2], w_gradient[2], place, per_w);
    x * x + y * y + z * z
}

/// Returns three pixels along an axis: the first and the last whose centres lie within an extent, and the one that
/// contains the splat's centre, which always belongs to the range.
#[inline(always)]
fn pixels(place: f32, half: f32, low: f32, high: f32) -> (i32, i32, i32) {
    let middle = place.floor();
    let first = (place - half - 0.5).ceil().min(middle).max(low);
    let last = (place + half - 0.5).floor().max(middle).min(high);
    (first as i32, last as i32, middle as i32)
}

#[inline(always)]
fn project_all<const PARALLEL: bool>(
    lanes: &mut Lanes,
    groups: usize,
    start: [f32; 3],
    constants: &Constants,
    rect: &Rect,
    pitch: i32,
) {
    let (steps, gradients) = (&constants.steps, &constants.gradients);
    let [right, up, toward] = &constants.axes;
    let (left, top) = (rect.low[0] as f32, rect.low[1] as f32);
    let (rightmost, bottom) = (rect.high[0] as f32 - 1.0, rect.high[1] as f32 - 1.0);
    let radius = SQUARED_RADIUS.sqrt();
    for group in 0..groups {
        for n in 0..GROUP {
            let (column, row, depth) = (lanes.column[group][n], lanes.row[group][n], lanes.depth[group][n]);
            let w = evaluate(start[2], steps, 2, column, row, depth);
            let per_w = if PARALLEL { 1.0 } else { 1.0 / w };
            let x = evaluate(start[0], steps, 0, column, row, depth) * per_w;
            let y = evaluate(start[1], steps, 1, column, row, depth) * per_w;

            // The unnormalised normal, and the depth steps by which its plane falls per pixel.
            let (a, b) =
                (lanes.normal[0][group][n] * constants.scale - 1.0, lanes.normal[1][group][n] * constants.scale - 1.0);
            let c = 1.0 - a.abs() - b.abs();
            let fold = (-c).max(0.0);
            let (a, b) = (a - fold.copysign(a), b - fold.copysign(b));
            let length = (a * a + b * b + c * c).sqrt();
            let facing = 1.0 / dot(toward, a, b, c).max(MIN_COSINE * length);
            let (by_column, by_row) = (dot(right, a, b, c) * facing, -dot(up, a, b, c) * facing);
            let factor = lanes.surfel[group][n];
            let is_surfel = factor > 0.0;
            let (u0, v0) = (steps[0][0] + by_column * steps[2][0], steps[1][0] + by_row * steps[2][0]);
            let (u1, v1) = (steps[0][1] + by_column * steps[2][1], steps[1][1] + by_row * steps[2][1]);
            let (u2, v2) = (steps[0][2] + by_column * steps[2][2], steps[1][2] + by_row * steps[2][2]);

            // Axes of the ellipse in the picture.
            let (ux, vx) = (
                position_derivative::<PARALLEL>(u0, u2, x, per_w) * factor,
                position_derivative::<PARALLEL>(v0, v2, x, per_w) * factor,
            );
            let (uy, vy) = (
                position_derivative::<PARALLEL>(u1, u2, y, per_w) * factor,
                position_derivative::<PARALLEL>(v1, v2, y, per_w) * factor,
            );
            let (u_near, v_near) = (
                nearness_derivative::<PARALLEL>(u2, per_w) * factor,
                nearness_derivative::<PARALLEL>(v2, per_w) * factor,
            );
            let (ball_x, ball_y) = (
                squared_ball_extent::<PARALLEL>(gradients, 0, x, per_w),
                squared_ball_extent::<PARALLEL>(gradients, 1, y, per_w),
            );
            // Half extents along both axes, divided by the radius. Surfels and balls share the square roots and
            // divisions, which are the slowest steps.
            let wide = if is_surfel { ux * ux + vx * vx } else { ball_x }.sqrt();
            let high = if is_surfel { uy * uy + vy * vy } else { ball_y }.sqrt();

            // A surfel seen edge-on is a line, shown only by its centre's pixel.
            let determinant = if is_surfel { ux * vy - vx * uy } else { wide * high };
            let is_flat =
                is_surfel && determinant.abs() <= f32::EPSILON * (ux.abs() + vx.abs()) * (uy.abs() + vy.abs());
            let edge = if is_flat { f32::MAX } else { 1.0 / determinant };
            let i00 = if is_surfel { vy } else { high } * edge;
            let i01 = if is_surfel { -vx * edge } else { 0.0 };
            let i10 = if is_surfel { -uy * edge } else { 0.0 };
            let i11 = if is_surfel { ux } else { wide } * edge;
            (lanes.inverse[0][group][n], lanes.inverse[1][group][n]) = (i00, i01);
            (lanes.inverse[2][group][n], lanes.inverse[3][group][n]) = (i10, i11);
            let is_sloped = is_surfel && !is_flat;
            let slope = [
                if is_sloped { u_near * i00 + v_near * i10 } else { 0.0 },
                if is_sloped { u_near * i01 + v_near * i11 } else { 0.0 },
            ];
            (lanes.slope[0][group][n], lanes.slope[1][group][n]) = (slope[0], slope[1]);
            let nearness = if PARALLEL { -w } else { per_w };
            lanes.nearness[group][n] = nearness;
            (lanes.place[0][group][n], lanes.place[1][group][n]) = (x, y);

            let extent = if is_flat { 0.0 } else { radius };
            // Near the eye the linear approximation at the centre would stretch ellipses across the picture.
            let margin = w - constants.min_w;
            let reach = if PARALLEL { 0.0 } else { radius * factor };
            let is_shown = margin >= 0.0 && reach * reach * (u2 * u2 + v2 * v2) <= margin * margin;
            let (first_x, last_x, middle_x) = pixels(x, extent * wide, left, rightmost);
            let (first_y, last_y, middle_y) = pixels(y, extent * high, top, bottom);
            (lanes.first[0][group][n], lanes.last[0][group][n], lanes.middle[0][group][n]) =
                (first_x, last_x, middle_x);
            (lanes.first[1][group][n], lanes.last[1][group][n], lanes.middle[1][group][n]) =
                (first_y, last_y, middle_y);

            let is_one_pixel = first_x == middle_x && last_x == middle_x && first_y == middle_y && last_y == middle_y;
            let is_hidden = !is_shown || first_x > last_x || first_y > last_y;
            let slot = (middle_y - rect.low[1]) * pitch + (middle_x - rect.low[0]);
            lanes.slot[group][n] = if is_hidden {
                HIDDEN
            } else if is_one_pixel {
                slot
            } else {
                SEVERAL_PIXELS
            };
            let (offset_x, offset_y) = (middle_x as f32 + 0.5 - x, middle_y as f32 + 0.5 - y);
            let (p, q) = (i00 * offset_x + i01 * offset_y, i10 * offset_x + i11 * offset_y);
            let is_inside = p * p + q * q <= SQUARED_RADIUS;
            let nearness = if is_inside { nearness + slope[1] * offset_y + slope[0] * offset_x } else { nearness };
            lanes.order[group][n] = sortable_bits(nearness);
        }
    }
}
