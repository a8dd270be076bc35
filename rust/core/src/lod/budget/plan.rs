//! Finds the price per triangle at which a budget is spent, and the levels at this price.

use std::cmp::Reverse;
use std::collections::HashSet;
use std::ops::RangeInclusive;

use super::super::select::SelectionCounts;
use super::hull::is_on_edge;
use super::prices::{ALWAYS, NEVER, class};
use super::rater::{RatedBlock, Rater, Scratch};
use super::ratings::Ratings;
use crate::base::Result;
use crate::base::memory::try_with_capacity;

/// Number of steps that are sorted at a time, unless one class has more.
const STEPS_PER_BATCH: u32 = 1 << 14;
/// A large step that does not fit is taken first, before others, if the mean score may rise by more than this.
const WORTH_A_STEP: f64 = 0.005;
/// A selection ends when at most 1/1000 of the budget remains, so that fewer steps have to be sorted.
const BUDGET_PER_REMAINDER: u64 = 1000;

/// A step between two levels on an object's hull.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    /// Weighted score per drawn triangle.
    pub slope: f64,
    pub object: u32,
    /// Ladder position that the step leads to.
    pub to: u16,
    /// Number of drawn triangles.
    pub triangles: u64,
    /// Weighted score.
    pub gain: f64,
}

/// Steps taken in order until the budget is spent. If a step does not fit, its object takes neither it nor later steps.
#[derive(Default)]
pub(super) struct Filling {
    /// Number of remaining triangles.
    pub remaining: u64,
    /// The selection ends when at most this number of triangles remains.
    sufficient: u64,
    /// The first step that does not fit; `None` if all fit.
    pub first_without_room: Option<Step>,
    /// Upper bound of `gain`: that of the steps before the first one without room, plus the share of it that fits. 0
    /// until a step does not fit.
    greatest_gain: f64,
    pub gain: f64,
    levels: Vec<(u32, u16)>,
    /// Objects that take no later step.
    stopped: HashSet<u32>,
}

impl Filling {
    pub fn new(remaining: u64, sufficient: u64) -> Self {
        Self { remaining, sufficient, ..Self::default() }
    }

    /// Returns whether few enough triangles remain.
    pub fn is_done(&self) -> bool {
        self.remaining <= self.sufficient
    }

    /// Takes the steps that fit, in order.
    pub fn take(&mut self, steps: &[Step]) {
        let least = steps.iter().map(|step| step.triangles).min().unwrap_or(0);
        for (n, step) in steps.iter().enumerate() {
            if self.stopped.contains(&step.object) {
                continue;
            }
            if step.triangles > self.remaining {
                if self.first_without_room.is_none() {
                    self.first_without_room = Some(*step);
                    self.greatest_gain = self.gain + step.gain * self.remaining as f64 / step.triangles as f64;
                }
                self.stopped.insert(step.object);
                if self.remaining < least {
                    // No other step of this batch fits. Objects whose steps are skipped here take no later step.
                    if !self.is_done() {
                        self.stopped.extend(steps[n..].iter().map(|step| step.object));
                    }
                    return;
                }
            } else {
                self.remaining -= step.triangles;
                self.gain += step.gain;
                self.levels.push((step.object, step.to));
            }
        }
    }

    /// Returns the objects that took steps, with the finest ladder position of each.
    pub fn levels(mut self) -> Vec<(u32, u16)> {
        // An object's finest position has the smallest number.
        self.levels.sort_unstable();
        self.levels.dedup_by_key(|level| level.0);
        self.levels
    }
}

/// Appends the steps along an object's hull whose classes are in a range. An edge is split at the levels on it.
fn append_hull_steps(block: &RatedBlock<'_>, lane: usize, classes: RangeInclusive<u16>, to: &mut Vec<Step>) {
    let RatedBlock { ladder, draws, scores, slopes, .. } = block;
    let mut coarse = slopes.len();
    while coarse > 0 {
        let slope = slopes[coarse - 1][lane];
        let is_same = |&position: &usize| position == coarse - 1 || slopes[position][lane] == slope;
        let fine = (0..coarse).rev().take_while(is_same).last().unwrap_or(0);
        if classes.contains(&block.classes[coarse - 1][lane]) {
            let mut from = coarse;
            for position in (fine..coarse).rev() {
                if position == fine || is_on_edge(ladder, scores, lane, [coarse, fine], position) {
                    to.push(Step {
                        slope,
                        object: block.objects[lane],
                        to: position as u16,
                        triangles: draws[lane] * (ladder.triangles[position] - ladder.triangles[from]),
                        gain: block.weights[lane] * (scores[position][lane] - scores[from][lane]),
                    });
                    from = position;
                }
            }
        }
        coarse = fine;
    }
}

/// Levels at a price: all steps of classes above `price_class`, and the listed levels.
pub(super) struct Purchase {
    pub price: f64,
    pub price_class: u16,
    pub triangles: u64,
    pub score: f64,
    /// Objects that take further steps, with their ladder positions.
    pub levels: Vec<(u32, u16)>,
}

