//! Blocks of points as arrays of coordinates.

use crate::base::Real;

/// Number of points in a block. The block's temporaries fit in the first-level cache.
pub(super) const BLOCK: usize = 64;

/// Limits within which a floating-point type is precise enough for the blend kernel.
pub trait BlendLimits: Real {
    /// Upper bound of the relative error of squared distances caused by two roundings of each coordinate.
    const DOUBT: f64;
    /// Range of lengths whose squares neither overflow nor lose digits.
    const LENGTHS: [f64; 2];
}

impl BlendLimits for f32 {
    const DOUBT: f64 = 1e-6;
    const LENGTHS: [f64; 2] = [1e-3, 1e8];
}

impl BlendLimits for f64 {
    const DOUBT: f64 = 2e-15;
    const LENGTHS: [f64; 2] = [1e-50, 1e50];
}

/// Coordinates of a block, one array per axis.
pub(super) type BlockCoordinates<T> = [[T; BLOCK]; 3];

#[inline(always)]
pub(super) fn gather<T: Real>(points: &[[T; 3]; BLOCK]) -> BlockCoordinates<T> {
    let mut lanes = [[T::zero(); BLOCK]; 3];
    for (i, point) in points.iter().enumerate() {
        lanes[0][i] = point[0];
        lanes[1][i] = point[1];
        lanes[2][i] = point[2];
    }
    lanes
}

#[inline(always)]
pub(super) fn scatter<T: Real>(lanes: &BlockCoordinates<T>, points: &mut [[T; 3]; BLOCK]) {
    for (i, point) in points.iter_mut().enumerate() {
        *point = [lanes[0][i], lanes[1][i], lanes[2][i]];
    }
}
