//! One root of f(r) = x at a time: Newton's method inside a bracket that holds the root, so that it cannot leave it.

use super::exact::residual;
use super::polynomial;

/// Greatest radius that is shown or looked for, and greatest coefficient: fourth derivatives, and halves of products, do
/// not overflow.
pub(super) const FARTHEST: f64 = 1e290;
/// Steps of Newton's method before halving takes turns with it.
const NEWTON_STEPS: u32 = 20;

/// f and what its inverse needs.
#[derive(Clone, Debug)]
pub(super) struct Radial {
    /// k₁, k₂, …
    pub k: Vec<f64>,
    /// 1, 3k₁, 5k₂, …: f′ in r².
    pub slope: Vec<f64>,
    /// Where f stops rising; +∞ for lenses that never fold.
    pub r_max: f64,
    /// f(r_max), rounded, or FARTHEST.
    pub x_max: f64,
    /// Radius at which the first of the terms is as large as r itself; +∞ without terms.
    pub unit: f64,
}

impl Radial {
    /// Finds where f′ = 0.
    pub fn new(k: &[f64]) -> Self {
        let count = k.iter().rposition(|&c| c != 0.0).map_or(0, |last| last + 1);
        let k = k[..count].to_vec();
        let mut slope = vec![1.0];
        slope.extend(k.iter().enumerate().map(|(n, c)| (2 * n + 3) as f64 * c));
        let r_max = polynomial::first_zero(&slope).map_or(f64::INFINITY, f64::sqrt);
        let one = |(n, c): (usize, &f64)| if *c == 0.0 { f64::INFINITY } else { c.abs().powf(-0.5 / (n + 1) as f64) };
        let unit = k.iter().enumerate().map(one).fold(f64::INFINITY, f64::min);
        // Where f overflows, so does its highest power: the search ends before it.
        let end = if r_max.is_finite() { residual(&k, r_max, 0.0) } else { FARTHEST };
        let x_max = if end <= FARTHEST { end } else { FARTHEST };
        Self { k, slope, r_max, x_max, unit }
    }

    /// f(r), right to a rounding.
    pub fn distort(&self, r: f64) -> f64 {
        residual(&self.k, r, 0.0)
    }

    /// f′(r).
    pub fn derivative(&self, r: f64) -> f64 {
        polynomial::value(&self.slope, r * r)
    }

    /// The r ≥ 0 with f(r) = x, for 0 ≤ x ≤ f(r_max).
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
            let off = residual(&self.k, r, x);
            if off == 0.0 {
                return r;
            }
            // Beyond all floats is too far as well.
            if off < 0.0 {
                low = r;
            } else {
                high = r;
            }
            let next = r - off / self.derivative(r);
            // A step that rounds away ends it: r is the nearest float there is, or its neighbour.
            if next == r {
                return r;
            }
            let middle = low + 0.5 * (high - low);
            let close = (next - r).abs() <= f64::EPSILON * r;
            // Beside the fold a step is either short of the root or far beyond it; then the bracket is halved.
            let within = low < next && next < high;
            if middle <= low || middle >= high {
                return self.better(low, high, x);
            }
            if within && close {
                return self.better(r, next, x);
            }
            // Where Newton's steps are still short after so many, the bracket halves at least every other time.
            r = if within && (step < NEWTON_STEPS || step % 2 == 0) { next } else { middle };
            step += 1;
        }
    }

    /// The one of two neighbouring floats with the smaller residual.
    fn better(&self, one: f64, other: f64, x: f64) -> f64 {
        if residual(&self.k, one, x).abs() <= residual(&self.k, other, x).abs() { one } else { other }
    }
}
