//! Classes of the steps of all objects, and the sums of each class.

use rayon::prelude::*;

use super::super::select::{HIDDEN, SelectionCounts};
use super::hull::{Classes, LANES, Ladder};
use super::prices::{ALWAYS, CLASSES, Ledger};
use super::rater::{Order, RatedBlock, Rater, Scratch};
use crate::base::memory::{room_for, room_for_values};
use crate::base::{Progress, Result};

/// Number of objects per task: fixed, so that the rounding of sums does not depend on the number of threads.
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
        room_for((count * (size_of::<u32>() + size_of::<u16>() * rater.most_steps())) as u64)?;
        let rate = |task: usize| {
            progress.check()?;
            let order = rater.order((task * TASK) as u32..count.min((task + 1) * TASK) as u32);
            let steps = rater.blocks(&order).map(|(ladder, _)| ladder.steps()).sum();
            let (mut ledger, mut classes, mut scratch) =
                (Ledger::default(), Vec::with_capacity(steps), Scratch::default());
            for (ladder, objects) in rater.blocks(&order) {
                let block = rater.rate(ladder, objects, &mut scratch);
                add_block(&block, &mut ledger);
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

    /// Returns the triangles of all objects at their coarsest selectable levels, after the steps of class `ALWAYS`.
    pub fn min_triangles(&self) -> u64 {
        self.ledger.first_triangles + self.ledger.classes[usize::from(ALWAYS)].triangles
    }

    /// Returns the objects with steps in a range of classes.
    pub fn objects_between(&self, rater: &Rater<'_>, lowest: u16, highest: u16) -> Result<Vec<u32>> {
        self.select(rater, lowest, highest, |_, _, has_steps| has_steps)
    }

    /// Returns the objects with steps in a class, or coarser than in the previous frame even after all these steps.
    pub fn coarser_than_previous(&self, rater: &Rater<'_>, class: u16, previous: &[i32]) -> Result<Vec<u32>> {
        self.select(rater, class, class, |object, level, has_steps| {
            has_steps || (0..level).contains(&previous[object as usize])
        })
    }

    /// Selects objects by their level after all steps of classes from `lowest` up, and by whether the range has steps.
    fn select(
        &self,
        rater: &Rater<'_>,
        lowest: u16,
        highest: u16,
        condition: impl Fn(u32, i32, bool) -> bool + Sync,
    ) -> Result<Vec<u32>> {
        // Lists of the pages, with capacities of up to twice their lengths, and the list of all objects.
        room_for_values::<[u32; 3]>(self.pages.iter().map(|page| page.order.objects.len()).sum())?;
        let pages = self.pages.par_iter().map(|page| {
            let mut objects = Vec::new();
            for (ladder, block, classes) in page.blocks(rater) {
                let (after, before) = (ladder_positions(classes, lowest - 1), ladder_positions(classes, highest));
                for (&object, (after, before)) in block.iter().zip(after.into_iter().zip(before)) {
                    if condition(object, ladder.level[usize::from(after)], after != before) {
                        objects.push(object);
                    }
                }
            }
            objects
        });
        Ok(pages.collect::<Vec<_>>().concat())
    }

    /// Writes the levels after all steps of classes above `price_class`; counts objects as `Plan::write` does.
    pub fn write(&self, rater: &Rater<'_>, price_class: u16, to: &mut [i32]) -> SelectionCounts {
        let tasks = self.pages.par_iter().zip(to.par_chunks_mut(TASK)).enumerate().map(|(task, (page, to))| {
            let mut counts = SelectionCounts::default();
            to.fill(HIDDEN as i32);
            counts.culled = (to.len() - page.order.objects.len()) as u64;
            for (ladder, block, classes) in page.blocks(rater) {
                let count = if ladder.steps() == 0 { &mut counts.one_level } else { &mut counts.asked };
                *count += block.len() as u64;
                for (&object, position) in block.iter().zip(ladder_positions(classes, price_class)) {
                    to[object as usize - task * TASK] = ladder.level[usize::from(position)];
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

/// Returns the ladder positions after all steps of classes above `price_class`.
fn ladder_positions(classes: &[Classes], price_class: u16) -> Classes {
    let mut positions = [0; LANES];
    for classes in classes {
        for n in 0..LANES {
            positions[n] += u16::from(classes[n] <= price_class);
        }
    }
    positions
}

/// Adds a block's coarsest levels and steps to the ledger.
fn add_block(block: &RatedBlock<'_>, ledger: &mut Ledger) {
    let coarsest = block.ladder.steps();
    let draws = &block.draws[..block.objects.len()];
    ledger.first_triangles += block.ladder.triangles[coarsest] * draws.iter().sum::<u64>();
    for (&weight, &score) in block.weights.iter().zip(&block.scores[coarsest]).take(block.objects.len()) {
        ledger.first_score += weight * score;
        ledger.weight += weight;
    }
    for ((classes, gains), &added) in block.classes.iter().zip(block.gains).zip(&block.ladder.added) {
        for ((&class, &gain), &draws) in classes.iter().zip(gains).zip(draws) {
            ledger.classes[usize::from(class) % CLASSES].add(added * draws, gain);
        }
    }
}
