//! Structural similarity. Wang, Bovik, Sheikh, Simoncelli: Image quality assessment: from error visibility to structural
//! similarity, 2004: weighted means, variances and covariance in a window that moves over both images.
//!
//! With s = x + y and d = x − y, σx² + σy² = (σs² + σd²)/2 and 2 σxy = (σs² − σd²)/2: four moments instead of five, and
//! both factors of the measure are 1 less something that is never negative and nothing for equal images.

use std::ops::Range;

use super::global::global;
use super::masked::Masked;
use super::measure::Source;
use super::plane::{Part, Plane, Real};
use super::windows::Windows;
use crate::base::{Error, Result};

/// What is averaged around each pixel.
#[derive(Clone, Debug, PartialEq)]
pub enum Window {
    /// Separable weights, the same from both ends, that sum to 1; an even number of them reaches one pixel further up
    /// and left.
    Weights(Vec<f64>),
    /// The whole image at once.
    Global,
}

impl Window {
    /// A Gaussian of σ pixels, cut off at `size` pixels.
    pub fn gaussian(size: usize, sigma: f64) -> Self {
        let middle = (size as f64 - 1.0) / 2.0;
        let nearest = if size.is_multiple_of(2) { 0.25 } else { 0.0 };
        // Less the least exponent, so that something is left however narrow it is.
        let weight = |i: usize| match (i as f64 - middle).powi(2) - nearest {
            0.0 => 1.0,
            farther => (-0.5 * farther / sigma / sigma).exp(),
        };
        let weights: Vec<f64> = (0..size).map(weight).collect();
        let sum: f64 = weights.iter().sum();
        Self::Weights(weights.into_iter().map(|weight| weight / sum).collect())
    }

    /// All `size` pixels alike.
    pub fn uniform(size: usize) -> Self {
        Self::Weights(vec![1.0 / size as f64; size])
    }
}

/// Constants of the measure: (k₁ L)² and (k₂ L)² keep it defined where means or variances vanish.
#[derive(Clone, Copy, Debug)]
pub struct Similarity {
    /// For the means.
    pub c1: f64,
    /// For the variances.
    pub c2: f64,
}

/// Two images to be compared.
#[derive(Clone, Copy)]
pub struct Pair<'a, P> {
    /// One of them.
    pub reference: Plane<'a, P>,
    /// The other one, of the same size.
    pub test: Plane<'a, P>,
}

impl<'a, P: Source> Pair<'a, P> {
    /// Two images of one size.
    pub fn new(reference: Plane<'a, P>, test: Plane<'a, P>) -> Result<Self> {
        reference.expect_size("test", [test.height, test.width])?;
        Ok(Self { reference, test })
    }

    /// Sum and difference of both along neighbouring pixels of a row, less their levels.
    #[inline]
    pub(super) fn load(&self, row: usize, columns: Range<usize>, levels: [P::Real; 2], [s, d]: [&mut [P::Real]; 2]) {
        let Self { reference, test } = self;
        match (reference.run(row, columns.clone()), test.run(row, columns.clone())) {
            (Some(x), Some(y)) => P::sum_and_difference(x, y, levels, s, d),
            _ => self.gather(row, columns, levels, [s, d]),
        }
    }

    /// The same in any precision and for any columns.
    pub(super) fn gather<R: Real>(
        &self,
        row: usize,
        columns: impl Iterator<Item = usize>,
        levels: [R; 2],
        [s, d]: [&mut [R]; 2],
    ) {
        for ((s, d), column) in s.iter_mut().zip(d).zip(columns) {
            let x = R::narrow(self.reference.at(row, column).wide()) - levels[0];
            let y = R::narrow(self.test.at(row, column).wide()) - levels[1];
            (*s, *d) = (x + y, x - y);
        }
    }

    /// About the means of both in a part, or of what a mask names of it.
    pub(super) fn levels(&self, part: &Part, mask: Option<&Plane<'_, u8>>) -> [f64; 2] {
        [&self.reference, &self.test].map(|image| image.level(part, mask))
    }

    /// The squared difference of one pixel.
    #[inline(always)]
    pub(super) fn square(&self, row: usize, column: usize) -> f64 {
        let difference = self.reference.at(row, column).wide() - self.test.at(row, column).wide();
        difference * difference
    }
}

