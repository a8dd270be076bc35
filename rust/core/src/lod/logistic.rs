//! The logistic function over an array of samples, with what a fit needs of it, eight samples at a time.

use crate::base::simd::widest;

/// Samples of one step of the kernels.
pub(super) const LANES: usize = 8;
pub(super) type Pack = [f64; LANES];

/// Beyond ±700 the exponential overflows soon, and the logistic function is 0 or 1 to 300 digits.
const FARTHEST: f64 = 700.0;

/// τ(v) = level + rise (v − origin), of which σ(τ) = 1/(1+e^−τ) is taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Line {
    pub(super) level: f64,
    pub(super) rise: f64,
    pub(super) origin: f64,
}

impl Line {
    pub(super) fn at(&self, v: f64) -> f64 {
        self.level + self.rise * (v - self.origin)
    }

    /// The same curve by 1 − σ(τ) = σ(−τ).
    pub(super) fn turned(self) -> Self {
        Self { level: -self.level, rise: -self.rise, ..self }
    }

    /// The same line by its value elsewhere.
    pub(super) fn seen_from(self, origin: f64) -> Self {
        Self { level: self.at(origin), origin, ..self }
    }
}

/// For p = σ(τ), g = p − mean(p), the best q, and r = y − q g: what Newton's method needs. With ′ for the derivative by
/// τ, and u = v − origin.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sums {
    pub(super) mean: f64,
    /// Σ g².
    pub(super) square: f64,
    /// The slope of y over p that leaves the least residual.
    pub(super) q: f64,
    /// Σ r².
    pub(super) residual: f64,
    /// Σ p′, Σ p′u.
    pub(super) plain: [f64; 2],
    /// Σ g p′, Σ g p′u.
    pub(super) along: [f64; 2],
    /// Σ r p′, Σ r p′u.
    pub(super) slope: [f64; 2],
    /// Σ p′², Σ p′²u, Σ p′²u².
    pub(super) squared: [f64; 3],
    /// Σ r p″, Σ r p″u, Σ r p″u².
    pub(super) bend: [f64; 3],
}

/// Samples in the kernels' own frame, padded to whole packs with weight 0.
#[derive(Debug)]
pub(super) struct Samples<'a> {
    pub(super) v: &'a [Pack],
    /// 1 for a sample, 0 for padding.
    pub(super) weight: &'a [Pack],
    /// With mean 0, 0 in the padding.
    pub(super) y: &'a [Pack],
    pub(super) count: f64,
}

/// e^t for |t| ≤ 700, to 2 units in the last place: t = n ln 2 + r, and Taylor's series of e^r, |r| ≤ ln 2/2, whose
/// term after the last is below 2⁻⁵⁷. In plain arithmetic, so that it becomes vectors and has the same bits everywhere.
#[inline(always)]
pub(super) fn exp(t: f64) -> f64 {
    /// Adding it leaves a number rounded to a whole one in the lowest bits.
    const WHOLE: f64 = 6_755_399_441_055_744.0;
    /// ln 2 in two parts; multiples of the first by up to 11 bits are exact.
    const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];
    const TAYLOR: [f64; 14] = [
        1.0,
        1.0,
        1.0 / 2.0,
        1.0 / 6.0,
        1.0 / 24.0,
        1.0 / 120.0,
        1.0 / 720.0,
        1.0 / 5_040.0,
        1.0 / 40_320.0,
        1.0 / 362_880.0,
        1.0 / 3_628_800.0,
        1.0 / 39_916_800.0,
        1.0 / 479_001_600.0,
        1.0 / 6_227_020_800.0,
    ];
    let t = if t > FARTHEST { FARTHEST } else { t };
    let t = if t < -FARTHEST { -FARTHEST } else { t };
    let shifted = t * std::f64::consts::LOG2_E + WHOLE;
    let n = shifted - WHOLE;
    let r = (t - n * LN_2[0]) - n * LN_2[1];
    let mut sum = TAYLOR[13];
    let mut k = 13;
    while k > 0 {
        k -= 1;
        sum = sum * r + TAYLOR[k];
    }
    sum * f64::from_bits(shifted.to_bits().wrapping_add(1023) << 52)
}

