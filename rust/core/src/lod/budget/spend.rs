//! The price of a triangle at which a budget is spent, and the levels at that price.

use std::ops::RangeInclusive;

use rayon::prelude::*;

use super::super::select::{Apparent, COLUMNS, Eye, EyeSizes, HIDDEN, Objects, SelectionCounts, ThresholdLine};
use super::fill::{Step, fill};
use super::hull::Choice;
use super::prices::{ALWAYS, CLASSES, Ledger, NEVER, class};
use super::rated::{Ladder, RatedModel};
use super::rater::{RatedBlock, Rater};
use super::sizes::{Kept, SeenObjects, SizesOf, Weights};
use crate::base::{Error, Progress, Result};

/// Number of objects in one task: fixed, so that sums are rounded the same for any number of threads.
const TASK: usize = 1 << 14;
/// Steps below the price that are tried in the order of their slopes, so that little of the budget is left.
const MOST_TRIED: u32 = 1 << 14;

/// How much may be drawn, and what counts.
#[derive(Clone, Copy, Debug)]
pub struct Budget<'a> {
    /// Triangles of all objects in view.
    pub triangles: u64,
    /// Weights of the objects.
    pub weights: Weights<'a>,
    /// Objects have at least f(σ) − floor where the budget allows it.
    pub floor: Option<f64>,
    /// The price of the frame before. It is kept where it spends at least 1 − hysteresis of the budget and no more.
    pub price: Option<f64>,
}

/// How sizes are seen.
#[derive(Clone, Copy, Debug)]
pub struct BudgetRules<'a> {
    /// SSIM threshold f(σ), for the floor.
    pub line: ThresholdLine,
    /// How the size that is seen follows from σ.
    pub apparent: Apparent<'a>,
    /// Whether objects outside the view get no level.
    pub cull: bool,
    /// Share by which the score for a triangle must be better elsewhere for an object to lose its level.
    pub hysteresis: f64,
}

/// How a budget was spent.
#[derive(Clone, Copy, Debug)]
pub struct Spent {
    /// Weighted score that the last triangle adds; 0 if all that gains anything is drawn.
    pub price: f64,
    /// Triangles of the levels.
    pub triangles: u64,
    /// Mean score of the objects in view by their weights; NaN without any.
    pub score: f64,
    /// Number of objects by the stage that decided their level.
    pub counts: SelectionCounts,
}

