//! Assembly: fills an eye's background from the third camera's picture, through the plane's homography.
//!
//! An eye's own picture shows all surfaces before the plane, on black. Samples without a surface get the third camera's
//! picture, weighted by the fraction of these samples in the pixel.
//!
//! Bilinear taps whose position is covered by an eye's own surface are skipped: there a surface that crosses the plane
//! at a slant may lie so far before the plane that the third camera does not draw it.

use glam::{DMat3, DVec2};
use rayon::prelude::*;

use super::rig::{Rig, Side};
use crate::base::{Progress, Result, ensure};

/// Mapping between an eye's pixels and the third camera's picture.
pub(super) struct EyeMap<'a> {
    pub to_center: DMat3,
    to_eye: DMat3,
    /// Size of the third camera's picture, pixels.
    pub size: (u32, u32),
    /// Width and height of the eye's picture, pixels.
    pub eye: (usize, usize),
    /// Fraction of each eye pixel that its own surfaces cover.
    pub coverage: &'a [f32],
}

/// Four pixels of the third camera around a position, by row-major numbers, and the fractions of the position between
/// them to the right and downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Taps {
    pub pixels: [usize; 4],
    pub fractions: [f32; 2],
}

/// Distance in eye pixels, horizontally and vertically, within which the four pixels around a position lie.
const TAP_DISTANCE: usize = 2;

impl EyeMap<'_> {
    /// Returns the third camera's position for position (x, y) of the eye's picture, pixels.
    #[inline]
    pub fn lookup_position(&self, x: f64, y: f64) -> DVec2 {
        let mapped = self.to_center.x_axis * x + self.to_center.y_axis * y + self.to_center.z_axis;
        mapped.truncate() / mapped.z
    }

    /// Returns the pixels around a position; at the picture's edge the outermost ones.
    #[inline]
    pub fn taps(&self, position: DVec2) -> Taps {
        let (left, right, x) = neighbours(position.x, self.size.0);
        let (upper, lower, y) = neighbours(position.y, self.size.1);
        let [upper, lower] = [upper, lower].map(|row| row * self.size.0 as usize);
        Taps { pixels: [upper + left, upper + right, lower + left, lower + right], fractions: [x, y] }
    }

    /// Returns the weights of the taps for a pixel of the eye: bilinear, without taps covered by the eye's own
    /// surfaces. `None` if no such surface is near or all taps are covered; then the bilinear weights apply.
    pub fn uncovered_weights(&self, column: usize, row: usize, taps: &Taps) -> Option<[f32; 4]> {
        let columns = column.saturating_sub(TAP_DISTANCE)..(column + TAP_DISTANCE + 1).min(self.eye.0);
        let mut rows = row.saturating_sub(TAP_DISTANCE)..(row + TAP_DISTANCE + 1).min(self.eye.1);
        let is_covered = |row: usize| {
            let start = row * self.eye.0;
            self.coverage[start + columns.start..start + columns.end].iter().any(|covered| *covered > 0.0)
        };
        if !rows.any(is_covered) {
            return None;
        }
        let mut weights = taps.weights();
        for (weight, pixel) in weights.iter_mut().zip(taps.pixels) {
            *weight *= 1.0 - self.coverage_at(pixel);
        }
        let sum: f32 = weights.iter().sum();
        (sum > MIN_SUM).then(|| weights.map(|weight| weight / sum))
    }

    /// Returns the fraction covered by the eye's own surfaces at the position of a third-camera pixel.
    fn coverage_at(&self, pixel: usize) -> f32 {
        let (x, y) = (pixel % self.size.0 as usize, pixel / self.size.0 as usize);
        let position =
            self.to_eye.x_axis * (x as f64 + 0.5) + self.to_eye.y_axis * (y as f64 + 0.5) + self.to_eye.z_axis;
        let position = position.truncate() / position.z;
        let is_inside =
            position.x >= 0.0 && position.y >= 0.0 && position.x < self.eye.0 as f64 && position.y < self.eye.1 as f64;
        if is_inside { self.coverage[position.y as usize * self.eye.0 + position.x as usize] } else { 0.0 }
    }

    /// Interpolates the taps of a pixel of the eye.
    #[inline]
    pub fn mix(&self, column: usize, row: usize, taps: &Taps, picture: &[[f32; 3]]) -> [f32; 3] {
        match self.uncovered_weights(column, row, taps) {
            None => taps.mix(picture),
            Some(weights) => {
                let colors = taps.pixels.map(|pixel| picture[pixel]);
                std::array::from_fn(|i| (0..4).map(|k| weights[k] * colors[k][i]).sum())
            }
        }
    }
}

/// Minimum sum of weights; below it, all taps count as covered.
const MIN_SUM: f32 = 1e-6;

