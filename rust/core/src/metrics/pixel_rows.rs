//! Kernels over rows of pixels: sums and differences, squared differences. Metrics use fused multiply-add if the
//! machine has it, which halves the instructions and saves a rounding. Otherwise results are the same on all machines.

use super::extremes::{Extremes, LANES};
use super::plane::Pixel;
use crate::base::simd::vectorized;

/// Lanes of the kernel that also finds extremes. Few, because its last block overlaps the previous one.
pub(super) const EXTREME_LANES: usize = LANES / 2;

/// Pixel types with row kernels.
pub trait PixelRows: Pixel {
    /// Returns the sum of the squared differences of a short run of pixels.
    fn squares(x: &[Self], y: &[Self]) -> f64;
}

macro_rules! pixel_rows {
    ($($pixel:ty: $squares:ident);*) => {$(
        impl PixelRows for $pixel {
            vectorized! { fn squares(x: &[$pixel], y: &[$pixel]) -> f64 = $squares; }
        }
    )*};
}

pixel_rows!(u8: byte_squares; u16: short_squares; f32: real_squares; f64: real_squares);

vectorized! {
    /// Writes sums and differences of two rows of pixels minus their levels.
    pub(super) fn sum_and_difference<P: Pixel>(
        x: &[P],
        y: &[P],
        levels: [P::Real; 2],
        s: &mut [P::Real],
        d: &mut [P::Real],
    ) = sum_and_difference_kernel;
    /// Same, and finds the extremes of both rows, which have at least `EXTREME_LANES` pixels.
    pub(super) fn sum_difference_and_extremes<P: Pixel>(
        x: &[P],
        y: &[P],
        levels: [P::Real; 2],
        s: &mut [P::Real],
        d: &mut [P::Real],
        extremes: &mut Extremes<P>,
    ) = sum_difference_and_extremes_kernel;
    /// Extends `extremes` by (rows, width) pixels; rows begin `step` values apart.
    pub(super) fn extend<P: Pixel>(values: &[P], step: usize, size: [usize; 2], extremes: &mut Extremes<P>)
        = extend_kernel;
}

/// Exact: 2¹⁴ squares of 8 bits fit into 32 bits.
#[inline(always)]
fn byte_squares(x: &[u8], y: &[u8]) -> f64 {
    let mut sum = 0u32;
    for (&x, &y) in x.iter().zip(y) {
        let difference = i32::from(x) - i32::from(y);
        sum += (difference * difference) as u32;
    }
    f64::from(sum)
}

/// Exact: 2¹⁴ squares of 16 bits need 46 bits.
#[inline(always)]
fn short_squares(x: &[u16], y: &[u16]) -> f64 {
    let mut sum = 0u64;
    for (&x, &y) in x.iter().zip(y) {
        let difference = u32::from(x.abs_diff(y));
        sum += u64::from(difference * difference);
    }
    sum as f64
}

#[inline(always)]
fn real_squares<P: Copy + Into<f64>>(x: &[P], y: &[P]) -> f64 {
    let mut sums = [0.0; LANES];
    let (x, last_x) = x.as_chunks::<LANES>();
    let (y, last_y) = y.as_chunks::<LANES>();
    for (x, y) in x.iter().zip(y) {
        for i in 0..LANES {
            let difference = x[i].into() - y[i].into();
            sums[i] += difference * difference;
        }
    }
    for (i, (&x, &y)) in last_x.iter().zip(last_y).enumerate() {
        let difference = x.into() - y.into();
        sums[i] += difference * difference;
    }
    sums.iter().sum()
}

#[inline(always)]
fn sum_and_difference_kernel<P: Pixel>(x: &[P], y: &[P], levels: [P::Real; 2], s: &mut [P::Real], d: &mut [P::Real]) {
    let length = x.len().min(y.len()).min(s.len()).min(d.len());
    let (x, y, s, d) = (&x[..length], &y[..length], &mut s[..length], &mut d[..length]);
    for i in 0..length {
        let (a, b) = (x[i].real() - levels[0], y[i].real() - levels[1]);
        s[i] = a + b;
        d[i] = a - b;
    }
}

#[inline(always)]
fn sum_difference_and_extremes_kernel<P: Pixel>(
    x: &[P],
    y: &[P],
    levels: [P::Real; 2],
    s: &mut [P::Real],
    d: &mut [P::Real],
    extremes: &mut Extremes<P>,
) {
    let length = x.len().min(y.len()).min(s.len()).min(d.len());
    let (x, y, s, d) = (&x[..length], &y[..length], &mut s[..length], &mut d[..length]);
    let (shared_least, shared_greatest) = (first(&mut extremes.least), first(&mut extremes.greatest));
    // Local copies stay in registers.
    let (mut least, mut greatest) = (*shared_least, *shared_greatest);
    let mut block = |x: &[P; EXTREME_LANES],
                     y: &[P; EXTREME_LANES],
                     s: &mut [P::Real; EXTREME_LANES],
                     d: &mut [P::Real; EXTREME_LANES]| {
        for i in 0..EXTREME_LANES {
            let (a, b) = (x[i].real() - levels[0], y[i].real() - levels[1]);
            s[i] = a + b;
            d[i] = a - b;
            // NaN is ignored together with the other image's pixel, which no window that counts contains.
            let (low, high) = if x[i] < y[i] { (x[i], y[i]) } else { (y[i], x[i]) };
            least[i] = if low < least[i] { low } else { least[i] };
            greatest[i] = if high > greatest[i] { high } else { greatest[i] };
        }
    };
    let images = x.as_chunks().0.iter().zip(y.as_chunks().0);
    let lines = s.as_chunks_mut().0.iter_mut().zip(d.as_chunks_mut().0);
    images.zip(lines).for_each(|((x, y), (s, d))| block(x, y, s, d));
    // The last block includes some pixels again, which changes nothing.
    if let (Some(x), Some(y), Some(s), Some(d)) =
        (x.last_chunk(), y.last_chunk(), s.last_chunk_mut(), d.last_chunk_mut())
    {
        block(x, y, s, d);
    }
    (*shared_least, *shared_greatest) = (least, greatest);
}

#[inline(always)]
fn first<P>(lanes: &mut [P; LANES]) -> &mut [P; EXTREME_LANES] {
    &mut lanes.as_chunks_mut().0[0]
}

#[inline(always)]
fn extend_kernel<P: Pixel>(values: &[P], step: usize, [rows, width]: [usize; 2], extremes: &mut Extremes<P>) {
    let rows = (0..rows).map(|row| &values[row * step..][..width]);
    if width < LANES {
        rows.for_each(|row| row.iter().enumerate().for_each(|(i, &pixel)| extremes.include(i, pixel)));
        return;
    }
    // Local copies stay in registers as long as no lane is indexed at run time.
    let (mut least, mut greatest) = (extremes.least, extremes.greatest);
    let mut include = |block: &[P; LANES]| {
        for i in 0..LANES {
            least[i] = if block[i] < least[i] { block[i] } else { least[i] };
            greatest[i] = if block[i] > greatest[i] { block[i] } else { greatest[i] };
        }
    };
    for row in rows {
        row.as_chunks::<LANES>().0.iter().for_each(&mut include);
        // The last block includes some pixels again, which changes nothing.
        if !width.is_multiple_of(LANES) {
            row.last_chunk::<LANES>().into_iter().for_each(&mut include);
        }
    }
    (extremes.least, extremes.greatest) = (least, greatest);
}
