//! Ratios σ′/σ of many spheres, with σ and σ′ the solid angles without and with the lens (Liebisch 2021, Eq.
//! 4.10–4.12). f⁻¹ comes from a table.

use super::inverse::{LANES, cubic_block};
use super::radial::RadialLens;
use super::size::Cap;
use super::table::Table;
use crate::base::simd::vectorized;

/// Number of spheres in a block.
pub const SPHERES_PER_BLOCK: usize = LANES;
/// Maximum argument of the polynomials below.
const MAX_SQUARE: f64 = 0.2;
/// Minimax polynomials (Remez) of atan(√t)/√t and asin(√t)/√t for t from 0 to MAX_SQUARE, with errors below 2.4·10⁻¹².
const ATAN: [f64; 8] = [
    0.999_999_999_997_646_7,
    -0.333_333_331_825_106,
    0.199_999_840_516_211_2,
    -0.142_850_675_441_242_6,
    0.110_981_110_042_490_5,
    -0.089_468_182_368_456_89,
    0.067_810_283_746_563_8,
    -0.034_460_935_818_881_76,
];
const ASIN: [f64; 8] = [
    0.999_999_999_998_128_6,
    0.166_666_667_862_746_85,
    0.074_999_875_266_811_82,
    0.044_647_780_695_202_01,
    0.030_287_346_989_447_5,
    0.023_345_233_781_470_85,
    0.011_956_386_657_469_75,
    0.028_520_557_448_714_78,
];

/// Spheres seen from an eye, as arrays of equal length, padded to a multiple of `SPHERES_PER_BLOCK`.
#[derive(Clone, Copy, Debug)]
pub struct Spheres<'a> {
    /// Sine of α, the angle between the centre and the lens's axis; at least 0.
    pub sin_alpha: &'a [f64],
    /// Cosine of α.
    pub cos_alpha: &'a [f64],
    /// Sine of μ, half the subtended angle.
    pub sin_mu: &'a [f64],
    /// Cosine of μ.
    pub cos_mu: &'a [f64],
}

impl RadialLens {
    /// Writes (α⁺ − α⁻) / 2μ of each sphere, see `Cap::stretch`, with a relative error of at most 10⁻⁸; 1 for spheres
    /// that extend to 90° or to the lens's fold.
    pub fn stretches<'a>(&self, tan_omega: f64, spheres: &Spheres<'a>, to: &mut [f64]) {
        let Some(table) = self.table() else {
            to.fill(1.0);
            return;
        };
        let lens = LensBend { k: &self.radial.k, table, scale: tan_omega };
        let blocks = |values: &'a [f64]| values.as_chunks::<LANES>().0.iter();
        let angles = blocks(spheres.sin_alpha).zip(blocks(spheres.cos_alpha));
        let sizes = blocks(spheres.sin_mu).zip(blocks(spheres.cos_mu));
        for (((sin_alpha, cos_alpha), (sin_mu, cos_mu)), to) in angles.zip(sizes).zip(to.chunks_mut(LANES)) {
            let block = SphereBlock { sin_alpha, cos_alpha, sin_mu, cos_mu };
            let mut ratios = [0.0; LANES];
            stretch(&lens, &block, &mut ratios);
            for (n, (to, ratio)) in to.iter_mut().zip(ratios).enumerate() {
                *to = if ratio > 0.0 { ratio } else { self.stretch_one(tan_omega, &block, n) };
            }
        }
    }

    /// Computes the stretch of one sphere of a block, by Newton's method.
    fn stretch_one(&self, tan_omega: f64, block: &SphereBlock<'_>, n: usize) -> f64 {
        let cap = Cap {
            lens: self,
            scale: tan_omega,
            sin_alpha: block.sin_alpha[n],
            cos_alpha: block.cos_alpha[n],
            sin_mu: block.sin_mu[n],
            cos_mu: block.cos_mu[n],
        };
        let [a, b] = cap.edges().map(|x| self.undistort(x.abs()).copysign(x));
        if cap.sin_mu == 0.0 || !a.is_finite() || !b.is_finite() { 1.0 } else { cap.stretch(a, b) }
    }
}

struct LensBend<'a> {
    k: &'a [f64],
    table: &'a Table,
    /// tan ω
    scale: f64,
}

