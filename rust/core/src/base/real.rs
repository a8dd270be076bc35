//! Precisions of the arrays that kernels read and write.

use num_traits::Float;

/// float32 or float64.
pub trait Real: Float + Default + Send + Sync + 'static {
    /// By how much, as a share, a rounded number may lie beyond the float64 that it was rounded from.
    const SLACK: f64;
    /// The same value.
    fn wide(self) -> f64;
    /// Rounded once.
    fn narrow(value: f64) -> Self;
    /// a b + c, rounded once where it is fused.
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
