//! Classes of all objects' steps by slope, with the sums of each class.

use rayon::prelude::*;

use super::super::select::{HIDDEN, SelectionCounts};
use super::hull::{Classes, LANES};
use super::rater::{Ladder, Order, RatedBlock, Rater, Scratch};
use crate::base::{Progress, Result};

/// Number of classes, geometrically spaced: the exponent and a few bits of the mantissa.
pub(super) const CLASSES: usize = 1 << 12;
/// Classes of steps that gain nothing, and of steps that are taken at any price.
pub(super) const NEVER: u16 = 0;
pub(super) const ALWAYS: u16 = CLASSES as u16 - 1;
/// Mantissa bits in a class: 2 % of a slope.
const DIGITS: u32 = 5;
const SHIFT: u32 = f64::MANTISSA_DIGITS - 1 - DIGITS;
/// Start of the range with separate classes, up to 2¹²⁸ times this slope; slopes outside share the outermost classes.
const MIN: f64 = 1.0 / (1u128 << 112) as f64;

/// Returns the class of a slope; it increases monotonically.
#[inline(always)]
pub(super) fn class(slope: f64) -> u16 {
    const FIRST: i64 = (MIN.to_bits() >> SHIFT) as i64;
    const LAST: i64 = ALWAYS as i64 - 1;
    let number = (slope.to_bits() >> SHIFT) as i64 - FIRST;
    let number = if number < 1 { 1 } else { number };
    let number = if number > LAST { LAST } else { number };
    let number = if slope > 0.0 { number } else { NEVER as i64 };
    (if slope == f64::INFINITY { ALWAYS as i64 } else { number }) as u16
}

/// Sums over the steps of a class; aligned so that its address is a shift.
#[derive(Clone, Copy, Default)]
#[repr(align(32))]
pub(super) struct Entry {
    pub triangles: u64,
    /// Weighted score.
    pub gain: f64,
    pub steps: u32,
}

impl Entry {
    #[inline(always)]
    pub fn add(&mut self, triangles: u64, gain: f64) {
        self.triangles += triangles;
        self.gain += gain;
        self.steps += 1;
    }
}

/// Sums over steps by class, and over objects at their coarsest level.
pub(super) struct Ledger {
    pub classes: Box<[Entry; CLASSES]>,
    /// Triangles, weighted score and weight of all objects before any step.
    pub first_triangles: u64,
    pub first_score: f64,
    pub weight: f64,
}

impl Default for Ledger {
    fn default() -> Self {
        Self { classes: Box::new([Entry::default(); CLASSES]), first_triangles: 0, first_score: 0.0, weight: 0.0 }
    }
}

impl Ledger {
    /// Adds another ledger; called in a fixed order, so that rounding does not depend on threads.
    pub fn add(&mut self, other: &Ledger) {
        for (own, other) in self.classes.iter_mut().zip(other.classes.iter()) {
            own.triangles += other.triangles;
            own.gain += other.gain;
            own.steps += other.steps;
        }
        self.first_triangles += other.first_triangles;
        self.first_score += other.first_score;
        self.weight += other.weight;
    }
}

/// Number of objects per task: fixed, so that sums are rounded the same for any number of threads.
const TASK: usize = 1 << 14;

/// Classes of all objects in view.
pub(super) struct Ratings {
    pub ledger: Ledger,
    pages: Vec<Page>,
}

/// Classes of the objects of a task.
struct Page {
    /// Objects in view.
    order: Order,
    /// Classes block by block, step by step.
    classes: Vec<Classes>,
}

impl Ratings {
    /// Rates all objects.
    pub fn new(rater: &Rater<'_>, progress: &Progress) -> Result<Self> {
        let count = rater.objects.radii.len();
        let rate = |task: usize| {
            progress.check()?;
            let order = rater.order((task * TASK) as u32..count.min((task + 1) * TASK) as u32);
            let steps = rater.blocks(&order).map(|(ladder, _)| ladder.steps()).sum();
            let (mut ledger, mut classes, mut scratch) =
                (Ledger::default(), Vec::with_capacity(steps), Scratch::default());
            for (ladder, objects) in rater.blocks(&order) {
                let block = rater.rate(ladder, objects, &mut scratch);
                enter(&block, &mut ledger);
                classes.extend_from_slice(block.classes);
            }
            Ok((ledger, Page { order, classes }))
        };
        let tasks: Vec<_> = (0..count.div_ceil(TASK)).into_par_iter().map(rate).collect::<Result<_>>()?;
        let mut ratings = Self { ledger: Ledger::default(), pages: Vec::with_capacity(tasks.len()) };
        for (ledger, page) in tasks {
            ratings.ledger.add(&ledger);
            ratings.pages.push(page);
        }
        Ok(ratings)
    }

