//! A lens: its distortion polynomial, its fold, and the table of its inverse.

use std::sync::OnceLock;

use super::polynomial;
use super::solve::{FARTHEST, Radial};
use super::table::Table;
use crate::base::error::number;
use crate::base::{Result, ensure};

/// Maximum number of coefficients of a lens.
const MAX_COEFFICIENTS: usize = 64;
/// Accepted range of `Radial::unit`. Powers of these radii neither overflow nor underflow.
const UNIT_RADII: std::ops::Range<f64> = 1e-30..1e30;

/// Magnification of a lens around a direction. r = tan α / tan ω is the radius of the direction, r′ = f⁻¹(r) the radius
/// of its pixel, and tan α′ = tan ω · r′.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Magnification {
    /// sin α′ / sin α: magnification of lengths on a circle around the axis. 1 beyond the lens's fold.
    Across,
    /// D(α) = (r′/r) (1/f′(r′)) / cos³ α: panel pixels per solid angle, relative to the axis. +∞ from the fold on.
    Panel,
}

/// A lens with radial and tangential distortion.
#[derive(Clone, Debug)]
pub struct RadialLens {
    pub(super) radial: Radial,
    pub(super) tangential: [f64; 2],
    /// Radius of a disc in which the lens map is injective: r_max, or less with tangential terms.
    pub reach: f64,
    table: OnceLock<Table>,
}

impl RadialLens {
    /// Creates a lens from k₁, k₂, … and p₁, p₂ of Brown's model (0 for a centred lens).
    pub fn new(k: &[f64], tangential: [f64; 2]) -> Result<Self> {
        for &c in k {
            let is_valid = c.abs() <= FARTHEST;
            ensure!(is_valid, "k", format!("coefficients of at most {}", number(FARTHEST)), number(c));
        }
        ensure!(k.len() <= MAX_COEFFICIENTS, "k", format!("at most {MAX_COEFFICIENTS} coefficients"), k.len());
        let are_finite = tangential.iter().all(|p| p.is_finite());
        ensure!(are_finite, "tangential", "two finite numbers", format!("{tangential:?}"));
        let radial = Radial::new(k);
        let is_valid = radial.unit.is_infinite() || UNIT_RADII.contains(&radial.unit);
        let expected = format!("terms that reach r at radii from {:e} to {:e}", UNIT_RADII.start, UNIT_RADII.end);
        ensure!(is_valid, "k", expected, format!("{:e}", radial.unit));
        let reach = reach(&radial, tangential);
        Ok(Self { radial, tangential, reach, table: OnceLock::new() })
    }

    /// Returns the radius at which f folds (f′ = 0); +∞ if f never folds.
    pub fn r_max(&self) -> f64 {
        self.radial.r_max
    }

    /// Returns f(r) for 0 ≤ r ≤ r_max.
    pub fn distort(&self, r: f64) -> f64 {
        self.radial.distort(r)
    }

    /// Returns f(r_max), or the limit of the search if that is smaller.
    pub fn x_max(&self) -> f64 {
        self.radial.x_max
    }

    /// Returns the r ≥ 0 with f(r) = x; NaN beyond f(r_max).
    pub fn undistort(&self, x: f64) -> f64 {
        if x <= self.radial.x_max { self.radial.undistort(x) } else { f64::NAN }
    }

    /// Returns the maximum relative error of `InverseMethod::Table`, and the x at which the table ends. Beyond that x,
    /// Newton's method computes the inverse.
    pub fn table_bound(&self) -> (f64, f64) {
        self.table().map_or((0.0, f64::INFINITY), |table| (table.bound, table.end))
    }

    /// Writes the magnification of directions, given by tan α ≥ 0; their number is a multiple of `SPHERES_PER_BLOCK`.
    /// f⁻¹ comes from the table, or by Newton's method if `exact`.
    pub fn magnify(&self, kind: Magnification, tan_omega: f64, exact: bool, tangents: &[f64], to: &mut [f64]) {
        for (to, tangent) in to.iter_mut().zip(tangents) {
            *to = tangent / tan_omega;
        }
        self.undistort_blocks(to, exact, 0.0);
        for (to, &tangent) in to.iter_mut().zip(tangents) {
            let (r, square) = (*to, *to * *to);
            let secant = 1.0 + tangent * tangent;
            // r / r′ is computed as a sum of even powers, because on the axis it is 0 / 0.
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

    /// Returns the table, created on first use; `None` for a lens without coefficients.
    pub(super) fn table(&self) -> Option<&Table> {
        (!self.radial.k.is_empty()).then(|| self.table.get_or_init(|| Table::new(&self.radial)))
    }
}

/// Returns the radius of a disc in which the lens map is provably injective.
///
/// A map of a convex set is injective if the symmetric part of its Jacobian is positive definite. The radial part of
/// this Jacobian has the eigenvalues f(r)/r and f′(r). Its tangential part has the eigenvalues
/// 4 (p₁y + p₂x) ± 2|p|r, which are at least −6|p|r.
fn reach(radial: &Radial, tangential: [f64; 2]) -> f64 {
    let p = tangential[0].hypot(tangential[1]);
    if p == 0.0 {
        return radial.r_max;
    }
    // Returns the first zero r of a polynomial in r², minus 6|p|r.
    let first_zero = |even_coefficients: &[f64]| {
        let mut coefficients: Vec<f64> = even_coefficients.iter().flat_map(|&c| [c, 0.0]).collect();
        coefficients[1] = -6.0 * p;
        polynomial::first_zero(&coefficients).unwrap_or(f64::INFINITY)
    };
    first_zero(&radial.factor()).min(first_zero(&radial.slope))
}
