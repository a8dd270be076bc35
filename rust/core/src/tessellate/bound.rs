//! How far a triangle's interpolated morph can miss the morph of its points, for every user within a distance of the
//! centre.
//!
//! With A = |P−U|, B = |P−O|, v = U−O, |v| ≤ R, u = d_O − d_U, κ = w(1−w), n² = 1 − κ|u|²:
//!
//! ```text
//! Q − U = (P−O) − w v + κ(A−B) u + τ d,   τ = (wA + (1−w)B) κ|u|²/(1+n)
//! ```
//!
//! P−O is linear, so that w v, κ(A−B) u and τ d alone are interpolated wrongly, and what lies along the displayed direction d
//! does not show. For barycentric weights bᵢ and a quadratic form H that is at least the length of their second
//! derivative across d, the error is ½ Σ bᵢ H[Pᵢ−P] = ½ Σ bᵢbⱼ H[Pᵢ−Pⱼ] ≤ max H[edge]/6. H has three parts:
//!
//! - w v: w″ = −c²/(ρ(r₂−r₁)), where c is the edge's part across the radius: along the radius w is linear.
//! - κ(A−B) u: (A−B)² + AB|u|² = |v|², (A−B)′ = −u, and the first three derivatives of X/|X| are at most 1, 2/√3 and 3
//!   over |X|, |X|², |X|³ (a symmetric form is greatest on its diagonal); so with D ≤ A, B: |(A−B)u| ≤ R²/2D,
//!   |((A−B)u)′| ≤ 4/3 (R/D)², |((A−B)u)″| ≤ √21 R²/D³.
//! - τ d: across d only 2 τ′d′ + τ d″ remain, which are smaller by R/D.
//!
//! Seen from the user, wherever he is, an error is divided by at least D (1 − (R/D)²/8) with D = ρ − R; the first part is
//! the turn between the user's and the centre's view, at most RB/(B²−R²).

use crate::morph::Kind;

/// A quadratic form of edges: its value over 6 is the angle, in radians as a user sees it, by which a triangle may miss.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Form {
    /// Of the squared length across the radius.
    pub across: f64,
    /// Of the squared length along the radius.
    pub along: f64,
    /// Of the squared length.
    pub any: f64,
}

/// Least ρ as a share of the user's distance from the centre: below it, terms that were taken to be small are not.
pub(super) const LEAST_CLEARANCE: f64 = 0.4;
/// Greatest second derivative of X/|X|, times |X|².
const SECOND_DERIVATIVE: f64 = 1.154_700_538_379_251_7;
/// w may leave 0..1 by a hundredth where a triangle passes a radius by less than the tolerance shows.
const PASSING: f64 = 1.02;
/// Share of the part along the radius in a product of that part with the whole length: the rest would count for upright
/// edges.
const RADIAL_SHARE: f64 = 1.5;

/// The geometry that a bound holds for.
#[derive(Clone, Copy, Debug)]
pub(super) struct RadialZone {
    /// Greatest |U−O|.
    pub reach: f64,
    /// r₂ − r₁.
    pub width: f64,
    /// Which distance along the direction.
    pub kind: Kind,
}

impl RadialZone {
    /// True where the form is a bound from a distance ρ on.
    pub fn holds(&self, rho: f64) -> bool {
        self.clearance(rho) > LEAST_CLEARANCE * rho
    }

    fn clearance(&self, rho: f64) -> f64 {
        rho - self.reach
    }

    /// D, R/D and what an error is divided by. Where no bound holds they are those of the nearest case that has one.
    fn distances(&self, rho: f64) -> (f64, f64, f64) {
        let nearest = self.clearance(rho).max(LEAST_CLEARANCE * rho);
        let ratio = self.reach.min(rho) / nearest;
        (nearest, ratio, nearest * (1.0 - ratio.min(2.0).powi(2) / 8.0))
    }

    /// The greatest turn of the picture while w goes from 1 to 0.
    fn turn(&self, rho: f64) -> f64 {
        let (nearest, ratio, _) = self.distances(rho);
        let reach = ratio * nearest;
        reach * rho / (nearest * (rho + reach)) / (1.0 - ratio.min(2.0).powi(2) / 8.0)
    }

