//! A stable, cancellable sort. Sorts of other crates cannot be cancelled, and take seconds for more than 10⁷ values.

use super::memory::try_copy;
use super::{Progress, Result};

/// Values sorted or merged between two checks for cancellation.
const VALUES_PER_CHECK: usize = 1 << 16;

/// Maps a float64 to an integer with the same order: IEEE 754's total order.
pub fn total_order(value: f64) -> i64 {
    let bits = value.to_bits() as i64;
    // Flips all bits of negative numbers except the sign.
    bits ^ ((bits >> 63) as u64 >> 1) as i64
}

/// Sorts values by a key on the current thread pool. Values with equal keys keep their order.
pub fn sort_by_key<T: Copy + Send + Sync, K: Ord>(
    values: &mut [T],
    key: impl Fn(&T) -> K + Sync,
    progress: &Progress,
) -> Result<()> {
    let mut copy = if values.len() > VALUES_PER_CHECK { try_copy(values)? } else { vec![] };
    sort(values, &mut copy, &key, progress)
}

/// Sorts `values`. If there are more than `VALUES_PER_CHECK`, `copy` must hold the same values; it is overwritten.
fn sort<T: Copy + Send + Sync, K: Ord>(
    values: &mut [T],
    copy: &mut [T],
    key: &(impl Fn(&T) -> K + Sync),
    progress: &Progress,
) -> Result<()> {
    if values.len() <= VALUES_PER_CHECK {
        values.sort_by_key(key);
        return progress.check();
    }
    let middle = values.len() / 2;
    let ((a, b), (c, d)) = (values.split_at_mut(middle), copy.split_at_mut(middle));
    let (first, second) = rayon::join(|| sort(c, a, key, progress), || sort(d, b, key, progress));
    first.and(second)?;
    merge([c, d], values, key, progress)
}

/// Merges two sorted parts; values of the first part come first among equal keys.
fn merge<T: Copy + Send + Sync, K: Ord>(
    [a, b]: [&[T]; 2],
    to: &mut [T],
    key: &(impl Fn(&T) -> K + Sync),
    progress: &Progress,
) -> Result<()> {
    if to.len() <= VALUES_PER_CHECK {
        merge_run([a, b], to, key);
        return progress.check();
    }
    // Splits the longer part in half, and the other part at the value where the second half begins.
    let (i, j) = if a.len() >= b.len() {
        let pivot = key(&a[a.len() / 2]);
        (a.len() / 2, b.partition_point(|value| key(value) < pivot))
    } else {
        let pivot = key(&b[b.len() / 2]);
        (a.partition_point(|value| key(value) <= pivot), b.len() / 2)
    };
    let (first, second) = to.split_at_mut(i + j);
    let (first, second) = rayon::join(
        || merge([&a[..i], &b[..j]], first, key, progress),
        || merge([&a[i..], &b[j..]], second, key, progress),
    );
    first.and(second)
}

fn merge_run<T: Copy, K: Ord>([mut a, mut b]: [&[T]; 2], to: &mut [T], key: &impl Fn(&T) -> K) {
    for slot in to {
        let source = match (a.first(), b.first()) {
            (Some(next_a), Some(next_b)) if key(next_b) < key(next_a) => &mut b,
            (Some(_), _) => &mut a,
            _ => &mut b,
        };
        if let Some((next, remaining)) = source.split_first() {
            (*slot, *source) = (*next, remaining);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random;

    #[test]
    fn values_are_sorted_and_equal_ones_keep_their_order() {
        for count in [0, 1, 2, VALUES_PER_CHECK, VALUES_PER_CHECK + 1, 5 * VALUES_PER_CHECK + 3] {
            for keys in [1.0, 7.0, 1e9] {
                let draw = |i: u64| ((random::uniform(1, count as u64, i) * keys) as u32, i);
                let mut values: Vec<(u32, u64)> = (0..count as u64).map(draw).collect();
                let mut expected = values.clone();
                expected.sort_by_key(|value| value.0);
                sort_by_key(&mut values, |value| value.0, &Progress::new()).unwrap();
                assert!(values == expected, "{count} {keys}");
                sort_by_key(&mut values, |value| value.0, &Progress::new()).unwrap();
                assert!(values == expected, "{count} {keys}, sorted before");
            }
        }
    }

    #[test]
    fn floats_have_their_total_order() {
        let values = [-f64::NAN, f64::NEG_INFINITY, -1.0, -f64::MIN_POSITIVE, -0.0, 0.0, 1e-300, 2.0, f64::NAN];
        assert!(values.is_sorted_by(|&a, &b| total_order(a) < total_order(b)));
    }

    #[test]
    fn a_cancelled_sort_ends() {
        let progress = Progress::new();
        progress.cancel();
        for count in [3, 3 * VALUES_PER_CHECK] {
            assert_eq!(sort_by_key(&mut vec![1; count], |&value| value, &progress), Err(crate::base::Error::Cancelled));
        }
    }
}
