//! Slopes of objects, many of one model at a time.

use super::super::select::Objects;
use super::hull::{Choice, LANES, Lanes, scores, slopes};
use super::rated::Ladder;
use super::sizes::{SeenObjects, Weights};

/// Rates objects in view.
pub(super) struct Rater<'a> {
    pub ladders: &'a [Ladder],
    pub objects: &'a Objects<'a>,
    pub seen: &'a SeenObjects,
    weights: Weights<'a>,
    pub choice: Choice,
    /// Power of 2 by which slopes are multiplied, so that no weight exceeds 1.
    pub scale: f64,
    hysteresis: f64,
    floor: Option<f64>,
}

/// An object with its slopes.
pub(super) struct Rated<'a> {
    pub object: u32,
    pub ladder: &'a Ladder,
    /// Place on the ladder where it begins.
    pub first: usize,
    pub weight: f64,
    lane: usize,
    scores: &'a [Lanes],
    slopes: &'a [Lanes],
    factor: f64,
    /// Steps from this place on lead to the level of the frame before, and count more.
    held: usize,
    hold: f64,
}

impl Rated<'_> {
    /// Score at a place on the ladder.
    pub fn score(&self, place: usize) -> f64 {
        self.scores[place][self.lane]
    }

    /// Slope of a step, scaled.
    pub fn slope(&self, step: usize) -> f64 {
        let own = self.slopes[step][self.lane] * self.factor;
        if step >= self.held { own * self.hold } else { own }
    }
}

impl<'a> Rater<'a> {
    pub fn new(
        ladders: &'a [Ladder],
        objects: &'a Objects<'a>,
        seen: &'a SeenObjects,
        weights: Weights<'a>,
        hysteresis: f64,
        floor: Option<f64>,
    ) -> Self {
        let most = match weights {
            Weights::Each(all) => all.iter().copied().fold(0.0, f64::max),
            _ => 1.0,
        };
        let exponent = if most > 0.0 { most.log2().ceil() } else { 0.0 };
        Self { ladders, objects, seen, weights, choice: Choice::All, scale: (-exponent).exp2(), hysteresis, floor }
    }

    /// Calls a function with each of some objects that is in view, in the order of their models.
    pub fn each(&self, objects: impl IntoIterator<Item = u32>, mut then: impl FnMut(&Rated<'_>)) {
        let order = self.by_model(objects);
        let (mut of_levels, mut of_steps) = (Vec::new(), Vec::new());
        for run in order.chunk_by(|&a, &b| self.objects.model[a as usize] == self.objects.model[b as usize]) {
            let ladder = &self.ladders[self.objects.model[run[0] as usize] as usize];
            for block in run.chunks(LANES) {
                self.block(ladder, block, &mut of_levels, &mut of_steps, &mut then);
            }
        }
    }

    /// The objects in view, sorted by their models.
    fn by_model(&self, objects: impl IntoIterator<Item = u32>) -> Vec<u32> {
        let visible: Vec<u32> = objects.into_iter().filter(|&object| self.seen.read[object as usize] >= 0.0).collect();
        let mut ends = vec![0; self.ladders.len() + 1];
        let model = |object: u32| self.objects.model[object as usize] as usize;
        visible.iter().for_each(|&object| ends[model(object) + 1] += 1);
        for n in 1..ends.len() {
            ends[n] += ends[n - 1];
        }
        let mut order = vec![0; visible.len()];
        for object in visible {
            let place = &mut ends[model(object)];
            order[*place] = object;
            *place += 1;
        }
        order
    }

    fn block(
        &self,
        ladder: &Ladder,
        block: &[u32],
        of_levels: &mut Vec<Lanes>,
        of_steps: &mut Vec<Lanes>,
        then: &mut impl FnMut(&Rated<'_>),
    ) {
        let mut logarithms = [0.0; LANES];
        for (to, &object) in logarithms.iter_mut().zip(block) {
            *to = self.seen.read[object as usize].max(ladder.range[0]).min(ladder.range[1]).ln();
        }
        scores(ladder, &logarithms, of_levels);
        let mut floors = [0.0; LANES];
        if let Some(floor) = self.floor {
            for (lane, (to, &object)) in floors.iter_mut().zip(block).enumerate() {
                let least = self.seen.threshold[object as usize] - floor;
                *to = of_levels.iter().rposition(|scores| scores[lane] >= least).unwrap_or(0) as f64;
            }
        }
        slopes(ladder, of_levels, &floors, self.choice, of_steps);
        for (lane, &object) in block.iter().enumerate() {
            let n = object as usize;
            let weight = if let Weights::Each(all) = self.weights { all[n] } else { 1.0 };
            let previous = self.objects.previous.map_or(-1, |levels| levels[n]);
            let held = ladder.level.iter().position(|&level| previous >= 0 && level >= previous);
            then(&Rated {
                object,
                ladder,
                first: if self.choice == Choice::FromFloor { floors[lane] as usize } else { ladder.steps() },
                weight,
                lane,
                scores: of_levels,
                slopes: of_steps,
                factor: weight * self.scale,
                held: held.unwrap_or(usize::MAX),
                hold: 1.0 + self.hysteresis,
            });
        }
    }
}
