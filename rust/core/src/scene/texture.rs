//! Base colour images.

use crate::base::{Buffer, Error, Result};

/// An sRGB image with linear alpha; row 0 on top, repeated in both directions.
#[derive(Debug)]
pub struct Texture {
    /// Texels across.
    pub width: u32,
    /// Texels down.
    pub height: u32,
    /// `width * height` texels, rows from the top.
    pub texels: Buffer<[u8; 4]>,
}

impl Texture {
    /// Checks that the texels fill the image.
    pub fn new(width: u32, height: u32, texels: Buffer<[u8; 4]>) -> Result<Self> {
        if width == 0 || height == 0 || texels.len() as u64 != u64::from(width) * u64::from(height) {
            return Err(Error::value("texture", format!("{width} x {height} texels"), texels.len()));
        }
        Ok(Self { width, height, texels })
    }
}
