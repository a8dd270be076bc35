//! Fits of many curves, one per row of samples.

use rayon::prelude::*;

use super::curve::{FitScratch, LogisticCurve, fit};
use super::frame::{SampleFrame, Unfit};
use crate::base::{Error, Progress, Result};

/// Number of curves in one task.
const TASK: usize = 16;

/// Fits least-squares curves to rows of `count` samples. `x` is one row shared by all curves, or has as many numbers
/// as `y`. Samples that are not finite are ignored.
pub fn fit_4pl(x: &[f64], y: &[f64], count: usize, progress: &Progress) -> Result<Vec<LogisticCurve>> {
    if count == 0 || !y.len().is_multiple_of(count) || x.len() != count && x.len() != y.len() {
        let got = format!("{} of x and {} of y for {count} each", x.len(), y.len());
        return Err(Error::value("x", "as many numbers as y, or one row of them", got));
    }
    let rows = y.len() / count;
    progress.expect(rows as u64);
    let shared_frame =
        (x.len() == count && rows > 0).then(|| SampleFrame::new(x, |n| x[n].is_finite(), progress)).transpose()?;
    let mut curves = vec![LogisticCurve::unfit(Unfit::TooFew); rows];
    curves.par_chunks_mut(TASK).enumerate().try_for_each(|(task, curves)| {
        let mut scratch = FitScratch::default();
        for (n, curve) in curves.iter_mut().enumerate() {
            let first = (task * TASK + n) * count;
            let y = &y[first..first + count];
            let x = if shared_frame.is_some() { x } else { &x[first..first + count] };
            let has_finite_y = |frame: &SampleFrame| frame.order.iter().all(|&n| y[n].is_finite());
            *curve = match &shared_frame {
                Some(Ok(frame)) if has_finite_y(frame) => fit(frame, y, &mut scratch, progress)?,
                _ => match SampleFrame::new(x, |n| x[n].is_finite() && y[n].is_finite(), progress)? {
                    Ok(frame) => fit(&frame, y, &mut scratch, progress)?,
                    Err(reason) => LogisticCurve::unfit(reason),
                },
            };
        }
        progress.report(curves.len() as u64)
    })?;
    Ok(curves)
}