widest! {
    fn evaluate_widest(samples: &Samples<'_>, line: &Line, p: &mut [Pack]) -> Sums = evaluate_kernel;
}

/// Everything about one curve. `p` is room for as many values as there are samples.
pub(super) fn evaluate(samples: &Samples<'_>, line: &Line, p: &mut [Pack]) -> Sums {
    evaluate_widest(samples, line, p)
}

#[inline(always)]
fn evaluate_kernel(samples: &Samples<'_>, line: &Line, p: &mut [Pack]) -> Sums {
    let packs = samples.v.len();
    let (v, weight, y, p) = (&samples.v[..packs], &samples.weight[..packs], &samples.y[..packs], &mut p[..packs]);
    let mut total = [0.0; LANES];
    for k in 0..packs {
        for i in 0..LANES {
            let e = exp(line.level + line.rise * (v[k][i] - line.origin));
            p[k][i] = e / (1.0 + e);
            total[i] += p[k][i] * weight[k][i];
        }
    }
    let mean = sum(&total) / samples.count;
    let (mut square, mut product) = ([0.0; LANES], [0.0; LANES]);
    for k in 0..packs {
        for i in 0..LANES {
            let g = (p[k][i] - mean) * weight[k][i];
            square[i] += g * g;
            product[i] += g * y[k][i];
        }
    }
    let square = sum(&square);
    let q = if square > 0.0 { sum(&product) / square } else { 0.0 };
    let (mut residual, mut plain, mut along) = ([0.0; LANES], [[0.0; LANES]; 2], [[0.0; LANES]; 2]);
    let (mut slope, mut squared, mut bend) = ([[0.0; LANES]; 2], [[0.0; LANES]; 3], [[0.0; LANES]; 3]);
    for k in 0..packs {
        // One short loop for each array: these become vectors, and sums of all in one loop don't.
        let (mut g, mut r, mut first, mut second) = ([0.0; LANES], [0.0; LANES], [0.0; LANES], [0.0; LANES]);
        let (mut first_u, mut second_u, mut u) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
        for i in 0..LANES {
            u[i] = v[k][i] - line.origin;
            g[i] = p[k][i] - mean;
            r[i] = (y[k][i] - q * g[i]) * weight[k][i];
            first[i] = p[k][i] * (1.0 - p[k][i]);
            first_u[i] = first[i] * u[i];
            second[i] = r[i] * first[i] * (1.0 - 2.0 * p[k][i]);
            second_u[i] = second[i] * u[i];
        }
        add(&mut plain[0], &first);
        add(&mut plain[1], &first_u);
        add(&mut bend[0], &second);
        add(&mut bend[1], &second_u);
        add_product(&mut bend[2], &second_u, &u);
        add_product(&mut residual, &r, &r);
        add_product(&mut along[0], &g, &first);
        add_product(&mut along[1], &g, &first_u);
        add_product(&mut slope[0], &r, &first);
        add_product(&mut slope[1], &r, &first_u);
        add_product(&mut squared[0], &first, &first);
        add_product(&mut squared[1], &first, &first_u);
        add_product(&mut squared[2], &first_u, &first_u);
    }
    Sums {
        mean,
        square,
        q,
        residual: sum(&residual),
        plain: [sum(&plain[0]), sum(&plain[1])],
        along: [sum(&along[0]), sum(&along[1])],
        slope: [sum(&slope[0]), sum(&slope[1])],
        squared: [sum(&squared[0]), sum(&squared[1]), sum(&squared[2])],
        bend: [sum(&bend[0]), sum(&bend[1]), sum(&bend[2])],
    }
}

#[inline(always)]
fn add(sums: &mut Pack, values: &Pack) {
    for i in 0..LANES {
        sums[i] += values[i];
    }
}

#[inline(always)]
fn add_product(sums: &mut Pack, one: &Pack, other: &Pack) {
    for i in 0..LANES {
        sums[i] += one[i] * other[i];
    }
}

#[inline(always)]
fn sum(lanes: &Pack) -> f64 {
    let [a, b, c, d, e, f, g, h] = *lanes;
    ((a + e) + (c + g)) + ((b + f) + (d + h))
}
