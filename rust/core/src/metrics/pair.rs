//! Two images that are compared, row by row.

use std::ops::Range;

use super::pixel_rows::{PixelRows, sum_and_difference};
use super::plane::{Plane, Region};
use crate::base::{Real, Result};

/// Two images to be compared.
#[derive(Clone, Copy)]
pub struct Pair<'a, P> {
    /// One of them.
    pub reference: Plane<'a, P>,
    /// The other one, of the same size.
    pub test: Plane<'a, P>,
}

impl<'a, P: PixelRows> Pair<'a, P> {
    /// Two images of one size.
    pub fn new(reference: Plane<'a, P>, test: Plane<'a, P>) -> Result<Self> {
        reference.expect_size("test", [test.height, test.width])?;
        Ok(Self { reference, test })
    }

    /// Sum and difference of both along neighbouring pixels of a row, less their levels.
    #[inline]
    pub(super) fn load(&self, row: usize, columns: Range<usize>, levels: [P::Real; 2], [s, d]: [&mut [P::Real]; 2]) {
        let Self { reference, test } = self;
        match (reference.run(row, columns.clone()), test.run(row, columns.clone())) {
            (Some(x), Some(y)) => sum_and_difference(x, y, levels, s, d),
            _ => self.gather(row, columns, levels, [s, d]),
        }
    }

    /// The same in any precision and for any columns.
    pub(super) fn gather<R: Real>(
        &self,
        row: usize,
        columns: impl Iterator<Item = usize>,
        levels: [R; 2],
        [s, d]: [&mut [R]; 2],
    ) {
        for ((s, d), column) in s.iter_mut().zip(d).zip(columns) {
            let x = R::narrow(self.reference.at(row, column).wide()) - levels[0];
            let y = R::narrow(self.test.at(row, column).wide()) - levels[1];
            (*s, *d) = (x + y, x - y);
        }
    }

    /// About the means of both in a part, or of what a mask names of it.
    pub(super) fn levels(&self, part: &Region, mask: Option<&Plane<'_, u8>>) -> [f64; 2] {
        [&self.reference, &self.test].map(|image| image.level(part, mask))
    }

    /// The squared difference of one pixel.
    #[inline(always)]
    pub(super) fn square(&self, row: usize, column: usize) -> f64 {
        let difference = self.reference.at(row, column).wide() - self.test.at(row, column).wide();
        difference * difference
    }
}
