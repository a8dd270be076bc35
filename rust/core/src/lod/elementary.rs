//! Exponential function and logarithm in basic arithmetic, which the compiler can vectorise. Without fused operations
//! they return the same bits on every machine.

use crate::base::Real;

/// Maximum |t|. Beyond about 709 the exponential overflows; at 700 the logistic function is 0 or 1 to 300 digits.
const FARTHEST: f64 = 700.0;

/// 1.5 · 2⁵². Adding it to a number leaves the nearest integer in the low bits.
const TO_INTEGER: f64 = 6_755_399_441_055_744.0;
/// ln 2 as the sum of two parts. Products of the first part and integers of up to 11 bits are exact.
const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];

/// Returns e^t with an error of at most 2 ulp; t is clamped to ±700. With t = n ln 2 + r and |r| ≤ ln 2/2, the result
/// is 2ⁿ e^r, and the first omitted term of the Taylor series of e^r is below 2⁻⁵⁷.
#[inline(always)]
pub(super) fn exp<const FUSED: bool>(t: f64) -> f64 {
    /// 1/n!
    const TAYLOR: [f64; 14] = {
        let (mut terms, mut factorial, mut n) = ([1.0; 14], 1.0, 1);
        while n < 14 {
            factorial *= n as f64;
            terms[n] = 1.0 / factorial;
            n += 1;
        }
        terms
    };
    let t = if t > FARTHEST { FARTHEST } else { t };
    let t = if t < -FARTHEST { -FARTHEST } else { t };
    let fuse = f64::fuse::<FUSED>;
    let shifted = fuse(t, std::f64::consts::LOG2_E, TO_INTEGER);
    let n = shifted - TO_INTEGER;
    let r = fuse(-n, LN_2[1], fuse(-n, LN_2[0], t));
    polynomial::<FUSED, 14>(&TAYLOR, r) * f64::from_bits(shifted.to_bits().wrapping_add(1023) << 52)
}

/// Evaluates a polynomial with coefficients in ascending order of power.
#[inline(always)]
fn polynomial<const FUSED: bool, const COUNT: usize>(coefficients: &[f64; COUNT], x: f64) -> f64 {
    let (mut sum, mut n) = (coefficients[COUNT - 1], COUNT - 1);
    while n > 0 {
        n -= 1;
        sum = f64::fuse::<FUSED>(sum, x, coefficients[n]);
    }
    sum
}

/// Returns ln x for 0 ≤ x < ∞, with an error of at most 3 ulp. With x = 2ⁿ m, √½ ≤ m < √2 and s = (m − 1)/(m + 1), it
/// is n ln 2 + 2 (s + s³/3 + s⁵/5 + …). |s| is below 0.172; the first omitted term is below 2⁻⁵⁷ of the first.
#[inline(always)]
pub(super) fn ln<const FUSED: bool>(x: f64) -> f64 {
    /// Factor that scales subnormal numbers to normal ones.
    const LIFT: f64 = (1u64 << 54) as f64;
    /// Difference of the bits of 1 and √½. Adding it to the bits of x makes the top bits the exponent n.
    const FROM_ROOT: u64 = 1.0f64.to_bits() - std::f64::consts::FRAC_1_SQRT_2.to_bits();
    /// 1/(2n+1)
    const SERIES: [f64; 11] = {
        let (mut terms, mut n) = ([1.0; 11], 0);
        while n < 11 {
            terms[n] = 1.0 / (2 * n + 1) as f64;
            n += 1;
        }
        terms
    };
    let is_small = x < f64::MIN_POSITIVE;
    let lifted = if is_small { x * LIFT } else { x };
    let exponent = (lifted.to_bits() + FROM_ROOT) >> 52;
    let m = f64::from_bits(lifted.to_bits().wrapping_sub(exponent << 52).wrapping_add(1.0f64.to_bits()));
    let n = f64::from_bits(exponent.wrapping_add(TO_INTEGER.to_bits())) - (TO_INTEGER + 1023.0);
    let n = if is_small { n - 54.0 } else { n };
    let s = (m - 1.0) / (m + 1.0);
    let logarithm = n * LN_2[0] + (n * LN_2[1] + 2.0 * (s * polynomial::<FUSED, 11>(&SERIES, s * s)));
    if x > 0.0 { logarithm } else { f64::NEG_INFINITY }
}

#[cfg(test)]
mod tests {
    use super::{exp, ln};

    fn check_exp<const FUSED: bool>() {
        for n in -14_000..=14_000 {
            let t = f64::from(n) * 0.049_987;
            let (found, expected) = (exp::<FUSED>(t), t.exp());
            // Two roundings of n ln 2 and one for each of the last terms: below 2 ulp; libm's own error is 1 ulp.
            assert!((found / expected - 1.0).abs() <= 3.0 * f64::EPSILON, "{t}: {found} {expected}");
        }
        assert_eq!(exp::<FUSED>(0.0), 1.0);
        assert!(exp::<FUSED>(f64::NEG_INFINITY) > 0.0 && exp::<FUSED>(f64::INFINITY).is_finite());
    }

    fn check_ln<const FUSED: bool>() {
        let places = (-1022..1023).flat_map(|n| (0..16).map(move |k| 2f64.powi(n) * (1.0 + f64::from(k) / 15.99)));
        let near_one = (-100..=100).map(|n| 1.0 + f64::from(n) * 1e-5);
        for x in places.chain(near_one).chain([f64::from_bits(1), 3e-320, f64::MAX]) {
            let (found, expected) = (ln::<FUSED>(x), x.ln());
            // s has three roundings, the sum and its product one each; libm's own error is 1 ulp.
            assert!((found - expected).abs() <= 4.0 * f64::EPSILON * expected.abs(), "{x:e}: {found} {expected}");
        }
        assert_eq!(ln::<FUSED>(1.0), 0.0);
        assert_eq!(ln::<FUSED>(0.0), f64::NEG_INFINITY);
    }

    #[test]
    fn exponentials_have_their_digits() {
        check_exp::<false>();
        check_exp::<true>();
    }

    #[test]
    fn logarithms_have_their_digits() {
        check_ln::<false>();
        check_ln::<true>();
    }
}
