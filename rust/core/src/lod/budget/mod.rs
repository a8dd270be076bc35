//! Levels under a budget of triangles: the greatest Σ w·M(size) with Σ triangles ≤ budget.
//!
//! Of each object only the upper hull of its levels (triangles, w·M) counts. At a price λ it takes the finest level of
//! the hull to which a triangle adds at least λ. Stages, in order: sizes of what is in view, slopes of the hulls and a
//! histogram of them, the price, levels.

mod fill;
mod hull;
mod plan;
mod prices;
mod rated;
mod rater;
mod ratings;
mod sizes;
mod spend;
#[cfg(test)]
mod tests;

pub use rated::RatedModel;
pub use sizes::Weights;
pub use spend::{Budget, BudgetRules, Spent, spend};
