//! Selection of the windows that count, and sums over them.

use super::super::extremes::ValueRange;
use super::super::plane::Plane;
use crate::base::Progress;

/// Sums over the pixels that count.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SimilaritySums {
    /// Sum of the similarity.
    pub similarity: f64,
    /// Sum of the contrast factor (contrast and structure); 0 if not requested.
    pub contrast: f64,
    /// Number of pixels that count.
    pub pixels: f64,
    /// Range of both images' values if requested: covers at least the pixels that counted windows see.
    pub range: ValueRange,
}

impl SimilaritySums {
    /// Returns the means of similarity and contrast factor.
    pub(super) fn means(&self) -> [f64; 2] {
        [self.similarity, self.contrast].map(|sum| sum / self.pixels)
    }

    pub(super) fn and(self, other: Self) -> Self {
        Self {
            similarity: self.similarity + other.similarity,
            contrast: self.contrast + other.contrast,
            pixels: self.pixels + other.pixels,
            range: self.range.and(other.range),
        }
    }
}

/// Selection of windows: those inside the image or all, restricted to a mask if there is one.
#[derive(Clone, Copy)]
pub struct Counted<'a> {
    /// Whether windows that extend beyond the image count too.
    pub all: bool,
    /// Mask of the image's size; non-zero values select pixels.
    pub mask: Option<Mask<'a>>,
    /// Whether to sum the contrast factor.
    pub contrast: bool,
    /// Whether to compute the range of values.
    pub range: bool,
    /// Progress and cancellation; sums are incomplete after a cancellation.
    pub progress: &'a Progress,
}

/// Effect of a mask on the mean, or on windows as well.
#[derive(Clone, Copy)]
pub enum Mask<'a> {
    /// Windows centred on other pixels do not count.
    Mean(Plane<'a, u8>),
    /// Windows also ignore other pixels, and those outside the image (normalised convolution).
    Windows(Plane<'a, u8>),
}

impl<'a> Mask<'a> {
    /// Returns the mask's pixels.
    pub(super) fn plane(&self) -> &Plane<'a, u8> {
        match self {
            Self::Mean(plane) | Self::Windows(plane) => plane,
        }
    }
}
