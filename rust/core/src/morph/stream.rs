//! The morph of long arrays: blocks of points run through kernels that the compiler turns into vectors; what these
//! leave in doubt is morphed point by point.

use std::ops::{Add, Div, Mul, Sub};
use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;
use rayon::prelude::*;

use super::{Kind, Morph, blend, cylinder};
use crate::base::simd::{prefetch, widest};

/// Points of one task.
const TILE: usize = 1 << 14;
/// Points that share a decision; their temporaries stay in the first-level cache.
pub(super) const BLOCK: usize = 64;
/// Blocks from the one at work to the one that is asked of memory: a block is hundreds of instructions, behind which
/// the next one's loads would wait. It saves a fifth of the time.
const AHEAD: usize = 4;

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

/// The block kernels of a precision, compiled for each width of vectors. They return a bit for each point in doubt.
pub(super) trait Streamed: Real {
    fn blend(constants: &blend::Constants<Self>, points: &[[Self; 3]; BLOCK], shown: &mut [[Self; 3]; BLOCK]) -> u64;
    fn cylinder(morph: &Morph, points: &[[Self; 3]; BLOCK], shown: &mut [[Self; 3]; BLOCK]) -> u64;
}

macro_rules! streamed {
    ($float:ty, $blend:ident, $cylinder:ident) => {
        widest! {
            fn $blend(c: &blend::Constants<$float>, points: &[[$float; 3]; BLOCK], shown: &mut [[$float; 3]; BLOCK]) -> u64
                = blend::block::<$float>;
        }
        widest! {
            fn $cylinder(morph: &Morph, points: &[[$float; 3]; BLOCK], shown: &mut [[$float; 3]; BLOCK]) -> u64
                = cylinder::block::<$float>;
        }
        impl Streamed for $float {
            fn blend(c: &blend::Constants<Self>, points: &[[Self; 3]; BLOCK], shown: &mut [[Self; 3]; BLOCK]) -> u64 {
                $blend(c, points, shown)
            }
            fn cylinder(morph: &Morph, points: &[[Self; 3]; BLOCK], shown: &mut [[Self; 3]; BLOCK]) -> u64 {
                $cylinder(morph, points, shown)
            }
        }
    };
}

streamed!(f32, blend_f32, cylinder_f32);
streamed!(f64, blend_f64, cylinder_f64);

/// Morphs all points in tiles on the current pool; the number of opposed ones.
pub(super) fn apply_all<T: Streamed>(morph: &Morph, points: &[[T; 3]], shown: &mut [[T; 3]]) -> u64 {
    assert_eq!(points.len(), shown.len(), "as many results as points");
    if morph.offset == DVec3::ZERO {
        // From the centre nothing moves.
        points.par_chunks(TILE).zip(shown.par_chunks_mut(TILE)).for_each(|(from, to)| to.copy_from_slice(from));
        return 0;
    }
    if morph.kind == Kind::Blend && blend::applies::<T>(morph) {
        let constants = blend::Constants::new(morph);
        return in_tiles(morph, points, shown, |block, shown| T::blend(&constants, block, shown));
    }
    in_tiles(morph, points, shown, |block, shown| T::cylinder(morph, block, shown))
}

fn in_tiles<T: Streamed>(
    morph: &Morph,
    points: &[[T; 3]],
    shown: &mut [[T; 3]],
    kernel: impl Fn(&[[T; 3]; BLOCK], &mut [[T; 3]; BLOCK]) -> u64 + Sync,
) -> u64 {
    let opposed = AtomicU64::new(0);
    points.par_chunks(TILE).zip(shown.par_chunks_mut(TILE)).for_each(|(points, shown)| {
        let (blocks, rest) = points.as_chunks::<BLOCK>();
        let (shown_blocks, shown_rest) = shown.as_chunks_mut::<BLOCK>();
        let mut count = 0;
        for (n, (block, shown)) in blocks.iter().zip(shown_blocks).enumerate() {
            if let Some(ahead) = blocks.get(n + AHEAD) {
                prefetch(ahead);
            }
            count += resolve(morph, kernel(block, shown), block, shown);
        }
        if let Some(&first) = rest.first() {
            // Padded to a block: a point's answer does not depend on its place.
            let mut block = [first; BLOCK];
            let mut shown = block;
            block[..rest.len()].copy_from_slice(rest);
            let doubts = kernel(&block, &mut shown) & ((1 << rest.len()) - 1);
            count += resolve(morph, doubts, &block, &mut shown);
            shown_rest.copy_from_slice(&shown[..rest.len()]);
        }
        opposed.fetch_add(count, Ordering::Relaxed);
    });
    opposed.into_inner()
}

/// Morphs the points of a block that are in doubt one by one.
fn resolve<T: Real>(morph: &Morph, mut doubts: u64, points: &[[T; 3]], shown: &mut [[T; 3]]) -> u64 {
    let mut opposed = 0;
    while doubts != 0 {
        let lane = doubts.trailing_zeros() as usize;
        let morphed = morph.examine(DVec3::from_array(points[lane].map(T::wide)));
        shown[lane] = morphed.point.to_array().map(T::narrow);
        opposed += u64::from(morphed.opposed);
        doubts &= doubts - 1;
    }
    opposed
}
