//! Comparison of many pairs of images at once: similarity, and mean squared error of raw pixel values.

use std::ops::Range;

use rayon::prelude::*;

use super::extremes::{Extremes, ValueRange};
use super::pair::Pair;
use super::pixel_rows::PixelRows;
use super::plane::{Plane, Region};
use super::similarity::{Mask, Scales, Selection, Shrunk, Similarity, SimilaritySums, Window, multiscale, similarity};
use crate::base::mapped::in_ranges;
use crate::base::{Progress, Result, ensure};

/// Pixels per task: fixed, so that sums do not depend on the number of threads, and few enough for integer sums.
const CHUNK: usize = 1 << 14;

/// Image size in bytes below which one thread is as fast as all.
const SERIAL_BYTES: usize = 1 << 22;

/// Settings of a comparison.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// Window around each pixel.
    pub window: Window,
    /// Constants of the measure.
    pub constants: Similarity,
    /// Factor by which images are shrunk before the comparison.
    pub shrink: usize,
    /// Whether to include windows across the image's border.
    pub includes_border: bool,
    /// Whether windows ignore pixels outside the masks, as `Mask::Windows`; otherwise only the mean does.
    pub masks_windows: bool,
    /// Whether to compute the range of the images' values.
    pub ranges: bool,
}

/// Pairs of images of one size and type, optionally with one mask per pair.
pub struct Stacks<'a, P> {
    /// Reference images.
    pub references: Vec<Plane<'a, P>>,
    /// Test images, compared with the references.
    pub tests: Vec<Plane<'a, P>>,
    /// Masks of the shrunk images' size.
    pub masks: Option<Vec<Plane<'a, u8>>>,
}

/// A pair of images and its mask.
type Job<'a, P> = (Pair<'a, P>, Option<Plane<'a, u8>>);

impl<'a, P> Stacks<'a, P>
where
    P: PixelRows<Real: PixelRows<Real = P::Real>>,
{
    fn jobs(&self) -> Result<Vec<Job<'a, P>>> {
        let count = self.references.len();
        for (argument, length) in [("test", self.tests.len()), ("mask", self.masks.as_ref().map_or(count, Vec::len))] {
            ensure!(length == count, argument, format!("{count} images"), length);
        }
        let job = |n: usize| {
            let mask = self.masks.as_ref().map(|masks| masks[n]);
            Ok((Pair::new(self.references[n], self.tests[n])?, mask))
        };
        (0..count).map(job).collect()
    }

    /// Returns the similarity sums of each pair; writes consecutive maps if requested.
    pub fn compare(
        &self,
        comparison: &Comparison,
        maps: Option<&mut [P::Real]>,
        progress: &Progress,
    ) -> Result<Vec<SimilaritySums>> {
        let jobs = self.jobs()?;
        progress.expect(jobs.len() as u64);
        let Comparison { ref window, constants, shrink, includes_border, masks_windows, ranges } = *comparison;
        let compare = |(pair, mask): &Job<'_, P>, map: Option<&mut [P::Real]>| {
            let mask = mask.map(if masks_windows { Mask::Windows } else { Mask::Mean });
            let selection =
                Selection { includes_border, mask, contrast: false, range: ranges && shrink == 1, progress };
            let mut sums;
            if shrink > 1 {
                let smaller = Shrunk::new(pair, shrink, progress)?;
                sums = similarity(&smaller.pair()?, window, constants, selection, map)?;
                if ranges {
                    sums.range = pair.range();
                }
            } else {
                sums = similarity(pair, window, constants, selection, map)?;
            }
            progress.report(1)?;
            Ok(sums)
        };
        match maps {
            Some(maps) => {
                let length = maps.len() / jobs.len().max(1);
                let maps = maps.par_chunks_mut(length.max(1));
                jobs.par_iter().zip_eq(maps).map(|(job, map)| compare(job, Some(map))).collect()
            }
            None => jobs.par_iter().map(|job| compare(job, None)).collect(),
        }
    }

    /// Returns the mean squared difference of each pair, with the range of values if `ranges`.
    pub fn mean_squared_errors(&self, ranges: bool, progress: &Progress) -> Result<Vec<SquaredError>> {
        self.jobs()?.iter().map(|(pair, _)| mean_squared_error(pair, ranges, progress)).collect()
    }

    /// Returns the means of each pair's similarity and contrast factor at each of `scales` scales.
    pub fn multiscale(&self, comparison: &Comparison, scales: usize, progress: &Progress) -> Result<Vec<Scales>> {
        let Comparison { window, constants, ranges, .. } = comparison;
        let means = |(pair, _): &Job<'_, P>| multiscale(pair, window, *constants, scales, *ranges, progress);
        self.jobs()?.par_iter().map(means).collect()
    }
}

/// Mean squared difference of two images, and the range of their values.
#[derive(Clone, Copy, Debug)]
pub struct SquaredError {
    /// Mean in float64; exact for integers.
    pub mean: f64,
    /// Range of both images' values, if requested.
    pub range: ValueRange,
}

/// Compares two images pixel by pixel.
fn mean_squared_error<P: PixelRows>(pair: &Pair<'_, P>, range: bool, progress: &Progress) -> Result<SquaredError> {
    let (height, width) = (pair.reference.height, pair.reference.width);
    let run = |row: usize, first: usize| {
        let end = width.min(first + CHUNK);
        match (pair.reference.run(row, first..end), pair.test.run(row, first..end)) {
            (Some(x), Some(y)) => P::squares(x, y),
            _ => (first..end).map(|column| pair.square(row, column)).sum(),
        }
    };
    let rows = (CHUNK / width).max(1);
    let task = |rows: Range<usize>| {
        let mut extremes = Extremes::default();
        let row_sum = |row: usize| -> f64 {
            if range {
                pair.extend(&Region { rows: [row, row + 1], columns: [0, width] }, &mut extremes);
            }
            (0..width).step_by(CHUNK).map(|first| run(row, first)).sum()
        };
        let sum: f64 = rows.map(row_sum).sum();
        progress.check().map(|()| (sum, extremes.range()))
    };
    // Small images stay on one thread, because waking threads takes as long as reading a few megabytes. The order of
    // sums is the same.
    let sums: Vec<(f64, ValueRange)> = if height.saturating_mul(width).saturating_mul(size_of::<P>()) < SERIAL_BYTES {
        (0..height).step_by(rows).map(|first| task(first..height.min(first + rows))).collect::<Result<_>>()?
    } else {
        in_ranges(height, rows, task)?
    };
    Ok(SquaredError {
        mean: sums.iter().map(|task| task.0).sum::<f64>() / (height as f64 * width as f64),
        range: sums.iter().fold(ValueRange::default(), |range, task| range.union(task.1)),
    })
}
