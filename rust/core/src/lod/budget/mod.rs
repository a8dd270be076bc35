//! Levels under a triangle budget: maximises Σ w·M(size), weights times scores, subject to Σ draws·triangles ≤ budget.
//!
//! Each object uses only the levels on the upper hull of its points (triangles, w·M). At a price λ per triangle it
//! takes the finest level of the hull for which each additional triangle adds at least λ. Stages, in order: sizes of
//! the objects in view, slopes of the hulls and their histogram, the price, the levels.

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
