//! The windows that count, and sums over them.

use super::super::extremes::ValueRange;
use super::super::plane::Plane;
use crate::base::Progress;

/// Sums over the pixels that count.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SimilaritySums {
    /// Sum of the measure.
    pub similarity: f64,
    /// Sum of its second factor alone, which compares contrast and structure; 0 where it is not wanted.
    pub contrast: f64,
    /// Pixels that count.
    pub pixels: f64,
    /// Of both images, where it is wanted: at least of what windows that count see.
    pub range: ValueRange,
}

impl SimilaritySums {
    /// Mean of the measure, and of its second factor.
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

/// Windows that count: those within the image, or all, and of these those that a mask names.
#[derive(Clone, Copy)]
pub struct Counted<'a> {
    /// Whether windows that reach beyond the image count too.
    pub all: bool,
    /// Of the image's size; anything but 0 names a pixel.
    pub mask: Option<Mask<'a>>,
    /// Whether the sum of the second factor is wanted.
    pub contrast: bool,
    /// Whether the range of values is wanted.
    pub range: bool,
    /// Where the caller may cancel; sums are then not complete.
    pub progress: &'a Progress,
}

/// Pixels that a mask excludes: from the mean, or from windows as well.
#[derive(Clone, Copy)]
pub enum Mask<'a> {
    /// The mean: windows around other pixels do not count.
    Mean(Plane<'a, u8>),
    /// Windows as well: other pixels, and those outside of the image, have no weight (normalised convolution).
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
