//! Levels under a triangle budget: maximises Σ w·M(size) subject to Σ draws·triangles ≤ budget.
//!
//! For each object only the upper hull of its levels (triangles, w·M) counts. At a price λ it takes the finest level
//! of the hull at which each drawn triangle adds at least λ. Stages, in order: sizes of objects in view, slopes of the
//! hulls and their histogram, the price, levels.

mod hull;
mod plan;
mod prices;
mod rater;
mod ratings;
mod sizes;
mod spend;
#[cfg(test)]
mod tests;

pub use hull::RatedModel;
pub use sizes::{Budget, Weights};
pub use spend::{BudgetRules, Spent, spend};
