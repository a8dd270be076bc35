//! Morph of long arrays. Vector kernels morph blocks of points; points in doubt are morphed one by one.

use glam::DVec3;
use rayon::prelude::*;

use super::lanes::{BLOCK, BlendLimits};
use super::point::{Kind, Morph};
use super::{blend, cylinder};
use crate::base::simd::{prefetch, vectorized};
use crate::base::{Progress, Real, Result};

/// Number of points in one task.
const CHUNK: usize = 1 << 14;
/// Prefetch distance, blocks. Otherwise the loads of the next block would wait behind hundreds of instructions of this
/// block. Prefetching saves a fifth of the time.
const PREFETCHED_BLOCKS: usize = 4;

vectorized! {
    /// Morphs a block in the points' precision. Returns one bit for each point in doubt.
    pub(super) fn blend_block<T: Real>(
        constants: &blend::Constants<T>,
        points: &[[T; 3]; BLOCK],
        morphed: &mut [[T; 3]; BLOCK],
    ) -> u64 = blend::block;
    /// Morphs a block in float64. Returns one bit for each point in doubt.
    fn cylinder_block<T: Real>(morph: &Morph, points: &[[T; 3]; BLOCK], morphed: &mut [[T; 3]; BLOCK]) -> u64
        = cylinder::block;
}

impl Morph {
    /// Morphs float32 or float64 points in chunks on the current thread pool. Unless directions are opposed, the error
    /// is at most half a step of the result plus half an epsilon of the type times (6 + 3 r₂/(r₂−r₁)) |U−O|. At full
    /// strength, points inside r₁ are unchanged, and blends move points beyond r₂ to U + P − O, rounded once. NaN gives
    /// NaN. Returns the number of points with opposed directions. Both slices must have the same length.
    pub fn apply_all<T: BlendLimits>(
        &self,
        points: &[[T; 3]],
        morphed: &mut [[T; 3]],
        progress: &Progress,
    ) -> Result<u64> {
        assert_eq!(points.len(), morphed.len(), "one result for each point");
        if self.offset == DVec3::ZERO {
            // If user and centre coincide, no point moves.
            points.par_chunks(CHUNK).zip(morphed.par_chunks_mut(CHUNK)).for_each(|(from, to)| to.copy_from_slice(from));
            return Ok(0);
        }
        if self.kind == Kind::Blend && blend::is_applicable::<T>(self) {
            let constants = blend::Constants::new(self);
            return morph_chunks(self, points, morphed, progress, |block, to| blend_block(&constants, block, to));
        }
        morph_chunks(self, points, morphed, progress, |block, to| cylinder_block(self, block, to))
    }
}

fn morph_chunks<T: BlendLimits>(
    morph: &Morph,
    points: &[[T; 3]],
    morphed: &mut [[T; 3]],
    progress: &Progress,
    kernel: impl Fn(&[[T; 3]; BLOCK], &mut [[T; 3]; BLOCK]) -> u64 + Sync,
) -> Result<u64> {
    let counts = points.par_chunks(CHUNK).zip(morphed.par_chunks_mut(CHUNK)).map(|(points, morphed)| {
        let (blocks, remaining) = points.as_chunks::<BLOCK>();
        let (morphed_blocks, morphed_remaining) = morphed.as_chunks_mut::<BLOCK>();
        let mut count = 0;
        for (n, (block, morphed)) in blocks.iter().zip(morphed_blocks).enumerate() {
            if let Some(ahead) = blocks.get(n + PREFETCHED_BLOCKS) {
                prefetch(ahead);
            }
            count += resolve(morph, kernel(block, morphed), block, morphed);
        }
        if let Some(&first) = remaining.first() {
            // Padded to a block; a point's result does not depend on its position in the block.
            let mut block = [first; BLOCK];
            let mut morphed = block;
            block[..remaining.len()].copy_from_slice(remaining);
            let doubts = kernel(&block, &mut morphed) & ((1 << remaining.len()) - 1);
            count += resolve(morph, doubts, &block, &mut morphed);
            morphed_remaining.copy_from_slice(&morphed[..remaining.len()]);
        }
        progress.check().map(|()| count)
    });
    counts.try_reduce(|| 0, |a, b| Ok(a + b))
}

/// Morphs the doubtful points of a block one by one. Returns the number of opposed points.
fn resolve<T: Real>(morph: &Morph, mut doubts: u64, points: &[[T; 3]], morphed: &mut [[T; 3]]) -> u64 {
    let mut opposed = 0;
    while doubts != 0 {
        let lane = doubts.trailing_zeros() as usize;
        let exact = morph.examine(DVec3::from_array(points[lane].map(T::wide)));
        morphed[lane] = exact.point.to_array().map(T::narrow);
        opposed += u64::from(exact.opposed);
        doubts &= doubts - 1;
    }
    opposed
}
