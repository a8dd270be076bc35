//! Value ranges of images, computed during the comparison, and vectors of pixels.

use super::plane::Pixel;
use crate::base::Real;

/// Number of pixels per vector operation.
pub(super) const LANES: usize = 32;

#[inline(always)]
pub(super) fn lanes<R>(values: &[R]) -> &[R; LANES] {
    &values.as_chunks::<LANES>().0[0]
}

/// Minimum and maximum of some pixels. An empty range has `least > greatest`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ValueRange {
    /// Minimum.
    pub least: f64,
    /// Maximum.
    pub greatest: f64,
}

impl Default for ValueRange {
    fn default() -> Self {
        Self { least: f64::INFINITY, greatest: f64::NEG_INFINITY }
    }
}

impl ValueRange {
    pub(super) fn union(self, other: Self) -> Self {
        Self { least: self.least.min(other.least), greatest: self.greatest.max(other.greatest) }
    }

    /// Extends the range by a value; NaN is ignored.
    #[inline(always)]
    pub(super) fn include(&mut self, value: f64) {
        *self = self.union(Self { least: value, greatest: value });
    }
}

/// Minimum and maximum per lane, so that rows of pixels are compared in whole vectors.
#[derive(Clone, Copy, Debug)]
pub struct Extremes<P> {
    pub(super) least: [P; LANES],
    pub(super) greatest: [P; LANES],
}

impl<P: Pixel> Default for Extremes<P> {
    fn default() -> Self {
        Self { least: [P::MAX; LANES], greatest: [P::MIN; LANES] }
    }
}

impl<P: Pixel> Extremes<P> {
    /// Extends a lane's range by a pixel; NaN is ignored, because it fails both comparisons.
    #[inline(always)]
    pub(super) fn include(&mut self, lane: usize, pixel: P) {
        self.least[lane] = if pixel < self.least[lane] { pixel } else { self.least[lane] };
        self.greatest[lane] = if pixel > self.greatest[lane] { pixel } else { self.greatest[lane] };
    }

    pub(super) fn range(&self) -> ValueRange {
        let mut range = ValueRange::default();
        // Unused lanes hold the type's bounds in reverse order.
        for (&least, &greatest) in self.least.iter().zip(&self.greatest).filter(|(least, greatest)| least <= greatest) {
            range.include(least.real().wide());
            range.include(greatest.real().wide());
        }
        range
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::{Pair, PixelRows, Plane};

    fn range<P: PixelRows>(values: &[P], width: usize, step: usize) -> ValueRange {
        let plane = |from: usize| Plane::new(&values[from..], [1, width], [1, step]).unwrap();
        Pair::new(plane(0), plane(values.len() / 2)).unwrap().range()
    }

    #[test]
    fn every_pixel_counts_wherever_it_lies() {
        for index in 0..2 * 75 {
            let mut bytes = [9u8; 150];
            bytes[index] = 255;
            assert_eq!(range(&bytes, 75, 1), ValueRange { least: 9.0, greatest: 255.0 });
            let mut reals = [0.5f32; 150];
            reals[index] = -3.0;
            assert_eq!(range(&reals, 75, 1), ValueRange { least: -3.0, greatest: 0.5 });
        }
    }

    #[test]
    fn nan_and_unread_pixels_are_ignored() {
        let mut reals = [2.0f64; 300];
        (reals[3], reals[8]) = (f64::NAN, -1.0);
        (reals[1], reals[299]) = (9.0, 9.0);
        assert_eq!(range(&reals, 75, 2), ValueRange { least: -1.0, greatest: 2.0 });
        assert_eq!(range(&[f32::NAN; 80], 40, 1), ValueRange::default());
        assert_eq!(range(&[u16::MAX; 80], 40, 1), ValueRange { least: 65_535.0, greatest: 65_535.0 });
    }
}
