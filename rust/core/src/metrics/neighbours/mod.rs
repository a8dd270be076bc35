//! Measures that compare a pixel's neighbourhood in the picture and in the truth. With p₀(p) the position of a pixel's
//! scene point in the truth, and N_p the pixels q ≠ p with |p₀(q) − p₀(p)| < ε:
//!
//! - discontinuity, the mean over N_p of |p − q| / |p₀(p) − p₀(q)| − 1. Popescu, Lee, Choi, Fahmy (2022), Eq. 5–6;
//! - tear: RMS residual of the best affine map from N_p and p in the truth to the picture, in pixels.

mod discontinuity;
mod points;
mod tear;

pub use discontinuity::{Neighbourhood, discontinuity};
pub use tear::{Border, Tears, tear};
