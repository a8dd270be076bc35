//! Cancellable maps and filters over long arrays, splitting of arrays into consecutive pieces, and bits of masks.

use std::ops::Range;

use rayon::prelude::*;

use super::memory::{try_grow, try_with_capacity};
use super::{Progress, Result};

/// Rows between two checks for cancellation: a few milliseconds of work.
const ROWS_PER_CHECK: usize = 1 << 20;

/// Rows per task of `write_mapped`.
const ROWS_PER_TASK: usize = 1 << 14;

/// Maximum number of rows that one thread maps alone: it finishes before other threads would have woken up.
const MAX_SEQUENTIAL_ROWS: usize = 1 << 13;

/// Applies a function to each row; the values keep the rows' order.
pub fn mapped<A: Sync, B: Send>(rows: &[A], map: impl Fn(&A) -> B + Sync, progress: &Progress) -> Result<Vec<B>> {
    let mut values = try_with_capacity(rows.len())?;
    if rows.len() <= MAX_SEQUENTIAL_ROWS {
        progress.check()?;
        values.extend(rows.iter().map(map));
        return Ok(values);
    }
    for part in rows.chunks(ROWS_PER_CHECK) {
        progress.check()?;
        values.par_extend(part.par_iter().map(&map));
    }
    Ok(values)
}

/// Applies a function to each row and writes the value to the row's slot.
pub fn write_mapped<A: Sync, B: Send>(
    rows: &[A],
    slots: &mut [B],
    map: impl Fn(&A) -> B + Sync,
    progress: &Progress,
) -> Result<()> {
    rows.par_chunks(ROWS_PER_TASK).zip(slots.par_chunks_mut(ROWS_PER_TASK)).try_for_each(|(rows, slots)| {
        slots.iter_mut().zip(rows).for_each(|(slot, row)| *slot = map(row));
        progress.check()
    })
}

/// Returns the numbers below `count` that satisfy a condition, ascending.
pub fn filtered(count: u32, condition: impl Fn(u32) -> bool + Sync, progress: &Progress) -> Result<Vec<u32>> {
    let mut numbers = Vec::new();
    for start in (0..count).step_by(ROWS_PER_CHECK) {
        progress.check()?;
        let end = count.min(start.saturating_add(ROWS_PER_CHECK as u32));
        try_grow(&mut numbers, (end - start) as usize)?;
        numbers.par_extend((start..end).into_par_iter().filter(|&number| condition(number)));
    }
    Ok(numbers)
}

/// Runs a task for each range of `size` numbers below `count`. Returns the results in order, or the error of the first
/// range that fails, independent of the number of threads.
pub fn in_ranges<T: Send>(
    count: usize,
    size: usize,
    task: impl Fn(Range<usize>) -> Result<T> + Sync,
) -> Result<Vec<T>> {
    let starts = (0..count.div_ceil(size)).into_par_iter().map(|number| number * size);
    let results: Vec<Result<T>> = starts.map(|start| task(start..count.min(start + size))).collect();
    results.into_iter().collect()
}

/// Splits an array into consecutive pieces of the given lengths.
pub fn pieces<T>(mut remaining: &mut [T], lengths: impl Iterator<Item = usize>) -> Vec<&mut [T]> {
    let split = |length| {
        let (piece, others) = std::mem::take(&mut remaining).split_at_mut(length);
        remaining = others;
        piece
    };
    lengths.map(split).collect()
}

/// Returns the start indices of consecutive pieces of the given lengths.
pub fn starts(lengths: impl Iterator<Item = usize>) -> impl Iterator<Item = usize> {
    lengths.scan(0, |next, length| {
        let start = *next;
        *next += length;
        Some(start)
    })
}

/// Returns the numbers of the set bits, ascending.
#[inline]
pub fn set_bits(mut bits: u64) -> impl Iterator<Item = u32> {
    std::iter::from_fn(move || {
        let number = (bits != 0).then(|| bits.trailing_zeros())?;
        bits &= bits - 1;
        Some(number)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::Error;

    #[test]
    fn order_stays_across_checks() {
        let count = 2 * ROWS_PER_CHECK as u32 + 3;
        let chosen = filtered(count, |number| number % 3 == 0, &Progress::new()).unwrap();
        assert!(chosen.iter().copied().eq((0..count).step_by(3)));
        let tripled = mapped(&chosen, |&number| u64::from(number) * 3, &Progress::new()).unwrap();
        assert!(tripled.into_iter().eq((0..u64::from(count)).step_by(3).map(|number| number * 3)));
    }

    #[test]
    fn a_cancelled_array_is_an_error() {
        let progress = Progress::new();
        progress.cancel();
        assert_eq!(filtered(3, |_| true, &progress), Err(Error::Cancelled));
        assert_eq!(mapped(&[1, 2], |&row| row, &progress), Err(Error::Cancelled));
    }
}
