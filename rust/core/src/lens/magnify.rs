//! Magnification of a lens around a direction, at the eye and on the panel.
//!
//! r = tan α / tan ω is the radius of a direction, r′ = f⁻¹(r) that of its pixel, and tan α′ = tan ω · r′.

use super::polynomial;
use super::radial::RadialLens;

/// Scale factor of lengths or areas for each direction of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Magnification {
    /// sin α′ / sin α: lengths around the axis. 1 beyond the lens's fold.
    Across,
    /// D(α) = (r′/r) (1/f′(r′)) / cos³ α: pixels of the panel, as a multiple of those on the axis. +∞ from the fold on.
    Panel,
}

impl RadialLens {
    /// Writes the magnification of directions, given by tan α ≥ 0. The number of directions is a multiple of `STRETCHED`. The
    /// inverse comes from the table, or by Newton's method if `exact`.
    pub fn magnify(&self, kind: Magnification, tan_omega: f64, exact: bool, tangents: &[f64], to: &mut [f64]) {
        for (to, tangent) in to.iter_mut().zip(tangents) {
            *to = tangent / tan_omega;
        }
        self.undistort_blocks(to, exact, 0.0);
        for (to, &tangent) in to.iter_mut().zip(tangents) {
            let (r, square) = (*to, *to * *to);
            let secant = 1.0 + tangent * tangent;
            // r / r′ and f′(r′) as sums of even powers, so that nothing is divided by 0 on the axis.
            let quotient = 1.0 + self.radial.k.iter().rev().fold(0.0, |sum, c| (sum + c) * square);
            *to = match kind {
                Magnification::Across if r.is_nan() => 1.0,
                Magnification::Across => (secant / (1.0 + tan_omega * tan_omega * square)).sqrt() / quotient,
                Magnification::Panel if r.is_nan() => f64::INFINITY,
                Magnification::Panel => {
                    secant * secant.sqrt() / (quotient * polynomial::value(&self.radial.slope, square))
                }
            };
        }
    }
}
