//! The morph of long arrays: blocks of points run through kernels that the compiler turns into vectors; what these
//! leave in doubt is morphed point by point.

use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;
use rayon::prelude::*;

use super::lanes::{BLOCK, BlendLimits};
use super::point::{Kind, Morph};
use super::{blend, cylinder};
use crate::base::Real;
use crate::base::simd::{prefetch, vectorized};

/// Points of one task.
const TILE: usize = 1 << 14;
/// Blocks between the one at work and the one that is prefetched: a block is hundreds of instructions, behind which the
/// next one's loads would wait. It saves a fifth of the time.
const PREFETCHED_BLOCKS: usize = 4;

vectorized! {
    /// Morphs a block in the points' precision; returns a bit for each point in doubt.
    pub(super) fn blend_block<T: Real>(
        constants: &blend::Constants<T>,
        points: &[[T; 3]; BLOCK],
        shown: &mut [[T; 3]; BLOCK],
    ) -> u64 = blend::block;
    /// Morphs a block in float64; returns a bit for each point in doubt.
    fn cylinder_block<T: Real>(morph: &Morph, points: &[[T; 3]; BLOCK], shown: &mut [[T; 3]; BLOCK]) -> u64
        = cylinder::block;
}

impl Morph {
    /// Morphs float32 points: half a float32 step of the answer and 2⁻²⁴ (6 + 3 r₂/(r₂−r₁)) |U−O| from the exact
    /// answer at most, where the directions are not opposed. Inside r₁ they keep their bits; beyond r₂ they are
    /// U + P − O, rounded once.
    /// Points with NaN give NaN. Returns the number of opposed points. Both slices have one length.
    pub fn apply_all_f32(&self, points: &[[f32; 3]], shown: &mut [[f32; 3]]) -> u64 {
        apply_all(self, points, shown)
    }

    /// The same for float64 points, where each step is a float64 one.
    pub fn apply_all_f64(&self, points: &[[f64; 3]], shown: &mut [[f64; 3]]) -> u64 {
        apply_all(self, points, shown)
    }
}

/// Morphs all points in tiles on the current pool; the number of opposed ones.
fn apply_all<T: BlendLimits>(morph: &Morph, points: &[[T; 3]], shown: &mut [[T; 3]]) -> u64 {
    assert_eq!(points.len(), shown.len(), "as many results as points");
    if morph.offset == DVec3::ZERO {
        // From the centre nothing moves.
        points.par_chunks(TILE).zip(shown.par_chunks_mut(TILE)).for_each(|(from, to)| to.copy_from_slice(from));
        return 0;
    }
    if morph.kind == Kind::Blend && blend::applies::<T>(morph) {
        let constants = blend::Constants::new(morph);
        return in_tiles(morph, points, shown, |block, shown| blend_block(&constants, block, shown));
    }
    in_tiles(morph, points, shown, |block, shown| cylinder_block(morph, block, shown))
}

fn in_tiles<T: BlendLimits>(
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
            if let Some(ahead) = blocks.get(n + PREFETCHED_BLOCKS) {
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
