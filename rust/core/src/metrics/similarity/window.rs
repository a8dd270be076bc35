//! Windows, the constants of the measure, the selection of the windows that count, and sums over them.

use rayon::prelude::*;

use super::super::extremes::ValueRange;
use super::super::plane::Plane;
use crate::base::{Progress, Real};

/// Weights of the pixels around each pixel.
#[derive(Clone, Debug, PartialEq)]
pub enum Window {
    /// Symmetric separable weights that sum to 1; a window of even size extends one pixel further up and left.
    Weights(Vec<f64>),
    /// The whole image at once.
    Global,
}

impl Window {
    /// Creates a Gaussian of σ pixels, truncated to `size` pixels.
    pub fn gaussian(size: usize, sigma: f64) -> Self {
        let middle = (size as f64 - 1.0) / 2.0;
        let nearest = if size.is_multiple_of(2) { 0.25 } else { 0.0 };
        // Relative to the largest weight, so that a narrow Gaussian does not underflow to zero everywhere.
        let weight = |i: usize| match (i as f64 - middle).powi(2) - nearest {
            0.0 => 1.0,
            farther => (-0.5 * farther / sigma / sigma).exp(),
        };
        let weights: Vec<f64> = (0..size).map(weight).collect();
        let sum: f64 = weights.iter().sum();
        Self::Weights(weights.into_iter().map(|weight| weight / sum).collect())
    }

    /// Creates `size` equal weights.
    pub fn uniform(size: usize) -> Self {
        Self::Weights(vec![1.0 / size as f64; size])
    }
}

/// Constants of the measure, (k₁ L)² and (k₂ L)², which keep it defined if means or variances vanish.
#[derive(Clone, Copy, Debug)]
pub struct Similarity {
    /// Constant of the means.
    pub c1: f64,
    /// Constant of the variances.
    pub c2: f64,
}

/// Sums over the pixels that count.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SimilaritySums {
    /// Sum of the similarity.
    pub similarity: f64,
    /// Sum of the contrast factor (contrast and structure); 0 if not requested.
    pub contrast: f64,
    /// Number of pixels that count.
    pub pixels: f64,
    /// Range of both images' values if requested; includes at least all pixels in windows that count.
    pub range: ValueRange,
}

impl SimilaritySums {
    /// Returns the means of similarity and contrast factor.
    pub(super) fn means(&self) -> [f64; 2] {
        [self.similarity, self.contrast].map(|sum| sum / self.pixels)
    }

    pub(super) fn plus(self, other: Self) -> Self {
        Self {
            similarity: self.similarity + other.similarity,
            contrast: self.contrast + other.contrast,
            pixels: self.pixels + other.pixels,
            range: self.range.union(other.range),
        }
    }
}

/// Selection of windows: those inside the image or all, restricted to a mask if there is one.
#[derive(Clone, Copy)]
pub struct Selection<'a> {
    /// Whether to include windows across the image's border.
    pub includes_border: bool,
    /// Mask of the image's size; non-zero values select pixels.
    pub mask: Option<Mask<'a>>,
    /// Whether to sum the contrast factor.
    pub contrast: bool,
    /// Whether to compute the range of values.
    pub range: bool,
    /// Progress and cancellation; sums are incomplete after a cancellation.
    pub progress: &'a Progress,
}

/// Effect of a mask.
#[derive(Clone, Copy)]
pub enum Mask<'a> {
    /// Windows centred on pixels outside the mask do not count.
    Mean(Plane<'a, u8>),
    /// Windows also ignore pixels outside the mask or the image (normalised convolution).
    Windows(Plane<'a, u8>),
}

impl<'a> Mask<'a> {
    pub(super) fn plane(&self) -> &Plane<'a, u8> {
        match self {
            Self::Mean(plane) | Self::Windows(plane) => plane,
        }
    }
}

/// Rows of a map, starting at row `top`.
pub(super) struct MapRows<'a, R> {
    values: &'a mut [R],
    width: usize,
    top: usize,
}

impl<R: Real> MapRows<'_, R> {
    pub fn write<S: Real>(&mut self, row: usize, column: usize, values: &[S]) {
        let first = (row - self.top) * self.width + column;
        for (slot, value) in self.values[first..].iter_mut().zip(values) {
            *slot = R::narrow(value.wide());
        }
    }
}

/// Returns the sums over all bands of `band_rows` rows; `band` gets the first row, the end row and the map's rows.
pub(super) fn sum_bands<R: Real>(
    [height, width]: [usize; 2],
    band_rows: usize,
    map: Option<&mut [R]>,
    band: impl Fn([usize; 2], Option<MapRows<'_, R>>) -> SimilaritySums + Sync,
) -> SimilaritySums {
    let rows = |n: usize| [n * band_rows, height.min((n + 1) * band_rows)];
    let sums: Vec<SimilaritySums> = match map {
        Some(map) => {
            let bands = map.par_chunks_mut(band_rows * width).enumerate();
            bands.map(|(n, values)| band(rows(n), Some(MapRows { values, width, top: n * band_rows }))).collect()
        }
        None => (0..height.div_ceil(band_rows)).into_par_iter().map(|n| band(rows(n), None)).collect(),
    };
    sums.into_iter().fold(SimilaritySums::default(), SimilaritySums::plus)
}
