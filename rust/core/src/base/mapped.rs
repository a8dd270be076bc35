//! Cancellable maps and filters over long arrays.

use rayon::prelude::*;

use super::{Progress, Result};

/// Rows between two checks for cancellation: a few milliseconds of work.
const ROWS_PER_CHECK: usize = 1 << 20;

/// Number of rows that one thread maps faster than it takes to wake the others.
const SHORT: usize = 1 << 13;

/// Applies `of` to each row; the values keep the rows' order.
pub fn mapped<A: Sync, B: Send>(rows: &[A], of: impl Fn(&A) -> B + Sync, progress: &Progress) -> Result<Vec<B>> {
    let mut values = Vec::with_capacity(rows.len());
    if rows.len() <= SHORT {
        progress.check()?;
        values.extend(rows.iter().map(of));
        return Ok(values);
    }
    for part in rows.chunks(ROWS_PER_CHECK) {
        progress.check()?;
        values.par_extend(part.par_iter().map(&of));
    }
    Ok(values)
}

/// Returns the chosen numbers below `count`, ascending.
pub fn filtered(count: u32, is_chosen: impl Fn(u32) -> bool + Sync, progress: &Progress) -> Result<Vec<u32>> {
    let mut chosen = Vec::new();
    for start in (0..count).step_by(ROWS_PER_CHECK) {
        progress.check()?;
        let end = count.min(start.saturating_add(ROWS_PER_CHECK as u32));
        chosen.par_extend((start..end).into_par_iter().filter(|&number| is_chosen(number)));
    }
    Ok(chosen)
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
