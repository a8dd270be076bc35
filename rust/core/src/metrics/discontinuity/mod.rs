//! Discontinuity: distance between pixels that are neighbours in the true picture.
//! Popescu, Lee, Choi, Fahmy (2022), Eq. 5–6:
//! with p₀ the place of a pixel's scene point in the truth, and N_p the pixels q ≠ p with |p₀(q) − p₀(p)| < ε,
//! δ(p) = mean over N_p of |p − q| / |p₀(p) − p₀(q)| − 1.

mod map;
mod neighbourhood;
mod pairs;
mod points;

pub use map::discontinuity;
pub use neighbourhood::Neighbourhood;
