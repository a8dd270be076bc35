//! Sizes and weights of the objects in view. With several eyes, an object has the size of the eye that sees it largest.

use std::ops::RangeInclusive;

use bytemuck::Zeroable;
use rayon::prelude::*;

use super::super::select::{CHUNK, COLUMNS, EyeSizes, HIDDEN, Model, Objects, OpenSizes, Sight, ThresholdLine};
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
    /// Price of the previous frame. It is kept if it spends at most the budget, and at least 1 − hysteresis of it.
    pub price: Option<f64>,
}

/// Range of weights for which sums and slopes neither overflow nor vanish.
const USUAL_WEIGHTS: RangeInclusive<f64> = 1e-150..=1e150;

/// Weights of the objects.
#[derive(Clone, Copy, Debug)]
pub enum Weights<'a> {
    /// Equal weights.
    Object,
    /// σ′ / (tangent of a pixel)².
    Pixels,
    /// One number per object.
    Each(&'a [f64]),
}

impl Weights<'_> {
    /// Fails for weights outside `USUAL_WEIGHTS`, except 0.
    pub fn check(&self) -> Result<()> {
        let Weights::Each(all) = self else { return Ok(()) };
        let is_refused = |weight: &f64| *weight != 0.0 && !USUAL_WEIGHTS.contains(weight);
        let Some(n) = all.iter().position(is_refused) else { return Ok(()) };
        let got = format!("{} at index {n}", number(all[n]));
        Err(Error::value("weight", "0, or numbers from 1e-150 to 1e150", got))
    }
}

/// Input of the computation of sizes.
pub(super) struct SizeInput<'a> {
    pub models: &'a [Model<'a>],
    pub objects: &'a Objects<'a>,
    pub eyes: &'a EyeSizes<'a>,
    /// Whether objects outside the view get no level.
    pub cull: bool,
    pub line: ThresholdLine,
}

/// Sizes of objects. Columns that were not requested are empty.
pub(super) struct ObjectSizes {
    /// Size at which curves are evaluated; below 0 for objects outside the view.
    pub curve_size: Vec<f64>,
    /// σ
    pub sigma: Vec<f64>,
    /// σ′, the displayed size.
    pub displayed: Vec<f64>,
    /// σ′/pixel²
    pub pixels: Vec<f64>,
    /// Maximum f(σ) over all eyes.
    pub threshold: Vec<f64>,
}

/// Columns of a chunk.
struct SizeChunk<'a> {
    first: usize,
    curve_size: &'a mut [f64],
    /// σ, σ′, σ′/pixel² and f(σ).
    optional: [&'a mut [f64]; 4],
}

impl ObjectSizes {
    /// Computes the sizes; `requested` says which of σ, σ′, σ′/pixel² and f(σ) are stored.
    pub fn new(input: &SizeInput<'_>, requested: [bool; 4], progress: &Progress) -> Result<Self> {
        let count = input.objects.radii.len();
        let column = |is_requested: bool| try_vec(HIDDEN, if is_requested { count } else { 0 });
        let mut curve_size = column(true)?;
        let [sigma, displayed, pixels, threshold] = requested.map(column);
        let mut optional = [sigma?, displayed?, pixels?, threshold?];
        let mut parts = optional.each_mut().map(|column| column.chunks_mut(CHUNK));
        let chunk = |(number, curve_size)| {
            let optional = parts.each_mut().map(|part| part.next().unwrap_or_default());
            SizeChunk { first: number * CHUNK, curve_size, optional }
        };
        let chunks: Vec<_> = curve_size.chunks_mut(CHUNK).enumerate().map(chunk).collect();
        let scratch = || (Box::new(Sight::zeroed()), Box::new(OpenSizes::zeroed()));
        let see = |(sight, open): &mut (Box<Sight>, Box<OpenSizes>), chunk: SizeChunk<'_>| {
            progress.check().and_then(|()| input.write_sizes(sight, open, chunk))
        };
        chunks.into_par_iter().try_for_each_init(scratch, see)?;
        let [sigma, displayed, pixels, threshold] = optional;
        Ok(Self { curve_size, sigma, displayed, pixels, threshold })
    }

    /// Writes σ, σ′, f(σ), the score and the level of each object.
    pub fn columns(
        &self,
        models: &[RatedModel<'_>],
        objects: &Objects<'_>,
        levels: &[i32],
        columns: [&mut [f64]; COLUMNS],
    ) {
        let [sigma, displayed, threshold, score, shown] = columns;
        for (n, &level) in levels.iter().enumerate() {
            let model = &models[objects.model[n] as usize];
            let size = self.curve_size[n].min(model.model.greatest());
            shown[n] = level.into();
            [sigma[n], displayed[n], threshold[n], score[n]] = match usize::try_from(level) {
                Ok(level) => [self.sigma[n], self.displayed[n], self.threshold[n], model.score(level, size)],
                Err(_) => [f64::NAN; 4],
            };
        }
    }
}

impl SizeInput<'_> {
    fn write_sizes(&self, sight: &mut Sight, open: &mut OpenSizes, chunk: SizeChunk<'_>) -> Result<()> {
        let SizeChunk { first, curve_size, optional: [sigma, displayed, pixels, threshold] } = chunk;
        let objects = self.objects.part(first..first + curve_size.len());
        objects.check(self.models, first)?;
        for (number, eye) in self.eyes.eyes.iter().enumerate() {
            eye.view.see(objects.centers, objects.radii, first, self.cull, sight)?;
            let mut count = 0;
            for n in 0..curve_size.len() {
                open.place[count % CHUNK] = n as u16;
                count += usize::from(sight.sigma[n] != HIDDEN);
            }
            self.eyes.write_sizes(number, &objects, sight, open, count, f64::INFINITY);
            let per_pixel = 1.0 / (eye.pixel * eye.pixel);
            for k in 0..count {
                let n = usize::from(open.place[k]);
                if let Some(threshold) = threshold.get_mut(n) {
                    *threshold = threshold.max(self.line.value(open.sigma[k]));
                }
                if open.curve_size[k] <= curve_size[n] {
                    continue;
                }
                curve_size[n] = open.curve_size[k];
                if let (Some(sigma), Some(displayed)) = (sigma.get_mut(n), displayed.get_mut(n)) {
                    (*sigma, *displayed) = (open.sigma[k], open.displayed[k]);
                }
                if let Some(pixels) = pixels.get_mut(n) {
                    // Beyond the lens's fold the panel shows nothing.
                    *pixels = if open.displayed[k] < f64::INFINITY { open.displayed[k] * per_pixel } else { 0.0 };
                }
            }
        }
        Ok(())
    }
}
