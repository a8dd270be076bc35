//! Block kernel of `Kind::Blend`: Eq. 1–3 in the points' own precision, as a small shift of each point.
//!
//! With A = |P−U|, B = |P−O|, v = U−O, e = (A−B)², h = w(1−w)/(AB) and n² = 1 − h(|v|²−e), the squared length of the
//! blend of both directions, Q = P + α (P−O) + β v. Here α = h(e + (|v|²−e)/(1+n))/n and β = 1 − w(w + (1−w)B/A)/n.
//!
//! Both terms are of the size of |v|, so rounding is relative to the user's offset, not to the distance. Points near a
//! radius, near the user or near opposed directions are in doubt, because rounding affects n or the choice of zone.

use super::lanes::{BLOCK, BlendLimits, BlockCoordinates, gather, scatter};
use super::point::Morph;
use crate::base::Real;

/// Maximum r₂/(r₂−r₁), by which the rounding of a float32 weight w grows. Above it, the morph uses float64.
const MAX_STEEPNESS: f64 = 16.0;

/// Returns whether the kernel may be used: no length overflows or loses digits, and points within r₁ do not move.
pub(super) fn is_applicable<T: BlendLimits>(morph: &Morph) -> bool {
    let [min, max] = T::LENGTHS;
    if morph.strength < 1.0 {
        return false;
    }
    let in_range = morph.r2 > min && morph.r2 < max && morph.offset.length() < max;
    // Two float32 numbers represent O to 2⁻⁴⁸ of its length, which must stay far below `DOUBT` of the inner radius.
    let in_range = in_range && morph.center.length() < 1e6 * if morph.r1 > 0.0 { morph.r1 } else { morph.r2 };
    in_range && morph.r2 < MAX_STEEPNESS * (morph.r2 - morph.r1)
}

/// Constants of the kernel, in the precision of the points.
pub(super) struct Constants<T> {
    /// O as the sum of two numbers: one float32 would be wrong by up to half a metre at 10⁷ m.
    center: [[T; 3]; 2],
    offset: [T; 3],
    offset_squared: T,
    offset_wide: [f64; 3],
    r2: T,
    /// 1 / (r₂−r₁).
    slope: T,
    /// Squared radii, each lowered and raised by the points' rounding error.
    inner: [T; 2],
    outer: [T; 2],
}

impl<T: BlendLimits> Constants<T> {
    pub(super) fn new(morph: &Morph) -> Self {
        let high: [T; 3] = morph.center.to_array().map(T::narrow);
        let low = std::array::from_fn(|i| T::narrow(morph.center[i] - high[i].wide()));
        let around = |r: f64| [T::narrow(r * r * (1.0 - T::DOUBT)), T::narrow(r * r * (1.0 + T::DOUBT))];
        Self {
            center: [high, low],
            offset: morph.offset.to_array().map(T::narrow),
            offset_squared: T::narrow(morph.offset.length_squared()),
            offset_wide: morph.offset.to_array(),
            r2: T::narrow(morph.r2),
            slope: T::narrow(1.0 / (morph.r2 - morph.r1)),
            inner: around(morph.r1),
            outer: around(morph.r2),
        }
    }
}

