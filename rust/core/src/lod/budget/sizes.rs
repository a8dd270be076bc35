//! Sizes and weights of the objects in view; of several eyes the one that sees an object largest counts.

use rayon::prelude::*;

use super::super::select::{COLUMNS, EyeSizes, HIDDEN, Model, Objects, OpenSizes, Sight, TILE, ThresholdLine};
use crate::base::{Error, Progress, Result};

/// Solid angle of all directions.
const ALL_AROUND: f64 = 4.0 * std::f64::consts::PI;

/// What an object counts for.
#[derive(Clone, Copy, Debug)]
pub enum Weights<'a> {
    /// Every object the same.
    Object,
    /// σ_eff / (tangent of a pixel)².
    Pixels,
    /// One number for each object.
    Each(&'a [f64]),
}

/// Sizes of objects; those outside the view have a `read` below 0.
pub(super) struct SeenObjects {
    /// σ
    pub sigma: Vec<f64>,
    /// σ_eff, the size that is seen.
    pub seen: Vec<f64>,
    /// The size at which curves are read.
    pub read: Vec<f64>,
    pub weight: Vec<f64>,
    /// Greatest f(σ) of all eyes.
    pub threshold: Vec<f64>,
}

/// The parts of a tile.
struct SeenTile<'a> {
    first: usize,
    parts: [&'a mut [f64]; 5],
}

impl SeenObjects {
    pub fn new(
        models: &[Model<'_>],
        objects: &Objects<'_>,
        eyes: &EyeSizes<'_>,
        cull: bool,
        line: &ThresholdLine,
        weights: &Weights<'_>,
        progress: &Progress,
    ) -> Result<Self> {
        let count = objects.radii.len();
        let hidden = || vec![HIDDEN; count];
        let mut all =
            Self { sigma: hidden(), seen: hidden(), read: hidden(), weight: vec![0.0; count], threshold: hidden() };
        let columns = [&mut all.sigma, &mut all.seen, &mut all.read, &mut all.weight, &mut all.threshold];
        let mut chunks = columns.map(|column| column.chunks_mut(TILE));
        let tiles: Vec<_> = (0..count.div_ceil(TILE))
            .map(|n| SeenTile {
                first: n * TILE,
                parts: chunks.each_mut().map(|column| column.next().unwrap_or_default()),
            })
            .collect();
        let room = || (Box::<Sight>::default(), Box::<OpenSizes>::default());
        tiles
            .into_par_iter()
            .map_init(room, |(sight, open), tile| {
                progress.check()?;
                see(models, objects, eyes, cull, line, weights, sight, open, tile)
            })
            .collect::<Result<()>>()?;
        Ok(all)
    }

    /// Writes σ, σ_eff, f(σ), the score and the level of each object.
    pub fn columns(&self, models: &[Model<'_>], objects: &Objects<'_>, levels: &[i32], columns: [&mut [f64]; COLUMNS]) {
        let [sigma, seen, threshold, score, shown] = columns;
        for (n, &level) in levels.iter().enumerate() {
            let model = &models[objects.model[n] as usize];
            let read = self.read[n].min(model.greatest());
            (sigma[n], seen[n], threshold[n], score[n], shown[n]) = match usize::try_from(level) {
                Ok(own) => (self.sigma[n], self.seen[n], self.threshold[n], model.score(own, read), level.into()),
                Err(_) => (f64::NAN, f64::NAN, f64::NAN, f64::NAN, level.into()),
            };
        }
    }
}

#[expect(clippy::too_many_arguments, reason = "the scene, the eyes, and a thread's buffers")]
fn see(
    models: &[Model<'_>],
    objects: &Objects<'_>,
    eyes: &EyeSizes<'_>,
    cull: bool,
    line: &ThresholdLine,
    weights: &Weights<'_>,
    sight: &mut Sight,
    open: &mut OpenSizes,
    tile: SeenTile<'_>,
) -> Result<()> {
    let SeenTile { first, parts: [sigma, seen, read, weight, threshold] } = tile;
    let own = objects.part(first..first + sigma.len());
    own.check(models, first)?;
    for (number, eye) in eyes.eyes.iter().enumerate() {
        eye.view.see(own.centers, own.radii, first, cull, sight)?;
        let mut count = 0;
        for n in 0..sigma.len() {
            open.place[count % TILE] = n as u16;
            count += usize::from(sight.sigma[n] != HIDDEN);
        }
        eyes.see(number, &own, sight, open, count, f64::INFINITY);
        let pixel = 1.0 / (eye.pixel * eye.pixel);
        for k in 0..count {
            let n = usize::from(open.place[k]);
            threshold[n] = threshold[n].max(line.at(open.sigma[k]));
            if open.read[k] > read[n] {
                (sigma[n], seen[n], read[n]) = (open.sigma[k], open.seen[k], open.read[k]);
                weight[n] = open.seen[k].min(ALL_AROUND) * pixel;
            }
        }
    }
    match weights {
        Weights::Pixels => {}
        Weights::Object => weight.fill(1.0),
        Weights::Each(all) => {
            for (n, (to, &given)) in weight.iter_mut().zip(&all[first..]).enumerate() {
                if !(given >= 0.0 && given.is_finite()) {
                    let got = format!("{given} at index {}", first + n);
                    return Err(Error::value("weight", "finite numbers of at least 0", got));
                }
                *to = given;
            }
        }
    }
    Ok(())
}
