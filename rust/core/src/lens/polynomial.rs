//! Polynomials with coefficients in ascending order of power: values, roots, bounds.

/// Evaluates by Horner's rule.
pub(super) fn value(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

/// Returns the coefficients of the derivative.
pub(super) fn derivative(coefficients: &[f64]) -> Vec<f64> {
    coefficients.iter().enumerate().skip(1).map(|(power, c)| power as f64 * c).collect()
}

/// Returns the smallest zero x > 0 of a polynomial that is positive at 0, within rounding. Double zeros count.
pub(super) fn first_zero(coefficients: &[f64]) -> Option<f64> {
    zeros(coefficients).first().copied()
}

/// Returns all zeros x > 0 of a polynomial, ascending. The polynomial is monotone between neighbouring zeros of its
/// derivative, so each sign change there is exactly one zero, which bisection finds.
fn zeros(coefficients: &[f64]) -> Vec<f64> {
    let degree = coefficients.iter().rposition(|&c| c != 0.0).unwrap_or(0);
    if degree == 0 {
        return Vec::new();
    }
    let coefficients = &coefficients[..=degree];
    let bound = zero_bound(coefficients);
    let extremes = zeros(&derivative(coefficients)).into_iter().filter(|&x| x < bound);
    let (mut zeros, mut start) = (Vec::new(), 0.0);
    for end in extremes.chain([bound]) {
        if sign(coefficients, start) * sign(coefficients, end) < 0.0 {
            zeros.push(bisect(coefficients, start, end));
        } else if sign(coefficients, end) == 0.0 {
            zeros.push(end);
        }
        start = end;
    }
    zeros
}

/// Upper limit of the search for zeros.
const MAX_ZERO: f64 = 1e100;

/// Returns Fujiwara's upper bound of the zeros.
fn zero_bound(coefficients: &[f64]) -> f64 {
    let degree = coefficients.len() - 1;
    let root = |i: usize| (coefficients[i] / coefficients[degree]).abs().powf(1.0 / (degree - i) as f64);
    (2.0 * (0..degree).map(root).fold(f64::MIN_POSITIVE, f64::max)).min(MAX_ZERO)
}

/// Returns the sign of a polynomial's value; 0 if the value may be a rounding error.
fn sign(coefficients: &[f64], x: f64) -> f64 {
    let add = |(sum, size): (f64, f64), c: &f64| (sum * x + c, size * x + c.abs());
    let (value, size) = coefficients.iter().rev().fold((0.0, 0.0), add);
    // The error of Horner's rule is at most 2n roundings of the sum of the terms' absolute values.
    let rounding = coefficients.len() as f64 * f64::EPSILON * size;
    if value.abs() <= rounding && size.is_finite() { 0.0 } else { f64::signum(value) }
}

/// Returns the last float before the sign change between two positions.
fn bisect(coefficients: &[f64], mut low: f64, mut high: f64) -> f64 {
    let sign = value(coefficients, low).signum();
    loop {
        let middle = low + (high - low) * 0.5;
        if middle <= low || middle >= high {
            return low;
        }
        if value(coefficients, middle).signum() == sign { low = middle } else { high = middle }
    }
}

/// Returns bounds of a polynomial's values on [low, high] with low ≥ 0. The sum of the positive terms and that of the
/// negative terms are monotone in x, so their values at the ends bound them. The bounds are tight on short intervals.
pub(super) fn range(coefficients: &[f64], low: f64, high: f64) -> (f64, f64) {
    let part = |sign: f64, x: f64| coefficients.iter().rev().fold(0.0, |sum, c| sum * x + (sign * c).max(0.0));
    (part(1.0, low) - part(-1.0, high), part(1.0, high) - part(-1.0, low))
}

/// Returns an upper bound of a polynomial's absolute value on [low, high], from `range`.
pub(super) fn size(coefficients: &[f64], low: f64, high: f64) -> f64 {
    let (least, greatest) = range(coefficients, low, high);
    least.abs().max(greatest.abs())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Returns the coefficients of the product of (1 − x / root).
    fn from_roots(roots: &[f64]) -> Vec<f64> {
        roots.iter().fold(vec![1.0], |product, root| {
            let mut next = vec![0.0; product.len() + 1];
            for (i, c) in product.iter().enumerate() {
                next[i] += c;
                next[i + 1] -= c / root;
            }
            next
        })
    }

    #[test]
    fn double_zeros_count_and_zero_polynomials_have_none() {
        assert_eq!(first_zero(&[1.0]), None);
        assert_eq!(first_zero(&[1.0, 2.0, 0.0]), None);
        assert_eq!(first_zero(&[1.0, -2.0]), Some(0.5));
        // Rounding moves a double zero by the square root of one rounding: 1.5e-8.
        assert!((first_zero(&[1.0, -2.0, 1.0]).unwrap() - 1.0).abs() < 1e-7);
        assert_eq!(first_zero(&[1.0, -1.999, 1.0]), None);
        // A term that is negligible up to far beyond the first zero does not hide it.
        assert!((first_zero(&[1.0, -0.3, 5e-310]).unwrap() - 10.0 / 3.0).abs() < 1e-14);
    }

    proptest! {
        #[test]
        fn the_first_of_several_zeros_is_found(
            first in 1e-3..1e3f64, others in prop::collection::vec(1.2..50.0f64, 0..4), negative in 0.0..10.0f64,
        ) {
            let mut roots: Vec<f64> = others.iter().map(|factor| first * factor).collect();
            roots.push(first);
            roots.push(-first * (0.1 + negative));
            let found = first_zero(&from_roots(&roots)).unwrap();
            // Rounded coefficients move a zero by its condition number: below 1e5 roundings for gaps of a fifth.
            prop_assert!((found / first - 1.0).abs() < 1e-10, "{found} {first}");
        }

        #[test]
        fn ranges_contain_all_values(
            coefficients in prop::collection::vec(-3.0..3.0f64, 1..6), low in 0.0..2.0f64, width in 0.0..1.0f64,
            share in 0.0..1.0f64,
        ) {
            let (least, greatest) = range(&coefficients, low, low + width);
            let inside = value(&coefficients, low + share * width);
            // Both sides are sums of at most six terms of up to 3 · 3⁵.
            prop_assert!(least - 1e-11 <= inside && inside <= greatest + 1e-11);
        }
    }
}
