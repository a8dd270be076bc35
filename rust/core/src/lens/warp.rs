//! Pictures through lenses, and pictures that lenses put right.

use rayon::prelude::*;

use super::{Method, RadialLens};
use crate::base::Result;
use crate::camera::Fov;

/// How pixels around a place become one value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Filter {
    /// Of four.
    Linear,
    /// Of sixteen: Catmull and Rom's cubics (Keys, a = −1/2).
    Cubic,
}

/// A value of a picture.
pub trait Pixel: Copy + Send + Sync {
    /// The same value.
    fn wide(self) -> f64;
    /// The nearest one there is.
    fn nearest(value: f64) -> Self;
}

macro_rules! pixel {
    ($($type:ty: $value:ident => $nearest:expr),*) => {$(
        impl Pixel for $type {
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
// Casts saturate, so that cubics which overshoot stay black or white.
pixel!(u8: v => v.round_ties_even() as u8, u16: v => v.round_ties_even() as u16, f32: v => v as f32, f64: v => v);

/// Rows of pixels with their channels side by side.
#[derive(Clone, Copy, Debug)]
pub struct Image<'a, P> {
    /// All values.
    pub values: &'a [P],
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// Values of a pixel.
    pub channels: usize,
}

/// What pictures show: both as tangents from the lens's axis.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// Of the picture that is read.
    pub from: Fov,
    /// Of the picture that is made.
    pub to: Fov,
    /// Tangent at which r = 1.
    pub tan_omega: f64,
    /// Pixels are shown at f(r), as the lens does it; else at f⁻¹(r), so that the lens puts them right.
    pub distort: bool,
}

impl View {
    /// Radii 1 apart, in pixels of a picture of that field of view: across and down.
    pub(super) fn density(&self, fov: &Fov, width: usize, height: usize) -> [f64; 2] {
        [width as f64 / (fov.right - fov.left), height as f64 / (fov.up - fov.down)].map(|each| each * self.tan_omega)
    }

    /// Place in units of the lens, y up, of shares of the made picture, from its top left corner.
    pub(super) fn place(&self, across: f64, down: f64) -> [f64; 2] {
        let Fov { left, right, down: bottom, up } = self.to;
        [(left + across * (right - left)) / self.tan_omega, (up - down * (up - bottom)) / self.tan_omega]
    }

    /// Shares of the picture that is read, from its top left corner.
    pub(super) fn share(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let Fov { left, right, down, up } = self.from;
        [(x * self.tan_omega - left) / (right - left), (up - y * self.tan_omega) / (up - down)]
    }

    /// Where what is shown at places comes from; NaN where from nowhere.
    pub(super) fn sources(&self, lens: &RadialLens, places: &[[f64; 2]], to: &mut [[f64; 2]]) -> Result<()> {
        if !self.distort {
            return lens.distort_points(places, to, false);
        }
        if lens.tangential != [0.0; 2] {
            return lens.undistort_points(places, to, false);
        }
        let radii: Vec<f64> = places.iter().map(|[x, y]| (x * x + y * y).sqrt()).collect();
        let mut roots = vec![0.0; radii.len()];
        // Its bound is a millionth of a pixel of any screen there is.
        lens.undistort_all(&radii, &mut roots, Method::Table, false)?;
        for (n, [x, y]) in places.iter().enumerate() {
            let scale = if radii[n] == 0.0 { 1.0 } else { roots[n] / radii[n] };
            to[n] = [x * scale, y * scale];
        }
        Ok(())
    }
}

/// Makes a picture row by row. `lenses` are one, or one for each channel; what shows nothing of the image is `fill`.
pub fn warp<P: Pixel>(
    lenses: &[RadialLens],
    image: &Image<'_, P>,
    view: &View,
    filter: Filter,
    fill: P,
    to: &mut [P],
    width: usize,
) -> Result<()> {
    let height = to.len() / (width * image.channels);
    to.par_chunks_mut(width * image.channels).enumerate().try_for_each(|(row, to)| {
        let down = (row as f64 + 0.5) / height as f64;
        let places: Vec<[f64; 2]> =
            (0..width).map(|column| view.place((column as f64 + 0.5) / width as f64, down)).collect();
        let mut sources = vec![[0.0; 2]; width];
        for (number, lens) in lenses.iter().enumerate() {
            view.sources(lens, &places, &mut sources)?;
            let channels = if lenses.len() == 1 { 0..image.channels } else { number..number + 1 };
            for (source, pixel) in sources.iter().zip(to.chunks_exact_mut(image.channels)) {
                let [across, down] = view.share(*source);
                for channel in channels.clone() {
                    pixel[channel] = image.at(across, down, channel, filter).map_or(fill, P::nearest);
                }
            }
        }
        Ok(())
    })
}

impl<P: Pixel> Image<'_, P> {
    /// Value at shares of the picture; `None` beside it. Beyond the outermost centres the outermost pixels go on.
    #[inline]
    fn at(&self, across: f64, down: f64, channel: usize, filter: Filter) -> Option<f64> {
        if !((0.0..=1.0).contains(&across) && (0.0..=1.0).contains(&down)) {
            return None;
        }
        let (x, y) = (across * self.width as f64 - 0.5, down * self.height as f64 - 0.5);
        let (column, row) = (x.floor(), y.floor());
        let value = |i: isize, j: isize| {
            let inside = |at: f64, by: isize, size: usize| (at as isize + by).clamp(0, size as isize - 1) as usize;
            let pixel = inside(row, j, self.height) * self.width + inside(column, i, self.width);
            self.values[pixel * self.channels + channel].wide()
        };
        let (s, t) = (x - column, y - row);
        Some(match filter {
            Filter::Linear => {
                let line = |j| value(0, j) + s * (value(1, j) - value(0, j));
                line(0) + t * (line(1) - line(0))
            }
            Filter::Cubic => {
                let (across, down) = (cubic_weights(s), cubic_weights(t));
                let line = |j: isize| (0..4).map(|i| across[i] * value(i as isize - 1, j)).sum::<f64>();
                (0..4).map(|j| down[j] * line(j as isize - 1)).sum()
            }
        })
    }
}

/// Keys (1981), a = −1/2: weights of the pixels at −1, 0, 1 and 2.
fn cubic_weights(t: f64) -> [f64; 4] {
    let (square, cube) = (t * t, t * t * t);
    [
        0.5 * (-cube + 2.0 * square - t),
        0.5 * (3.0 * cube - 5.0 * square + 2.0),
        0.5 * (-3.0 * cube + 4.0 * square + t),
        0.5 * (cube - square),
    ]
}
