//! Upper bound of the error of a triangle's interpolated cylinder morph, for every user within a distance u of the
//! centre, every radius R above a minimum and every strength.
//!
//! All positions are relative to O; v = U−O, |v| ≤ u; x is a point, A = |x−v|, B = |x|, ρ = |x_h|. Eq. 1 blends
//! (x−v)/A and x/B, so the direction is that of y = x − κv with κ = wB/(wB + (1−w)A): the point is seen from an eye at
//! κv, and shown at Q − U = μy, where |v_h + μy_h| = ρ. With corner weights bᵢ and m = μ(x) the interpolation is
//!
//! ```text
//! Σ bᵢ μᵢyᵢ / m = y − (Σ bᵢκᵢ − κ) v + Σ bᵢ (μᵢ/m − 1) yᵢ,   yᵢ = y + (xᵢ−x) − (κᵢ−κ) v
//! ```
//!
//! y itself is no error, nor is any component parallel to it. Let hᵢ, ℓᵢ be the horizontal length and the length of
//! xᵢ−x, and rᵢ = |ρᵢ−ρ|. Then Σ bᵢhᵢ² ≤ h²/3 and Σ bᵢℓᵢ² ≤ ℓ²/3 with the maximum h and ℓ of the edges, Σ bᵢρᵢ − ρ ≤
//! h²/(6ρ), and Σ bᵢrᵢ² ≤ c²/4 + h²/1700 with the maximum range c of ρ along an edge, as h is at most 1.141 ρ/8. With
//! e = u/ρ, q = u/B, Y = B−u, at the minimum ρ and B of the triangle, e ≤ ½:
//!
//! - κ is a function of w and a = ln(B/A): |∂κ/∂w| ≤ 1/(1−q), |∂κ/∂a| ≤ ¼, |∂²κ/∂w²| ≤ 2q/(1−q)², |∂²κ/∂w∂a| ≤ 1/(1−q),
//!   |∂²κ/∂a²| ≤ √3/18. |∇a| = |v|/AB ≤ u/BY, and |a″| ≤ 2u/Y³ (the third derivative of ln|x| is at most 2/|x|³).
//! - The length of v across y, divided by |y|, is |v × x|/|y|². With the angle χ between v and x it is at most
//!   q sin χ/(1 − 2κq cos χ + κ²q²) ≤ q/(1−q²). Multiplied by ∂κ/∂w it is sin ω/n², where ω is the angle between the
//!   views of U and O, sin ω ≤ q, and n ≥ cos ω/2 the length of the blend: at most 2 tan ω/2 = 2q/(1 + √(1−q²)).
//! - w is linear in ρ between kinks, with slope W = 1/((1−n)R). As R may be any radius, a kink may lie anywhere:
//!   |Σ bᵢwᵢ − w| ≤ W (c/4 + h²/(6ρ)). Where R is known and edges are cut there, no triangle has corners on both sides,
//!   and the first term is missing.
//! - With p = v + μy, d ln μ = ((x/μ − p)·dx_h + p·v dκ)/(p·y), horizontally. In units of ρ, let y have the direction
//!   (1, 0), v = e (cos ψ, s), a = √(1−κ²e²s²) and b = √(1−e²s²). Then x = (a, κes), p = (b, es), |y| = a − κe cos ψ,
//!   μ|y| = b − e cos ψ, and
//!
//! ```text
//! |x/μ − p|/(p·y) = e √((b−κa)² + e²s²(1−κ²)²) / (b (b − e cos ψ) (a − κe cos ψ))
//! ```
//!
//!   - 0 ≤ b−κa ≤ (1−κ)(a − e²s²(1+κ)/(2a)), so the root is at most (1−κ)(1 + e²s²(κ + 1/3)/2).
//!   - b (b − e cos ψ) ≥ (1−e)(1 + e (1−e) s²/2), because 2 b cos ψ ≤ b² + cos² ψ.
//!   - a − κe cos ψ ≥ (1−κe)(1 + 0.46 κe s²).
//!
//!   Therefore the quotient is at most e (1−κ)/((1−e)(1−κe)) for e ≤ ½, without s. As b (cos ψ + e s²/b) ≤ b, the
//!   factor of dκ is at most e/(1−κe). So |d ln μ| ≤ G |dx_h| + k |dκ| with G = e/((1−e)ρ) and k = e/(1−e).
//! - |y| ≥ B−κu. Where w is 0, κ is 0, and |y| is B. Where w is constant, κ changes by at most δ = u ℓ/(4BY), G falls
//!   with κ as (1−κ)/(1−κe), k |dκ| as κ(1−κ)/(1−κe), and for either the quotient by |y| is at most the bound for |y|
//!   = B, times 1 + 4δ/(1−q).
//!
//! The remaining terms are sums and products of these; a product ab is at most (sa² + b²/s)/2, with s so that lengths
//! may grow with the height above the centre. The angle is at most the length across y, divided by |y| and by
//! exp(−1/8)(1 − 2 angle), as μᵢ/m stays within exp(±1/8) and the component of v along y is at most twice the bound of
//! its component across.

/// Factors of the measures of an edge. The bound of a triangle, in radians, is the maximum `range` term over its edges
/// plus the maximum `length` term.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Measure {
    /// Factors of c and c², where c is the range of ρ along the edge.
    pub range: [f64; 2],
    /// Factors of h² and ℓ², the squares of the edge's horizontal length and its length.
    pub length: [f64; 2],
    /// Maximum c, h and ℓ for which the bound holds.
    pub limits: [f64; 3],
}

