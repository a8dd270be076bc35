//! The morph of long arrays: whole blocks that stay are copied, whole blocks beyond r₂ are shifted, and the others run
//! through a form of Eq. 1–3 in the arrays' own precision that adds a small shift to each point:
//!
//! with A = |P−U|, B = |P−O|, v = U−O, e = (A−B)², h = w(1−w)/(AB) and n² = 1 − h(|v|²−e) (the squared length of the
//! blend of both directions), Q = P + α (P−O) + β v, where α = h(e + (|v|²−e)/(1+n))/n and
//! β = 1 − w(w + (1−w)B/A)/n.
//!
//! Both terms are of the size of |v|, so that rounding is relative to the user's offset, not to the distance. Points
//! near a radius, near the user or near opposition leave n or the choice of zone in doubt and are morphed one by one in float64.

use std::ops::{Add, Div, Mul, Sub};
use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;
use rayon::prelude::*;

use super::{Kind, Morph};
use crate::base::simd::widest;

/// Points of one task.
const TILE: usize = 1 << 14;
/// Points that share a decision; their temporaries stay in the first-level cache.
const BLOCK: usize = 64;
/// A float32 weight w loses a factor r₂/(r₂−r₁) of its digits: beyond this everything is done in float64.
const STEEPEST: f64 = 16.0;

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

/// What a block needs, in the precision of the points.
pub(super) struct Constants<T> {
    /// O as the sum of two numbers: float32 alone would be off by metres at 10⁷ m.
    center: [[T; 3]; 2],
    offset: [T; 3],
    offset_squared: T,
    offset_wide: [f64; 3],
    r2: T,
    /// 1 / (r₂−r₁).
    slope: T,
    /// Squared radii, each lowered and raised by what the points' own rounding leaves in doubt.
    inner: [T; 2],
    outer: [T; 2],
}

