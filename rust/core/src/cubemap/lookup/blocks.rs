//! Kernels over blocks of directions, which the compiler vectorises. Between the kernels, texels are read one by one,
//! because gather instructions are no faster and on some machines much slower.

use super::super::faces::is_known;
use crate::base::Real;
use crate::base::simd::vectorized;

/// Number of directions in a block. The block's temporaries fit in the first-level cache.
pub const BLOCK: usize = 64;

/// Minimum weight of a texel that counts for minima and maxima. In the largest pictures, 32,768 texels across, rounding
/// moves a position by up to 2e-11 texels, so lower weights may be mere rounding.
pub const MIN_WEIGHT: f64 = 1e-10;

/// 2⁵². Adding it to a number leaves the nearest integer in the low bits. This replaces a cast from float to integer,
/// which saturates in Rust and therefore has no vector instruction.
const UNITS: f64 = 4_503_599_627_370_496.0;

/// One value for each direction of a block.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct BlockValues<T>(pub [T; BLOCK]);

/// Points where a block's directions intersect the cube.
struct CubePoints {
    face: BlockValues<f64>,
    u: BlockValues<f64>,
    v: BlockValues<f64>,
}

/// Positions of a block's directions between texel centres.
#[derive(Debug)]
pub struct Positions {
    /// Number of the last texel whose centre lies above and to the left; it has neighbours to the right and below.
    pub first: BlockValues<u32>,
    /// Distance to the right of the first texel's centre, 0 to 1 texels.
    pub s: BlockValues<f64>,
    /// Distance below the first texel's centre, 0 to 1 texels.
    pub t: BlockValues<f64>,
    /// 1 if the filter needs texels beyond the face or picture; then the other fields are undefined.
    pub seam: BlockValues<u8>,
}

/// Region of a face in which a filter reads only that face's texels.
#[derive(Clone, Copy, Debug)]
pub struct Inner {
    /// Maximum |u| and |v|.
    limit: f64,
    /// Minimum and maximum row and column of `Positions::first`.
    first_range: [f64; 2],
}

impl Inner {
    /// Creates the region for a filter that reads `before` texels before `Positions::first` and `after` after it.
    pub fn new(size: u32, before: u32, after: u32) -> Self {
        if size <= before + after {
            return Self { limit: -1.0, first_range: [0.0; 2] };
        }
        let limit = 1.0 - f64::from(1 + 2 * before) * (1.0 / f64::from(size));
        Self { limit, first_range: [f64::from(before), f64::from(size - 1 - after)] }
    }
}

impl Positions {
    /// Creates positions to be overwritten.
    pub fn new() -> Self {
        Self {
            first: BlockValues([0; BLOCK]),
            s: BlockValues([0.0; BLOCK]),
            t: BlockValues([0.0; BLOCK]),
            seam: BlockValues([0; BLOCK]),
        }
    }
}

vectorized! {
    /// Finds the texel that each direction hits. Returns the number of directions that are zero or not finite.
    pub fn find_texels<D: Real>(directions: &[[D; 3]; BLOCK], size: u32, texel: &mut BlockValues<u32>) -> u32
        = find_texels_kernel;
    /// Finds each direction's position between texels. Returns the number of directions that are zero or not finite.
    pub fn locate<D: Real>(directions: &[[D; 3]; BLOCK], size: u32, inner: Inner, out: &mut Positions) -> u32
        = locate_kernel;
    /// Writes the weighted mean of each direction's four texels.
    pub fn mix<T: Real>(texels: &[BlockValues<T>; 4], weights: &[BlockValues<f64>; 4], out: &mut BlockValues<T>)
        = mix_kernel;
    /// Writes the minimum of the texels whose weight is above `MIN_WEIGHT`; NaN if all are NaN.
    pub fn least<T: Real>(texels: &[BlockValues<T>; 4], weights: &[BlockValues<f64>; 4], out: &mut BlockValues<T>)
        = extreme::<T, false>;
    /// Writes the maximum of the texels whose weight is above `MIN_WEIGHT`; NaN if all are NaN.
    pub fn greatest<T: Real>(texels: &[BlockValues<T>; 4], weights: &[BlockValues<f64>; 4], out: &mut BlockValues<T>)
        = extreme::<T, true>;
    /// Adds the weighted mean of a row of four texels, times the row's weight `down`, to the sums.
    pub fn add_row<T: Real>(
        texels: &[BlockValues<T>; 4],
        across: &[BlockValues<f64>; 4],
        down: &BlockValues<f64>,
        sums: &mut BlockValues<f64>,
    ) = add_row_kernel;
    /// Writes the minimum of each 2 × 2 values of two rows; NaN if all four are NaN.
    pub fn halve_least<T: Real>(above: &[T], below: &[T], out: &mut [T]) = halve_extreme::<T, false>;
    /// Writes the maximum of each 2 × 2 values of two rows; NaN if all four are NaN.
    pub fn halve_greatest<T: Real>(above: &[T], below: &[T], out: &mut [T]) = halve_extreme::<T, true>;
    /// Writes the weighted means of each 2 × 2 values of two rows.
    pub fn halve<T: Real>(above: &[T], below: &[T], weights: [&[f64]; 2], out: &mut [T]) = halve_kernel;
    /// Writes the bilinear weights of the four texels around each direction, row by row.
    pub fn bilinear(positions: &Positions, weights: &mut [BlockValues<f64>; 4]) = bilinear_kernel;
    /// Writes `keys` of each fraction.
    pub fn cubic(fraction: &BlockValues<f64>, weights: &mut [BlockValues<f64>; 4]) = cubic_kernel;
}

