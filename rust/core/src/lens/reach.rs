//! Disc in which the lens map is injective.

use super::polynomial;
use super::solve::Radial;

/// Returns the radius of a disc in which the lens map is provably injective.
///
/// A map of a convex set is injective where the symmetric part of its Jacobian is positive definite. Here the radial
/// part has the eigenvalues f(r)/r and f′(r), and the eigenvalues of the tangential part, 4 (p₁y + p₂x) ± 2|p|r, are
/// never below −6|p|r.
pub(super) fn reach(radial: &Radial, tangential: [f64; 2]) -> f64 {
    let p = tangential[0].hypot(tangential[1]);
    if p == 0.0 {
        return radial.r_max;
    }
    let less = |of_square: &[f64]| {
        let mut in_r = vec![0.0; (2 * of_square.len()).max(2)];
        for (n, c) in of_square.iter().enumerate() {
            in_r[2 * n] = *c;
        }
        in_r[1] = -6.0 * p;
        polynomial::first_zero(&in_r).unwrap_or(f64::INFINITY)
    };
    let mut factor = vec![1.0];
    factor.extend(&radial.k);
    less(&factor).min(less(&radial.slope))
}
