//! Kernels over blocks of a depth buffer's rows, written so that the compiler vectorises them.

use crate::base::Real;
use crate::base::simd::vectorized;

/// Number of pixels in a block.
pub const BLOCK: usize = 64;

/// A row of a view's depth buffer.
#[derive(Clone, Copy, Debug)]
pub struct DepthRow {
    /// Tangents x, y of the direction through the first pixel's centre.
    pub start: [f64; 2],
    /// Change of the tangents from one pixel to the next.
    pub step: [f64; 2],
    /// Inverse distances along the viewing axis at depths 0 and 1; distances for parallel rays.
    pub ends: [f64; 2],
    /// Depth of pixels where nothing was drawn: 0 or 1.
    pub background: f64,
    /// Whether all rays are parallel.
    pub parallel: bool,
}

/// Storage type of depth buffers, with values from 0 to `MAX`.
pub trait Depth: Copy + Into<f64> + Send + Sync + 'static {
    /// Type of the ranges.
    type Range: Real + Into<f64>;
    /// Stored value of depth 1.
    const MAX: f64;
    /// Description of the accepted values, for messages.
    const EXPECTED: &'static str;
}

/// Types of ranges that can be converted to depths: float32 or float64.
pub trait Ranged: Depth<Range = Self> + Real {
    /// Distance by which a point may lie in front of the near plane, relative to the plane's distance.
    const NEAR_TOLERANCE: f64;
}

vectorized! {
    /// Writes the ranges of a block. Returns true if a depth is invalid; its range is NaN.
    pub fn ranges<T: Depth>(row: &DepthRow, column: i32, depth: &[T; BLOCK], ranges: &mut [T::Range; BLOCK]) -> bool
        = ranges_kernel;
    /// Writes the depths of a block. Returns true if a range is negative or before the near plane; its depth is NaN.
    pub fn depths<T: Ranged>(row: &DepthRow, column: i32, ranges: &[T; BLOCK], depth: &mut [T; BLOCK]) -> bool
        = depths_kernel;
}

/// A block of numbers, aligned for vector loads.
#[repr(align(64))]
struct PixelLanes([f64; BLOCK]);

/// Writes the length of the direction through each column of a block. Directions have length 1 along the viewing axis.
#[inline(always)]
fn secants(row: &DepthRow, column: i32, secants: &mut PixelLanes) {
    let [[x, y], [dx, dy]] = [row.start, row.step];
    for i in 0..BLOCK {
        let column = f64::from(column + i as i32);
        let (x, y) = (x + column * dx, y + column * dy);
        secants.0[i] = (1.0 + x * x + y * y).sqrt();
    }
}

// Both kernels use `&` and `|` instead of `&&` and `||`, whose branches prevent vectorisation.

#[inline(always)]
fn ranges_kernel<T: Depth>(row: &DepthRow, column: i32, depth: &[T; BLOCK], ranges: &mut [T::Range; BLOCK]) -> bool {
    // Dividing by `MAX` here saves a division per pixel.
    let [low, high] = [row.ends[0] / T::MAX, row.ends[1] / T::MAX];
    let background = row.background * T::MAX;
    let mut lengths = PixelLanes([1.0; BLOCK]);
    if !row.parallel {
        secants(row, column, &mut lengths);
    }
    let mut refused = 0u64;
    for i in 0..BLOCK {
        let value: f64 = depth[i].into();
        let axial = low * (T::MAX - value) + high * value;
        let range = if row.parallel { axial } else { lengths.0[i] / axial };
        // Background, or a point beyond infinity, where a projection matrix may place its far plane.
        let is_background = (value == background) | (axial < 0.0);
        let range = if is_background { f64::INFINITY } else { range };
        let is_valid = (value >= 0.0) & (value <= T::MAX);
        refused |= u64::from(!is_valid);
        ranges[i] = T::Range::narrow(if is_valid { range } else { f64::NAN });
    }
    refused != 0
}

#[inline(always)]
fn depths_kernel<T: Ranged>(row: &DepthRow, column: i32, ranges: &[T; BLOCK], depth: &mut [T; BLOCK]) -> bool {
    let scale = 1.0 / (row.ends[1] - row.ends[0]);
    let slack = T::NEAR_TOLERANCE * (row.ends[0].max(row.ends[1]) * scale).abs();
    // Depth rises or falls from the near to the far plane.
    let (rise, near) = if row.background == 1.0 { (1.0, 0.0) } else { (-1.0, 1.0) };
    let mut lengths = PixelLanes([1.0; BLOCK]);
    if !row.parallel {
        secants(row, column, &mut lengths);
    }
    let mut refused = 0u64;
    for i in 0..BLOCK {
        let range = ranges[i].wide();
        let axial = if row.parallel { range } else { lengths.0[i] / range };
        let value = (axial - row.ends[0]) * scale;
        let behind = (value - near) * rise;
        let is_valid = (range >= 0.0) & (behind >= -slack);
        refused |= u64::from(!is_valid);
        let clamped = if value < 0.0 { 0.0 } else { value };
        let clamped = if clamped > 1.0 { 1.0 } else { clamped };
        let empty = (behind >= 1.0) | (range == f64::INFINITY);
        let value = if empty { row.background } else { clamped };
        depth[i] = T::narrow(if is_valid { value } else { f64::NAN });
    }
    refused != 0
}

macro_rules! stored {
    ($($value:ty, $range:ty, $max:expr, $expected:expr);*) => {$(
        impl Depth for $value {
            type Range = $range;
            const MAX: f64 = $max;
            const EXPECTED: &'static str = $expected;
        }
    )*};
}

// u32 holds 24-bit depth, the only integer format with more than 16 bits.
stored!(
    f32, f32, 1.0, "values from 0 to 1";
    f64, f64, 1.0, "values from 0 to 1";
    u16, f32, 65_535.0, "whole numbers from 0 to 65535";
    u32, f32, 16_777_215.0, "whole numbers from 0 to 16777215"
);

impl Ranged for f32 {
    /// Two roundings of the range.
    const NEAR_TOLERANCE: f64 = 1.2e-7;
}

impl Ranged for f64 {
    /// 45 times its machine epsilon.
    const NEAR_TOLERANCE: f64 = 1e-14;
}