    /// Returns the triangles of all objects at their coarsest selectable levels.
    pub fn least(&self) -> u64 {
        self.ledger.first_triangles + self.ledger.classes[usize::from(ALWAYS)].triangles
    }

    /// Returns the objects with steps in a range of classes.
    pub fn between(&self, rater: &Rater<'_>, lowest: u16, highest: u16) -> Vec<u32> {
        self.pick(rater, lowest, highest, |_, _, is_between| is_between)
    }

    /// Returns the objects with steps in a class, and those that even after all its steps are coarser than before.
    pub fn coarser_than_before(&self, rater: &Rater<'_>, class: u16, before: &[i32]) -> Vec<u32> {
        self.pick(rater, class, class, |object, level, is_between| {
            is_between || (0..level).contains(&before[object as usize])
        })
    }

    /// Selects objects by their level after all steps of class `lowest` and above, and by whether they have steps in
    /// the range.
    fn pick(
        &self,
        rater: &Rater<'_>,
        lowest: u16,
        highest: u16,
        is_picked: impl Fn(u32, i32, bool) -> bool + Sync,
    ) -> Vec<u32> {
        let pages = self.pages.par_iter().map(|page| {
            let mut objects = Vec::new();
            for (ladder, block, classes) in page.blocks(rater) {
                let (after, before) = (places(classes, lowest - 1), places(classes, highest));
                for (&object, (after, before)) in block.iter().zip(after.into_iter().zip(before)) {
                    if is_picked(object, ladder.level[usize::from(after)], after != before) {
                        objects.push(object);
                    }
                }
            }
            objects
        });
        pages.collect::<Vec<_>>().concat()
    }

    /// Writes the levels after all steps of higher classes, and counts the objects by the stage that decided.
    pub fn write(&self, rater: &Rater<'_>, price_class: u16, to: &mut [i32]) -> SelectionCounts {
        let tasks = self.pages.par_iter().zip(to.par_chunks_mut(TASK)).enumerate().map(|(task, (page, to))| {
            let mut counts = SelectionCounts::default();
            to.fill(HIDDEN as i32);
            counts.culled = (to.len() - page.order.objects.len()) as u64;
            for (ladder, block, classes) in page.blocks(rater) {
                let of_steps = if ladder.steps() == 0 { &mut counts.one_level } else { &mut counts.asked };
                *of_steps += block.len() as u64;
                for (&object, place) in block.iter().zip(places(classes, price_class)) {
                    to[object as usize - task * TASK] = ladder.level[usize::from(place)];
                }
            }
            counts
        });
        tasks.reduce(SelectionCounts::default, SelectionCounts::plus)
    }
}

impl Page {
    /// Returns the objects, their ladders and the classes of their steps, block by block.
    fn blocks<'p>(&'p self, rater: &Rater<'p>) -> impl Iterator<Item = (&'p Ladder, &'p [u32], &'p [Classes])> {
        let mut remaining = self.classes.as_slice();
        rater.blocks(&self.order).map(move |(ladder, block)| {
            let (classes, others) = remaining.split_at(ladder.steps());
            remaining = others;
            (ladder, block, classes)
        })
    }
}

/// Returns the ladder positions after all steps of higher classes.
fn places(classes: &[Classes], price_class: u16) -> Classes {
    let mut places = [0; LANES];
    for classes in classes {
        for n in 0..LANES {
            places[n] += u16::from(classes[n] <= price_class);
        }
    }
    places
}

/// Adds a block to the ledger: its coarsest levels and its steps.
fn enter(block: &RatedBlock<'_>, ledger: &mut Ledger) {
    let coarsest = block.ladder.steps();
    ledger.first_triangles += block.ladder.triangles[coarsest] * block.objects.len() as u64;
    for (&weight, &score) in block.weights.iter().zip(&block.scores[coarsest]).take(block.objects.len()) {
        ledger.first_score += weight * score;
        ledger.weight += weight;
    }
    for ((classes, gains), &added) in block.classes.iter().zip(block.gains).zip(&block.ladder.added) {
        for (&class, &gain) in classes.iter().zip(gains).take(block.objects.len()) {
            ledger.classes[usize::from(class) % CLASSES].add(added, gain);
        }
    }
}
