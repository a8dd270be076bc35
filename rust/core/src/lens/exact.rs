//! f(r) = r (1 + k₁r² + k₂r⁴ + …) with twice the precision of float64. Near a fold, and where terms cancel, float64
//! alone has an error of many roundings, and a root found with it has an even larger error.
//!
//! Error-free sums are Knuth's, error-free products Dekker's or, with the same bits, a fused multiply-add.

/// Returns a + b, rounded, and the rounding error.
#[inline(always)]
pub(super) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}

/// Returns a · b, rounded, and the rounding error.
#[inline(always)]
pub(super) fn two_product<const FUSED: bool>(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    if FUSED {
        return (product, a.mul_add(b, -product));
    }
    let ((ah, al), (bh, bl)) = (halves(a), halves(b));
    (product, ((ah * bh - product) + ah * bl + al * bh) + al * bl)
}

/// Returns two floats of 26 bits each whose sum is `a` (Veltkamp's split).
#[inline(always)]
fn halves(a: f64) -> (f64, f64) {
    const FACTOR: f64 = 134_217_729.0; // 2²⁷ + 1
    let large = FACTOR * a;
    let high = large - (large - a);
    (high, a - high)
}

/// Returns f(r), rounded, and the rounding error.
#[inline(always)]
pub(super) fn distort<const FUSED: bool>(k: &[f64], r: f64) -> (f64, f64) {
    let (square, square_error) = two_product::<FUSED>(r, r);
    let (mut high, mut error) = (0.0, 0.0);
    for n in (0..k.len()).rev() {
        let (sum, sum_error) = two_sum(high, k[n]);
        let (product, product_error) = two_product::<FUSED>(sum, square);
        error = product_error + (sum * square_error + (error + sum_error) * square);
        high = product;
    }
    let (sum, sum_error) = two_sum(high, 1.0);
    let (product, product_error) = two_product::<FUSED>(sum, r);
    (product, product_error + (error + sum_error) * r)
}

/// Returns f(r) − x, correct to one rounding unless it is smaller than 10⁻³⁰ times the terms of f.
pub(super) fn residual(k: &[f64], r: f64, x: f64) -> f64 {
    let (high, error) = distort::<false>(k, r);
    (high - x) + error
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn both_products_have_the_same_bits(a in -1e90..1e90f64, b in -1e3..1e3f64, k in -1.0..1.0f64, r in 0.0..9.0f64) {
            prop_assert_eq!(two_product::<true>(a, b), two_product::<false>(a, b));
            prop_assert_eq!(distort::<true>(&[k, a], r), distort::<false>(&[k, a], r));
        }

        #[test]
        fn integers_are_exact(k in -20..20i64, l in -20..20i64, r in 0..1000i64) {
            let expected = i128::from(r) + i128::from(k * r.pow(3)) + i128::from(l) * i128::from(r).pow(5);
            let (high, error) = distort::<false>(&[k as f64, l as f64], r as f64);
            prop_assert_eq!(high as i128 + error as i128, expected);
        }
    }
}