/// Same as `face_from_direction`, without branches. Returns the number of directions that are zero or not finite.
#[inline(always)]
fn find_cube_points<D: Real>(directions: &[[D; 3]; BLOCK], out: &mut CubePoints) -> u32 {
    let mut d = [BlockValues([0.0f64; BLOCK]); 3];
    for (i, direction) in directions.iter().enumerate() {
        d[0].0[i] = direction[0].wide();
        d[1].0[i] = direction[1].wide();
        d[2].0[i] = direction[2].wide();
    }
    let mut invalid_count = 0u64;
    for i in 0..BLOCK {
        let (x, y, z) = (d[0].0[i], d[1].0[i], d[2].0[i]);
        let (ax, ay, az) = (x.abs(), y.abs(), z.abs());
        let not_x = (ax < ay) | (ax < az);
        let is_z = not_x & (ay < az);
        let major = if is_z { z } else { y };
        let major = if not_x { major } else { x };
        let sign = 1.0f64.copysign(major);
        let right = if is_z { sign * x } else { x };
        let right = if not_x { right } else { -sign * z };
        let down = if not_x & !is_z { sign * z } else { -y };
        let length = major.abs();
        let axis = if is_z { 4.0 } else { 2.0 };
        let axis = if not_x { axis } else { 0.0 };
        out.face.0[i] = axis + if major < 0.0 { 1.0 } else { 0.0 };
        out.u.0[i] = right / length;
        out.v.0[i] = down / length;
        // 0 × ∞ and 0 × NaN are NaN, not 0.
        let finite = (x * 0.0 + y * 0.0) + z * 0.0 == 0.0;
        invalid_count += u64::from(!(finite & (length > 0.0)));
    }
    invalid_count as u32
}

impl CubePoints {
    #[inline(always)]
    fn new() -> Self {
        Self { face: BlockValues([0.0; BLOCK]), u: BlockValues([0.0; BLOCK]), v: BlockValues([0.0; BLOCK]) }
    }
}

/// Returns the integer part of `position`, clamped to `low..=high`; `low` for NaN.
#[inline(always)]
pub(in crate::cubemap) fn clamped_floor(position: f64, low: f64, high: f64) -> f64 {
    let at_least_low = if position > low { position } else { low };
    let clamped = if at_least_low < high { at_least_low } else { high };
    let nearest = (clamped + UNITS) - UNITS;
    nearest - if nearest > clamped { 1.0 } else { 0.0 }
}

/// Converts an integer below 2³² to u32.
#[inline(always)]
pub(in crate::cubemap) fn index(number: f64) -> u32 {
    (number + UNITS).to_bits() as u32
}

/// Same as `texel_from_direction`, for a block.
#[inline(always)]
fn find_texels_kernel<D: Real>(directions: &[[D; 3]; BLOCK], size: u32, texel: &mut BlockValues<u32>) -> u32 {
    let mut points = CubePoints::new();
    let invalid_count = find_cube_points(directions, &mut points);
    let edge = f64::from(size);
    for i in 0..BLOCK {
        let column = clamped_floor((points.u.0[i] + 1.0) * 0.5 * edge, 0.0, edge - 1.0);
        let row = clamped_floor((points.v.0[i] + 1.0) * 0.5 * edge, 0.0, edge - 1.0);
        texel.0[i] = index((points.face.0[i] * edge + row) * edge + column);
    }
    invalid_count
}

/// Same as `Taps::new`, for directions whose texels lie on one face.
#[inline(always)]
fn locate_kernel<D: Real>(directions: &[[D; 3]; BLOCK], size: u32, inner: Inner, out: &mut Positions) -> u32 {
    let mut points = CubePoints::new();
    let invalid_count = find_cube_points(directions, &mut points);
    let edge = f64::from(size);
    let [low, high] = inner.first_range;
    for i in 0..BLOCK {
        let (u, v) = (points.u.0[i], points.v.0[i]);
        let x = (u + 1.0) * 0.5 * edge - 0.5;
        let y = (v + 1.0) * 0.5 * edge - 0.5;
        let (column, row) = (clamped_floor(x, low, high), clamped_floor(y, low, high));
        let (s, t) = (x - column, y - row);
        // Clamped, because rounding may move a position beyond the outermost centres.
        let (s, t) = (if s > 0.0 { s } else { 0.0 }, if t > 0.0 { t } else { 0.0 });
        out.s.0[i] = if s < 1.0 { s } else { 1.0 };
        out.t.0[i] = if t < 1.0 { t } else { 1.0 };
        out.first.0[i] = index((points.face.0[i] * edge + row) * edge + column);
        // With NaN the comparison is false, so NaN counts as a seam.
        let inside = (u.abs() <= inner.limit) & (v.abs() <= inner.limit);
        out.seam.0[i] = u8::from(!inside);
    }
    invalid_count
}

