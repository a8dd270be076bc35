//! One root of f(r) = x: Newton's method within a bracket.

use super::exact::residual;
use super::polynomial;

/// Maximum radius and coefficient, so that neither fourth derivatives nor the splits of `two_product` overflow.
pub(super) const FARTHEST: f64 = 1e290;
/// Number of Newton steps after which bisection alternates with Newton's method.
const NEWTON_STEPS: u32 = 20;

/// f and the data that its inverse needs.
#[derive(Clone, Debug)]
pub(super) struct Radial {
    /// k₁, k₂, …
    pub k: Vec<f64>,
    /// 1, 3k₁, 5k₂, …: coefficients of f′ in r².
    pub slope: Vec<f64>,
    /// Radius at which f stops increasing; +∞ for lenses without a fold.
    pub r_max: f64,
    /// f(r_max), rounded; at most FARTHEST.
    pub x_max: f64,
    /// Smallest radius at which a term kᵢ r²ⁱ⁺¹ is as large as r; +∞ without terms.
    pub unit: f64,
}

impl Radial {
    /// Prepares f, and finds the radius at which f′ = 0.
    pub fn new(k: &[f64]) -> Self {
        let count = k.iter().rposition(|&c| c != 0.0).map_or(0, |last| last + 1);
        let k = k[..count].to_vec();
        let mut slope = vec![1.0];
        slope.extend(k.iter().enumerate().map(|(n, c)| (2 * n + 3) as f64 * c));
        let r_max = polynomial::first_zero(&slope).map_or(f64::INFINITY, f64::sqrt);
        let r = |(n, c): (usize, &f64)| if *c == 0.0 { f64::INFINITY } else { c.abs().powf(-0.5 / (n + 1) as f64) };
        let unit = k.iter().enumerate().map(r).fold(f64::INFINITY, f64::min);
        // If f(r_max) overflows, FARTHEST limits the search.
        let end = if r_max.is_finite() { residual(&k, r_max, 0.0) } else { FARTHEST };
        let x_max = if end <= FARTHEST { end } else { FARTHEST };
        Self { k, slope, r_max, x_max, unit }
    }

    /// Returns the coefficients of f(r)/r in r²: 1, k₁, k₂, …
    pub fn factor(&self) -> Vec<f64> {
        [1.0].iter().chain(&self.k).copied().collect()
    }

    /// Returns the coefficients of f in r: 0, 1, 0, k₁, 0, k₂, …
    pub fn coefficients(&self) -> Vec<f64> {
        self.factor().into_iter().flat_map(|c| [0.0, c]).collect()
    }

    /// Returns f(r), correct to one rounding.
    pub fn distort(&self, r: f64) -> f64 {
        residual(&self.k, r, 0.0)
    }

    /// Returns f′(r).
    pub fn derivative(&self, r: f64) -> f64 {
        polynomial::value(&self.slope, r * r)
    }

    /// Returns the r ≥ 0 with f(r) = x, for 0 ≤ x ≤ f(r_max).
    pub fn undistort(&self, x: f64) -> f64 {
        if self.k.is_empty() || x == 0.0 || !x.is_finite() {
            return x;
        }
        let (mut low, mut high) = (0.0, self.r_max);
        if high.is_infinite() {
            high = x.min(self.unit);
            while residual(&self.k, high, x) < 0.0 {
                low = high;
                high *= 2.0;
            }
        }
        let mut r = if low < x && x < high { x } else { 0.5 * (low + high) };
        let mut step = 0;
        loop {
            let residual = residual(&self.k, r, x);
            if residual == 0.0 {
                return r;
            }
            // An overflow (NaN) also means that r is too large.
            if residual < 0.0 {
                low = r
            } else {
                high = r
            }
            let next = r - residual / self.derivative(r);
            // The step is smaller than a rounding of r: r is the float nearest to the root, or its neighbour.
            if next == r {
                return r;
            }
            let middle = low + 0.5 * (high - low);
            let is_close = (next - r).abs() <= f64::EPSILON * r;
            // Near the fold a Newton step may end outside the bracket; then the bracket is halved.
            let is_within = low < next && next < high;
            if middle <= low || middle >= high {
                return self.nearer_root(low, high, x);
            }
            if is_within && is_close {
                return self.nearer_root(r, next, x);
            }
            // If Newton's method has not converged after NEWTON_STEPS, every other step halves the bracket.
            r = if is_within && (step < NEWTON_STEPS || step % 2 == 0) { next } else { middle };
            step += 1;
        }
    }

    /// Returns that one of two neighbouring floats which has the smaller residual.
    fn nearer_root(&self, a: f64, b: f64, x: f64) -> f64 {
        if residual(&self.k, a, x).abs() <= residual(&self.k, b, x).abs() { a } else { b }
    }
}
