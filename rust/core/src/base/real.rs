//! The floating-point types of the arrays that kernels read and write.

use num_traits::Float;

/// float32 or float64.
pub trait Real: Float + Default + Send + Sync + 'static {
    /// Maximum relative error of rounding a float64 to this type.
    const SLACK: f64;
    /// Converts to float64, exactly.
    fn wide(self) -> f64;
    /// Rounds a float64 once to this type.
    fn narrow(value: f64) -> Self;
    /// Returns a b + c; rounded once if `FUSED`, otherwise twice.
    fn fuse<const FUSED: bool>(a: Self, b: Self, c: Self) -> Self;
}

macro_rules! real {
    ($($float:ty: $slack:expr),*) => {$(
        impl Real for $float {
            const SLACK: f64 = $slack;
            #[inline(always)]
            fn wide(self) -> f64 {
                f64::from(self)
            }
            #[inline(always)]
            fn narrow(value: f64) -> Self {
                value as Self
            }
            #[inline(always)]
            fn fuse<const FUSED: bool>(a: Self, b: Self, c: Self) -> Self {
                if FUSED { a.mul_add(b, c) } else { a * b + c }
            }
        }
    )*};
}

real!(f32: f32::EPSILON as f64 / 2.0, f64: 0.0);
