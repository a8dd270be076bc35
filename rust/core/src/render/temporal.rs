//! Temporal anti-aliasing (Karis 2014): blends each picture with the accumulated history.
//!
//! Each picture is rendered with a different pixel jitter. The history is looked up at the surface's previous
//! position, and its colour is clamped to the box of colours around the pixel, because it may show another surface.

use rayon::prelude::*;

use crate::base::{Progress, Result, ensure};

type Color = [f32; 3];

/// A picture with motion vectors.
#[derive(Clone, Copy, Debug)]
pub struct Moving<'a> {
    /// Pixels per row.
    pub width: usize,
    /// Linear RGB.
    pub color: &'a [Color],
    /// Pixels to the right and down by which each pixel's surface has moved; NaN if unknown.
    pub motion: &'a [[f32; 2]],
    /// Distances of the surfaces, metres.
    pub range: &'a [f32],
}

/// Extra growth of the colour box where nothing moves, so that detail missing from one picture is not lost.
const STATIC_GROWTH: f32 = 1.0;
/// Speed from which on the box does not grow, pixels per picture.
const MAX_GROWTH_SPEED: f32 = 4.0;
/// Minimum half side of a box, which keeps divisions finite.
const MIN_HALF_SIDE: f32 = 1e-12;

impl Moving<'_> {
    /// Blends the picture, with a weight, into the history, a picture of the same size.
    pub fn gather(&self, history: &[Color], weight: f32, mixed: &mut [Color], progress: &Progress) -> Result<()> {
        let count = self.color.len();
        let are_rows = self.width > 0 && count.is_multiple_of(self.width);
        ensure!(are_rows, "color", format!("rows of {} pixels", self.width), count);
        for (argument, length) in [
            ("motion", self.motion.len()),
            ("range", self.range.len()),
            ("gathered", history.len()),
            ("mixed", mixed.len()),
        ] {
            ensure!(length == count, argument, format!("{count} pixels"), length);
        }
        mixed.par_chunks_mut(self.width).enumerate().try_for_each(|(y, row)| {
            for (x, mixed) in row.iter_mut().enumerate() {
                let now = self.color[y * self.width + x];
                *mixed = match self.history_color(history, x, y) {
                    None => now,
                    Some(before) => std::array::from_fn(|i| before[i] + (now[i] - before[i]) * weight),
                };
            }
            progress.check()
        })
    }

    /// Returns the history's colour at the previous position of a pixel's surface; `None` outside the picture.
    fn history_color(&self, history: &[Color], x: usize, y: usize) -> Option<Color> {
        let (width, height) = (self.width, self.color.len() / self.width);
        let [right, down] = self.motion[self.nearest_around(x, y)];
        let position = [x as f64 + 0.5 - f64::from(right), y as f64 + 0.5 - f64::from(down)];
        let is_inside = (0.0..=width as f64).contains(&position[0]) && (0.0..=height as f64).contains(&position[1]);
        if !is_inside {
            return None;
        }
        let speed = right.hypot(down);
        let growth = 1.0 + STATIC_GROWTH * (1.0 - (speed / MAX_GROWTH_SPEED).min(1.0));
        Some(self.box_around(x, y, growth).clamp(cubic(history, width, position)))
    }

    /// Returns the pixel of the nearest of 3 × 3 surfaces, so that both sides of an edge follow the foreground.
    fn nearest_around(&self, x: usize, y: usize) -> usize {
        let nearer = |a: usize, b: usize| if self.range[b] < self.range[a] { b } else { a };
        self.neighbourhood(x, y).fold(y * self.width + x, nearer)
    }

    /// Returns the pixels of the picture in the 3 × 3 square around a pixel.
    fn neighbourhood(&self, x: usize, y: usize) -> impl Iterator<Item = usize> {
        let (width, height) = (self.width, self.color.len() / self.width);
        let columns = x.saturating_sub(1)..(x + 2).min(width);
        (y.saturating_sub(1)..(y + 2).min(height)).flat_map(move |row| columns.clone().map(move |x| row * width + x))
    }

    /// Returns the bounding box of the colours of 3 × 3 pixels, scaled about its middle.
    fn box_around(&self, x: usize, y: usize, growth: f32) -> ColorBox {
        let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        for pixel in self.neighbourhood(x, y) {
            let color = luma_chroma(self.color[pixel]);
            for i in 0..3 {
                (low[i], high[i]) = (low[i].min(color[i]), high[i].max(color[i]));
            }
        }
        ColorBox {
            middle: std::array::from_fn(|i| 0.5 * (low[i] + high[i])),
            half_side: std::array::from_fn(|i| (0.5 * growth * (high[i] - low[i])).max(MIN_HALF_SIDE)),
        }
    }
}

/// A box in YCoCg, whose axes fit the colours of pictures better than those of RGB.
struct ColorBox {
    middle: Color,
    half_side: Color,
}

impl ColorBox {
    /// Clamps a colour in linear RGB to the box, along the line to the box's middle.
    fn clamp(&self, color: Color) -> Color {
        let color = luma_chroma(color);
        let offset: Color = std::array::from_fn(|i| color[i] - self.middle[i]);
        let excess = (0..3).map(|i| offset[i].abs() / self.half_side[i]).fold(1.0, f32::max);
        rgb(std::array::from_fn(|i| self.middle[i] + offset[i] / excess))
    }
}

/// Converts linear RGB to YCoCg.
fn luma_chroma([r, g, b]: Color) -> Color {
    [0.25 * r + 0.5 * g + 0.25 * b, 0.5 * (r - b), 0.5 * g - 0.25 * (r + b)]
}

fn rgb([luma, orange, green]: Color) -> Color {
    let red_and_blue = luma - green;
    [red_and_blue + orange, luma + green, red_and_blue - orange]
}

/// Returns the colour at (x, y), pixels, by cubic interpolation (Catmull and Rom 1974), which blurs less than linear.
/// Pixels outside the picture repeat its edge.
pub(crate) fn cubic(picture: &[Color], width: usize, [x, y]: [f64; 2]) -> Color {
    let ((column, across), (row, down)) = (cubic_taps(x), cubic_taps(y));
    let (last_column, last_row) = (width as i64 - 1, (picture.len() / width) as i64 - 1);
    let mut sum = [0.0; 3];
    for (j, vertical) in down.into_iter().enumerate() {
        let start = (row + j as i64).clamp(0, last_row) as usize * width;
        for (i, horizontal) in across.into_iter().enumerate() {
            let color = picture[start + (column + i as i64).clamp(0, last_column) as usize];
            (0..3).for_each(|c| sum[c] += vertical * horizontal * color[c]);
        }
    }
    sum
}

/// Returns the first of the four pixels around a coordinate, and their weights.
fn cubic_taps(x: f64) -> (i64, [f32; 4]) {
    let first = (x - 0.5).floor();
    let t = (x - 0.5 - first) as f32;
    let weights = [
        t * (-0.5 + t * (1.0 - 0.5 * t)),
        1.0 + t * t * (1.5 * t - 2.5),
        t * (0.5 + t * (2.0 - 1.5 * t)),
        t * t * (0.5 * t - 0.5),
    ];
    (first as i64 - 1, weights)
}
