//! Sizes and weights of the objects in view; with several eyes, the one that sees an object largest counts.

use std::ops::RangeInclusive;

use bytemuck::Zeroable;
use rayon::prelude::*;

use super::super::select::{COLUMNS, EyeSizes, HIDDEN, Model, Objects, OpenSizes, Sight, TILE, ThresholdLine};
use super::hull::RatedModel;
use crate::base::error::number;
use crate::base::memory::try_vec;
use crate::base::{Error, Progress, Result};

/// Budget, draws and weights.
#[derive(Clone, Copy, Debug)]
pub struct Budget<'a> {
    /// Maximum number of drawn triangles of all objects in view.
    pub triangles: u64,
    /// Number of times that each object is drawn; 0 counts as 1. None draws every object once.
    pub draws: Option<&'a [u8]>,
    /// Weights of the objects.
    pub weights: Weights<'a>,
    /// Objects score at least f(σ) − floor if the budget allows it.
    pub floor: Option<f64>,
    /// Price of the previous frame. It is kept if it spends at least 1 − hysteresis of the budget and no more than
    /// all.
    pub price: Option<f64>,
}

/// Range of weights within which sums and slopes neither overflow nor vanish.
const USUAL_WEIGHTS: RangeInclusive<f64> = 1e-150..=1e150;

/// Weights of the objects.
#[derive(Clone, Copy, Debug)]
pub enum Weights<'a> {
    /// Equal weights.
    Object,
    /// σ_eff / (tangent of a pixel)².
    Pixels,
    /// One number per object.
    Each(&'a [f64]),
}

impl Weights<'_> {
    /// Fails for numbers that would be lost in sums.
    pub fn check(&self) -> Result<()> {
        let Weights::Each(all) = self else { return Ok(()) };
        let is_refused = |weight: &f64| *weight != 0.0 && !USUAL_WEIGHTS.contains(weight);
        let Some(n) = all.iter().position(is_refused) else { return Ok(()) };
        let got = format!("{} at index {n}", number(all[n]));
        Err(Error::value("weight", "0, or numbers from 1e-150 to 1e150", got))
    }
}

/// Input of the size computation: objects and eyes.
pub(super) struct SizesOf<'a> {
    pub models: &'a [Model<'a>],
    pub objects: &'a Objects<'a>,
    pub eyes: &'a EyeSizes<'a>,
    /// Whether objects outside the view get no level.
    pub cull: bool,
    pub line: ThresholdLine,
}

/// Sizes of objects; `read` is below 0 for those outside the view.
pub(super) struct SeenObjects {
    /// Size at which curves are read.
    pub read: Vec<f64>,
    /// σ, σ_eff, σ_eff/pixel² and the maximum f(σ) over all eyes; empty if not requested.
    pub sigma: Vec<f64>,
    pub seen: Vec<f64>,
    pub pixels: Vec<f64>,
    pub threshold: Vec<f64>,
}

/// Columns of a tile.
struct SeenTile<'a> {
    first: usize,
    read: &'a mut [f64],
    /// σ, σ_eff, σ_eff/pixel² and f(σ).
    optional: [&'a mut [f64]; 4],
}

impl SeenObjects {
    /// `requested` tells which of σ, σ_eff, σ_eff/pixel² and f(σ) to compute.
    pub fn new(of: &SizesOf<'_>, requested: [bool; 4], progress: &Progress) -> Result<Self> {
        let count = of.objects.radii.len();
        let column = |is_requested: bool| try_vec(HIDDEN, if is_requested { count } else { 0 });
        let mut read = column(true)?;
        let [sigma, seen, pixels, threshold] = requested.map(column);
        let mut optional = [sigma?, seen?, pixels?, threshold?];
        let mut chunks = optional.each_mut().map(|column| column.chunks_mut(TILE));
        let tile = |(number, read)| {
            let optional = chunks.each_mut().map(|chunks| chunks.next().unwrap_or_default());
            SeenTile { first: number * TILE, read, optional }
        };
        let tiles: Vec<_> = read.chunks_mut(TILE).enumerate().map(tile).collect();
        let scratch = || (Box::new(Sight::zeroed()), Box::new(OpenSizes::zeroed()));
        let see = |(sight, open): &mut (Box<Sight>, Box<OpenSizes>), tile: SeenTile<'_>| {
            progress.check().and_then(|()| of.see(sight, open, tile))
        };
        tiles.into_par_iter().try_for_each_init(scratch, see)?;
        let [sigma, seen, pixels, threshold] = optional;
        Ok(Self { read, sigma, seen, pixels, threshold })
    }

    /// Writes σ, σ_eff, f(σ), the score and the level of each object.
    pub fn columns(
        &self,
        models: &[RatedModel<'_>],
        objects: &Objects<'_>,
        levels: &[i32],
        columns: [&mut [f64]; COLUMNS],
    ) {
        let [sigma, seen, threshold, score, shown] = columns;
        for (n, &level) in levels.iter().enumerate() {
            let model = &models[objects.model[n] as usize];
            let read = self.read[n].min(model.model.greatest());
            (sigma[n], seen[n], threshold[n], score[n], shown[n]) = match usize::try_from(level) {
                Ok(number) => (self.sigma[n], self.seen[n], self.threshold[n], model.score(number, read), level.into()),
                Err(_) => (f64::NAN, f64::NAN, f64::NAN, f64::NAN, level.into()),
            };
        }
    }
}

impl SizesOf<'_> {
    fn see(&self, sight: &mut Sight, open: &mut OpenSizes, tile: SeenTile<'_>) -> Result<()> {
        let SeenTile { first, read, optional: [sigma, seen, pixels, threshold] } = tile;
        let objects = self.objects.part(first..first + read.len());
        objects.check(self.models, first)?;
        for (number, eye) in self.eyes.eyes.iter().enumerate() {
            eye.view.see(objects.centers, objects.radii, first, self.cull, sight)?;
            let mut count = 0;
            for n in 0..read.len() {
                open.place[count % TILE] = n as u16;
                count += usize::from(sight.sigma[n] != HIDDEN);
            }
            self.eyes.see(number, &objects, sight, open, count, f64::INFINITY);
            let per_pixel = 1.0 / (eye.pixel * eye.pixel);
            for k in 0..count {
                let n = usize::from(open.place[k]);
                if let Some(threshold) = threshold.get_mut(n) {
                    *threshold = threshold.max(self.line.value(open.sigma[k]));
                }
                if open.read[k] <= read[n] {
                    continue;
                }
                read[n] = open.read[k];
                if let (Some(sigma), Some(seen)) = (sigma.get_mut(n), seen.get_mut(n)) {
                    (*sigma, *seen) = (open.sigma[k], open.seen[k]);
                }
                if let Some(pixels) = pixels.get_mut(n) {
                    // Beyond the lens's fold the panel shows nothing.
                    let shown = if open.seen[k] < f64::INFINITY { open.seen[k] } else { 0.0 };
                    *pixels = shown * per_pixel;
                }
            }
        }
        Ok(())
    }
}
