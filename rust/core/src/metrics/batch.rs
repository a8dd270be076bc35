//! Many pairs of images compared at once.

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
    /// Images are made smaller by this first.
    pub shrink: usize,
    /// Whether windows that reach beyond the image count too.
    pub all: bool,
    /// Whether windows see only what masks name.
    pub hidden: bool,
    /// Whether the ranges of the images' values are wanted.
    pub ranges: bool,
}

/// Images of one size and type, pair by pair, with a mask each or none at all.
pub struct Stacks<'a, P> {
    /// The true ones.
    pub references: Vec<Plane<'a, P>>,
    /// Those that are compared with them.
    pub tests: Vec<Plane<'a, P>>,
    /// Masks of the images' size after shrinking.
    pub masks: Option<Vec<Plane<'a, u8>>>,
}

/// Two images and what is looked at of them.
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

    /// Sums of each pair's similarity; and where wanted the maps, one behind the other.
    pub fn compare(
        &self,
        comparison: &Comparison,
        maps: Option<&mut [P::Real]>,
        progress: &Progress,
    ) -> Result<Vec<SimilaritySums>> {
        let jobs = self.jobs()?;
        progress.expect(jobs.len() as u64);
        let one = |job: &Job<'_, P>, map: Option<&mut [P::Real]>| {
            let sums = comparison.of(&job.pair, job.mask, map, progress)?;
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

    /// Mean of each pair's squared differences, and where wanted the range of its values.
    pub fn mean_squared_errors(&self, ranges: bool, progress: &Progress) -> Result<Vec<SquaredError>> {
        self.jobs()?.iter().map(|job| mean_squared_error(&job.pair, ranges, progress)).collect()
    }

    /// Means of each pair's similarity and of its second factor at each of `scales`.
    pub fn multiscale(&self, comparison: &Comparison, scales: usize, progress: &Progress) -> Result<Vec<Scales>> {
        let Comparison { window, constants, ranges, .. } = comparison;
        let one = |job: &Job<'_, P>| multiscale(&job.pair, window, *constants, scales, *ranges, progress);
        self.jobs()?.par_iter().map(one).collect()
    }
}

impl Comparison {
    fn of<P>(
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
