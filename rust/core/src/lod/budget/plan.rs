//! The price of a triangle at which a budget is spent, and the levels at that price.

use std::cmp::Reverse;
use std::ops::RangeInclusive;

use super::super::select::SelectionCounts;
use super::fill::{Filling, Step};
use super::hull::is_on_edge;
use super::prices::{ALWAYS, NEVER, class};
use super::rater::{RatedBlock, Rater, Room};
use super::ratings::Ratings;

/// Steps that are sorted at a time, if their class has no more.
const TRIED: u32 = 1 << 14;
/// Part of the budget that may be left where more steps than these would have to be sorted.
const LEFT: u64 = 1000;

/// Adds the edges of an object's hull whose classes are in a range. Levels that lie on an edge part it.
fn edges(block: &RatedBlock<'_>, lane: usize, classes: RangeInclusive<u16>, to: &mut Vec<Step>) {
    let RatedBlock { ladder, scores, slopes, .. } = block;
    let mut coarse = slopes.len();
    while coarse > 0 {
        let slope = slopes[coarse - 1][lane];
        let is_same = |&place: &usize| place == coarse - 1 || slopes[place][lane] == slope;
        let fine = (0..coarse).rev().take_while(is_same).last().unwrap_or(0);
        if classes.contains(&block.classes[coarse - 1][lane]) {
            let mut from = coarse;
            for place in (fine..coarse).rev() {
                if place == fine || is_on_edge(ladder, scores, lane, [coarse, fine], place) {
                    to.push(Step {
                        slope,
                        object: block.objects[lane],
                        to: place as u16,
                        triangles: ladder.triangles[place] - ladder.triangles[from],
                        gain: block.weights[lane] * (scores[place][lane] - scores[from][lane]),
                    });
                    from = place;
                }
            }
        }
        coarse = fine;
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

impl Bought {
    fn new(price: f64, above: u16, budget: u64, score: f64, filling: Filling) -> Self {
        let (triangles, score) = (budget - filling.left, score + filling.gain);
        Self { price, above, triangles, score, levels: filling.levels() }
    }
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

    /// The least class that is tried along with one, so that not too many steps are sorted.
    fn reach(&self, most: u16, tried: u32) -> u16 {
        let steps = |class: u16| self.ratings.ledger.classes[usize::from(class)].steps;
        let (mut least, mut sum) = (most, steps(most));
        while least > NEVER + 1 && sum.saturating_add(steps(least - 1)) <= tried {
            least -= 1;
            sum += steps(least);
        }
        least
    }

    /// The wanted steps of some objects in some classes, in the order in which they are tried.
    fn steps(&self, objects: Vec<u32>, classes: RangeInclusive<u16>, is_wanted: impl Fn(&Step) -> bool) -> Vec<Step> {
        let (mut steps, mut room) = (Vec::new(), Room::default());
        let order = self.rater.order(objects.into_iter());
        for (ladder, objects) in self.rater.blocks(&order) {
            let block = self.rater.rate(ladder, objects, &mut room);
            for lane in 0..objects.len() {
                edges(&block, lane, classes.clone(), &mut steps);
            }
        }
        steps.retain(is_wanted);
        // Bits of numbers of at least 0 are in the order of the numbers.
        steps.sort_unstable_by_key(|step| (Reverse(step.slope.to_bits()), step.object, Reverse(step.to)));
        steps
    }

    /// All steps of some classes.
    fn between(&self, least: u16, most: u16) -> Vec<Step> {
        self.steps(self.ratings.between(self.rater, least, most), least..=most, |_| true)
    }

    /// Steps of a class that are worth more than a slope, and those down to it that lead no further than the levels of
    /// the frame before.
    fn regained(&self, own: u16, slope: f64, before: &[i32]) -> Vec<Step> {
        self.steps(self.ratings.behind(self.rater, own, before), NEVER + 1..=own, |step| {
            let level = self.rater.ladder(step.object).level[usize::from(step.to)];
            step.slope > slope || (0..=level).contains(&before[step.object as usize])
        })
    }

    /// Tries steps from a class on, more each time, until little enough is left.
    fn go_on(&self, mut next: u16, filling: &mut Filling) {
        let mut tried = TRIED;
        while next > NEVER && !filling.is_done() {
            tried = tried.saturating_mul(4);
            let least = self.reach(next, tried);
            filling.take(&self.between(least, next));
            next = least - 1;
        }
    }

    /// Takes steps with the triangles that are left of a budget.
    fn filling(&self, left: u64, budget: u64) -> Filling {
        Filling::new(left, self.rater.fewest().saturating_sub(1).max(budget / LEFT))
    }

    /// Buys what a price of the frame before buys, if that is within the budget and most of it. What is left keeps
    /// levels of that frame, or buys steps below the price where they are not known.
    pub fn keep(&self, price: f64, budget: u64, hysteresis: f64) -> Option<Bought> {
        let scaled = price * self.rater.scale;
        let own = class(scaled).min(ALWAYS - 1);
        let (triangles, score) = self.above(own);
        let mut filling = self.filling(budget.checked_sub(triangles)?, budget);
        let (steps, next) = match self.rater.objects.previous {
            _ if own == NEVER => (Vec::new(), NEVER),
            Some(before) => (self.regained(own, scaled, before), NEVER),
            None => {
                let least = self.reach(own, TRIED);
                (self.between(least, own), least - 1)
            }
        };
        let (sure, others) = steps.split_at(steps.partition_point(|step| step.slope > scaled));
        filling.take(sure);
        let is_enough = (budget - filling.left) as f64 >= (1.0 - hysteresis) * budget as f64 || own == NEVER;
        if filling.has_missed() || !is_enough {
            return None;
        }
        filling.take(others);
        self.go_on(next, &mut filling);
        Some(Bought::new(price, own, budget, score, filling))
    }

    /// Spends a budget of at least what all objects have at their coarsest levels.
    pub fn buy(&self, budget: u64) -> Bought {
        let (mut triangles, mut score) = (self.ratings.ledger.first_triangles, self.ratings.ledger.first_score);
        let mut most = ALWAYS;
        let entry = |class: u16| &self.ratings.ledger.classes[usize::from(class)];
        while most > NEVER && triangles + entry(most).triangles <= budget {
            triangles += entry(most).triangles;
            score += entry(most).gain;
            most -= 1;
        }
        let mut filling = self.filling(budget - triangles, budget);
        if most > NEVER {
            let least = self.reach(most, TRIED);
            filling.take(&self.between(least, most));
            self.go_on(least - 1, &mut filling);
        }
        Bought::new(filling.slope / self.rater.scale, most, budget, score, filling)
    }

    /// Writes the levels, and counts the objects by the stage that decided.
    pub fn write(&self, above: u16, levels: &[(u32, u16)], to: &mut [i32]) -> SelectionCounts {
        let counts = self.ratings.write(self.rater, above, to);
        for &(object, place) in levels {
            to[object as usize] = self.rater.ladder(object).level[usize::from(place)];
        }
        counts
    }
}