/// Morphs a block. Returns one bit for each point in doubt.
#[inline(always)]
pub(super) fn block<T: Real>(c: &Constants<T>, points: &[[T; 3]; BLOCK], morphed: &mut [[T; 3]; BLOCK]) -> u64 {
    let coordinates = gather(points);
    let mut from_center: BlockCoordinates<T> = [[T::zero(); BLOCK]; 3];
    for axis in 0..3 {
        for i in 0..BLOCK {
            from_center[axis][i] = coordinates[axis][i] - c.center[0][axis] - c.center[1][axis];
        }
    }
    let mut rho_squared = [T::zero(); BLOCK];
    let (mut inside, mut outside) = (0u32, 0u32);
    for i in 0..BLOCK {
        let (x, z) = (from_center[0][i], from_center[2][i]);
        let square = x * x + z * z;
        inside += u32::from(square <= c.inner[0]);
        outside += u32::from(square >= c.outer[1]);
        rho_squared[i] = square;
    }
    if inside as usize == BLOCK {
        *morphed = *points;
        return 0;
    }
    let mut results: BlockCoordinates<T> = [[T::zero(); BLOCK]; 3];
    for axis in 0..3 {
        for i in 0..BLOCK {
            results[axis][i] = T::narrow(coordinates[axis][i].wide() + c.offset_wide[axis]);
        }
    }
    let mut doubts = 0;
    if (outside as usize) < BLOCK {
        doubts = blend(c, &coordinates, &from_center, &rho_squared, &mut results);
    }
    scatter(&results, morphed);
    doubts
}

/// Selects the original, the blended or the shifted position of each point, by its zone.
#[inline(always)]
fn blend<T: Real>(
    c: &Constants<T>,
    coordinates: &BlockCoordinates<T>,
    from_center: &BlockCoordinates<T>,
    rho_squared: &[T; BLOCK],
    results: &mut BlockCoordinates<T>,
) -> u64 {
    let (mut alpha, mut beta, mut certain) = ([T::zero(); BLOCK], [T::zero(); BLOCK], [T::zero(); BLOCK]);
    for i in 0..BLOCK {
        let (x, y, z) = (from_center[0][i], from_center[1][i], from_center[2][i]);
        let (ax, ay, az) = (x - c.offset[0], y - c.offset[1], z - c.offset[2]);
        let a_squared = ax * ax + ay * ay + az * az;
        let b_squared = x * x + y * y + z * z;
        let (a, b) = (a_squared.sqrt(), b_squared.sqrt());
        let (sum, product) = (a + b, a * b);
        // One division gives both 1/(A+B) and 1/(AB). If the square of a height overflows, both are 0.
        let both = T::one() / (sum * product);
        let along = x * c.offset[0] + y * c.offset[1] + z * c.offset[2];
        let difference = (c.offset_squared - along - along) * (product * both);
        let inverse_product = sum * both;
        let e = difference * difference;
        let turn = c.offset_squared - e;
        let w = (c.r2 - rho_squared[i].sqrt()) * c.slope;
        let h = w * (T::one() - w) * inverse_product;
        let n = (T::one() - h * turn).sqrt();
        // One division gives both 1/n and 1/(n(1+n)).
        let inverse = T::one() / (n * (T::one() + n));
        alpha[i] = h * (e * (T::one() + n) + turn) * inverse;
        beta[i] = T::one() - w * (w + (T::one() - w) * b_squared * inverse_product) * (T::one() + n) * inverse;
        let is_clear = (c.offset_squared <= product) & (both > T::zero());
        certain[i] = if is_clear { T::one() } else { T::zero() };
    }
    for axis in 0..3 {
        for i in 0..BLOCK {
            let point = coordinates[axis][i];
            let blended = point + (alpha[i] * from_center[axis][i] + beta[i] * c.offset[axis]);
            let moving = if rho_squared[i] >= c.outer[1] { results[axis][i] } else { blended };
            results[axis][i] = if rho_squared[i] <= c.inner[0] { point } else { moving };
        }
    }
    let mut doubtful = [false; BLOCK];
    let mut count = 0u32;
    for i in 0..BLOCK {
        let square = rho_squared[i];
        let is_between = (square > c.inner[1]) & (square < c.outer[0]) & (certain[i] > T::zero());
        doubtful[i] = !((square <= c.inner[0]) | (square >= c.outer[1]) | is_between);
        count += u32::from(doubtful[i]);
    }
    if count == 0 {
        return 0;
    }
    doubtful.iter().enumerate().fold(0, |doubts, (i, &doubtful)| doubts | u64::from(doubtful) << i)
}
