//! Least-squares curves with four parameters, y = d + (a−d)/(1+(x/c)^b). A grid of curves gives start points; descents
//! from the best of them find the minimum.

mod curve;
mod descend;
mod frame;
mod grid;
mod logistic;
#[cfg(test)]
mod tests;

pub use curve::{LogisticCurve, Status, fit_4pl};
pub use frame::Unfit;