/// Writes the level of each object, −1 outside the view, and the numbers of COLUMNS if requested.
#[expect(clippy::too_many_arguments, reason = "what a selection weighs, and where it goes")]
pub fn spend(
    models: &[RatedModel<'_>],
    objects: &Objects<'_>,
    eyes: &[Eye],
    rules: &BudgetRules<'_>,
    budget: &Budget<'_>,
    to: &mut [i32],
    columns: Option<[&mut [f64]; COLUMNS]>,
    progress: &Progress,
) -> Result<Spent> {
    let ladders = models.iter().enumerate().map(|(n, rated)| Ladder::new(rated, n)).collect::<Result<Vec<_>>>()?;
    let plain: Vec<_> = models.iter().map(|rated| rated.model).collect();
    let sizes = EyeSizes::new(&plain, eyes, rules.apparent);
    budget.weights.check()?;
    let is_full = columns.is_some();
    let kept = Kept {
        sizes: is_full,
        pixels: matches!(budget.weights, Weights::Pixels),
        thresholds: is_full || budget.floor.is_some(),
    };
    let of = SizesOf { models: &plain, objects, eyes: &sizes, cull: rules.cull, line: rules.line };
    let seen = SeenObjects::new(&of, kept, progress)?;
    let weights = match budget.weights {
        Weights::Pixels => Weights::Each(&seen.pixels),
        other => other,
    };
    let mut rater = Rater::new(&ladders, objects, &seen, weights, rules.hysteresis, budget.floor);
    let stride = ladders.iter().map(Ladder::steps).max().unwrap_or(0).max(1);
    let mut classes = vec![NEVER; to.len() * stride];
    if budget.floor.is_some() {
        rater.choice = Choice::FromFloor;
        let floors = ledger(&rater, stride, &mut classes, progress)?;
        rater.choice = if floors.first_triangles <= budget.triangles { Choice::FromFloor } else { Choice::ToFloor };
    }
    let ledger = ledger(&rater, stride, &mut classes, progress)?;
    let least = ledger.first_triangles;
    if least > budget.triangles {
        let expected = format!("at least {least} triangles, those of the coarsest levels in view");
        return Err(Error::value("budget", expected, budget.triangles));
    }
    let plan = Plan { rater: &rater, ledger: &ledger, classes: &classes, stride };
    let kept = budget.price.and_then(|price| plan.keep(price, budget.triangles, rules.hysteresis));
    let Bought { price, above, triangles, score, levels } = kept.unwrap_or_else(|| plan.buy(budget.triangles));
    plan.write(above, &levels, to);
    let mut counts = SelectionCounts::default();
    for (&level, &model) in to.iter().zip(objects.model) {
        let one = ladders[model as usize].steps() == 0;
        let class = if level < 0 {
            &mut counts.culled
        } else if one {
            &mut counts.one_level
        } else {
            &mut counts.asked
        };
        *class += 1;
    }
    counts.lens = if sizes.is_bent() { counts.asked } else { 0 };
    counts.formula = counts.asked;
    if let Some(columns) = columns {
        seen.columns(&plain, objects, to, columns);
    }
    Ok(Spent { price, triangles, score: score / ledger.weight, counts })
}

/// Rates all objects: writes the class of each step, and sums them up.
fn ledger(rater: &Rater<'_>, stride: usize, classes: &mut [u16], progress: &Progress) -> Result<Ledger> {
    let tasks: Vec<_> = classes
        .par_chunks_mut(TASK * stride)
        .enumerate()
        .map(|(number, classes)| {
            progress.check()?;
            let first = number * TASK;
            let count = classes.len() / stride;
            classes.fill(NEVER);
            let mut ledger = Ledger::default();
            rater.each(first as u32..(first + count) as u32, |block| enter(block, first, stride, classes, &mut ledger));
            Ok(ledger)
        })
        .collect::<Result<_>>()?;
    let mut sum = Ledger::default();
    tasks.iter().for_each(|task| sum.add(task));
    Ok(sum)
}

/// Enters the steps of a block; `origin` is the first object of the classes.
fn enter(block: &RatedBlock<'_>, origin: usize, stride: usize, classes: &mut [u16], ledger: &mut Ledger) {
    for (lane, &first) in block.first[..block.objects.len()].iter().enumerate() {
        ledger.first_triangles = ledger.first_triangles.saturating_add(block.ladder.triangles[first]);
        ledger.first_score += block.weights[lane] * block.scores[first][lane];
        ledger.weight += block.weights[lane];
    }
    for (step, (of_step, &added)) in block.classes.iter().zip(&block.ladder.added).enumerate() {
        let gains = block.gains(step);
        for (lane, &object) in block.objects.iter().enumerate() {
            let is_had = step >= block.first[lane];
            classes[(object as usize - origin) * stride + step] = if is_had { ALWAYS } else { of_step[lane] };
            if !is_had {
                let entry = &mut ledger.classes[usize::from(of_step[lane]) % CLASSES];
                entry.triangles = entry.triangles.saturating_add(added);
                entry.gain += gains[lane];
                entry.steps += 1;
            }
        }
    }
}

/// Adds the edges of an object's hull whose classes are in a range.
fn edges(block: &RatedBlock<'_>, lane: usize, classes: RangeInclusive<u16>, to: &mut Vec<Step>) {
    let mut before = f64::NAN;
    for step in (0..block.first[lane]).rev().filter(|&step| classes.contains(&block.classes[step][lane])) {
        let slope = block.slopes[step][lane];
        if slope != before {
            to.push(Step { slope, object: block.objects[lane], to: 0, triangles: 0, gain: 0.0 });
        }
        before = slope;
        if let Some(last) = to.last_mut() {
            last.to = step as u16;
            last.triangles += block.ladder.added[step];
            last.gain += block.gains(step)[lane];
        }
    }
}

/// The levels that a price buys: all steps of classes above one, and some levels beside.
struct Bought {
    price: f64,
    above: u16,
    triangles: u64,
    score: f64,
    /// Objects whose levels differ from what the classes above say, and places on their ladders.
    levels: Vec<(u32, u16)>,
}

struct Plan<'a> {
    rater: &'a Rater<'a>,
    ledger: &'a Ledger,
    classes: &'a [u16],
    stride: usize,
}

