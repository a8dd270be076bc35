//! Warping of pictures by a lens's distortion, or by its inverse so that the lens undoes the warp.

use std::ops::Range;

use rayon::prelude::*;

use super::points::{CHUNK, PointChunk};
use super::radial::RadialLens;
use crate::base::simd::vectorized;
use crate::base::{Progress, Result};
use crate::camera::Fov;

/// Interpolation between pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WarpFilter {
    /// Bilinear, from four pixels.
    Linear,
    /// Bicubic, from sixteen pixels: Catmull and Rom's cubics (Keys, a = −1/2).
    Cubic,
}

/// The type of a picture's values.
pub trait WarpPixel: Copy + Send + Sync {
    /// Converts to float64, exactly.
    fn wide(self) -> f64;
    /// Rounds to this type.
    fn nearest(value: f64) -> Self;
}

macro_rules! pixel {
    ($($type:ty: $value:ident => $nearest:expr);*) => {$(
        impl WarpPixel for $type {
            #[inline(always)]
            fn wide(self) -> f64 {
                self.into()
            }
            #[inline(always)]
            fn nearest($value: f64) -> Self {
                $nearest
            }
        }
    )*};
}
// Casts saturate, so overshoots of the cubic filter are clamped to black or white.
pixel! {
    u8: v => v.round_ties_even() as u8;
    u16: v => v.round_ties_even() as u16;
    f32: v => v as f32;
    f64: v => v
}

/// Rows of pixels with interleaved channels.
#[derive(Clone, Copy, Debug)]
pub struct Image<'a, P> {
    /// All values.
    pub values: &'a [P],
    /// Width, pixels.
    pub width: usize,
    /// Height, pixels.
    pub height: usize,
    /// Number of values per pixel.
    pub channels: usize,
}

/// Fields of view of the source and the target picture, as tangents from the lens's axis.
#[derive(Clone, Copy, Debug)]
pub struct WarpView {
    /// Field of view of the source picture.
    pub from: Fov,
    /// Field of view of the target picture.
    pub to: Fov,
    /// Tangent at which r = 1.
    pub tan_omega: f64,
    /// Whether a pixel at r moves to f(r), as the lens moves it; otherwise to f⁻¹(r), so that the lens undoes the warp.
    pub distort: bool,
}

impl WarpView {
    /// Returns the pixels per unit of r, across and down, of a picture with a field of view.
    pub(super) fn density(&self, fov: &Fov, width: usize, height: usize) -> [f64; 2] {
        [width as f64 / (fov.right - fov.left), height as f64 / (fov.up - fov.down)].map(|each| each * self.tan_omega)
    }

    /// Converts fractions from the target picture's top left corner to units of the lens, y up.
    pub(super) fn lens_position(&self, across: f64, down: f64) -> [f64; 2] {
        (self.to.point(across, down) / self.tan_omega).to_array()
    }

    /// Converts units of the lens to fractions from the source picture's top left corner.
    pub(super) fn source_fraction(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let Fov { left, right, down, up } = self.from;
        [(x * self.tan_omega - left) / (right - left), (up - y * self.tan_omega) / (up - down)]
    }

    /// Writes the source position of each point of the target picture; NaN if there is none.
    pub(super) fn sources(
        &self,
        lens: &RadialLens,
        positions: &[[f64; 2]],
        to: &mut [[f64; 2]],
        progress: &Progress,
    ) -> Result<()> {
        if !self.distort {
            return lens.distort_points(positions, to, false, progress);
        }
        if lens.tangential != [0.0; 2] {
            return lens.undistort_points(positions, to, false, progress);
        }
        for (from, to) in positions.chunks(CHUNK).zip(to.chunks_mut(CHUNK)) {
            PointChunk::new(from).scale_radii(to, |radii| lens.undistort_blocks(radii, false, 0.0));
            progress.check()?;
        }
        Ok(())
    }
}

/// Writes the target picture, `width` pixels wide. `lenses` holds one lens, or one per channel. Pixels without a source
/// are set to `fill`.
#[expect(clippy::too_many_arguments, reason = "a picture, a view, and where the result goes")]
pub fn warp<P: WarpPixel>(
    lenses: &[RadialLens],
    image: &Image<'_, P>,
    view: &WarpView,
    filter: WarpFilter,
    fill: P,
    to: &mut [P],
    width: usize,
    progress: &Progress,
) -> Result<()> {
    let height = to.len() / (width * image.channels);
    progress.expect(height as u64);
    to.par_chunks_mut(width * image.channels).enumerate().try_for_each(|(row, to)| {
        let down = (row as f64 + 0.5) / height as f64;
        let position_of = |column| view.lens_position((column as f64 + 0.5) / width as f64, down);
        let positions: Vec<[f64; 2]> = (0..width).map(position_of).collect();
        let mut sources = vec![[0.0; 2]; width];
        for (number, lens) in lenses.iter().enumerate() {
            view.sources(lens, &positions, &mut sources, progress)?;
            let channels = if lenses.len() == 1 { 0..image.channels } else { number..number + 1 };
            for source in &mut sources {
                *source = view.source_fraction(*source);
            }
            mix_row(image, &sources, channels, filter, fill, to);
        }
        progress.report(1)
    })
}

