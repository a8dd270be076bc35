//! Levels of detail: `simplify` makes coarser surfaces, `fit` fits four-parameter curves to a level's quality as a
//! function of its size, `select` chooses each object's level by these curves.
//!
//! Liebisch: Level of Detail Selection for Foveated Rendering in Virtual Reality, TU Graz 2021. Curves: y = d +
//! (a−d)/(1+(x/c)^b).

mod budget;
mod elementary;
mod fit;
mod select;
mod simplify;

pub use budget::{Budget, BudgetRules, RatedModel, Spent, Weights, spend};
pub use fit::{LogisticCurve, Status, Unfit, fit_4pl};
pub use select::{
    Acuity, Apparent, COLUMNS, Eye, EyeLens, Frustum, Model, Objects, Parameters, Rules, SelectionCounts, SizeLimit,
    ThresholdLine, select,
};
pub use simplify::{Allowance, Charts, SurfacePlace, Vertices, collapse, first_alike, pieces};
