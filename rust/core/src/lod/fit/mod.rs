//! Curves of least squares with four parameters, y = d + (a−d)/(1+(x/c)^b): starts from a grid, the best ones descended
//! from.

mod curve;
mod descend;
mod frame;
mod grid;
mod logistic;
mod rows;
mod steps;
#[cfg(test)]
mod tests;

pub use curve::{LogisticCurve, Status};
pub use frame::Unfit;
pub use rows::fit_4pl;
