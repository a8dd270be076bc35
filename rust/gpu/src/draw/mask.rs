//! Masks: the pixels of a picture that are drawn.

use std::sync::Arc;

use nearfar_core::base::{Error, Result};
use nearfar_core::camera::Camera;
use nearfar_core::render::{MaskPyramid, Pixels};

use super::window::Window;

/// Pixels that are drawn, and what of the geometry behind the others is left out.
pub(crate) struct Mask {
    /// For each pixel of the picture whether it is drawn, by rows.
    pub pixels: Vec<bool>,
    /// The same at several resolutions, where geometry that no drawn pixel shows is not drawn.
    pub pyramid: Option<MaskPyramid>,
}

impl Mask {
    /// The mask of a picture, if it has one.
    pub fn of(pixels: &Pixels<'_>, camera: &Camera) -> Result<Option<Arc<Self>>> {
        let Some(mask) = pixels.mask else { return Ok(None) };
        let count = camera.width as usize * camera.height as usize;
        if mask.len() != count {
            return Err(Error::value("mask", format!("{count} pixels"), mask.len()));
        }
        let pyramid = pixels.occlusion.then(|| MaskPyramid::new(mask, camera.width as usize));
        Ok(Some(Arc::new(Self { pixels: mask.to_vec(), pyramid })))
    }

    /// A bit for each pixel of a window, by rows.
    pub fn bits(&self, window: &Window, width: u32) -> Vec<u32> {
        let mut words = vec![0u32; window.pixels().div_ceil(32)];
        let mut n = 0;
        for row in window.row..window.row + window.height {
            let start = row as usize * width as usize + window.column as usize;
            for drawn in &self.pixels[start..start + window.width as usize] {
                words[n / 32] |= u32::from(*drawn) << (n % 32);
                n += 1;
            }
        }
        words
    }
}