/// Returns the two pixels whose centres enclose a coordinate, and the weight of the second.
#[inline]
pub(super) fn neighbours(coordinate: f64, count: u32) -> (usize, usize, f32) {
    let last = f64::from(count - 1);
    let position = (coordinate - 0.5).clamp(0.0, last);
    let first = position.floor();
    (first as usize, (first + 1.0).min(last) as usize, (position - first) as f32)
}

impl Taps {
    /// Returns the bilinear weights.
    fn weights(&self) -> [f32; 4] {
        let [across, down] = self.fractions;
        let (left, upper) = (1.0 - across, 1.0 - down);
        [left * upper, across * upper, left * down, across * down]
    }

    /// Interpolates a picture bilinearly.
    #[inline]
    pub fn mix(&self, picture: &[[f32; 3]]) -> [f32; 3] {
        let [a, b, c, d] = self.pixels.map(|pixel| picture[pixel]);
        let [across, down] = self.fractions;
        std::array::from_fn(|i| {
            let (upper, lower) = (a[i] + (b[i] - a[i]) * across, c[i] + (d[i] - c[i]) * across);
            upper + (lower - upper) * down
        })
    }
}

impl Rig {
    /// Returns the map of an eye, given the fraction of each of its pixels that its own surfaces cover.
    pub(super) fn eye_map<'a>(&self, side: Side, coverage: &'a [f32]) -> Result<EyeMap<'a>> {
        self.check("coverage", coverage.len())?;
        let (to_eye, (width, height)) = (self.homography(side), self.size);
        let eye = (width as usize, height as usize);
        Ok(EyeMap { to_center: to_eye.inverse(), to_eye, size: self.center_size, eye, coverage })
    }

    /// Adds the third camera's picture behind an eye's own, bilinearly at the centres of the eye's pixels.
    pub fn assemble(
        &self,
        side: Side,
        coverage: &[f32],
        center: &[[f32; 3]],
        color: &mut [[f32; 3]],
        progress: &Progress,
    ) -> Result<()> {
        let map = self.eye_map(side, coverage)?;
        self.check_shared("center", center.len())?;
        self.add_behind(coverage, color, progress, |column, row| {
            let taps = map.taps(map.lookup_position(column as f64 + 0.5, row as f64 + 0.5));
            map.mix(column, row, &taps, center)
        })
    }

    /// Adds a colour behind each pixel of an eye that has samples without an own surface.
    pub(super) fn add_behind(
        &self,
        coverage: &[f32],
        color: &mut [[f32; 3]],
        progress: &Progress,
        background: impl Fn(usize, usize) -> [f32; 3] + Sync,
    ) -> Result<()> {
        self.check("color", color.len())?;
        let width = self.size.0 as usize;
        let rows = color.par_chunks_mut(width).zip(coverage.par_chunks(width)).enumerate();
        rows.try_for_each(|(row, (colors, coverage))| {
            let pixels = colors.iter_mut().zip(coverage).enumerate();
            for (column, (color, covered)) in pixels.filter(|(_, (_, covered))| **covered < 1.0) {
                let background = background(column, row);
                (0..3).for_each(|i| color[i] += (1.0 - covered) * background[i]);
            }
            progress.check()
        })
    }

    /// Writes, for each pixel of an eye, the third camera's pixel with the largest weight in its interpolation.
    pub fn nearest(&self, side: Side, coverage: &[f32], numbers: &mut [u32], progress: &Progress) -> Result<()> {
        self.check("numbers", numbers.len())?;
        let map = self.eye_map(side, coverage)?;
        numbers.par_chunks_mut(self.size.0 as usize).enumerate().try_for_each(|(row, numbers)| {
            for (column, number) in numbers.iter_mut().enumerate() {
                let taps = map.taps(map.lookup_position(column as f64 + 0.5, row as f64 + 0.5));
                let weights = map.uncovered_weights(column, row, &taps).unwrap_or_else(|| taps.weights());
                let heaviest = (1..4).fold(0, |heaviest, k| if weights[k] > weights[heaviest] { k } else { heaviest });
                *number = taps.pixels[heaviest] as u32;
            }
            progress.check()
        })
    }

    fn check(&self, argument: &'static str, length: usize) -> Result<()> {
        expect(argument, pixels(self.size), length)
    }

    /// Checks the length of an array with an entry for each pixel of the third camera, which both eyes share.
    pub(super) fn check_shared(&self, argument: &'static str, length: usize) -> Result<()> {
        expect(argument, pixels(self.center_size), length)
    }
}

pub(super) fn pixels((width, height): (u32, u32)) -> usize {
    width as usize * height as usize
}

fn expect(argument: &'static str, expected: usize, length: usize) -> Result<()> {
    ensure!(length == expected, argument, format!("{expected} pixels"), length);
    Ok(())
}
