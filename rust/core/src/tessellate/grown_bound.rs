//! Upper bound of the error of a triangle's interpolated cylinder morph, for every user within a distance u of the
//! centre, every radius R from a least one on and every strength.
//!
//! All positions are relative to O; v = U−O, |v| ≤ u; x is a point, A = |x−v|, B = |x|, ρ = |x_h|. Eq. 1 of the morph blends
//! (x−v)/A and x/B, so the direction is that of y = x − κv with κ = wB/(wB + (1−w)A): the point is seen from an eye at κv,
//! and shown at Q − U = μy, where |v_h + μy_h| = ρ. With weights bᵢ of the corners and m = μ(x) the interpolation is
//!
//! ```text
//! Σ bᵢ μᵢyᵢ / m = y − (Σ bᵢκᵢ − κ) v + Σ bᵢ (μᵢ/m − 1) yᵢ,   yᵢ = y + (xᵢ−x) − (κᵢ−κ) v
//! ```
//!
//! of which y itself is no error. Let hᵢ, ℓᵢ be the horizontal length and the length of xᵢ−x, and rᵢ = |ρᵢ−ρ|. Then
//! Σ bᵢhᵢ² ≤ h²/3 and Σ bᵢℓᵢ² ≤ ℓ²/3 with the greatest h and ℓ of the edges, Σ bᵢρᵢ − ρ ≤ h²/(6ρ), and
//! Σ bᵢrᵢ² ≤ c²/4 + h²/1700 with the greatest range c of ρ along an edge, as h is at most 1.141 ρ/8. With e = u/ρ, q = u/B,
//! Y = B−u, at the least ρ and B of the triangle:
//!
//! - κ is a function of w and a = ln(B/A): |∂κ/∂w| ≤ 1/(1−q), |∂κ/∂a| ≤ ¼, |∂²κ/∂w²| ≤ 2q/(1−q)², |∂²κ/∂w∂a| ≤ 1/(1−q),
//!   |∂²κ/∂a²| ≤ √3/18. |∇a| = |v|/AB ≤ u/BY, and |a″| ≤ 2u/Y³ (the third derivative of ln|x| is at most 2/|x|³).
//! - w is linear in ρ between kinks, with slope W = 1/((1−n)R). As R may be any radius, a kink may lie anywhere:
//!   |Σ bᵢwᵢ − w| ≤ W (c/4 + h²/(6ρ)). Where R is known and edges are cut there, no triangle has corners on both sides, and
//!   the first term is missing.
//! - d ln μ = ((x/μ − v − μy)·dx_h + (v + μy)·v dκ)/((v + μy)·y), horizontally. From the chord of the circle of radius ρ in
//!   the direction y, |μ−1| ≤ 1.09 e (1−κ)/(1−κe) for e ≤ 0.6. So |d ln μ| ≤ G |dx_h| + k |dκ| with G and k below.
//!
//! What remains are sums and products of these; a product ab is at most (sa² + b²/s)/2, with s so that lengths may grow with
//! the height above the centre. The angle is at most the length across y, divided by |y| ≥ Y and by exp(−1/8)(1 − angle),
//! as μᵢ/m stays within exp(±1/8).

/// Factors of the measures of an edge. The bound of a triangle, in radians, is the greatest `range` of its edges plus the
/// greatest `length`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Measure {
    /// Factors of c and c², where c is the range of ρ along the edge.
    pub range: [f64; 2],
    /// Factors of h² and ℓ², the squares of the edge's horizontal length and its length.
    pub length: [f64; 2],
    /// Greatest c, h and ℓ for which the bound holds.
    pub most: [f64; 3],
}

/// Greatest u/ρ for which there is a bound.
pub(super) const MOST_RATIO: f64 = 0.5;
/// Greatest length of an edge as a share of its least distance from the axis or the centre.
pub(super) const LONGEST: f64 = 0.125;
/// Greatest quotient of the distance of an edge and that of any point of its triangle, if edges are not longer than
/// `LONGEST`: 1 + c/(1 − c √3/2).
pub(super) const SPREAD: f64 = 1.141;
/// exp(−1/8), where 1/8 is the greatest |ln μᵢ/m|: 1/16 by κ along ranges, and 1/32 each by h and by κ along lengths.
const STEADY: f64 = 0.882;
/// Greatest (exp(g) − 1)/g for g ≤ 1/8.
const GROWTH: f64 = 1.07;