struct SphereBlock<'a> {
    sin_alpha: &'a [f64; LANES],
    cos_alpha: &'a [f64; LANES],
    sin_mu: &'a [f64; LANES],
    cos_mu: &'a [f64; LANES],
}

vectorized! {
    fn stretch(lens: &LensBend<'_>, block: &SphereBlock<'_>, to: &mut [f64; LANES]) = stretch_block;
}

/// Computes the stretches of a block; 0 for spheres beyond the table or polynomials, which the caller solves.
#[inline(always)]
fn stretch_block(lens: &LensBend<'_>, block: &SphereBlock<'_>, to: &mut [f64; LANES]) {
    let SphereBlock { sin_alpha, cos_alpha, sin_mu, cos_mu } = block;
    let (mut far, mut near, mut rise) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
    let (mut is_in_range, mut is_behind) = ([false; LANES], [false; LANES]);
    for n in 0..LANES {
        // Edges of the sphere: tan(α ± μ) / tan ω. Both edges and their distance share one division.
        let (cos_cos, sin_sin) = (cos_alpha[n] * cos_mu[n], sin_alpha[n] * sin_mu[n]);
        let (cos_far, cos_near) = (cos_cos - sin_sin, cos_cos + sin_sin);
        let (sin_cos, cos_sin) = (sin_alpha[n] * cos_mu[n], cos_alpha[n] * sin_mu[n]);
        let inverse = 1.0 / (cos_far * cos_near * lens.scale);
        far[n] = (sin_cos + cos_sin) * (cos_near * inverse);
        near[n] = (sin_cos - cos_sin) * (cos_far * inverse);
        rise[n] = 2.0 * lens.scale * cos_mu[n] * inverse;
        is_behind[n] = cos_far <= 0.0;
        is_in_range[n] = (far[n] < lens.table.end) & (sin_mu[n] * sin_mu[n] <= MAX_SQUARE);
    }
    let (mut a, mut b) = ([0.0; LANES], [0.0; LANES]);
    cubic_block(lens.table, &far, &mut a);
    cubic_block(lens.table, &near, &mut b);
    for n in 0..LANES {
        b[n] = b[n].copysign(near[n]);
    }
    // The divided difference of f between the two roots, as in `size::divided_difference`.
    let (mut sum, mut power, mut total) = ([1.0; LANES], [1.0; LANES], [1.0; LANES]);
    for &c in lens.k {
        for n in 0..LANES {
            power[n] *= b[n];
            sum[n] = sum[n] * a[n] + power[n];
            power[n] *= b[n];
            sum[n] = sum[n] * a[n] + power[n];
            total[n] += c * sum[n];
        }
    }
    for n in 0..LANES {
        // tan((α⁺ − α⁻)/2) / sin μ, from the sine and cosine of α⁺ − α⁻, both multiplied by the divided difference.
        let along = total[n] * (1.0 + lens.scale * lens.scale * (a[n] * b[n]));
        let across = rise[n] * sin_mu[n];
        let half = 1.0 / ((along * along + across * across).sqrt() + along);
        let square = (across * half) * (across * half);
        let ratio = rise[n] * half * polynomial(&ATAN, square) / polynomial(&ASIN, sin_mu[n] * sin_mu[n]);
        let ratio = if is_in_range[n] & (square <= MAX_SQUARE) { ratio } else { 0.0 };
        to[n] = if is_behind[n] { 1.0 } else { ratio };
    }
}

#[inline(always)]
fn polynomial(coefficients: &[f64; 8], t: f64) -> f64 {
    let mut sum = coefficients[7];
    let mut n = 7;
    while n > 0 {
        n -= 1;
        sum = sum * t + coefficients[n];
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_hold_their_bound() {
        for step in 1..=10_000 {
            let t: f64 = MAX_SQUARE * f64::from(step) / 10_000.0;
            let root = t.sqrt();
            assert!((polynomial(&ATAN, t) * root / root.atan() - 1.0).abs() < 2.6e-12, "{t}");
            assert!((polynomial(&ASIN, t) * root / root.asin() - 1.0).abs() < 2.6e-12, "{t}");
        }
    }
}
