//! Search for the price per triangle at which a budget is spent, and the levels at that price.

use std::cmp::Reverse;
use std::ops::RangeInclusive;

use super::super::select::SelectionCounts;
use super::fill::{Filling, Step};
use super::hull::is_on_edge;
use super::prices::{ALWAYS, NEVER, class};
use super::rater::{RatedBlock, Rater, Room};
use super::ratings::Ratings;

/// Number of steps sorted at a time, unless one class has more.
const TRIED: u32 = 1 << 14;
/// Divisor of the budget: a smaller remainder may be left if more steps than these would have to be sorted.
const LEFT: u64 = 1000;

/// Appends the edges of an object's hull with classes in a range. Levels on an edge split it.
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

/// Levels bought at a price: all steps of classes above `above`, and the listed levels.
pub(super) struct Bought {
    pub price: f64,
    pub above: u16,
    pub triangles: u64,
    pub score: f64,
    /// Objects whose levels differ from those of the classes above, with ladder positions.
    pub levels: Vec<(u32, u16)>,
}

impl Bought {
    fn new(price: f64, above: u16, budget: u64, score: f64, filling: Filling) -> Self {
        let (triangles, score) = (budget - filling.left, score + filling.gain);
        Self { price, above, triangles, score, levels: filling.levels() }
    }
}

/// Search for the price at which the sum of all objects' steps fits the budget.
pub(super) struct Plan<'a> {
    pub rater: &'a Rater<'a>,
    pub ratings: &'a Ratings,
}

impl Plan<'_> {
    /// Returns the triangles and the score of all steps of classes above the given one.
    fn above(&self, class: u16) -> (u64, f64) {
        let (mut triangles, mut score) = (self.ratings.ledger.first_triangles, self.ratings.ledger.first_score);
        for entry in self.ratings.ledger.classes[usize::from(class) + 1..].iter().rev() {
            triangles += entry.triangles;
            score += entry.gain;
        }
        (triangles, score)
    }

    /// Returns the lowest class to try together with `most`, so that about `tried` steps are sorted.
    fn reach(&self, most: u16, tried: u32) -> u16 {
        let steps = |class: u16| self.ratings.ledger.classes[usize::from(class)].steps;
        let (mut least, mut sum) = (most, steps(most));
        while least > NEVER + 1 && sum.saturating_add(steps(least - 1)) <= tried {
            least -= 1;
            sum += steps(least);
        }
        least
    }

    /// Returns the wanted steps of some objects in some classes, in the order in which they are tried.
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
        // Bits of non-negative numbers are ordered like the numbers.
        steps.sort_unstable_by_key(|step| (Reverse(step.slope.to_bits()), step.object, Reverse(step.to)));
        steps
    }

    /// Returns all steps of some classes.
    fn between(&self, least: u16, most: u16) -> Vec<Step> {
        self.steps(self.ratings.between(self.rater, least, most), least..=most, |_| true)
    }

    /// Returns the steps of a class whose slope exceeds the given one, and lower steps that lead to levels no finer
    /// than in the previous frame.
    fn regained(&self, own: u16, slope: f64, before: &[i32]) -> Vec<Step> {
        self.steps(self.ratings.coarser_than_before(self.rater, own, before), NEVER + 1..=own, |step| {
            let level = self.rater.ladder(step.object).level[usize::from(step.to)];
            step.slope > slope || (0..=level).contains(&before[step.object as usize])
        })
    }

    /// Tries steps from a class on, in growing batches, until few enough triangles remain.
    fn go_on(&self, mut next: u16, filling: &mut Filling) {
        let mut tried = TRIED;
        while next > NEVER && !filling.is_done() {
            tried = tried.saturating_mul(4);
            let least = self.reach(next, tried);
            filling.take(&self.between(least, next));
            next = least - 1;
        }
    }

    /// Starts a selection of steps with the remaining triangles of a budget.
    fn filling(&self, left: u64, budget: u64) -> Filling {
        Filling::new(left, self.rater.fewest().saturating_sub(1).max(budget / LEFT))
    }

    /// Buys the levels of the previous frame's price if that spends most of the budget but no more. The remainder
    /// keeps the previous frame's levels, or buys steps below the price if these are unknown.
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

    /// Spends a budget that suffices for all objects at their coarsest levels.
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
