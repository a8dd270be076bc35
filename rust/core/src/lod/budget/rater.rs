//! Scores and slopes of objects, computed in blocks of objects of one model.

use super::super::select::Objects;
use super::hull::{Choice, Classes, LANES, Ladder, Lanes, SlopeFactors, gains, is_on_edge, scores, slopes, weigh};
use super::sizes::{Budget, ObjectSizes, Weights};

/// Maximum exponent of the power of 2 that scales weights; the power and its inverse are floats.
const MAX_EXPONENT: f64 = 1000.0;

/// Computes scores and slopes of objects in view.
pub(super) struct Rater<'a> {
    pub ladders: &'a [Ladder],
    pub objects: &'a Objects<'a>,
    pub sizes: &'a ObjectSizes,
    weights: Weights<'a>,
    draws: Option<&'a [u8]>,
    pub choice: Choice,
    /// Power of 2 by which slopes are multiplied, so that no weight exceeds 1.
    pub scale: f64,
    pub hysteresis: f64,
    floor: Option<f64>,
}

/// Objects of one model with their slopes, one per lane.
pub(super) struct RatedBlock<'a> {
    pub objects: &'a [u32],
    pub ladder: &'a Ladder,
    pub weights: Lanes,
    /// Number of times that each object is drawn.
    pub draws: [u64; LANES],
    /// Scores, by ladder position.
    pub scores: &'a [Lanes],
    /// Weighted score added by each step.
    pub gains: &'a [Lanes],
    /// Scaled weighted score per drawn triangle of each step, and its class.
    pub slopes: &'a [Lanes],
    pub classes: &'a [Classes],
}

/// Objects sorted by model.
pub(super) struct Order {
    pub objects: Vec<u32>,
    /// End of each model's objects.
    ends: Vec<usize>,
}

/// Buffers for a block.
#[derive(Default)]
pub(super) struct Scratch {
    scores: Vec<Lanes>,
    gains: Vec<Lanes>,
    slopes: Vec<Lanes>,
    classes: Vec<Classes>,
}

impl Scratch {
    fn resize(&mut self, steps: usize) {
        self.scores.resize(steps + 1, [0.0; LANES]);
        self.gains.resize(steps, [0.0; LANES]);
        self.slopes.resize(steps, [0.0; LANES]);
        self.classes.resize(steps, [0; LANES]);
    }
}

impl<'a> Rater<'a> {
    pub fn new(
        ladders: &'a [Ladder],
        objects: &'a Objects<'a>,
        sizes: &'a ObjectSizes,
        weights: Weights<'a>,
        budget: &Budget<'a>,
        hysteresis: f64,
    ) -> Self {
        let max_weight = match weights {
            Weights::Each(all) => all.iter().copied().fold(0.0, f64::max),
            _ => 1.0,
        };
        let exponent = if max_weight > 0.0 { max_weight.log2().ceil().clamp(-MAX_EXPONENT, MAX_EXPONENT) } else { 0.0 };
        let (scale, draws, floor) = ((-exponent).exp2(), budget.draws, budget.floor);
        Self { ladders, objects, sizes, weights, draws, choice: Choice::All, scale, hysteresis, floor }
    }