impl<T: Real> Constants<T> {
    fn new(morph: &Morph) -> Self {
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

/// Morphs all points in tiles on the current pool; the number of opposed ones.
pub(super) fn apply_all<T: Streamed>(morph: &Morph, points: &[[T; 3]], shown: &mut [[T; 3]]) -> u64 {
    assert_eq!(points.len(), shown.len(), "as many results as points");
    if morph.offset == DVec3::ZERO {
        // From the centre nothing moves.
        points.par_chunks(TILE).zip(shown.par_chunks_mut(TILE)).for_each(|(from, to)| to.copy_from_slice(from));
        return 0;
    }
    let [least, greatest] = T::LENGTHS;
    let in_range = morph.r2 > least && morph.r2 < greatest && morph.offset.length() < greatest;
    // Two float32 numbers hold O to 2⁻⁴⁸ of its size, which must stay far below the doubt about the inner radius.
    let in_range = in_range && morph.center.length() < 1e6 * if morph.r1 > 0.0 { morph.r1 } else { morph.r2 };
    let streamed = morph.kind == Kind::Blend && in_range && morph.r2 < STEEPEST * (morph.r2 - morph.r1);
    let constants = Constants::new(morph);
    let opposed = AtomicU64::new(0);
    points.par_chunks(TILE).zip(shown.par_chunks_mut(TILE)).for_each(|(from, to)| {
        let count = if streamed { stream_tile(morph, &constants, from, to) } else { apply_each(morph, from, to) };
        opposed.fetch_add(count, Ordering::Relaxed);
    });
    opposed.into_inner()
}

/// The scalar form for each point.
fn apply_each<T: Real>(morph: &Morph, points: &[[T; 3]], shown: &mut [[T; 3]]) -> u64 {
    let mut opposed = 0;
    for (point, shown) in points.iter().zip(shown) {
        opposed += u64::from(apply_one(morph, point, shown));
    }
    opposed
}

fn apply_one<T: Real>(morph: &Morph, point: &[T; 3], shown: &mut [T; 3]) -> bool {
    let morphed = morph.examine(DVec3::from_array(point.map(T::wide)));
    *shown = morphed.point.to_array().map(T::narrow);
    morphed.opposed
}

fn stream_tile<T: Streamed>(morph: &Morph, constants: &Constants<T>, points: &[[T; 3]], shown: &mut [[T; 3]]) -> u64 {
    let (blocks, rest) = points.as_chunks::<BLOCK>();
    let (shown_blocks, shown_rest) = shown.as_chunks_mut::<BLOCK>();
    let mut opposed = 0;
    for (block, shown) in blocks.iter().zip(shown_blocks) {
        let doubts = T::stream_block(constants, block, shown);
        opposed += resolve(morph, doubts, block, shown);
    }
    opposed + stream_rest(morph, constants, rest, shown_rest)
}

/// The last points, padded to a block: a point's answer does not depend on its place.
fn stream_rest<T: Streamed>(morph: &Morph, constants: &Constants<T>, points: &[[T; 3]], shown: &mut [[T; 3]]) -> u64 {
    let Some(&first) = points.first() else { return 0 };
    let mut block = [first; BLOCK];
    let mut shown_block = block;
    block[..points.len()].copy_from_slice(points);
    let doubts = T::stream_block(constants, &block, &mut shown_block) & ((1 << points.len()) - 1);
    let opposed = resolve(morph, doubts, &block, &mut shown_block);
    shown.copy_from_slice(&shown_block[..points.len()]);
    opposed
}

/// Morphs the points of a block that are in doubt one by one.
fn resolve<T: Real>(morph: &Morph, mut doubts: u64, points: &[[T; 3]], shown: &mut [[T; 3]]) -> u64 {
    let mut opposed = 0;
    while doubts != 0 {
        let lane = doubts.trailing_zeros() as usize;
        opposed += u64::from(apply_one(morph, &points[lane], &mut shown[lane]));
        doubts &= doubts - 1;
    }
    opposed
}

/// The block kernel of a precision, compiled for each width of vectors.
pub(super) trait Streamed: Real {
    fn stream_block(constants: &Constants<Self>, points: &[[Self; 3]; BLOCK], shown: &mut [[Self; 3]; BLOCK]) -> u64;
}

macro_rules! streamed {
    ($float:ty, $name:ident) => {
        widest! {
            fn $name(constants: &Constants<$float>, points: &[[$float; 3]; BLOCK], shown: &mut [[$float; 3]; BLOCK]) -> u64
                = block::<$float>;
        }
        impl Streamed for $float {
            fn stream_block(
                constants: &Constants<Self>,
                points: &[[Self; 3]; BLOCK],
                shown: &mut [[Self; 3]; BLOCK],
            ) -> u64 {
                $name(constants, points, shown)
            }
        }
    };
}

streamed!(f32, block_f32);
streamed!(f64, block_f64);

/// Coordinates of a block by axis.
type Lanes<T> = [[T; BLOCK]; 3];

/// Morphs a block; one bit for each point whose answer is in doubt.
#[inline(always)]
fn block<T: Real>(c: &Constants<T>, points: &[[T; 3]; BLOCK], shown: &mut [[T; 3]; BLOCK]) -> u64 {
    let mut given: Lanes<T> = [[T::ZERO; BLOCK]; 3];
    for (i, point) in points.iter().enumerate() {
        given[0][i] = point[0];
        given[1][i] = point[1];
        given[2][i] = point[2];
    }
    let mut from_center: Lanes<T> = [[T::ZERO; BLOCK]; 3];
    for axis in 0..3 {
        for i in 0..BLOCK {
            from_center[axis][i] = given[axis][i] - c.center[0][axis] - c.center[1][axis];
        }
    }
    let mut rho_squared = [T::ZERO; BLOCK];
    let (mut inside, mut outside) = (0u32, 0u32);
    for i in 0..BLOCK {
        let (x, z) = (from_center[0][i], from_center[2][i]);
        let square = x * x + z * z;
        inside += u32::from(square <= c.inner[0]);
        outside += u32::from(square >= c.outer[1]);
        rho_squared[i] = square;
    }
    if inside as usize == BLOCK {
        *shown = *points;
        return 0;
    }
    let mut moved: Lanes<T> = [[T::ZERO; BLOCK]; 3];
    for axis in 0..3 {
        for i in 0..BLOCK {
            moved[axis][i] = T::narrow(given[axis][i].wide() + c.offset_wide[axis]);
        }
    }
    let mut doubts = 0;
    if (outside as usize) < BLOCK {
        doubts = blend(c, &given, &from_center, &rho_squared, &mut moved);
    }
    for (i, shown) in shown.iter_mut().enumerate() {
        *shown = [moved[0][i], moved[1][i], moved[2][i]];
    }
    doubts
}

/// Replaces the shifted points of a block by the given or the blended ones where these hold.
#[inline(always)]
fn blend<T: Real>(
    c: &Constants<T>,
    given: &Lanes<T>,
    from_center: &Lanes<T>,
    rho_squared: &[T; BLOCK],
    moved: &mut Lanes<T>,
) -> u64 {
    let (mut alpha, mut beta, mut certain) = ([T::ZERO; BLOCK], [T::ZERO; BLOCK], [T::ZERO; BLOCK]);
    for i in 0..BLOCK {
        let (x, y, z) = (from_center[0][i], from_center[1][i], from_center[2][i]);
        let (ax, ay, az) = (x - c.offset[0], y - c.offset[1], z - c.offset[2]);
        let a_squared = ax * ax + ay * ay + az * az;
        let b_squared = x * x + y * y + z * z;
        let (a, b) = (a_squared.root(), b_squared.root());
        let (sum, product) = (a + b, a * b);
        // One division gives both 1/(A+B) and 1/(AB); a height whose square overflows leaves 0.
        let both = T::ONE / (sum * product);
        let along = x * c.offset[0] + y * c.offset[1] + z * c.offset[2];
        let difference = (c.offset_squared - along - along) * (product * both);
        let inverse_product = sum * both;
        let e = difference * difference;
        let turn = c.offset_squared - e;
        let w = (c.r2 - rho_squared[i].root()) * c.slope;
        let h = w * (T::ONE - w) * inverse_product;
        let n = (T::ONE - h * turn).root();
        // One division gives both 1/n and 1/(n(1+n)).
        let inverse = T::ONE / (n * (T::ONE + n));
        alpha[i] = h * (e * (T::ONE + n) + turn) * inverse;
        beta[i] = T::ONE - w * (w + (T::ONE - w) * b_squared * inverse_product) * (T::ONE + n) * inverse;
        let is_clear = (c.offset_squared <= product) & (both > T::ZERO);
        certain[i] = if is_clear { T::ONE } else { T::ZERO };
    }
    for axis in 0..3 {
        for i in 0..BLOCK {
            let point = given[axis][i];
            let blended = point + (alpha[i] * from_center[axis][i] + beta[i] * c.offset[axis]);
            let moving = if rho_squared[i] >= c.outer[1] { moved[axis][i] } else { blended };
            moved[axis][i] = if rho_squared[i] <= c.inner[0] { point } else { moving };
        }
    }
    let mut doubtful = [false; BLOCK];
    let mut count = 0u32;
    for i in 0..BLOCK {
        let square = rho_squared[i];
        let is_between = (square > c.inner[1]) & (square < c.outer[0]) & (certain[i] > T::ZERO);
        doubtful[i] = !((square <= c.inner[0]) | (square >= c.outer[1]) | is_between);
        count += u32::from(doubtful[i]);
    }
    if count == 0 {
        return 0;
    }
    doubtful.iter().enumerate().fold(0, |doubts, (i, &doubtful)| doubts | u64::from(doubtful) << i)
}
