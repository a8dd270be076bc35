//! Values of a cube map's six faces.

use super::texels::MAX_SIZE;
use crate::base::{Error, Result};

/// Six faces of `size` × `size` texels with `channels` values each.
#[derive(Debug)]
pub struct CubeFaces<'a, T> {
    pub(super) values: &'a [T],
    pub(super) size: u32,
    pub(super) channels: usize,
}

impl<T> Clone for CubeFaces<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for CubeFaces<'_, T> {}

impl<'a, T: Copy> CubeFaces<'a, T> {
    /// Creates faces; checks that the values fill them.
    pub fn new(values: &'a [T], size: u32, channels: usize) -> Result<Self> {
        check_size(size)?;
        let expected = 6 * size as usize * size as usize * channels;
        if values.len() != expected {
            return Err(Error::value("faces", format!("{expected} values for size {size}"), values.len()));
        }
        Ok(Self { values, size, channels })
    }

    #[inline]
    pub(super) fn texel(&self, number: u32) -> &'a [T] {
        &self.values[number as usize * self.channels..][..self.channels]
    }

    /// Fails unless `out` has room for one texel per direction, for `count` directions.
    pub(super) fn check_out<U>(&self, out: &[U], count: usize) -> Result<()> {
        if out.len() == count * self.channels {
            return Ok(());
        }
        Err(Error::value("out", format!("{} values", count * self.channels), out.len()))
    }
}

/// Fails for faces without texels, or with more texels than texel numbers can address.
pub(super) fn check_size(size: u32) -> Result<()> {
    if (1..=MAX_SIZE).contains(&size) {
        return Ok(());
    }
    Err(Error::value("faces", format!("1 to {MAX_SIZE} texels across a face"), size))
}

/// Returns whether a number is not NaN. Minima and maxima skip NaN, which marks an unknown value.
#[inline(always)]
#[allow(clippy::eq_op)]
pub(super) fn is_known<T: PartialEq + Copy>(value: T) -> bool {
    value == value
}
