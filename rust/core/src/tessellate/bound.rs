//! Upper bound of the error of a triangle's interpolated morph, for every user within a distance R of the centre.
//!
//! With A = |P−U|, B = |P−O|, v = U−O, |v| ≤ R, d_U and d_O the directions in which U and O see P, u = d_O − d_U,
//! κ = w(1−w), n² = 1 − κ|u|²:
//!
//! ```text
//! Q − U = (P−O) − w v + κ(A−B) u + τ d,   τ = (wA + (1−w)B) κ|u|²/(1+n)
//! ```
//!
//! P−O is linear, so only w v, κ(A−B) u and τ d have interpolation errors, and errors along the displayed direction d
//! are not visible. Let bᵢ be barycentric weights and H a quadratic form that bounds the length of the second
//! derivative across d. Then the error is at most ½ Σ bᵢ H[Pᵢ−P] = ½ Σ bᵢbⱼ H[Pᵢ−Pⱼ] ≤ max H[edge]/6. H has three
//! parts:
//!
//! - w v: w″ = −c²/(ρ(r₂−r₁)), where c is the edge's component across the radius; along the radius w is linear.
//! - κ(A−B) u: (A−B)² + AB|u|² = |v|² and (A−B)′ = −u. The first three derivatives of X/|X| are at most 1, 2/√3 and 3,
//!   divided by |X|, |X|², |X|³ (a symmetric form is largest on its diagonal). So with D ≤ A, B: |(A−B)u| ≤ R²/2D,
//!   |((A−B)u)′| ≤ 4/3 (R/D)², |((A−B)u)″| ≤ √21 R²/D³.
//! - τ d: across d only 2 τ′d′ + τ d″ remain, which are smaller by R/D.
//!
//! With D = ρ − R, dividing an error by D (1 − (R/D)²/8) bounds its angle for every user. The first part is the angle
//! between the user's and the centre's view, at most RB/(B²−R²).

/// Quadratic form of edges. Its value divided by 6 is the maximum error of a triangle, in radians as a user sees it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Form {
    /// Factor of the squared length across the radius.
    pub across: f64,
    /// Factor of the squared length along the radius.
    pub along: f64,
    /// Factor of the squared length.
    pub any: f64,
}

/// Minimum D/ρ for which the form is a bound: below it, terms that were assumed to be small are not.
pub(super) const MIN_CLEARANCE: f64 = 0.4;
/// Maximum second derivative of X/|X|, multiplied by |X|²: 2/√3.
const SECOND_DERIVATIVE: f64 = 1.154_700_538_379_251_7;
/// Factor for w outside 0..1 by up to a hundredth, where a triangle crosses a radius within the tolerance.
const BLEND_OVERSHOOT: f64 = 1.02;
/// Weight s in c ℓ ≤ (s c² + ℓ²/s)/2, where c is an edge's component along the radius and ℓ its length. A larger s
/// reduces the second term, which also counts for vertical edges.
const RADIAL_WEIGHT: f64 = 1.5;

/// Region for which a bound holds.
#[derive(Clone, Copy, Debug)]
pub(super) struct RadialZone {
    /// R, the maximum |U−O|, metres.
    pub reach: f64,
    /// r₂ − r₁, metres.
    pub width: f64,
}

impl RadialZone {
    /// Returns whether the form is a bound from a distance ρ on.
    pub fn holds(&self, rho: f64) -> bool {
        self.clearance(rho) > MIN_CLEARANCE * rho
    }

    fn clearance(&self, rho: f64) -> f64 {
        rho - self.reach
    }

    /// Returns D, R/D and the divisor of errors. If there is no bound, D is increased to the minimum with one.
    fn distances(&self, rho: f64) -> (f64, f64, f64) {
        let nearest = self.clearance(rho).max(MIN_CLEARANCE * rho);
        let ratio = self.reach.min(rho) / nearest;
        (nearest, ratio, nearest * (1.0 - ratio.min(2.0).powi(2) / 8.0))
    }

    /// Returns the maximum rotation of the picture, in radians, while w changes from 1 to 0.
    fn turn(&self, rho: f64) -> f64 {
        let (nearest, ratio, _) = self.distances(rho);
        let reach = ratio * nearest;
        reach * rho / (nearest * (rho + reach)) / (1.0 - ratio.min(2.0).powi(2) / 8.0)
    }

    /// Returns the maximum error, in radians, per metre by which a point lies on the wrong side of a radius.
    pub fn slope(&self, rho: f64) -> f64 {
        let (nearest, ratio, divisor) = self.distances(rho);
        BLEND_OVERSHOOT * (self.turn(rho) + ratio * ratio * nearest / (2.0 * divisor)) / self.width
    }

