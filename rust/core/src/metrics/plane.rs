//! One channel of an image in memory, of any number type.

use crate::base::{Error, Real, Result, ensure};

/// Pixel number type, and the precision in which it is computed.
pub trait Pixel: Copy + PartialOrd + Send + Sync {
    /// Precision of computations; float32 holds every 8- and 16-bit difference exactly.
    type Real: RoundingLimits;
    /// Smallest value of the type.
    const MIN: Self;
    /// Largest value of the type.
    const MAX: Self;
    /// The value.
    fn real(self) -> Self::Real;
}

/// Limits within which a precision keeps the digits of similarity.
pub trait RoundingLimits: Real {
    /// Maximum error of either factor of the measure, in roundings of a pixel minus its level: 1e-6 in float32 and
    /// 5e-13 in float64. All windows of a uniform area are rounded alike, which shifts the mean.
    const MAX_CHANGE: f64;
    /// Maximum distance of a window from the level, in units of √c₁ or √c₂.
    const MAX_DISTANCE: f64;
    /// Maximum level, whose fourth power is finite.
    const MAX_LEVEL: f64;
    /// Maximum divisor, far below overflow.
    const MAX_DIVISOR: f64;
    /// Minimum constant, for which the product of both constants keeps all digits.
    const MIN_CONSTANT: f64;
}

impl RoundingLimits for f32 {
    const MAX_CHANGE: f64 = 20.0;
    const MAX_DISTANCE: f64 = 1e4;
    const MAX_LEVEL: f64 = 1e8;
    const MAX_DIVISOR: f64 = 1e37;
    const MIN_CONSTANT: f64 = 1e-15;
}

impl RoundingLimits for f64 {
    const MAX_CHANGE: f64 = 5e3;
    const MAX_DISTANCE: f64 = 1e7;
    const MAX_LEVEL: f64 = 1e75;
    const MAX_DIVISOR: f64 = 1e305;
    const MIN_CONSTANT: f64 = 1e-140;
}

macro_rules! pixel {
    ($($type:ident => $real:ty, $least:ident to $greatest:ident);*) => {$(
        impl Pixel for $type {
            type Real = $real;
            const MIN: $type = $type::$least;
            const MAX: $type = $type::$greatest;
            #[inline(always)]
            fn real(self) -> $real {
                <$real>::from(self)
            }
        }
    )*};
}

pixel!(
    u8 => f32, MIN to MAX;
    u16 => f32, MIN to MAX;
    f32 => f32, NEG_INFINITY to INFINITY;
    f64 => f64, NEG_INFINITY to INFINITY
);

/// One channel of an image: values at fixed strides.
#[derive(Clone, Copy, Debug)]
pub struct Plane<'a, P> {
    values: &'a [P],
    /// Height, pixels.
    pub height: usize,
    /// Width, pixels.
    pub width: usize,
    row_step: usize,
    column_step: usize,
}

impl<'a, P: Pixel> Plane<'a, P> {
    /// Creates a plane of (height, width) pixels with strides, in values, to the next row and the next column.
    pub fn new(values: &'a [P], [height, width]: [usize; 2], [row_step, column_step]: [usize; 2]) -> Result<Self> {
        let longest = height.max(width);
        ensure!(u32::try_from(longest).is_ok(), "image", "fewer than 2³² pixels each way", longest);
        let last = |count: usize, step: usize| count.saturating_sub(1).checked_mul(step);
        let end = last(height, row_step).zip(last(width, column_step)).and_then(|(a, b)| a.checked_add(b));
        let is_within = height > 0 && width > 0 && end.is_some_and(|end| end < values.len());
        let expected = format!("at least one pixel, and {height} × {width} of them within {} values", values.len());
        ensure!(is_within, "image", expected, format!("steps of {row_step} and {column_step}"));
        Ok(Self { values, height, width, row_step, column_step })
    }

    /// Splits a stack of images of one size, in order; the last two axes are the images'.
    pub fn stack(values: &'a [P], shape: &[usize], steps: &[usize]) -> Result<Vec<Self>> {
        let (Some((outer, &size)), Some((outer_steps, &steps))) = (shape.split_last_chunk(), steps.split_last_chunk())
        else {
            return Err(Error::value("image", "two axes or more", shape.len()));
        };
        let offset = |mut n: usize| {
            let axes = outer.iter().zip(outer_steps).rev();
            axes.fold(0, |offset, (&length, &step)| {
                let index = n % length;
                n /= length;
                offset + index * step
            })
        };
        let image = |n| {
            let values = values.get(offset(n)..).unwrap_or_default();
            Self::new(values, size, steps)
        };
        (0..outer.iter().product()).map(image).collect()
    }

    /// Returns a pixel's value in computing precision.
    #[inline(always)]
    pub fn value(&self, row: usize, column: usize) -> P::Real {
        self.pixel(row, column).real()
    }

    /// Returns a pixel as stored.
    #[inline(always)]
    pub(super) fn pixel(&self, row: usize, column: usize) -> P {
        self.values[row * self.row_step + column * self.column_step]
    }