/// The morphs and users for which the bound holds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Region {
    /// u, metres.
    pub reach: f64,
    /// n, the quotient of r₁ and R.
    pub near: f64,
    /// Least and greatest R, metres.
    pub radii: [f64; 2],
    /// Whether edges are cut at all kinks.
    pub is_cut: bool,
}

impl Region {
    /// Greatest slope of w for points from ρ on; `most` is the greatest ρ.
    pub fn slope(&self, rho: f64, most: f64) -> f64 {
        let [least, greatest] = self.radii;
        let is_flat = rho >= greatest || most < self.near * least;
        if is_flat { 0.0 } else { 1.0 / ((1.0 - self.near) * least.max(rho)) }
    }

    /// The bound for triangles whose points have at least distance ρ from the axis and B ≥ ρ from the centre, and at most
    /// distance `most` from the axis. It only falls where ρ and B grow.
    pub fn measure(&self, rho: f64, distance: f64, most: f64) -> Measure {
        let u = self.reach;
        let (e, q, away, tall) = (u / rho, u / distance, distance - u, distance / rho);
        let is_seen_from_centre = rho >= self.radii[1];
        let slope = self.slope(rho, most);
        let root = (1.0 - e * e).sqrt();
        let mut bound = Measure::default();
        let [mut first, mut second, mut level, mut any] = [0.0; 4];
        let mut add = |factor: f64, terms: [f64; 4]| {
            first += factor * terms[0];
            second += factor * terms[1];
            level += factor * terms[2];
            any += factor * terms[3];
        };
        // (x/μ − v − μy)/ρ, and G.
        let bent = (1.09 * e).powi(2) / (1.0 - 1.09 * e);
        let grows = if is_seen_from_centre {
            (e + e * e / root + bent) / (rho * root)
        } else {
            (e + e * e * (0.78 / (1.0 - e) + 1.12 / root) + bent) / (rho * root * (1.0 - e))
        };
        add(GROWTH / away, [0.0, 0.0, grows * tall / 6.0, grows / (6.0 * tall)]);
        bound.most = [f64::INFINITY, 1.0 / (32.0 * grows), f64::INFINITY];
        if !is_seen_from_centre {
            let k = e / ((1.0 - e) * root);
            // |κᵢ−κ| ≤ turn rᵢ + lift ℓᵢ.
            let (turn, lift) = (slope / (1.0 - q), u / (4.0 * distance * away));
            let log = u / (distance * away);
            let linear = if self.is_cut { 0.0 } else { turn / 4.0 };
            let curved = q / (1.0 - q).powi(2) * slope * slope + turn * slope / 2.0;
            add(
                u / away,
                [
                    linear,
                    curved / 4.0,
                    turn / (6.0 * rho) + curved / 1700.0,
                    u / (12.0 * away.powi(3)) + log * log * (1.0 / (6.0 * (1.0 - q)) + 0.0161),
                ],
            );
            add(GROWTH / away * k * turn, [0.0, tall * 3.0 / 8.0, tall * 1.5 / 1700.0, 1.0 / (18.0 * tall)]);
            add(GROWTH / away * grows * u * turn, [0.0, 0.5, 2.0 / 1700.0 + 1.0 / 24.0, 0.0]);
            add(GROWTH / away * k * u * turn * turn, [0.0, 0.5, 2.0 / 1700.0, 0.0]);
            add(GROWTH / away * lift, [0.0, 0.0, grows * u * tall / 6.0, k / 3.0 + grows * u / (6.0 * tall)]);
            add(GROWTH / away * k * u * lift * lift, [0.0, 0.0, 0.0, 2.0 / 3.0]);
            bound.most[0] = 1.0 / (32.0 * k * turn);
            bound.most[2] = 1.0 / (32.0 * k * lift);
        }
        Measure { range: [first, second], length: [level, any], ..bound }
    }
}

/// The error in radians that the sum of the parts of a bound may have, so that the angle is within a tolerance.
pub(super) fn allowed(tolerance: f64) -> f64 {
    let angle = tolerance.min(0.5);
    angle * STEADY * (1.0 - angle)
}