    /// Returns the form for triangles whose points have at least distance ρ from the axis. `spread` is the sine of the
    /// angle between the radii of any two of their points.
    pub fn form(&self, rho: f64, spread: f64) -> Form {
        let (d, q, divisor) = self.distances(rho);
        let width = self.width;
        let mut across = self.turn(rho) / (width * rho) / (1.0 - spread * spread / 4.0);
        // κ(A−B)u by the product rule.
        let bent = q * q * d / 2.0;
        across += BLEND_OVERSHOOT * bent / (rho * width) / divisor;
        let mut along = 2.0 * bent / (width * width) / divisor;
        let mut mixed = BLEND_OVERSHOOT * 2.0 * (4.0 / 3.0) * q * q / width / divisor;
        let mut any = 21.0_f64.sqrt() / 4.0 * q * q / d / divisor;
        // τ d. Pairs are derivatives per metre: in any direction, and in addition along the radius.
        let min_n = (1.0 - (q * q / 4.0).min(0.75)).sqrt();
        let tau = q * q * d / 4.0 / (1.0 + min_n);
        let n = (SECOND_DERIVATIVE * q * q / (4.0 * d * min_n), BLEND_OVERSHOOT * q * q / (2.0 * width * min_n));
        let tau_change = (
            (q * q / 4.0 + SECOND_DERIVATIVE / 2.0 * q * q * (1.0 + q).sqrt() + tau * n.0) / (1.0 + min_n),
            (q * q / 4.0 * q * d / width + BLEND_OVERSHOOT * q * q * d / width + tau * n.1) / (1.0 + min_n),
        );
        let blend = (1.0 / d, q / width);
        any += (2.0 * tau_change.0 * blend.0 / min_n
            + tau * (SECOND_DERIVATIVE / (d * d * min_n) + 2.0 * blend.0 * n.0 / min_n.powi(2)))
            / divisor;
        mixed += (2.0 * (tau_change.0 * blend.1 + tau_change.1 * blend.0) / min_n
            + tau
                * (2.0 * SECOND_DERIVATIVE * q / (d * width * min_n)
                    + 2.0 * (blend.0 * n.1 + blend.1 * n.0) / min_n.powi(2)))
            / divisor;
        along += (2.0 * tau_change.1 * blend.1 / min_n + tau * 2.0 * blend.1 * n.1 / min_n.powi(2)) / divisor;
        across += tau * q / (rho * width * min_n) / divisor;
        along += mixed * RADIAL_WEIGHT / 2.0;
        any += mixed / (2.0 * RADIAL_WEIGHT);
        let turned = (across - along).abs() * spread.min(1.0);
        Form { across: across + turned, along: along + turned, any }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::morph::{Kind, Morph};
    use glam::DVec3;
    use proptest::prelude::*;

    /// Returns the second difference of the morph along a step, across the displayed direction, as an angle.
    fn curvature(morph: &Morph, point: DVec3, step: DVec3) -> f64 {
        let [before, here, after] = [point - step, point, point + step].map(|p| morph.apply(p) - morph.user);
        let second = before + after - 2.0 * here;
        let away = here.normalize();
        (second - away * second.dot(away)).length() / here.length()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1024))]
        #[test]
        fn no_second_derivative_exceeds_its_form(
            r1 in 5.0..60.0f64, width in 2.0..60.0f64, depth in 0.01..0.99f64, height in -30.0..60.0f64,
            turn in 0.0..6.2f64, reach in 0.01..0.59f64, aim in (-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64),
            step in (-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64),
        ) {
            let offset = DVec3::from(aim).normalize_or_zero() * reach * r1;
            let morph = Morph::new(offset, DVec3::ZERO, r1, r1 + width, Kind::Blend).unwrap();
            let rho = r1 + width * depth;
            let (z, x) = turn.sin_cos();
            let (away, side) = (DVec3::new(x, 0.0, z), DVec3::new(-z, 0.0, x));
            let step = DVec3::from(step).normalize_or_zero() * 1e-3 * width.min(r1) * depth.min(1.0 - depth);
            let point = away * rho + DVec3::Y * height;
            let zone = RadialZone { reach: reach * r1, width };
            let nearest = rho - step.length();
            let form = zone.form(nearest, step.length() / nearest);
            let bound = form.across * step.dot(side).powi(2) + form.along * step.dot(away).powi(2)
                + form.any * step.length_squared();
            prop_assert!(zone.holds(nearest));
            // Second differences of float64 coordinates have an error of 1e-16 of the coordinates.
            prop_assert!(curvature(&morph, point, step) <= bound * (1.0 + 1e-6) + 1e-14);
        }
    }
}