    /// Returns neighbouring pixels of a row; `None` if they are not contiguous.
    #[inline(always)]
    pub fn run(&self, row: usize, columns: std::ops::Range<usize>) -> Option<&'a [P]> {
        let start = row * self.row_step;
        (self.column_step == 1).then(|| &self.values[start + columns.start..start + columns.end])
    }

    /// Returns the values from a pixel on and the row stride; `None` if the pixels of a row are not contiguous.
    pub(super) fn rows_from(&self, row: usize, column: usize) -> Option<(&'a [P], usize)> {
        (self.column_step == 1).then(|| (&self.values[row * self.row_step + column..], self.row_step))
    }

    /// Returns an approximate mean of a region from a few of its pixels, without those that are not finite. With a mask
    /// it uses only masked pixels, at least the first one, so that the level does not depend on other pixels.
    pub(super) fn level(&self, part: &Region, mask: Option<&Plane<'_, u8>>) -> f64 {
        let is_masked = |&(row, column): &(usize, usize)| mask.is_none_or(|mask| mask.contains(row, column));
        let mut samples = part.samples().filter(is_masked).peekable();
        let first = if samples.peek().is_none() { mask.and_then(|mask| mask.first(part)) } else { None };
        let values =
            samples.chain(first).map(|(row, column)| self.value(row, column).wide()).filter(|value| value.is_finite());
        let (sum, count) = values.fold((0.0, 0.0), |(sum, count), value| (sum + value, count + 1.0));
        if count > 0.0 { sum / count } else { 0.0 }
    }

    pub(super) fn expect_size(&self, argument: &'static str, [height, width]: [usize; 2]) -> Result<()> {
        let is_equal = [height, width] == [self.height, self.width];
        let expected = format!("{} × {} pixels", self.height, self.width);
        ensure!(is_equal, argument, expected, format!("{height} × {width}"));
        Ok(())
    }
}

impl Plane<'_, u8> {
    /// Returns whether a mask contains a pixel.
    #[inline(always)]
    pub(super) fn contains(&self, row: usize, column: usize) -> bool {
        self.pixel(row, column) != 0
    }

    /// Returns the number of pixels in a mask.
    pub(super) fn count(&self) -> usize {
        let row = |row| (0..self.width).filter(|&column| self.contains(row, column)).count();
        (0..self.height).map(row).sum()
    }

    /// Returns the first and the last column of a row in a mask.
    pub(super) fn first_and_last(&self, row: usize, [from, end]: [usize; 2]) -> Option<(usize, usize)> {
        if let Some(run) = self.run(row, from..end) {
            // Most rows are empty; this test is vectorised.
            if run.iter().fold(0, |any, value| any | value) == 0 {
                return None;
            }
            let first = run.iter().position(|&value| value != 0)?;
            return Some((from + first, from + run.iter().rposition(|&value| value != 0)?));
        }
        let first = (from..end).find(|&column| self.contains(row, column))?;
        Some((first, (first..end).rfind(|&column| self.contains(row, column))?))
    }

    /// Returns the row and column of the first masked pixel of a region.
    fn first(&self, part: &Region) -> Option<(usize, usize)> {
        let in_row = |row| self.first_and_last(row, part.columns).map(|(first, _)| (row, first));
        (part.rows[0]..part.rows[1]).find_map(in_row)
    }

    /// Returns the smallest region that contains all masked pixels of a region.
    pub(super) fn bounds(&self, part: Region) -> Region {
        let mut bounds = Region { rows: [part.rows[1], part.rows[0]], columns: [part.columns[1], part.columns[0]] };
        for row in part.rows[0]..part.rows[1] {
            let Some((first, last)) = self.first_and_last(row, part.columns) else { continue };
            bounds.rows = [bounds.rows[0].min(row), row + 1];
            bounds.columns = [bounds.columns[0].min(first), bounds.columns[1].max(last + 1)];
        }
        bounds
    }
}

/// Rectangle of an image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Region {
    /// First row and end.
    pub rows: [usize; 2],
    /// First column and end.
    pub columns: [usize; 2],
}

impl Region {
    pub fn is_empty(&self) -> bool {
        self.rows[0] >= self.rows[1] || self.columns[0] >= self.columns[1]
    }

    pub fn contains_row(&self, row: usize) -> bool {
        (self.rows[0]..self.rows[1]).contains(&row)
    }

    pub fn contains(&self, row: usize, column: usize) -> bool {
        self.contains_row(row) && (self.columns[0]..self.columns[1]).contains(&column)
    }

    /// Returns a few of its pixels, evenly spaced.
    fn samples(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        const SAMPLES_PER_SIDE: usize = 4;
        let pick = |[from, to]: [usize; 2], i: usize| from + (2 * i + 1) * (to - from) / (2 * SAMPLES_PER_SIDE);
        (0..SAMPLES_PER_SIDE * SAMPLES_PER_SIDE)
            .map(move |i| (pick(self.rows, i / SAMPLES_PER_SIDE), pick(self.columns, i % SAMPLES_PER_SIDE)))
    }

    /// Clips the region to rows.
    pub fn within_rows(&self, rows: [usize; 2]) -> Self {
        Self { rows: [self.rows[0].max(rows[0]), self.rows[1].min(rows[1])], columns: self.columns }
    }
}

/// Mirrors an index at the ends of a line: d c b a | a b c d | d c b a.
pub(super) fn mirror(i: i64, length: usize) -> usize {
    let length = length as i64;
    let offset = i.rem_euclid(2 * length);
    (if offset < length { offset } else { 2 * length - 1 - offset }) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_mirrored_at_their_ends() {
        let line = |from: i64, to: i64, length: usize| (from..to).map(|i| mirror(i, length)).collect::<Vec<_>>();
        assert_eq!(line(-2, 5, 3), [1, 0, 0, 1, 2, 2, 1]);
        assert_eq!(line(-2, 3, 2), [1, 0, 0, 1, 1]);
        assert_eq!(line(-2, 3, 1), [0; 5]);
    }
}
