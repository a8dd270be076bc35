//! Format of views: size, depth steps and normal bits.

use crate::base::{Error, Result};

/// Format of views: size, depth steps and normal bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Format {
    /// Width and height of a view, pixels; a multiple of 4.
    pub size: usize,
    /// Number of steps that a cell's depth is divided into.
    pub steps: u32,
    /// Bits of each of a normal's two components.
    pub normal_bits: u32,
}

/// Maximum size of a view, pixels.
const MAX_SIZE: usize = 4096;

impl Format {
    /// Creates a format. Codes of `depth_bits` bits give the maximum number of steps that is a multiple of 6: then
    /// children lie on whole steps of their parents' ranges.
    pub fn new(size: usize, depth_bits: u32, normal_bits: u32) -> Result<Self> {
        if size == 0 || !size.is_multiple_of(4) || size > MAX_SIZE {
            return Err(Error::value("size", format!("a multiple of 4, at most {MAX_SIZE}"), size));
        }
        if !(8..=16).contains(&depth_bits) {
            return Err(Error::value("depth_bits", "8 to 16", depth_bits));
        }
        if normal_bits != 16 && normal_bits != 24 {
            return Err(Error::value("normal_bits", "16 or 24", normal_bits));
        }
        let most = (1 << depth_bits) - 1;
        Ok(Self { size, steps: most / 6 * 6, normal_bits: normal_bits / 2 })
    }

    /// Returns the number of a view's pixels.
    pub fn pixels(&self) -> usize {
        self.size * self.size
    }
}
