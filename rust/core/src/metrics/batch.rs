//! Comparison of many pairs of images at once.

use rayon::prelude::*;

use super::pair::Pair;
use super::pixel_rows::PixelRows;
use super::plane::Plane;
use super::similarity::{Counted, Mask, Scales, Shrunk, Similarity, SimilaritySums, Window, multiscale, similarity};
use super::squared_error::{SquaredError, mean_squared_error};
use crate::base::{Error, Progress, Result};

/// Settings of a comparison.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// Window around each pixel.
    pub window: Window,
    /// Constants of the measure.
    pub constants: Similarity,
    /// Factor by which images are shrunk before the comparison.
    pub shrink: usize,
    /// Whether windows that extend beyond the image count too.
    pub all: bool,
    /// Whether windows ignore pixels outside the masks.
    pub hidden: bool,
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
struct Job<'a, P> {
    pair: Pair<'a, P>,
    mask: Option<Plane<'a, u8>>,
}

impl<'a, P> Stacks<'a, P>
where
    P: PixelRows<Real: PixelRows<Real = P::Real>>,
{
    fn jobs(&self) -> Result<Vec<Job<'a, P>>> {
        let count = self.references.len();
        for (argument, length) in [("test", self.tests.len()), ("mask", self.masks.as_ref().map_or(count, Vec::len))] {
            if length != count {
                return Err(Error::value(argument, format!("{count} images"), length));
            }
        }
        let job = |n: usize| {
            let mask = self.masks.as_ref().map(|masks| masks[n]);
            Ok(Job { pair: Pair::new(self.references[n], self.tests[n])?, mask })
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
        let one = |job: &Job<'_, P>, map: Option<&mut [P::Real]>| {
            let sums = comparison.compare_pair(&job.pair, job.mask, map, progress)?;
            progress.report(1)?;
            Ok(sums)
        };
        match maps {
            Some(maps) => {
                let length = maps.len() / jobs.len().max(1);
                let maps = maps.par_chunks_mut(length.max(1));
                jobs.par_iter().zip_eq(maps).map(|(job, map)| one(job, Some(map))).collect()
            }
            None => jobs.par_iter().map(|job| one(job, None)).collect(),
        }
    }

    /// Returns the mean squared difference of each pair, with the range of values if `ranges`.
    pub fn mean_squared_errors(&self, ranges: bool, progress: &Progress) -> Result<Vec<SquaredError>> {
        self.jobs()?.iter().map(|job| mean_squared_error(&job.pair, ranges, progress)).collect()
    }

    /// Returns the means of each pair's similarity and contrast factor at each of `scales` scales.
    pub fn multiscale(&self, comparison: &Comparison, scales: usize, progress: &Progress) -> Result<Vec<Scales>> {
        let Comparison { window, constants, ranges, .. } = comparison;
        let one = |job: &Job<'_, P>| multiscale(&job.pair, window, *constants, scales, *ranges, progress);
        self.jobs()?.par_iter().map(one).collect()
    }
}

impl Comparison {
    fn compare_pair<P>(
        &self,
        pair: &Pair<'_, P>,
        mask: Option<Plane<'_, u8>>,
        map: Option<&mut [P::Real]>,
        progress: &Progress,
    ) -> Result<SimilaritySums>
    where
        P: PixelRows<Real: PixelRows<Real = P::Real>>,
    {
        let mask = mask.map(if self.hidden { Mask::Windows } else { Mask::Mean });
        let counted =
            Counted { all: self.all, mask, contrast: false, range: self.ranges && self.shrink == 1, progress };
        if self.shrink > 1 {
            let smaller = Shrunk::new(pair, self.shrink, progress)?;
            let sums = similarity(&smaller.pair()?, &self.window, self.constants, counted, map)?;
            let range = if self.ranges { pair.range() } else { sums.range };
            return Ok(SimilaritySums { range, ..sums });
        }
        similarity(pair, &self.window, self.constants, counted, map)
    }
}
