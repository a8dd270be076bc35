//! Selection under a budget: input, result and the order of its stages.

use super::super::select::{Apparent, COLUMNS, Eye, EyeSizes, Objects, SelectionCounts, ThresholdLine};
use super::hull::{Choice, Ladder, RatedModel};
use super::plan::{Plan, Purchase};
use super::rater::Rater;
use super::ratings::Ratings;
use super::sizes::{Budget, ObjectSizes, SizeInput, Weights};
use crate::base::{Progress, Result, ensure};

/// Rules for sizes and visibility.
#[derive(Clone, Copy, Debug)]
pub struct BudgetRules<'a> {
    /// SSIM threshold f(σ), which `Budget::floor` refers to.
    pub line: ThresholdLine,
    /// Relation between σ and the displayed size.
    pub apparent: Apparent<'a>,
    /// Whether objects outside the view get no level.
    pub cull: bool,
    /// An object loses its level only to steps with a score per triangle that is higher by this fraction.
    pub hysteresis: f64,
}

/// Result of a budgeted selection.
#[derive(Clone, Copy, Debug)]
pub struct Spent {
    /// Weighted score per drawn triangle of the first step that does not fit; 0 if every step with a gain fits.
    pub price: f64,
    /// Triangles of the levels, each object counted once.
    pub triangles: u64,
    /// Triangles of the levels, each object counted as often as it is drawn.
    pub drawn: u64,
    /// Weighted mean score of the objects in view; NaN if there are none.
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
    // So no sum overflows.
    let max_triangles = ladders.iter().map(|ladder| ladder.triangles[0]).max().unwrap_or(0);
    let max_draws = budget.draws.map_or(1, |_| u64::from(u8::MAX));
    let is_countable = max_triangles.checked_mul(to.len() as u64).and_then(|all| all.checked_mul(max_draws)).is_some();
    let expected = format!("fewer than 2^64 triangles in {} objects", to.len());
    ensure!(is_countable, "models", expected, format!("up to {max_triangles} in each"));
    let curves: Vec<_> = models.iter().map(|rated| rated.model).collect();
    let sizes = EyeSizes::new(&curves, eyes, rules.apparent);
    budget.weights.check()?;
    let (has_columns, has_pixels) = (columns.is_some(), matches!(budget.weights, Weights::Pixels));
    let requested = [has_columns, has_columns, has_pixels, has_columns || budget.floor.is_some()];
    let input = SizeInput { models: &curves, objects, eyes: &sizes, cull: rules.cull, line: rules.line };
    let object_sizes = ObjectSizes::new(&input, requested, progress)?;
    let weights = match budget.weights {
        Weights::Pixels => Weights::Each(&object_sizes.pixels),
        other => other,
    };
    let mut rater = Rater::new(&ladders, objects, &object_sizes, weights, budget, rules.hysteresis);
    if budget.floor.is_some() {
        rater.choice = Choice::FromFloor;
        let floors = Ratings::new(&rater, progress)?;
        rater.choice = if floors.min_triangles() <= budget.triangles { Choice::FromFloor } else { Choice::ToFloor };
    }
    let ratings = Ratings::new(&rater, progress)?;
    let least = ratings.min_triangles();
    let draws = if budget.draws.is_some() { ", counting each draw" } else { "" };
    let expected = format!("at least {least} triangles, those of the coarsest levels in view{draws}");
    ensure!(least <= budget.triangles, "budget", expected, budget.triangles);
    let plan = Plan { rater: &rater, ratings: &ratings };
    let bought =
        budget.price.map(|price| plan.buy_at_price(price, budget.triangles, rules.hysteresis)).transpose()?.flatten();
    let Purchase { price, price_class, triangles: drawn, score, levels } = match bought {
        Some(bought) => bought,
        None => plan.buy(budget.triangles)?,
    };
    let mut counts = plan.write(price_class, &levels, to);
    counts.lens = if sizes.changes_sizes() { counts.asked } else { 0 };
    counts.formula = counts.asked;
    let triangles = if budget.draws.is_some() { triangles_of(models, objects, to) } else { drawn };
    if let Some(columns) = columns {
        object_sizes.columns(models, objects, to, columns);
    }
    Ok(Spent { price, triangles, drawn, score: score / ratings.ledger.weight, counts })
}

/// Returns the triangles of all objects' levels, each object counted once.
fn triangles_of(models: &[RatedModel<'_>], objects: &Objects<'_>, levels: &[i32]) -> u64 {
    let triangles =
        |(&level, &model): (&i32, &i64)| usize::try_from(level).map_or(0, |n| models[model as usize].triangles[n]);
    levels.iter().zip(objects.model).map(|each| triangles(each) as u64).sum()
}
