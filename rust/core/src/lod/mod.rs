//! Levels of detail (Liebisch: Level of Detail Selection for Foveated Rendering in Virtual Reality, TU Graz 2021).
//! `simplify` makes coarser surfaces. `fit` fits curves y = d + (a−d)/(1+(x/c)^b) to a level's quality y by its size x.
//! With them, `select` chooses each object's coarsest sufficient level, `budget` the levels under a triangle budget.

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
pub use simplify::{Allowance, ConnectedSurface, SurfacePlace, Vertices, collapse, first_alike, pieces};
