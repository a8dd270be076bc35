//! Pairs of images, compared row by row.

use std::ops::Range;

use rayon::prelude::*;

use super::extremes::{Extremes, LANES, ValueRange};
use super::pixel_rows::{EXTREME_LANES, PixelRows, extend, sum_and_difference, sum_difference_and_extremes};
use super::plane::{Plane, Region};
use crate::base::{Real, Result};

/// Rows per task.
const ROWS: usize = 64;

/// Two images to be compared.
#[derive(Clone, Copy)]
pub struct Pair<'a, P> {
    /// Reference image.
    pub reference: Plane<'a, P>,
    /// Test image, of the same size.
    pub test: Plane<'a, P>,
}

impl<'a, P: PixelRows> Pair<'a, P> {
    /// Creates a pair; fails if the sizes differ.
    pub fn new(reference: Plane<'a, P>, test: Plane<'a, P>) -> Result<Self> {
        reference.expect_size("test", [test.height, test.width])?;
        Ok(Self { reference, test })
    }

    /// Writes sums and differences of neighbouring pixels of a row, minus their levels; updates `extremes` if given.
    #[inline]
    pub(super) fn load(
        &self,
        row: usize,
        columns: Range<usize>,
        levels: [P::Real; 2],
        [s, d]: [&mut [P::Real]; 2],
        extremes: Option<&mut Extremes<P>>,
    ) {
        let Self { reference, test } = self;
        if let (Some(x), Some(y)) = (reference.run(row, columns.clone()), test.run(row, columns.clone())) {
            if columns.len() >= EXTREME_LANES
                && let Some(extremes) = extremes
            {
                return sum_difference_and_extremes(x, y, levels, s, d, extremes);
            }
            sum_and_difference(x, y, levels, s, d);
        } else {
            self.gather(row, columns.clone(), levels, [s, d]);
        }
        self.extend_row(row, columns, extremes);
    }

    /// Extends `extremes`, if given, by the values of both images along a row.
    pub(super) fn extend_row(&self, row: usize, columns: Range<usize>, extremes: Option<&mut Extremes<P>>) {
        if let Some(extremes) = extremes {
            self.extend(&Region { rows: [row, row + 1], columns: [columns.start, columns.end] }, extremes);
        }
    }

    /// Same as `load`, for any precision and any columns.
    pub(super) fn gather<R: Real>(
        &self,
        row: usize,
        columns: impl Iterator<Item = usize>,
        levels: [R; 2],
        [s, d]: [&mut [R]; 2],
    ) {
        for ((s, d), column) in s.iter_mut().zip(d).zip(columns) {
            let x = R::narrow(self.reference.value(row, column).wide()) - levels[0];
            let y = R::narrow(self.test.value(row, column).wide()) - levels[1];
            (*s, *d) = (x + y, x - y);
        }
    }

    /// Extends `extremes` by the values of both images in a region.
    pub(super) fn extend(&self, part: &Region, extremes: &mut Extremes<P>) {
        let ([first, end], [top, bottom]) = (part.columns, part.rows);
        if part.is_empty() {
            return;
        }
        for image in [&self.reference, &self.test] {
            match image.rows_from(top, first) {
                Some((values, step)) => extend(values, step, [bottom - top, end - first], extremes),
                None => {
                    for row in top..bottom {
                        (first..end).for_each(|column| extremes.include(column % LANES, image.pixel(row, column)));
                    }
                }
            }
        }
    }

    /// Returns the range of the values of both images.
    pub(super) fn range(&self) -> ValueRange {
        let (height, width) = (self.reference.height, self.reference.width);
        let band = |n: usize| {
            let mut extremes = Extremes::default();
            let rows = [n * ROWS, height.min((n + 1) * ROWS)];
            self.extend(&Region { rows, columns: [0, width] }, &mut extremes);
            extremes.range()
        };
        (0..height.div_ceil(ROWS)).into_par_iter().map(band).reduce(ValueRange::default, ValueRange::union)
    }

    /// Returns approximate means of both images in a region, restricted to the mask if there is one.
    pub(super) fn levels(&self, part: &Region, mask: Option<&Plane<'_, u8>>) -> [f64; 2] {
        [&self.reference, &self.test].map(|image| image.level(part, mask))
    }

    /// Returns the squared difference of one pixel.
    #[inline(always)]
    pub(super) fn square(&self, row: usize, column: usize) -> f64 {
        let difference = self.reference.value(row, column).wide() - self.test.value(row, column).wide();
        difference * difference
    }
}