impl Purchase {
    fn new(price: f64, price_class: u16, budget: u64, score: f64, filling: Filling) -> Self {
        let (triangles, score) = (budget - filling.remaining, score + filling.gain);
        Self { price, price_class, triangles, score, levels: filling.levels() }
    }
}

/// Search for the price at which the sum of all objects' steps fits the budget.
pub(super) struct Plan<'a> {
    pub rater: &'a Rater<'a>,
    pub ratings: &'a Ratings,
}

impl Plan<'_> {
    /// Returns the triangles and the score of all objects after all steps of classes above the given one.
    fn sums_above(&self, class: u16) -> (u64, f64) {
        let (mut triangles, mut score) = (self.ratings.ledger.first_triangles, self.ratings.ledger.first_score);
        for entry in self.ratings.ledger.classes[usize::from(class) + 1..].iter().rev() {
            triangles += entry.triangles;
            score += entry.gain;
        }
        (triangles, score)
    }

    /// Returns the lowest class to try together with `highest`, so that about `count` steps are sorted.
    fn lowest_class(&self, highest: u16, count: u32) -> u16 {
        let steps = |class: u16| self.ratings.ledger.classes[usize::from(class)].steps;
        let (mut lowest, mut sum) = (highest, steps(highest));
        while lowest > NEVER + 1 && sum.saturating_add(steps(lowest - 1)) <= count {
            lowest -= 1;
            sum += steps(lowest);
        }
        lowest
    }

    /// Returns steps of some objects in a range of classes, in the order in which they are tried.
    fn steps(
        &self,
        objects: Vec<u32>,
        classes: RangeInclusive<u16>,
        is_wanted: impl Fn(&Step) -> bool,
    ) -> Result<Vec<Step>> {
        let order = self.rater.order(objects.into_iter());
        let most_steps = self.rater.blocks(&order).map(|(ladder, objects)| ladder.steps() * objects.len()).sum();
        let (mut steps, mut scratch) = (try_with_capacity(most_steps)?, Scratch::default());
        for (ladder, objects) in self.rater.blocks(&order) {
            let block = self.rater.rate(ladder, objects, &mut scratch);
            for lane in 0..objects.len() {
                append_hull_steps(&block, lane, classes.clone(), &mut steps);
            }
        }
        steps.retain(is_wanted);
        // Bits of non-negative numbers are ordered like the numbers.
        steps.sort_unstable_by_key(|step| (Reverse(step.slope.to_bits()), step.object, Reverse(step.to)));
        Ok(steps)
    }

    /// Returns all steps of a range of classes.
    fn steps_between(&self, lowest: u16, highest: u16) -> Result<Vec<Step>> {
        self.steps(self.ratings.objects_between(self.rater, lowest, highest)?, lowest..=highest, |_| true)
    }

    /// Returns the steps of a class whose slope exceeds the given one, and the steps with lower slopes that lead to
    /// levels no finer than in the previous frame.
    fn steps_to_previous_levels(&self, class: u16, slope: f64, previous: &[i32]) -> Result<Vec<Step>> {
        self.steps(self.ratings.coarser_than_previous(self.rater, class, previous)?, NEVER + 1..=class, |step| {
            let level = self.rater.ladder(step.object).level[usize::from(step.to)];
            step.slope > slope || (0..=level).contains(&previous[step.object as usize])
        })
    }

    /// Tries steps from a class downwards, in growing batches, until few enough triangles remain.
    fn fill_from(&self, mut next: u16, filling: &mut Filling) -> Result<()> {
        let mut count = STEPS_PER_BATCH;
        while next > NEVER && !filling.is_done() {
            count = count.saturating_mul(4);
            let lowest = self.lowest_class(next, count);
            filling.take(&self.steps_between(lowest, next)?);
            next = lowest - 1;
        }
        Ok(())
    }

    /// Creates an empty selection of steps for the remaining triangles of a budget.
    fn new_filling(&self, remaining: u64, budget: u64) -> Filling {
        Filling::new(remaining, self.rater.min_step_triangles().saturating_sub(1).max(budget / BUDGET_PER_REMAINDER))
    }

    /// Buys the levels at the previous frame's price; `None` if they exceed the budget or leave too much of it. The
    /// remaining budget is spent on levels of the previous frame, or on steps below the price if these are unknown.
    pub fn buy_at_price(&self, price: f64, budget: u64, hysteresis: f64) -> Result<Option<Purchase>> {
        let scaled = price * self.rater.scale;
        let class_of_price = class(scaled).min(ALWAYS - 1);
        let (triangles, score) = self.sums_above(class_of_price);
        let Some(remaining) = budget.checked_sub(triangles) else { return Ok(None) };
        let mut filling = self.new_filling(remaining, budget);
        let (steps, next) = match self.rater.objects.previous {
            _ if class_of_price == NEVER => (Vec::new(), NEVER),
            Some(previous) => (self.steps_to_previous_levels(class_of_price, scaled, previous)?, NEVER),
            None => {
                let lowest = self.lowest_class(class_of_price, STEPS_PER_BATCH);
                (self.steps_between(lowest, class_of_price)?, lowest - 1)
            }
        };
        let (bought, cheaper) = steps.split_at(steps.partition_point(|step| step.slope > scaled));
        filling.take(bought);
        let spent = (budget - filling.remaining) as f64;
        let is_enough = spent >= (1.0 - hysteresis) * budget as f64 || class_of_price == NEVER;
        if !filling.stopped.is_empty() || !is_enough {
            return Ok(None);
        }
        filling.take(cheaper);
        self.fill_from(next, &mut filling)?;
        if self.is_far_from_greatest(&filling) {
            return Ok(None);
        }
        Ok(Some(Purchase::new(price, class_of_price, budget, score, filling)))
    }

    /// Finds the price for a budget that suffices for all objects at their coarsest levels.
    pub fn buy(&self, budget: u64) -> Result<Purchase> {
        let (mut triangles, mut score) = (self.ratings.ledger.first_triangles, self.ratings.ledger.first_score);
        let mut highest = ALWAYS;
        let entry = |class: u16| &self.ratings.ledger.classes[usize::from(class)];
        while highest > NEVER && triangles + entry(highest).triangles <= budget {
            triangles += entry(highest).triangles;
            score += entry(highest).gain;
            highest -= 1;
        }
        let mut filling = self.new_filling(budget - triangles, budget);
        if highest > NEVER {
            let lowest = self.lowest_class(highest, STEPS_PER_BATCH);
            filling.take(&self.steps_between(lowest, highest)?);
            self.fill_from(lowest - 1, &mut filling)?;
        }
        let step = filling.first_without_room.filter(|_| self.is_far_from_greatest(&filling));
        let bought = self.purchase(highest, budget, score, filling);
        let Some(step) = step else { return Ok(bought) };
        let first_taken = self.buy_step_first(&step, budget)?;
        Ok(first_taken.filter(|other| self.is_better(other, &bought, &step)).unwrap_or(bought))
    }

    /// Returns the purchase after a filling, at the price of the first step that does not fit.
    fn purchase(&self, price_class: u16, budget: u64, score: f64, filling: Filling) -> Purchase {
        let price = filling.first_without_room.map_or(0.0, |step| step.slope) / self.rater.scale;
        Purchase::new(price, price_class, budget, score, filling)
    }

    /// Returns whether a choice with a step is better than one without it. The choice that keeps the object's previous
    /// level is, unless the other one gains more by the share `hysteresis`.
    fn is_better(&self, with: &Purchase, without: &Purchase, step: &Step) -> bool {
        let [with, without] = [with, without].map(|choice| choice.score - self.ratings.ledger.first_score);
        let held = 1.0 + self.rater.hysteresis;
        match self.rater.objects.previous.map(|previous| previous[step.object as usize]) {
            None | Some(..0) => with > without,
            Some(level) if level <= self.rater.ladder(step.object).level[usize::from(step.to)] => with * held > without,
            Some(_) => with > without * held,
        }
    }

    /// Returns whether the mean score may be lower by more than `WORTH_A_STEP` than that of the best choice. This
    /// happens if one object has most of the weight, and its step takes much of the budget.
    fn is_far_from_greatest(&self, filling: &Filling) -> bool {
        filling.greatest_gain - filling.gain > WORTH_A_STEP * self.ratings.ledger.weight
    }

    /// Buys an object's steps up to the given one, and then those of the others in order; `None` if the budget does not
    /// suffice.
    fn buy_step_first(&self, step: &Step, budget: u64) -> Result<Option<Purchase>> {
        // Triangles and gain of the object's own steps that are not in the sums above a class.
        let own = |class: u16| -> Result<(u64, f64)> {
            let steps = self.steps(vec![step.object], NEVER + 1..=class, |own| own.to >= step.to)?;
            Ok((steps.iter().map(|own| own.triangles).sum(), steps.iter().map(|own| own.gain).sum()))
        };
        let fits = |class: u16| Ok(self.sums_above(class).0 + own(class)?.0 <= budget);
        let (mut low, mut high) = (NEVER, ALWAYS - 1);
        if !fits(high)? {
            return Ok(None);
        }
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            if fits(middle)? { high = middle } else { low = middle }
        }
        let ((triangles, score), (own_triangles, own_gain)) = (self.sums_above(high), own(high)?);
        let mut filling = self.new_filling(budget - triangles - own_triangles, budget);
        filling.gain = own_gain;
        filling.levels.push((step.object, step.to));
        filling.stopped.insert(step.object);
        self.fill_from(high, &mut filling)?;
        Ok(Some(self.purchase(high, budget, score, filling)))
    }

    /// Writes the levels. Counts the objects decided by culling, by a model with one level, and by the price.
    pub fn write(&self, price_class: u16, levels: &[(u32, u16)], to: &mut [i32]) -> SelectionCounts {
        let counts = self.ratings.write(self.rater, price_class, to);
        for &(object, position) in levels {
            to[object as usize] = self.rater.ladder(object).level[usize::from(position)];
        }
        counts
    }
}
