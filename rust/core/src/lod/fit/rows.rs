//! Levels of detail: coarser surfaces, curves of four parameters through samples of a level's quality over its size, and
//! the levels that are enough by them.
//!
//! Liebisch: Perceptual level of detail for head-mounted displays, 2021; y = d + (a−d)/(1+(x/c)^b).

mod carry;
mod collapse;
mod descend;
mod fit;
mod frame;
mod grid;
mod logistic;
mod select;
mod settle;
mod steps;
mod surface;
#[cfg(test)]
mod tests;

use rayon::prelude::*;

use crate::base::{Error, Progress, Result};
pub use carry::{Charts, Place};
pub use collapse::{Given, Vertices, collapse};
pub use fit::{Curve, Status};
pub use frame::Unfit;
pub use select::{Acuity, COLUMNS, Counts, Eye, Glass, Line, Model, Objects, Parameters, Rules, View, select};
pub use surface::{first_alike, pieces};

use fit::Room;
use frame::Frame;

/// Curves of one task.
const TASK: usize = 16;

/// The curves of least squares through rows of `count` samples. `x` is one row, which all share, or has as many as
/// `y`. Samples that are not finite do not count.
pub fn fit_4pl(x: &[f64], y: &[f64], count: usize, progress: &Progress) -> Result<Vec<Curve>> {
    if count == 0 || !y.len().is_multiple_of(count) || x.len() != count && x.len() != y.len() {
        let got = format!("{} of x and {} of y for {count} each", x.len(), y.len());
        return Err(Error::value("x", "as many numbers as y, or one row of them", got));
    }
    let rows = y.len() / count;
    progress.expect(rows as u64);
    let shared = (x.len() == count && rows > 0).then(|| Frame::new(x, |n| x[n].is_finite()));
    let mut curves = vec![Curve::unfit(Unfit::TooFew); rows];
    curves.par_chunks_mut(TASK).enumerate().try_for_each(|(task, curves)| {
        let mut room = Room::default();
        for (n, curve) in curves.iter_mut().enumerate() {
            let row = (task * TASK + n) * count;
            let y = &y[row..row + count];
            let x = if shared.is_some() { x } else { &x[row..row + count] };
            let is_whole = |frame: &Frame| frame.order.iter().all(|&n| y[n].is_finite());
            *curve = match &shared {
                Some(Ok(frame)) if is_whole(frame) => fit::fit(frame, y, &mut room),
                _ => match Frame::new(x, |n| x[n].is_finite() && y[n].is_finite()) {
                    Ok(frame) => fit::fit(&frame, y, &mut room),
                    Err(why) => Curve::unfit(why),
                },
            };
        }
        progress.report(curves.len() as u64)
    })?;
    Ok(curves)
}