    pub fn ladder(&self, object: u32) -> &'a Ladder {
        &self.ladders[self.objects.model[object as usize] as usize]
    }

    /// Returns the minimum number of triangles that a step of any model adds.
    pub fn min_step_triangles(&self) -> u64 {
        self.ladders.iter().flat_map(|ladder| &ladder.added).copied().min().unwrap_or(0)
    }

    /// Returns the greatest number of steps of a model.
    pub fn most_steps(&self) -> usize {
        self.ladders.iter().map(Ladder::steps).max().unwrap_or(0)
    }

    /// Returns those of some objects that are in view, sorted by model.
    pub fn order(&self, objects: impl Iterator<Item = u32> + Clone) -> Order {
        let visible = objects.filter(|&object| self.sizes.curve_size[object as usize] >= 0.0);
        let mut ends = vec![0; self.ladders.len() + 1];
        let model = |object: u32| self.objects.model[object as usize] as usize;
        visible.clone().for_each(|object| ends[model(object) + 1] += 1);
        for n in 1..ends.len() {
            ends[n] += ends[n - 1];
        }
        let mut sorted = vec![0; ends[ends.len() - 1]];
        for object in visible {
            let next = &mut ends[model(object)];
            sorted[*next] = object;
            *next += 1;
        }
        ends.pop();
        Order { objects: sorted, ends }
    }

    /// Splits the objects into blocks of one model, in their order.
    pub fn blocks<'o>(&self, order: &'o Order) -> impl Iterator<Item = (&'a Ladder, &'o [u32])> {
        let mut start = 0;
        self.ladders.iter().zip(&order.ends).flat_map(move |(ladder, &end)| {
            let objects = &order.objects[start..end];
            start = end;
            objects.chunks(LANES).map(move |block| (ladder, block))
        })
    }

    /// Computes scores and slopes of a block.
    pub fn rate<'r>(&self, ladder: &'r Ladder, block: &'r [u32], scratch: &'r mut Scratch) -> RatedBlock<'r> {
        let (mut sizes, mut weights, mut draws) = ([0.0; LANES], [0.0; LANES], [1; LANES]);
        sizes.iter_mut().zip(block).for_each(|(to, &object)| *to = self.sizes.curve_size[object as usize]);
        weights.iter_mut().zip(block).for_each(|(to, &object)| *to = self.weight(object));
        if let Some(all) = self.draws {
            draws.iter_mut().zip(block).for_each(|(to, &object)| *to = u64::from(all[object as usize].max(1)));
        }
        scratch.resize(ladder.steps());
        scores(ladder, &sizes, &mut scratch.scores);
        let mut floors = [0.0; LANES];
        if let Some(floor) = self.floor {
            for (lane, (to, &object)) in floors.iter_mut().zip(block).enumerate() {
                let least = self.sizes.threshold[object as usize] - floor;
                *to = scratch.scores.iter().rposition(|scores| scores[lane] >= least).unwrap_or(0) as f64;
            }
        }
        slopes(ladder, &scratch.scores, &floors, self.choice, &mut scratch.slopes);
        let factors = SlopeFactors {
            weights: std::array::from_fn(|n| weights[n] * self.scale / draws[n] as f64),
            hold: 1.0 + self.hysteresis,
            held_from: self.held_steps(ladder, block, scratch),
            always_from: if self.choice == Choice::FromFloor { floors } else { [f64::INFINITY; LANES] },
        };
        weigh(&mut scratch.slopes, &factors, &mut scratch.classes);
        gains(&scratch.scores, &weights, &mut scratch.gains);
        let Scratch { scores, gains, slopes, classes } = scratch;
        RatedBlock { objects: block, ladder, weights, draws, scores, gains, slopes, classes }
    }

    fn weight(&self, object: u32) -> f64 {
        if let Weights::Each(all) = self.weights { all[object as usize] } else { 1.0 }
    }

    /// Returns the number of the step that leads to the previous frame's level; +∞ if the level is not held.
    fn held_steps(&self, ladder: &Ladder, block: &[u32], scratch: &Scratch) -> Lanes {
        let mut held = [f64::INFINITY; LANES];
        let Some(previous) = self.objects.previous.filter(|_| self.hysteresis > 0.0) else { return held };
        for (lane, (to, &object)) in held.iter_mut().zip(block).enumerate() {
            let level = previous[object as usize];
            let position = ladder.level.iter().position(|&ladder_level| level >= 0 && ladder_level >= level);
            // A level below the hull is not held, because holding it would split the edge above it.
            let is_corner = |&position: &usize| {
                let [coarse, fine] = edge_around(&scratch.slopes, lane, position);
                position == coarse
                    || position == fine
                    || is_on_edge(ladder, &scratch.scores, lane, [coarse, fine], position)
            };
            *to = position.filter(is_corner).map_or(f64::INFINITY, |position| position as f64);
        }
        held
    }
}

/// Returns the ends of the hull's edge at or above a position: the range of steps with equal slope.
fn edge_around(slopes: &[Lanes], lane: usize, position: usize) -> [usize; 2] {
    let (mut coarse, mut fine) = (position, position);
    if (1..slopes.len()).contains(&position) && slopes[position - 1][lane] == slopes[position][lane] {
        let slope = slopes[position][lane];
        while coarse < slopes.len() && slopes[coarse][lane] == slope {
            coarse += 1;
        }
        while fine > 0 && slopes[fine - 1][lane] == slope {
            fine -= 1;
        }
    }
    [coarse, fine]
}
