//! Similarity measure from means and variances of the sum and difference of both images.

use super::super::extremes::LANES;
use super::super::plane::RoundingLimits;
use super::moments::{COLUMNS, Moments};
use crate::base::simd::vectorized;

/// Levels and constants that turn moments into similarity.
pub struct Measure<R> {
    /// Value subtracted from each image.
    pub levels: [R; 2],
    /// (k₁ L)² and (k₂ L)².
    pub constants: [R; 2],
}

impl<R: RoundingLimits> Measure<R> {
    /// Returns the similarity, and its contrast factor if `CONTRAST`, from mean and variance of s and of d. With S and
    /// D the sum and the difference of both means, both factors are 1 minus a non-negative term: l = 1 −
    /// D²/((S²+D²)/2+c₁) and cs = 1 − σd²/((σs²+σd²)/2 + c₂). Swapping the images gives the same bits.
    #[inline(always)]
    pub fn similarity<const CONTRAST: bool, const FUSED: bool>(
        &self,
        [s, s2]: [R; 2],
        [d, d2]: [R; 2],
    ) -> Measurement<R> {
        let (half, zero) = (R::narrow(0.5), R::default());
        // Negative variances are rounding errors. NaN fails the comparison and stays.
        let s2 = if s2 < zero { zero } else { s2 };
        let d2 = if d2 < zero { zero } else { d2 };
        let sum = (self.levels[0] + self.levels[1]) + s;
        let difference = (self.levels[0] - self.levels[1]) + d;
        let difference_squared = difference * difference;
        let means = R::fuse::<FUSED>(half, R::fuse::<FUSED>(sum, sum, difference_squared), self.constants[0]);
        let variances = R::fuse::<FUSED>(half, s2 + d2, self.constants[1]);
        let contrast_numerator = variances - d2;
        // One division serves both factors.
        let divisor = means * variances;
        let similarity = (means - difference_squared) * contrast_numerator / divisor;
        // Subtracting levels has a rounding error e proportional to |s| + |d|. It changes the contrast factor by
        // e √σd² / σ² and the first factor by e |D| / (S² + D²), to which the rounding of means adds.
        let distance_squared = R::fuse::<FUSED>(s, s, d * d);
        let square = |factor: f64| R::narrow(factor * factor);
        let smaller_divisor = if means < variances { means } else { variances };
        let is_precise = ((distance_squared + (s2 + d2)) * difference_squared
            <= square(R::MAX_CHANGE) * (means * means))
            & (distance_squared * d2 <= square(R::MAX_CHANGE) * (variances * variances))
            & (distance_squared <= square(R::MAX_DISTANCE) * smaller_divisor)
            & (divisor <= R::narrow(R::MAX_DIVISOR));
        Measurement { similarity, contrast: if CONTRAST { contrast_numerator / variances } else { zero }, is_precise }
    }
}

/// Similarity of one window.
pub struct Measurement<R> {
    /// Similarity.
    pub similarity: R,
    /// Contrast factor, if computed.
    pub contrast: R,
    /// Whether precision and exponent range sufficed.
    pub is_precise: bool,
}

/// A row of windows.
#[repr(align(64))]
pub struct WindowRow<R> {
    /// 1 for windows that count, 0 for others.
    pub counts: [R; COLUMNS],
    /// Similarity of each window.
    pub similarity: [R; COLUMNS],
    /// Number of windows, in units of `LANES`.
    pub blocks: usize,
    /// Whether to compute the contrast factor.
    pub contrast: bool,
    /// Whether windows that do not count are required, too.
    pub all_required: bool,
    /// Whether precision sufficed for all required windows of the last row.
    pub is_precise: bool,
    /// Sums of similarity and contrast factor over all rows since the last reset, per lane.
    pub sums: [[f64; LANES]; 2],
}

vectorized! {
    /// Computes the similarity of a row of windows; sums it and, if wanted, the contrast factor of windows that count.
    pub(super) fn measure_row<R: RoundingLimits>(
        measure: &Measure<R>,
        s: &Moments<R>,
        d: &Moments<R>,
        row: &mut WindowRow<R>,
    ) = fused measure_any_row<_>;
    /// Returns the sums of s, d, s² and d².
    pub(super) fn power_sums(s: &[f64], d: &[f64]) -> [f64; 4] = power_sums_kernel;
}

#[inline(always)]
fn measure_any_row<R: RoundingLimits, const FUSED: bool>(
    measure: &Measure<R>,
    s: &Moments<R>,
    d: &Moments<R>,
    row: &mut WindowRow<R>,
) {
    if row.contrast {
        measure_row_kernel::<R, true, FUSED>(measure, s, d, row);
    } else {
        measure_row_kernel::<R, false, FUSED>(measure, s, d, row);
    }
}

#[inline(always)]
fn measure_row_kernel<R: RoundingLimits, const CONTRAST: bool, const FUSED: bool>(
    measure: &Measure<R>,
    s: &Moments<R>,
    d: &Moments<R>,
    row: &mut WindowRow<R>,
) {
    let mut sums = row.sums;
    let (mut failed, all_required) = ([0u32; LANES], row.all_required);
    let (s_mean, s_variance) = (s.mean.as_chunks::<LANES>().0, s.variance.as_chunks::<LANES>().0);
    let (d_mean, d_variance) = (d.mean.as_chunks::<LANES>().0, d.variance.as_chunks::<LANES>().0);
    let similarity = row.similarity.as_chunks_mut::<LANES>().0;
    for (block, counts) in row.counts.as_chunks::<LANES>().0[..row.blocks].iter().enumerate() {
        let mut contrast = [R::default(); LANES];
        for i in 0..LANES {
            let (s, d) = ([s_mean[block][i], s_variance[block][i]], [d_mean[block][i], d_variance[block][i]]);
            let measurement = measure.similarity::<CONTRAST, FUSED>(s, d);
            (similarity[block][i], contrast[i]) = (measurement.similarity, measurement.contrast);
            let is_required = all_required | (counts[i] > R::default());
            failed[i] |= u32::from(is_required & !measurement.is_precise);
        }
        // Selected, not multiplied, because windows that do not count may be NaN.
        for i in 0..LANES {
            let counts = counts[i] > R::default();
            sums[0][i] += if counts { similarity[block][i].wide() } else { 0.0 };
            if CONTRAST {
                sums[1][i] += if counts { contrast[i].wide() } else { 0.0 };
            }
        }
    }
    row.sums = sums;
    row.is_precise = failed.iter().fold(0, |any, lane| any | lane) == 0;
}

#[inline(always)]
fn power_sums_kernel(s: &[f64], d: &[f64]) -> [f64; 4] {
    const WIDE: usize = 8;
    let mut sums = [[0.0; WIDE]; 4];
    let (s, s_rest) = s.as_chunks::<WIDE>();
    let (d, d_rest) = d.as_chunks::<WIDE>();
    for (s, d) in s.iter().zip(d) {
        for i in 0..WIDE {
            sums[0][i] += s[i];
            sums[1][i] += d[i];
            sums[2][i] += s[i] * s[i];
            sums[3][i] += d[i] * d[i];
        }
    }
    for (s, d) in s_rest.iter().zip(d_rest) {
        sums[0][0] += s;
        sums[1][0] += d;
        sums[2][0] += s * s;
        sums[3][0] += d * d;
    }
    sums.map(|lanes| lanes.iter().sum())
}
