//! The price of a triangle at which a budget is spent, and the levels at that price.

use std::cmp::Reverse;
use std::ops::RangeInclusive;

use super::super::select::SelectionCounts;
use super::fill::{Step, fill};
use super::prices::{ALWAYS, NEVER, class};
use super::rater::{RatedBlock, Rater, Room};
use super::ratings::Ratings;

/// Steps below the price that are tried in the order of their slopes, so that little of the budget is left.
const MOST_TRIED: u32 = 1 << 14;

/// Adds the edges of an object's hull whose classes are in a range.
fn edges(block: &RatedBlock<'_>, lane: usize, classes: RangeInclusive<u16>, to: &mut Vec<Step>) {
    let mut before = f64::NAN;
    for step in (0..block.slopes.len()).rev().filter(|&step| classes.contains(&block.classes[step][lane])) {
        let slope = block.slopes[step][lane];
        if slope != before {
            to.push(Step { slope, object: block.objects[lane], to: 0, triangles: 0, gain: 0.0 });
        }
        before = slope;
        if let Some(last) = to.last_mut() {
            last.to = step as u16;
            last.triangles += block.ladder.added[step];
            last.gain += block.gains[step][lane];
        }
    }
}

/// The levels that a price buys: all steps of classes above one, and some levels beside.
pub(super) struct Bought {
    pub price: f64,
    pub above: u16,
    pub triangles: u64,
    pub score: f64,
    /// Objects whose levels differ from what the classes above say, and places on their ladders.
    pub levels: Vec<(u32, u16)>,
}

/// Finds a price for what all objects' steps add up to.
pub(super) struct Plan<'a> {
    pub rater: &'a Rater<'a>,
    pub ratings: &'a Ratings,
}

impl Plan<'_> {
    /// Triangles and score of all steps of classes above one.
    fn above(&self, class: u16) -> (u64, f64) {
        let (mut triangles, mut score) = (self.ratings.ledger.first_triangles, self.ratings.ledger.first_score);
        for entry in self.ratings.ledger.classes[usize::from(class) + 1..].iter().rev() {
            triangles += entry.triangles;
            score += entry.gain;
        }
        (triangles, score)
    }

    /// The steps of some classes, in the order in which they are tried.
    fn steps(&self, least: u16, most: u16) -> Vec<Step> {
        let (mut steps, mut room) = (Vec::new(), Room::default());
        let order = self.rater.order(self.ratings.between(self.rater, least, most).into_iter());
        for (ladder, objects) in self.rater.blocks(&order) {
            let block = self.rater.rate(ladder, objects, &mut room);
            for lane in 0..objects.len() {
                edges(&block, lane, least..=most, &mut steps);
            }
        }
        // Bits of numbers of at least 0 are in the order of the numbers.
        steps.sort_unstable_by_key(|step| (Reverse(step.slope.to_bits()), step.object, Reverse(step.to)));
        steps
    }

    /// Buys what a price of the frame before buys, if that is within the budget and most of it.
    pub fn keep(&self, price: f64, budget: u64, hysteresis: f64) -> Option<Bought> {
        let scaled = price * self.rater.scale;
        let own = class(scaled);
        let (mut triangles, mut score) = self.above(own);
        if triangles > budget {
            return None;
        }
        let mut levels = Vec::new();
        if own != NEVER {
            for step in self.steps(own, own).into_iter().take_while(|step| step.slope > scaled) {
                triangles += step.triangles;
                score += step.gain;
                levels.push((step.object, step.to));
            }
        }
        let is_enough = triangles as f64 >= (1.0 - hysteresis) * budget as f64 || own == NEVER;
        (triangles <= budget && is_enough).then_some(Bought { price, above: own, triangles, score, levels })
    }

    /// Spends a budget.
    pub fn buy(&self, budget: u64) -> Bought {
        let (mut triangles, mut score) = (self.ratings.ledger.first_triangles, self.ratings.ledger.first_score);
        let mut most = ALWAYS;
        let entry = |class: u16| &self.ratings.ledger.classes[usize::from(class)];
        while most > NEVER && triangles + entry(most).triangles <= budget {
            triangles += entry(most).triangles;
            score += entry(most).gain;
            most -= 1;
        }
        if most == NEVER {
            return Bought { price: 0.0, above: NEVER, triangles, score, levels: Vec::new() };
        }
        let (mut least, mut tried) = (most, entry(most).steps);
        while least > 1 && tried + entry(least - 1).steps <= MOST_TRIED {
            least -= 1;
            tried += entry(least).steps;
        }
        let filled = fill(&self.steps(least, most), budget - triangles);
        Bought {
            price: filled.slope / self.rater.scale,
            above: most,
            triangles: triangles + filled.triangles,
            score: score + filled.gain,
            levels: filled.levels,
        }
    }

    /// Writes the levels, and counts the objects by the stage that decided.
    pub fn write(&self, above: u16, levels: &[(u32, u16)], to: &mut [i32]) -> SelectionCounts {
        let counts = self.ratings.write(self.rater, above, to);
        for &(object, place) in levels {
            let ladder = &self.rater.ladders[self.rater.objects.model[object as usize] as usize];
            to[object as usize] = ladder.level[usize::from(place)];
        }
        counts
    }
}
