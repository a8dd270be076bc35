//! Slopes of objects, many of one model at a time.

use super::super::select::Objects;
use super::hull::{Choice, LANES, Lanes, Worth, scores, slopes, worths};
use super::rated::Ladder;
use super::sizes::{SeenObjects, Weights};

/// Greatest power of 2 by which weights are scaled; its inverse is a float, too.
const MOST_EXPONENT: f64 = 1000.0;

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

/// Objects of one model with their slopes, by lane.
pub(super) struct RatedBlock<'a> {
    pub objects: &'a [u32],
    pub ladder: &'a Ladder,
    /// Places on the ladder where the objects begin.
    pub first: [usize; LANES],
    pub weights: Lanes,
    /// By place on the ladder: scores.
    pub scores: &'a [Lanes],
    /// By step: slopes by the objects' weights, scaled, and their classes.
    pub slopes: &'a [Lanes],
    pub classes: &'a [[u16; LANES]],
}

/// Buffers for a block.
#[derive(Default)]
struct Room {
    scores: Vec<Lanes>,
    slopes: Vec<Lanes>,
    classes: Vec<[u16; LANES]>,
}

impl RatedBlock<'_> {
    /// Weighted scores that a step adds.
    #[inline(always)]
    pub fn gains(&self, step: usize) -> Lanes {
        let (finer, coarser) = (&self.scores[step], &self.scores[step + 1]);
        std::array::from_fn(|n| self.weights[n] * (finer[n] - coarser[n]))
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
        let exponent = if most > 0.0 { most.log2().ceil().clamp(-MOST_EXPONENT, MOST_EXPONENT) } else { 0.0 };
        Self { ladders, objects, seen, weights, choice: Choice::All, scale: (-exponent).exp2(), hysteresis, floor }
    }

    /// Calls a function with those of some objects that are in view, block by block in the order of their models.
    pub fn each(&self, objects: impl IntoIterator<Item = u32>, mut then: impl FnMut(&RatedBlock<'_>)) {
        let order = self.by_model(objects);
        let mut room = Room::default();
        for run in order.chunk_by(|&a, &b| self.objects.model[a as usize] == self.objects.model[b as usize]) {
            let ladder = &self.ladders[self.objects.model[run[0] as usize] as usize];
            for block in run.chunks(LANES) {
                self.block(ladder, block, &mut room, &mut then);
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

    fn block(&self, ladder: &Ladder, block: &[u32], room: &mut Room, then: &mut impl FnMut(&RatedBlock<'_>)) {
        let mut logarithms = [0.0; LANES];
        for (to, &object) in logarithms.iter_mut().zip(block) {
            *to = self.seen.read[object as usize].max(ladder.range[0]).min(ladder.range[1]).ln();
        }
        scores(ladder, &logarithms, &mut room.scores);
        let mut floors = [0.0; LANES];
        if let Some(floor) = self.floor {
            for (lane, (to, &object)) in floors.iter_mut().zip(block).enumerate() {
                let least = self.seen.threshold[object as usize] - floor;
                *to = room.scores.iter().rposition(|scores| scores[lane] >= least).unwrap_or(0) as f64;
            }
        }
        slopes(ladder, &room.scores, &floors, self.choice, &mut room.slopes);
        let worth = self.worth(ladder, block, &room.slopes);
        worths(&mut room.slopes, &worth, &mut room.classes);
        let mut weights = [0.0; LANES];
        weights.iter_mut().zip(block).for_each(|(to, &object)| *to = self.weight(object));
        let is_floored = self.choice == Choice::FromFloor;
        then(&RatedBlock {
            objects: block,
            ladder,
            first: floors.map(|floor| if is_floored { floor as usize } else { ladder.steps() }),
            weights,
            scores: &room.scores,
            slopes: &room.slopes,
            classes: &room.classes,
        });
    }

    fn weight(&self, object: u32) -> f64 {
        if let Weights::Each(all) = self.weights { all[object as usize] } else { 1.0 }
    }

    fn worth(&self, ladder: &Ladder, block: &[u32], slopes: &[Lanes]) -> Worth {
        let mut worth = Worth { weights: [0.0; LANES], held: [f64::INFINITY; LANES], hold: 1.0 + self.hysteresis };
        for (to, &object) in worth.weights.iter_mut().zip(block) {
            *to = self.weight(object) * self.scale;
        }
        let Some(previous) = self.objects.previous.filter(|_| self.hysteresis > 0.0) else { return worth };
        for (lane, (to, &object)) in worth.held.iter_mut().zip(block).enumerate() {
            let level = previous[object as usize];
            let place = ladder.level.iter().position(|&own| level >= 0 && own >= level);
            // A level below the hull is not held: the edge above it would be parted.
            let is_corner =
                |&place: &usize| place == 0 || place == slopes.len() || slopes[place - 1][lane] != slopes[place][lane];
            *to = place.filter(is_corner).map_or(f64::INFINITY, |place| place as f64);
        }
        worth
    }
}