/// Maximum u/ρ for which there is a bound.
pub(super) const MAX_RATIO: f64 = 0.5;
/// Maximum length c of an edge relative to its minimum distance from the axis or the centre.
pub(super) const MAX_LENGTH: f64 = 0.125;
/// Maximum ratio of the distance of an edge to that of any point of its triangle: 1 + c/(1 − c √3/2).
pub(super) const MAX_SPREAD: f64 = 1.141;
/// The same two numbers for edges where only the centre's view counts.
pub(super) const MAX_FAR_LENGTH: f64 = 0.5;
pub(super) const MAX_FAR_SPREAD: f64 = 1.882;
/// exp(−1/8), where 1/8 is the maximum |ln μᵢ/m|: 1/16 by κ along ranges, and 1/32 each by h and by κ along lengths.
const MIN_STRETCH_RATIO: f64 = 0.882;
/// Maximum (exp(g) − 1)/g for g ≤ 1/8.
const MAX_EXP_SLOPE: f64 = 1.07;

/// Morphs and users for which the bound holds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Region {
    /// u, metres.
    pub reach: f64,
    /// n, the ratio of r₁ to R.
    pub near: f64,
    /// Minimum and maximum R, metres.
    pub radii: [f64; 2],
    /// Whether edges are cut at all kinks.
    pub is_cut: bool,
}

impl Region {
    /// Returns the maximum slope of w for points from ρ on.
    pub fn slope(&self, rho: f64) -> f64 {
        let [min, max] = self.radii;
        if rho >= max { 0.0 } else { 1.0 / ((1.0 - self.near) * min.max(rho)) }
    }

    /// Returns the bound for triangles whose points have at least distance ρ from the axis and B ≥ ρ from the centre;
    /// `is_flat` if they all lie within the minimum r₁. It decreases as ρ and B grow.
    pub fn measure(&self, rho: f64, distance: f64, is_flat: bool) -> Measure {
        let u = self.reach;
        let (e, q, clearance, tall) = (u / rho, u / distance, distance - u, distance / rho);
        let is_seen_from_centre = rho >= self.radii[1];
        let slope = if is_flat { 0.0 } else { self.slope(rho) };
        let mut bound = Measure::default();
        let [mut first, mut second, mut horizontal, mut any] = [0.0; 4];
        let mut add = |factor: f64, terms: [f64; 4]| {
            first += factor * terms[0];
            second += factor * terms[1];
            horizontal += factor * terms[2];
            any += factor * terms[3];
        };
        // G, and the maximum component of v across y in radians.
        let (grows, across) = (e / ((1.0 - e) * rho), q / (1.0 - q * q));
        // Products of lengths and changes of ln μ are divided by |y|.
        let product = MAX_EXP_SLOPE
            * match () {
                () if is_seen_from_centre => 1.0 / distance,
                () if is_flat => {
                    (1.0 / distance * (1.0 + MAX_LENGTH * MAX_SPREAD * q / (1.0 - q).powi(2))).min(1.0 / clearance)
                }
                () => 1.0 / clearance,
            };
        add(product, [0.0, 0.0, grows * tall / 6.0, grows / (6.0 * tall)]);
        bound.limits = [f64::INFINITY, 1.0 / (32.0 * grows), f64::INFINITY];
        if !is_seen_from_centre {
            let k = e / (1.0 - e);
            // |κᵢ−κ| ≤ turn rᵢ + lift ℓᵢ.
            let (turn, lift) = (slope / (1.0 - q), u / (4.0 * distance * clearance));
            let log = u / (distance * clearance);
            let kink = slope * 2.0 * q / (1.0 + (1.0 - q * q).sqrt());
            add(kink, [if self.is_cut { 0.0 } else { 0.25 }, 0.0, 1.0 / (6.0 * rho), 0.0]);
            let curved = q / (1.0 - q).powi(2) * slope * slope + turn * slope / 2.0;
            let mixed = if slope > 0.0 { log * log / (6.0 * (1.0 - q)) } else { 0.0 };
            let bent = u / (12.0 * clearance.powi(3)) + log * log * 0.0161 + mixed;
            add(across, [0.0, curved / 4.0, curved / 1700.0, bent]);
            add(product * k * turn, [0.0, tall * 3.0 / 8.0, tall * 1.5 / 1700.0, 1.0 / (18.0 * tall)]);
            add(product * grows * u * turn, [0.0, 0.5, 2.0 / 1700.0 + 1.0 / 24.0, 0.0]);
            add(product * k * u * turn * turn, [0.0, 0.5, 2.0 / 1700.0, 0.0]);
            add(product * lift, [0.0, 0.0, grows * u * tall / 6.0, k / 3.0 + grows * u / (6.0 * tall)]);
            add(product * k * u * lift * lift, [0.0, 0.0, 0.0, 2.0 / 3.0]);
            bound.limits[0] = 1.0 / (32.0 * k * turn);
            bound.limits[2] = 1.0 / (32.0 * k * lift);
        }
        Measure { range: [first, second], length: [horizontal, any], ..bound }
    }
}

/// Returns the maximum sum of a bound's terms, in radians, for which the angle is within a tolerance.
pub(super) fn allowed_error(tolerance: f64) -> f64 {
    let angle = tolerance.min(0.25);
    angle * MIN_STRETCH_RATIO * (1.0 - 2.0 * angle)
}