/// Sums over the pixels that count.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sums {
    /// Of the measure.
    pub similarity: f64,
    /// Of its second factor alone, which compares contrast and structure; 0 where it is not wanted.
    pub contrast: f64,
    /// Pixels that count.
    pub pixels: f64,
}

impl Sums {
    pub(super) fn and(self, other: Self) -> Self {
        Self {
            similarity: self.similarity + other.similarity,
            contrast: self.contrast + other.contrast,
            pixels: self.pixels + other.pixels,
        }
    }
}

/// Which windows count: those within the image, or all, and of these those that a mask names.
#[derive(Clone, Copy)]
pub struct Counted<'a> {
    /// Whether windows that reach beyond the image count too.
    pub all: bool,
    /// Of the image's size; anything but 0 names a pixel.
    pub mask: Option<Mask<'a>>,
    /// Whether the sum of the second factor is wanted.
    pub contrast: bool,
}

/// What a mask limits.
#[derive(Clone, Copy)]
pub enum Mask<'a> {
    /// The mean: windows around other pixels do not count.
    Mean(Plane<'a, u8>),
    /// What windows see as well: other pixels, and those outside of the image, have no weight (normalised convolution).
    Windows(Plane<'a, u8>),
}

impl<'a> Mask<'a> {
    /// The pixels that it names.
    pub(super) fn plane(&self) -> &Plane<'a, u8> {
        match self {
            Self::Mean(plane) | Self::Windows(plane) => plane,
        }
    }
}

/// Sums of the similarity of windows, and where wanted its map: rows of the image's width. Outside of images these are
/// mirrored. Without a map only windows that count are looked at.
pub fn similarity<P: Source>(
    pair: &Pair<'_, P>,
    window: &Window,
    constants: Similarity,
    counted: Counted<'_>,
    map: Option<&mut [P::Real]>,
) -> Result<Sums> {
    let size = [pair.reference.height, pair.reference.width];
    if let Some(mask) = counted.mask {
        pair.reference.expect_size("mask", [mask.plane().height, mask.plane().width])?;
    }
    if let Some(map) = map.as_ref().filter(|map| map.len() != size[0] * size[1]) {
        return Err(Error::value("map", format!("{} × {} values", size[0], size[1]), map.len()));
    }
    let constants = [constants.c1, constants.c2];
    Ok(match (window, counted.mask) {
        (Window::Global, _) => global(pair, constants, counted, map),
        (Window::Weights(weights), Some(Mask::Windows(mask))) => {
            Masked { pair: *pair, weights, constants, mask, contrast: counted.contrast }.sums(map)
        }
        (Window::Weights(weights), _) => Windows::new(*pair, weights, constants, counted).sums(map),
    })
}

#[cfg(test)]
mod tests {
    use super::super::plane::Plane;
    use super::*;

    fn plane(values: &[f64]) -> Plane<'_, f64> {
        Plane::new(values, [5, 7], [7, 1]).unwrap()
    }

    #[test]
    fn equal_images_are_exactly_alike_and_order_does_not_matter() {
        let a: Vec<f64> = (0..35).map(|i| f64::from(i * i % 17) / 16.0).collect();
        let b: Vec<f64> = (0..35).map(|i| f64::from(i * 7 % 13) / 12.0).collect();
        let constants = Similarity { c1: 1e-4, c2: 9e-4 };
        for window in [Window::gaussian(11, 1.5), Window::uniform(4), Window::Global] {
            let of = |a: &[f64], b: &[f64]| {
                let mut map = vec![0.0; 35];
                let pair = Pair::new(plane(a), plane(b)).unwrap();
                let counted = Counted { all: true, mask: None, contrast: true };
                let sums = similarity(&pair, &window, constants, counted, Some(&mut map)).unwrap();
                assert_eq!(sums, similarity(&pair, &window, constants, counted, None).unwrap());
                (sums, map)
            };
            assert!(of(&a, &a).1.iter().all(|&value| value == 1.0));
            assert_eq!(of(&a, &a).0, Sums { similarity: 35.0, contrast: 35.0, pixels: 35.0 });
            assert_eq!(of(&a, &b), of(&b, &a));
            assert!(of(&a, &b).1.iter().all(|&value| value < 1.0));
        }
    }
}
