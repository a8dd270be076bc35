//! Means and variances in a window, separably and without cancellation.
//!
//! The mean of squares minus the square of the mean has no correct digits if the level is high. Here each row's moments
//! are relative to the pixel in its middle, and those of the window relative to the middle row. The square that is
//! still subtracted is at most the variance divided by the middle's weight (the middle is one of the averaged values).
//! So the relative error is a few roundings divided by that weight, at any level.

use super::super::extremes::{LANES, lanes};
use crate::base::Real;
use crate::base::simd::vectorized;

/// Maximum number of windows of a row per pass: with the moments of a window's rows they fit in the first-level cache.
pub(super) const COLUMNS: usize = 128;

/// Means and variances of adjacent windows, aligned to cache lines: vectors across two lines are read twice.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub struct Moments<R> {
    /// Mean of each window.
    pub mean: [R; COLUMNS],
    /// Variance of each window.
    pub variance: [R; COLUMNS],
    /// Padding, because narrow tiles fill only the beginning of each array: rows a power of two apart would share few
    /// sets of the first-level cache.
    _padding: [u8; 64],
}

impl<R: Real> Default for Moments<R> {
    fn default() -> Self {
        Self { mean: [R::default(); COLUMNS], variance: [R::default(); COLUMNS], _padding: [0; 64] }
    }
}

vectorized! {
    /// Computes moments along a line for the first `blocks` × `LANES` windows; the n-th begins at the n-th value.
    pub(super) fn row_moments<R: Real>(line: &[R], weights: &[R], moments: &mut Moments<R>, blocks: usize)
        = fused row_moments_kernel<_>;
    /// Combines row moments to window moments; `order[k]` is the index in `rows` of the window's k-th row.
    pub(super) fn window_moments<R: Real>(
        rows: &[Moments<R>],
        order: &[usize],
        weights: &[R],
        moments: &mut Moments<R>,
        blocks: usize,
    ) = fused window_moments_kernel<_>;
}

#[inline(always)]
pub(super) fn row_moments_kernel<R: Real, const FUSED: bool>(
    line: &[R],
    weights: &[R],
    moments: &mut Moments<R>,
    blocks: usize,
) {
    let middle = weights.len() / 2;
    let means = &mut moments.mean.as_chunks_mut::<LANES>().0[..blocks];
    let variances = &mut moments.variance.as_chunks_mut::<LANES>().0[..blocks];
    for block in 0..blocks {
        let line = &line[block * LANES..][..LANES + weights.len() - 1];
        let center: &[R; LANES] = lanes(&line[middle..]);
        let (mut first, mut second) = ([R::default(); LANES], [R::default(); LANES]);
        for (k, &weight) in weights[..weights.len() / 2].iter().enumerate() {
            let values: [&[R; LANES]; 2] = [lanes(&line[k..]), lanes(&line[weights.len() - 1 - k..])];
            for i in 0..LANES {
                let (a, b) = (values[0][i] - center[i], values[1][i] - center[i]);
                first[i] = R::fuse::<FUSED>(weight, a + b, first[i]);
                second[i] = R::fuse::<FUSED>(weight, R::fuse::<FUSED>(a, a, b * b), second[i]);
            }
        }
        for i in 0..LANES {
            means[block][i] = center[i] + first[i];
            variances[block][i] = second[i] - first[i] * first[i];
        }
    }
}

#[inline(always)]
pub(super) fn window_moments_kernel<R: Real, const FUSED: bool>(
    rows: &[Moments<R>],
    order: &[usize],
    weights: &[R],
    moments: &mut Moments<R>,
    blocks: usize,
) {
    let taps = order.len();
    let middle = &rows[order[taps / 2]];
    let means = &mut moments.mean.as_chunks_mut::<LANES>().0[..blocks];
    let variances = &mut moments.variance.as_chunks_mut::<LANES>().0[..blocks];
    for block in 0..blocks {
        let center: &[R; LANES] = block_values(&middle.mean, block);
        let (mut first, mut second) = ([R::default(); LANES], [R::default(); LANES]);
        if taps % 2 == 1 {
            let spreads: &[R; LANES] = block_values(&middle.variance, block);
            for i in 0..LANES {
                second[i] = weights[taps / 2] * spreads[i];
            }
        }
        for (k, &weight) in weights[..taps / 2].iter().enumerate() {
            let (upper, lower) = (&rows[order[k]], &rows[order[taps - 1 - k]]);
            let values = [block_values(&upper.mean, block), block_values(&lower.mean, block)];
            let spreads = [block_values(&upper.variance, block), block_values(&lower.variance, block)];
            for i in 0..LANES {
                let (a, b) = (values[0][i] - center[i], values[1][i] - center[i]);
                first[i] = R::fuse::<FUSED>(weight, a + b, first[i]);
                let spread = R::fuse::<FUSED>(a, a, spreads[0][i] + spreads[1][i]);
                second[i] = R::fuse::<FUSED>(weight, R::fuse::<FUSED>(b, b, spread), second[i]);
            }
        }
        for i in 0..LANES {
            means[block][i] = center[i] + first[i];
            variances[block][i] = second[i] - first[i] * first[i];
        }
    }
}

#[inline(always)]
fn block_values<R>(values: &[R; COLUMNS], block: usize) -> &[R; LANES] {
    &values.as_chunks::<LANES>().0[block]
}
