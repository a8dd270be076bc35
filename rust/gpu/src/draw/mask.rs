//! Masks: drawn pixels of a picture.

use std::sync::Arc;

use nearfar_core::base::{Error, Result};
use nearfar_core::camera::Camera;
use nearfar_core::render::{MaskPyramid, Pixels};

use super::window::Window;

/// Drawn pixels, and a pyramid for culling geometry behind the others.
pub(crate) struct Mask {
    /// Row-major flags of the drawn pixels.
    pub pixels: Vec<bool>,
    /// Mask pyramid, if geometry that no drawn pixel shows is to be culled.
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
        let pyramid = pixels.occlusion.then(|| MaskPyramid::new(mask, camera.width as usize));
        Ok(Some(Arc::new(Self { pixels: mask.to_vec(), pyramid })))
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
