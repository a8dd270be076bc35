//! Logistic function at the samples, and the sums that a fit needs, for eight samples at a time.

use super::super::elementary::exp;
use crate::base::Progress;
use crate::base::simd::vectorized;

/// Number of samples in one step of the kernels.
pub(super) const LANES: usize = 8;
pub(super) type Pack = [f64; LANES];

/// Line τ(v) = level + rise (v − origin), the argument of σ(τ) = 1/(1+e^−τ).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Line {
    pub(super) level: f64,
    pub(super) rise: f64,
    pub(super) origin: f64,
}

impl Line {
    pub(super) fn value(&self, v: f64) -> f64 {
        self.level + self.rise * (v - self.origin)
    }

    /// Returns the same curve expressed by 1 − σ(τ) = σ(−τ).
    pub(super) fn complement(self) -> Self {
        Self { level: -self.level, rise: -self.rise, ..self }
    }

    /// Returns the same line with another origin.
    pub(super) fn with_origin(self, origin: f64) -> Self {
        Self { level: self.value(origin), origin, ..self }
    }
}

/// Sums for Newton's method, with p = σ(τ), g = p − mean(p), r = y − q g and u = v − origin. Primes (1 and 2 in names)
/// are derivatives with respect to τ. Arrays have the moments: the sum, the sum times u, and the sum times u².
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct LogisticSums {
    /// Mean of p.
    pub(super) mean: f64,
    /// Σ g².
    pub(super) gg: f64,
    /// Factor of g that minimises the residual.
    pub(super) q: f64,
    /// Σ r².
    pub(super) residual: f64,
    /// Σ p′, Σ p′u.
    pub(super) p1: [f64; 2],
    /// Σ g p′, Σ g p′u.
    pub(super) g_p1: [f64; 2],
    /// Σ r p′, Σ r p′u.
    pub(super) r_p1: [f64; 2],
    /// Σ p′², Σ p′²u, Σ p′²u².
    pub(super) p1_p1: [f64; 3],
    /// Σ r p″, Σ r p″u, Σ r p″u².
    pub(super) r_p2: [f64; 3],
}

impl LogisticSums {
    /// Returns u of the point for which, as the origin, level and rise are nearly independent.
    pub(super) fn center(&self) -> f64 {
        if self.p1_p1[0] > 0.0 { (self.p1_p1[1] / self.p1_p1[0]).clamp(-3.0, 3.0) } else { 0.0 }
    }
}

/// Samples at coordinates v, padded to whole packs with weight 0.
#[derive(Debug)]
pub(super) struct Samples<'a> {
    pub(super) v: &'a [Pack],
    /// 1 for a sample, 0 for padding.
    pub(super) weight: &'a [Pack],
    /// Values with mean 0; 0 in the padding.
    pub(super) y: &'a [Pack],
    pub(super) count: f64,
    /// Progress and cancellation; after a cancellation all sums are 0, which ends a descent.
    pub(super) progress: &'a Progress,
}

/// Buffers for intermediate values of each sample.
#[derive(Debug, Default)]
pub(super) struct LogisticScratch {
    p: Vec<Pack>,
    r: Vec<Pack>,
    first: Vec<Pack>,
    first_u: Vec<Pack>,
    second: Vec<Pack>,
    second_u: Vec<Pack>,
    u: Vec<Pack>,
}

impl LogisticScratch {
    pub(super) fn resize(&mut self, packs: usize) {
        let Self { p, r, first, first_u, second, second_u, u } = self;
        for array in [p, r, first, first_u, second, second_u, u] {
            array.resize(packs, [0.0; LANES]);
        }
    }
}

vectorized! {
    /// Computes all sums of one curve. The buffers of `scratch` have one entry per sample.
    pub(super) fn evaluate(samples: &Samples<'_>, line: &Line, scratch: &mut LogisticScratch) -> LogisticSums
        = evaluate_kernel;
}

// Short loops with one result each, because the compiler does not vectorise one loop with all sums.
#[inline(always)]
fn evaluate_kernel(samples: &Samples<'_>, line: &Line, scratch: &mut LogisticScratch) -> LogisticSums {
    let packs = samples.v.len();
    let (v, weight, y) = (&samples.v[..packs], &samples.weight[..packs], &samples.y[..packs]);
    let (p, u) = (&mut scratch.p[..packs], &mut scratch.u[..packs]);
    for k in 0..packs {
        let (mut from_origin, mut sigma) = ([0.0; LANES], [0.0; LANES]);
        for i in 0..LANES {
            from_origin[i] = v[k][i] - line.origin;
            let e = exp::<false>(line.level + line.rise * from_origin[i]);
            sigma[i] = e / (1.0 + e);
        }
        (u[k], p[k]) = (from_origin, sigma);
    }
    if samples.progress.check().is_err() {
        return LogisticSums::default();
    }
    let mean = product(p, weight) / samples.count;
    // r holds g until q is known.
    let r = &mut scratch.r[..packs];
    for k in 0..packs {
        for i in 0..LANES {
            r[k][i] = (p[k][i] - mean) * weight[k][i];
        }
    }
    let gg = product(r, r);
    let q = if gg > 0.0 { product(r, y) / gg } else { 0.0 };
    let (first, first_u) = (&mut scratch.first[..packs], &mut scratch.first_u[..packs]);
    for k in 0..packs {
        for i in 0..LANES {
            first[k][i] = p[k][i] * (1.0 - p[k][i]);
            first_u[k][i] = first[k][i] * u[k][i];
        }
    }
    if samples.progress.check().is_err() {
        return LogisticSums::default();
    }
    let g_p1 = [product(r, first), product(r, first_u)];
    let (second, second_u) = (&mut scratch.second[..packs], &mut scratch.second_u[..packs]);
    for k in 0..packs {
        for i in 0..LANES {
            r[k][i] = y[k][i] - q * r[k][i];
            second[k][i] = r[k][i] * first[k][i] * (1.0 - 2.0 * p[k][i]);
            second_u[k][i] = second[k][i] * u[k][i];
        }
    }
    LogisticSums {
        mean,
        gg,
        q,
        residual: product(r, r),
        p1: [product(first, weight), product(first_u, weight)],
        g_p1,
        r_p1: [product(r, first), product(r, first_u)],
        p1_p1: [product(first, first), product(first, first_u), product(first_u, first_u)],
        r_p2: [product(second, weight), product(second_u, weight), product(second_u, u)],
    }
}

/// Returns the scalar product of two arrays, from eight parallel sums.
#[inline(always)]
fn product(a: &[Pack], b: &[Pack]) -> f64 {
    let b = &b[..a.len()];
    let mut s = [0.0; LANES];
    for k in 0..a.len() {
        for i in 0..LANES {
            s[i] += a[k][i] * b[k][i];
        }
    }
    ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]))
}