#[inline(always)]
fn bilinear_kernel(positions: &Positions, weights: &mut [BlockValues<f64>; 4]) {
    for i in 0..BLOCK {
        let (s, t) = (positions.s.0[i], positions.t.0[i]);
        weights[0].0[i] = (1.0 - s) * (1.0 - t);
        weights[1].0[i] = s * (1.0 - t);
        weights[2].0[i] = (1.0 - s) * t;
        weights[3].0[i] = s * t;
    }
}

#[inline(always)]
fn cubic_kernel(fraction: &BlockValues<f64>, weights: &mut [BlockValues<f64>; 4]) {
    for i in 0..BLOCK {
        let four = keys(fraction.0[i]);
        for k in 0..4 {
            weights[k].0[i] = four[k];
        }
    }
}

/// Returns the cubic weights of four texels at a fraction s between the second and the third: Keys, "Cubic convolution
/// interpolation for digital image processing" (1981), Eq. 4 with a = −1/2.
#[inline(always)]
pub fn keys(s: f64) -> [f64; 4] {
    [
        ((1.0 - 0.5 * s) * s - 0.5) * s,
        (1.5 * s - 2.5) * s * s + 1.0,
        ((2.0 - 1.5 * s) * s + 0.5) * s,
        (0.5 * s - 0.5) * s * s,
    ]
}

/// Skips texels without weight, because 0 × ∞ is NaN.
#[inline(always)]
fn mix_kernel<T: Real>(texels: &[BlockValues<T>; 4], weights: &[BlockValues<f64>; 4], out: &mut BlockValues<T>) {
    for i in 0..BLOCK {
        let mut term = [0.0; 4];
        for k in 0..4 {
            let weight = weights[k].0[i];
            let product = texels[k].0[i].wide() * weight;
            term[k] = if weight > 0.0 { product } else { 0.0 };
        }
        out.0[i] = T::narrow((term[0] + term[1]) + (term[2] + term[3]));
    }
}

#[inline(always)]
fn extreme<T: Real, const MAX: bool>(
    texels: &[BlockValues<T>; 4],
    weights: &[BlockValues<f64>; 4],
    out: &mut BlockValues<T>,
) {
    for i in 0..BLOCK {
        let mut best = T::narrow(f64::NAN);
        for k in 0..4 {
            let texel = texels[k].0[i];
            let is_better = if MAX { texel > best } else { texel < best };
            let is_preferred = (weights[k].0[i] > MIN_WEIGHT) & (!is_known(best) | is_better);
            best = if is_preferred { texel } else { best };
        }
        out.0[i] = best;
    }
}

#[inline(always)]
fn add_row_kernel<T: Real>(
    texels: &[BlockValues<T>; 4],
    across: &[BlockValues<f64>; 4],
    down: &BlockValues<f64>,
    sums: &mut BlockValues<f64>,
) {
    for i in 0..BLOCK {
        let mut term = [0.0; 4];
        for k in 0..4 {
            term[k] = texels[k].0[i].wide() * across[k].0[i];
        }
        sums.0[i] += ((term[0] + term[3]) + (term[1] + term[2])) * down.0[i];
    }
}

#[inline(always)]
fn halve_kernel<T: Real>(above: &[T], below: &[T], weights: [&[f64]; 2], out: &mut [T]) {
    let count = out.len();
    let (above, below) = (&above[..2 * count], &below[..2 * count]);
    let (w_above, w_below) = (&weights[0][..2 * count], &weights[1][..2 * count]);
    for i in 0..count {
        let (a, b) = (above[2 * i].wide() * w_above[2 * i], above[2 * i + 1].wide() * w_above[2 * i + 1]);
        let (c, d) = (below[2 * i].wide() * w_below[2 * i], below[2 * i + 1].wide() * w_below[2 * i + 1]);
        let total = (w_above[2 * i] + w_above[2 * i + 1]) + (w_below[2 * i] + w_below[2 * i + 1]);
        out[i] = T::narrow(((a + b) + (c + d)) / total);
    }
}

#[inline(always)]
fn halve_extreme<T: Real, const MAX: bool>(above: &[T], below: &[T], out: &mut [T]) {
    let count = out.len();
    let (above, below) = (&above[..2 * count], &below[..2 * count]);
    for i in 0..count {
        let mut best = above[2 * i];
        for other in [above[2 * i + 1], below[2 * i], below[2 * i + 1]] {
            let is_better = if MAX { other > best } else { other < best };
            best = if is_better | !is_known(best) { other } else { best };
        }
        out[i] = best;
    }
}
