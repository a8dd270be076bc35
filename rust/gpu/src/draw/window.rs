//! Windows, which are parts of an image that are drawn one after the other; the layout of their output; and masks,
//! which select the drawn pixels of a picture.

use std::sync::Arc;

use nearfar_core::base::memory::try_copy;
use nearfar_core::base::{Error, Result};
use nearfar_core::camera::{Camera, Fov};
use nearfar_core::render::{Channels, MaskPyramid, Pixels};

use crate::device::Device;

/// Number of an image's channels in the output.
pub(super) const CHANNELS: usize = 8;

/// First word of each of an image's channels in the output, or `u32::MAX`.
pub(super) type Outputs = [u32; CHANNELS];

/// A part of an image drawn at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Window {
    pub column: u32,
    pub row: u32,
    pub width: u32,
    pub height: u32,
}

impl Window {
    pub fn pixels(&self) -> usize {
        self.width as usize * self.height as usize
    }

    /// Returns the part of the field of view that it covers, with a margin of one pixel for samples beside the centres.
    pub fn part_of(&self, camera: &Camera, fov: &Fov) -> Fov {
        let (across, down) = (fov.right - fov.left, fov.up - fov.down);
        let column = |pixel: f64| fov.left + across * pixel / f64::from(camera.width);
        let row = |pixel: f64| fov.up - down * pixel / f64::from(camera.height);
        Fov {
            left: column(f64::from(self.column) - 1.0),
            right: column(f64::from(self.column + self.width) + 1.0),
            down: row(f64::from(self.row + self.height) + 1.0),
            up: row(f64::from(self.row) - 1.0),
        }
    }

    /// Splits an image into windows with limited pixels and side length.
    pub fn split(width: u32, height: u32, pixels: u64, side: u32) -> Vec<Self> {
        let columns = side.min(width).min(pixels.min(u64::from(u32::MAX)) as u32).max(1);
        let rows = ((pixels / u64::from(columns)).min(u64::from(side)) as u32).clamp(1, height);
        let windows_of_row = |row: u32| {
            let height = rows.min(height - row);
            let window = move |column| Self { column, row, width: columns.min(width - column), height };
            (0..width).step_by(columns as usize).map(window)
        };
        (0..height).step_by(rows as usize).flat_map(windows_of_row).collect()
    }
}

/// Bytes per pixel of each channel: colour, range, ids, position, normal, albedo, shading normal, coverage.
const CHANNEL_BYTES: [u64; CHANNELS] = [12, 4, 8, 12, 12, 12, 12, 4];

/// Returns flags of the requested channels, in the order of `CHANNEL_BYTES`.
fn channel_flags(channels: Channels) -> [bool; CHANNELS] {
    let Channels { color, coverage, range, object_id, face_id, position, normal, albedo, shading_normal } = channels;
    [color, range, object_id || face_id, position, normal, albedo, shading_normal, coverage]
}

pub(super) fn bytes_per_pixel(channels: Channels) -> u64 {
    channel_flags(channels).iter().zip(CHANNEL_BYTES).map(|(&requested, bytes)| u64::from(requested) * bytes).sum()
}

/// Returns the maximum number of pixels of a window, and its maximum width and height.
pub(super) fn window_limits(device: &Device, channels: Channels) -> (u64, u32) {
    let max_pixels = device.largest_binding() / bytes_per_pixel(channels).max(1);
    (max_pixels.max(1), device.limits.max_texture_dimension_2d)
}

/// Returns the first word of each channel of a window, for each view.
pub(super) fn output_layouts(channels: Channels, window: &Window, views: usize) -> Vec<Outputs> {
    let is_requested = channel_flags(channels);
    let mut end = 0;
    let mut first_word = |channel: usize| {
        let first = end;
        end += if is_requested[channel] { (CHANNEL_BYTES[channel] / 4) as u32 * window.pixels() as u32 } else { 0 };
        if is_requested[channel] { first } else { u32::MAX }
    };
    (0..views).map(|_| std::array::from_fn(&mut first_word)).collect()
}

/// Mask of the drawn pixels, with a pyramid for culling.
pub(crate) struct Mask {
    /// Row-major flags of the drawn pixels.
    pub pixels: Vec<bool>,
    /// Pyramid of the mask, if geometry is to be culled that no drawn pixel shows.
    pub pyramid: Option<MaskPyramid>,
}

impl Mask {
    /// Returns the mask of a picture, if it has one.
    pub fn from_pixels(pixels: &Pixels<'_>, camera: &Camera) -> Result<Option<Arc<Self>>> {
        let Some(mask) = pixels.mask else { return Ok(None) };
        let count = camera.width as usize * camera.height as usize;
        if mask.len() != count {
            return Err(Error::value("mask", format!("{count} pixels"), mask.len()));
        }
        let pyramid = pixels.culls_masked.then(|| MaskPyramid::new(mask, camera.width as usize));
        Ok(Some(Arc::new(Self { pixels: try_copy(mask)?, pyramid })))
    }

    /// Returns one bit per pixel of a window, row by row.
    pub fn bits(&self, window: &Window, width: u32) -> Vec<u32> {
        let mut words = vec![0u32; window.pixels().div_ceil(32)];
        let rows = self.pixels.chunks(width as usize).skip(window.row as usize).take(window.height as usize);
        let pixels = rows.flat_map(|row| &row[window.column as usize..][..window.width as usize]);
        pixels.enumerate().for_each(|(n, &drawn)| words[n / 32] |= u32::from(drawn) << (n % 32));
        words
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn windows_cover_every_pixel_once() {
        let cases = [(7, 5, 1, 9), (100, 3, 250, 64), (64, 64, 1 << 20, 64), (1, 900, 100, 50)];
        for (width, height, pixels, side) in cases {
            let mut counts = vec![0; (width * height) as usize];
            for window in Window::split(width, height, pixels, side) {
                assert!(window.pixels() as u64 <= pixels && window.width <= side && window.height <= side);
                for row in window.row..window.row + window.height {
                    let first = (row * width + window.column) as usize;
                    counts[first..first + window.width as usize].iter_mut().for_each(|count| *count += 1);
                }
            }
            assert!(counts.iter().all(|&count| count == 1));
        }
    }
}