    /// The greatest angle for each metre by which a point is taken to be on the other side of a radius.
    pub fn slope(&self, rho: f64) -> f64 {
        let (nearest, ratio, divisor) = self.distances(rho);
        PASSING * (self.turn(rho) + ratio * ratio * nearest / (2.0 * divisor)) / self.width
    }

    /// The form for triangles no point of which is nearer to the axis than ρ. `spread` is the sine of the angle between
    /// the radii of any two of their points.
    pub fn form(&self, rho: f64, spread: f64) -> Form {
        let (d, q, divisor) = self.distances(rho);
        let width = self.width;
        let mut across = self.turn(rho) / (width * rho) / (1.0 - spread * spread / 4.0);
        // κ(A−B)u by the product rule.
        let bent = q * q * d / 2.0;
        across += PASSING * bent / (rho * width) / divisor;
        let mut along = 2.0 * bent / (width * width) / divisor;
        let mut mixed = PASSING * 2.0 * (4.0 / 3.0) * q * q / width / divisor;
        let mut any = 21.0_f64.sqrt() / 4.0 * q * q / d / divisor;
        // τ d. Pairs are derivatives for a metre of any direction, and what a metre along the radius adds.
        let least_n = (1.0 - (q * q / 4.0).min(0.75)).sqrt();
        let tau = q * q * d / 4.0 / (1.0 + least_n);
        let n = (SECOND_DERIVATIVE * q * q / (4.0 * d * least_n), PASSING * q * q / (2.0 * width * least_n));
        let tau_change = (
            (q * q / 4.0 + SECOND_DERIVATIVE / 2.0 * q * q * (1.0 + q).sqrt() + tau * n.0) / (1.0 + least_n),
            (q * q / 4.0 * q * d / width + PASSING * q * q * d / width + tau * n.1) / (1.0 + least_n),
        );
        let blend = (1.0 / d, q / width);
        any += (2.0 * tau_change.0 * blend.0 / least_n
            + tau * (SECOND_DERIVATIVE / (d * d * least_n) + 2.0 * blend.0 * n.0 / least_n.powi(2)))
            / divisor;
        mixed += (2.0 * (tau_change.0 * blend.1 + tau_change.1 * blend.0) / least_n
            + tau
                * (2.0 * SECOND_DERIVATIVE * q / (d * width * least_n)
                    + 2.0 * (blend.0 * n.1 + blend.1 * n.0) / least_n.powi(2)))
            / divisor;
        along += (2.0 * tau_change.1 * blend.1 / least_n + tau * 2.0 * blend.1 * n.1 / least_n.powi(2)) / divisor;
        across += tau * q / (rho * width * least_n) / divisor;
        if self.kind == Kind::Cylinder {
            // To first order in R: the distance changes by R/(r₂−r₁) along and 2R/D across, the direction by 1/D.
            let (first, second) = (q / width / divisor, 2.0 * q / d / divisor);
            (across, along) = (across + first + 2.0 * second, along + first);
        }
        along += mixed * RADIAL_SHARE / 2.0;
        any += mixed / (2.0 * RADIAL_SHARE);
        let turned = (across - along).abs() * spread.min(1.0);
        Form { across: across + turned, along: along + turned, any }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::morph::Morph;
    use glam::DVec3;
    use proptest::prelude::*;

    /// Second difference of the morph along a step, across the displayed direction and as an angle: what a form bounds.
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
            let zone = RadialZone { reach: reach * r1, width, kind: Kind::Blend };
            let nearest = rho - step.length();
            let form = zone.form(nearest, step.length() / nearest);
            let bound = form.across * step.dot(side).powi(2) + form.along * step.dot(away).powi(2)
                + form.any * step.length_squared();
            prop_assert!(zone.holds(nearest));
            // Second differences of float64 coordinates lose 1e-16 of them.
            prop_assert!(curvature(&morph, point, step) <= bound * (1.0 + 1e-6) + 1e-14);
        }
    }
}