vectorized! {
    /// Writes some channels of a row of pixels. `positions` are fractions of the image.
    fn mix_row<P: WarpPixel>(
        image: &Image<'_, P>,
        positions: &[[f64; 2]],
        channels: Range<usize>,
        filter: WarpFilter,
        fill: P,
        to: &mut [P],
    ) = mix;
}

#[inline(always)]
fn mix<P: WarpPixel>(
    image: &Image<'_, P>,
    positions: &[[f64; 2]],
    channels: Range<usize>,
    filter: WarpFilter,
    fill: P,
    to: &mut [P],
) {
    match filter {
        WarpFilter::Linear => mix_by(linear_weights, image, positions, channels, fill, to),
        WarpFilter::Cubic => mix_by(cubic_weights, image, positions, channels, fill, to),
    }
}

/// Interpolates pixels with weights that depend on the fractional position.
#[inline(always)]
fn mix_by<P: WarpPixel, const N: usize>(
    weights: impl Fn(f64) -> [f64; N],
    image: &Image<'_, P>,
    positions: &[[f64; 2]],
    channels: Range<usize>,
    fill: P,
    to: &mut [P],
) {
    for (position, pixel) in positions.iter().zip(to.chunks_exact_mut(image.channels)) {
        match image.position_of(*position) {
            None => pixel[channels.clone()].fill(fill),
            Some([x, y]) => {
                let weights = [weights(x - x.floor()), weights(y - y.floor())];
                image.mix([x, y], channels.start, weights, &mut pixel[channels.clone()]);
            }
        }
    }
}

impl<P: WarpPixel> Image<'_, P> {
    /// Converts fractions to column and row, 0 at the first pixel's centre; `None` outside the picture.
    #[inline(always)]
    fn position_of(&self, [across, down]: [f64; 2]) -> Option<[f64; 2]> {
        let within = (0.0..=1.0).contains(&across) && (0.0..=1.0).contains(&down);
        within.then_some([across * self.width as f64 - 0.5, down * self.height as f64 - 0.5])
    }

    /// Interpolates some channels at a position. Beyond the outermost centres the outermost pixels are repeated.
    #[inline(always)]
    fn mix<const N: usize>(&self, [x, y]: [f64; 2], first: usize, [across, down]: [[f64; N]; 2], to: &mut [P]) {
        let (mut columns, mut rows) = ([0; N], [0; N]);
        for n in 0..N {
            columns[n] = neighbour::<N>(x, n, self.width) * self.channels + first;
            rows[n] = neighbour::<N>(y, n, self.height) * self.width * self.channels;
        }
        for (channel, to) in to.iter_mut().enumerate() {
            let mut value = 0.0;
            for j in 0..N {
                let mut line = 0.0;
                for i in 0..N {
                    line += across[i] * self.values[rows[j] + columns[i] + channel].wide();
                }
                value += down[j] * line;
            }
            *to = P::nearest(value);
        }
    }
}

/// Returns the index of the n-th of the N pixels around a position.
#[inline(always)]
fn neighbour<const N: usize>(position: f64, n: usize, size: usize) -> usize {
    let number = position.floor() as isize + n as isize - (N as isize / 2 - 1);
    number.clamp(0, size as isize - 1) as usize
}

/// Returns the weights of the pixels at 0 and 1.
#[inline(always)]
fn linear_weights(t: f64) -> [f64; 2] {
    [1.0 - t, t]
}

/// Returns the weights of the pixels at −1, 0, 1 and 2: Keys (1981), a = −1/2.
#[inline(always)]
fn cubic_weights(t: f64) -> [f64; 4] {
    let (square, cube) = (t * t, t * t * t);
    [
        0.5 * (-cube + 2.0 * square - t),
        0.5 * (3.0 * cube - 5.0 * square + 2.0),
        0.5 * (-3.0 * cube + 4.0 * square + t),
        0.5 * (cube - square),
    ]
}
