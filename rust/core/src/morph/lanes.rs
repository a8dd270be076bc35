//! Blocks of points, coordinate by coordinate.

use std::ops::{Add, Div, Mul, Sub};

/// Points that share a decision; their temporaries stay in the first-level cache.
pub(super) const BLOCK: usize = 64;

/// Float32 or float64.
pub(super) trait Real:
    Copy + PartialOrd + Send + Sync + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    const ZERO: Self;
    const ONE: Self;
    /// Relative error of squared distances that two roundings of each coordinate can cause, generously.
    const DOUBT: f64;
    /// Squares of lengths within these bounds neither overflow nor lose digits.
    const LENGTHS: [f64; 2];
    fn root(self) -> Self;
    fn wide(self) -> f64;
    fn narrow(value: f64) -> Self;
}

macro_rules! real {
    ($float:ty, $doubt:expr, $lengths:expr) => {
        impl Real for $float {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const DOUBT: f64 = $doubt;
            const LENGTHS: [f64; 2] = $lengths;
            #[inline(always)]
            fn root(self) -> Self {
                self.sqrt()
            }
            #[inline(always)]
            fn wide(self) -> f64 {
                f64::from(self)
            }
            #[inline(always)]
            fn narrow(value: f64) -> Self {
                value as Self
            }
        }
    };
}

real!(f32, 1e-6, [1e-3, 1e8]);
real!(f64, 2e-15, [1e-50, 1e50]);

/// Coordinates of a block by axis.
pub(super) type Lanes<T> = [[T; BLOCK]; 3];

#[inline(always)]
pub(super) fn gather<T: Real>(points: &[[T; 3]; BLOCK]) -> Lanes<T> {
    let mut lanes = [[T::ZERO; BLOCK]; 3];
    for (i, point) in points.iter().enumerate() {
        lanes[0][i] = point[0];
        lanes[1][i] = point[1];
        lanes[2][i] = point[2];
    }
    lanes
}

#[inline(always)]
pub(super) fn scatter<T: Real>(lanes: &Lanes<T>, points: &mut [[T; 3]; BLOCK]) {
    for (i, point) in points.iter_mut().enumerate() {
        *point = [lanes[0][i], lanes[1][i], lanes[2][i]];
    }
}
