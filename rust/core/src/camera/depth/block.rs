//! Blocks of a row of a depth buffer, which the compiler turns into vectors.

use crate::base::simd::widest;

/// Pixels of a block.
pub(super) const BLOCK: usize = 64;

/// A row of a view's depth buffer.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    /// Tangents x, y of its first pixel.
    pub start: [f64; 2],
    /// How they change from pixel to pixel.
    pub step: [f64; 2],
    /// Square of the directions' component along the axis.
    pub squared: f64,
    /// Inverse distance along the axis where the buffer is 0 and 1; the distance itself for parallel rays.
    pub ends: [f64; 2],
    /// Value where nothing was drawn, 0 or 1.
    pub background: f64,
    /// Whether all rays are parallel.
    pub parallel: bool,
}

/// A value that depth buffers hold: from 0 to `MOST`.
pub trait Depth: Copy + Into<f64> + Send + Sync + 'static {
    /// The type of its range.
    type Range: Copy + Default + Into<f64> + Send + Sync;
    /// What stands for 1.
    const MOST: f64;
    /// The ranges of a block.
    #[doc(hidden)]
    #[allow(private_interfaces)]
    fn ranges(line: &Line, column: i32, depth: &[Self; BLOCK], ranges: &mut [Self::Range; BLOCK]) -> bool;
}

/// Float32 or float64.
pub trait Real: Depth<Range = Self> + Default {
    /// Ranges this share before the near plane lie on it.
    const NEARLY: f64;
    /// The depth of a block.
    #[doc(hidden)]
    #[allow(private_interfaces)]
    fn depths(line: &Line, column: i32, ranges: &[Self; BLOCK], depth: &mut [Self; BLOCK]) -> bool;
}

/// Rounding to the type of results.
trait Narrow: Copy {
    fn narrow(value: f64) -> Self;
}

impl Narrow for f32 {
    #[inline(always)]
    fn narrow(value: f64) -> Self {
        value as Self
    }
}

impl Narrow for f64 {
    #[inline(always)]
    fn narrow(value: f64) -> Self {
        value
    }
}

/// Square of the length of the direction through a column whose component along the axis is 1.
#[inline(always)]
fn secant_squared(line: &Line, column: i32) -> f64 {
    let column = f64::from(column);
    let (x, y) = (line.start[0] + column * line.step[0], line.start[1] + column * line.step[1]);
    line.squared + x * x + y * y
}

#[inline(always)]
fn ranges<T: Depth<Range: Narrow>>(
    line: &Line,
    column: i32,
    depth: &[T; BLOCK],
    ranges: &mut [T::Range; BLOCK],
) -> bool {
    // The ends for whole numbers: what stands for 1 is divided by once.
    let ends = [line.ends[0] / T::MOST, line.ends[1] / T::MOST];
    let background = line.background * T::MOST;
    let mut refused = 0u32;
    for i in 0..BLOCK {
        let value: f64 = depth[i].into();
        let along = ends[0] * (T::MOST - value) + ends[1] * value;
        let range = if line.parallel { along } else { secant_squared(line, column + i as i32).sqrt() / along };
        // Nothing was drawn, or farther away than any place: a matrix may have its far plane there.
        let range = if value == background || along < 0.0 { f64::INFINITY } else { range };
        let wrong = !(value >= 0.0 && value <= T::MOST);
        refused |= u32::from(wrong);
        ranges[i] = T::Range::narrow(if wrong { f64::NAN } else { range });
    }
    refused != 0
}

#[inline(always)]
fn depths<T: Real + Narrow>(line: &Line, column: i32, ranges: &[T; BLOCK], depth: &mut [T; BLOCK]) -> bool {
    let scale = 1.0 / (line.ends[1] - line.ends[0]);
    // Depth rises from the background's end to the other one, which is the near plane.
    let near = 1.0 - line.background;
    let slack = T::NEARLY * (line.ends[0].max(line.ends[1]) * scale).abs();
    let mut refused = 0u32;
    for i in 0..BLOCK {
        let range: f64 = ranges[i].into();
        let along = if line.parallel { range } else { secant_squared(line, column + i as i32).sqrt() / range };
        let value = (along - line.ends[0]) * scale;
        // Distance from the near plane's value, towards the far one.
        let behind = if near == 0.0 { value } else { 1.0 - value };
        let wrong = !(range >= 0.0 && behind >= -slack);
        refused |= u32::from(wrong);
        let value = if behind >= 1.0 || range == f64::INFINITY { line.background } else { value.clamp(0.0, 1.0) };
        depth[i] = T::narrow(if wrong { f64::NAN } else { value });
    }
    refused != 0
}

macro_rules! stored {
    ($value:ty, $range:ty, $most:expr, $ranges:ident) => {
        widest! {
            fn $ranges(line: &Line, column: i32, depth: &[$value; BLOCK], found: &mut [$range; BLOCK]) -> bool
                = ranges::<$value>;
        }
        impl Depth for $value {
            type Range = $range;
            const MOST: f64 = $most;
            #[allow(private_interfaces)]
            fn ranges(line: &Line, column: i32, depth: &[Self; BLOCK], ranges: &mut [$range; BLOCK]) -> bool {
                $ranges(line, column, depth, ranges)
            }
        }
    };
}

macro_rules! real {
    ($float:ty, $nearly:expr, $depths:ident) => {
        widest! {
            fn $depths(line: &Line, column: i32, ranges: &[$float; BLOCK], depth: &mut [$float; BLOCK]) -> bool
                = depths::<$float>;
        }
        impl Real for $float {
            const NEARLY: f64 = $nearly;
            #[allow(private_interfaces)]
            fn depths(line: &Line, column: i32, ranges: &[Self; BLOCK], depth: &mut [Self; BLOCK]) -> bool {
                $depths(line, column, ranges, depth)
            }
        }
    };
}

stored!(f32, f32, 1.0, ranges_f32);
stored!(f64, f64, 1.0, ranges_f64);
stored!(u16, f32, 65_535.0, ranges_u16);
// Of 24 bits, the only whole numbers beyond 16 bits that depth buffers have.
stored!(u32, f32, 16_777_215.0, ranges_u24);
// Two roundings of the range.
real!(f32, 1.2e-7, depths_f32);
real!(f64, 1e-14, depths_f64);