impl Plan<'_> {
    /// Triangles and score of all steps of classes above one.
    fn above(&self, class: u16) -> (u64, f64) {
        let (mut triangles, mut score) = (self.ledger.first_triangles, self.ledger.first_score);
        for entry in self.ledger.classes[usize::from(class) + 1..].iter().rev() {
            triangles = triangles.saturating_add(entry.triangles);
            score += entry.gain;
        }
        (triangles, score)
    }

    /// The steps of some classes, in the order in which they are tried.
    fn steps(&self, least: u16, most: u16) -> Vec<Step> {
        let count = self.classes.len() / self.stride;
        let is_theirs = |&object: &u32| {
            let own = &self.classes[object as usize * self.stride..][..self.stride];
            own.iter().any(|class| (least..=most).contains(class))
        };
        let objects: Vec<u32> = (0..count as u32).into_par_iter().filter(is_theirs).collect();
        let mut steps = Vec::new();
        self.rater.each(objects, |block| {
            for lane in 0..block.objects.len() {
                edges(block, lane, least..=most, &mut steps);
            }
        });
        steps.sort_by(|a, b| b.slope.total_cmp(&a.slope).then(a.object.cmp(&b.object)).then(b.to.cmp(&a.to)));
        steps
    }

    /// Buy what a price of the frame before buys, if that is within the budget and most of it.
    fn keep(&self, price: f64, budget: u64, hysteresis: f64) -> Option<Bought> {
        let scaled = price * self.rater.scale;
        let own = class(scaled);
        let (mut triangles, mut score) = self.above(own);
        if triangles > budget {
            return None;
        }
        let mut levels = Vec::new();
        if own != NEVER {
            for step in self.steps(own, own).into_iter().take_while(|step| step.slope > scaled) {
                triangles = triangles.saturating_add(step.triangles);
                score += step.gain;
                levels.push((step.object, step.to));
            }
        }
        let is_enough = triangles as f64 >= (1.0 - hysteresis) * budget as f64 || own == NEVER;
        (triangles <= budget && is_enough).then_some(Bought { price, above: own, triangles, score, levels })
    }

    /// Spend the budget.
    fn buy(&self, budget: u64) -> Bought {
        let (mut triangles, mut score) = (self.ledger.first_triangles, self.ledger.first_score);
        let mut most = ALWAYS;
        let entry = |class: u16| &self.ledger.classes[usize::from(class)];
        while most > NEVER && triangles.saturating_add(entry(most).triangles) <= budget {
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

    fn write(&self, above: u16, levels: &[(u32, u16)], to: &mut [i32]) {
        let rater = self.rater;
        to.par_iter_mut().zip(self.classes.par_chunks(self.stride)).enumerate().for_each(|(n, (to, classes))| {
            let ladder = &rater.ladders[rater.objects.model[n] as usize];
            let place = classes[..ladder.steps()].iter().filter(|class| **class <= above).count();
            *to = if rater.seen.read[n] < 0.0 { HIDDEN as i32 } else { ladder.level[place] };
        });
        for &(object, place) in levels {
            let ladder = &rater.ladders[rater.objects.model[object as usize] as usize];
            to[object as usize] = ladder.level[usize::from(place)];
        }
    }
}
