//! Samples of a curve in the coordinate v: ln x, shifted and scaled to the range −1 to 1.

use super::descend::Limits;
use super::grid::CurveGrid;
use super::logistic::{LANES, Pack};
use crate::base::memory::room_for_values;
use crate::base::sort::{sort_by_key, total_order};
use crate::base::{Progress, Result};

/// v of x = 0: far enough to lie on a plateau for every allowed rise, and with a finite square.
const ZERO: f64 = -1e30;
/// Minimum number of distinct x, the number of parameters.
pub(super) const MIN_DISTINCT: usize = 4;
/// Maximum distance of ln c from the middle of the samples, so that c is finite.
const FARTHEST_LN: f64 = 600.0;
/// Product of rise and gap at which the samples on both sides of a transition lie on the plateaus to 17 digits.
const SATURATED: f64 = 80.0;

/// Numbers per sample in all arrays of a frame and a fit; the capacity of a growing vector is up to twice its length.
const ARRAYS: usize = 16;

/// Reason why no curve can be fitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unfit {
    /// Fewer than four distinct x have finite values.
    TooFew,
    /// An x is negative.
    Negative,
    /// The parameters exceed the range of float64.
    Overflow,
}

/// Samples used for the fit, sorted by x.
#[derive(Debug)]
pub(super) struct SampleFrame {
    /// Indices of the samples, by ascending x.
    pub(super) order: Vec<usize>,
    pub(super) v: Vec<Pack>,
    pub(super) weight: Vec<Pack>,
    /// End in `order` of each run of equal x.
    pub(super) ends: Vec<usize>,
    /// v of each run.
    pub(super) positions: Vec<f64>,
    pub(super) limits: Limits,
    pub(super) grid: CurveGrid,
    /// v = (ln(x/unit) − middle) / half.
    unit: f64,
    middle: f64,
    half: f64,
}

impl SampleFrame {
    /// Creates a frame of the samples for which `is_included` is true; their x must be finite.
    pub(super) fn new(
        x: &[f64],
        is_included: impl Fn(usize) -> bool,
        progress: &Progress,
    ) -> Result<std::result::Result<Self, Unfit>> {
        room_for_values::<[f64; ARRAYS]>(x.len())?;
        let mut order: Vec<usize> = (0..x.len()).filter(|&n| is_included(n)).collect();
        sort_by_key(&mut order, |&n| total_order(x[n]), progress)?;
        if order.first().is_some_and(|&n| x[n] < 0.0) {
            return Ok(Err(Unfit::Negative));
        }
        let positive: Vec<f64> = order.iter().map(|&n| x[n]).filter(|&x| x > 0.0).collect();
        let [Some(&least), Some(&greatest)] = [positive.first(), positive.last()] else {
            return Ok(Err(Unfit::TooFew));
        };
        let unit = (0.5 * (least.ln() + greatest.ln())).exp();
        let [low, high] = [least, greatest].map(|x| ln_ratio(x, unit));
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        if half <= 0.0 {
            return Ok(Err(Unfit::TooFew));
        }
        let place = |x: f64| if x > 0.0 { (ln_ratio(x, unit) - middle) / half } else { ZERO };
        let sorted: Vec<f64> = order.iter().map(|&n| place(x[n])).collect();
        progress.check()?;
        let ends: Vec<usize> = (1..=sorted.len()).filter(|&n| n == sorted.len() || sorted[n] > sorted[n - 1]).collect();
        let positions: Vec<f64> = ends.iter().map(|&end| sorted[end - 1]).collect();
        if positions.len() < MIN_DISTINCT {
            return Ok(Err(Unfit::TooFew));
        }
        let narrowest = positions.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
        let limits = Limits { steepest: SATURATED / narrowest, farthest: FARTHEST_LN / half };
        let packed = |value: &dyn Fn(usize) -> f64| -> Vec<Pack> {
            (0..sorted.len().div_ceil(LANES)).map(|k| std::array::from_fn(|i| value(LANES * k + i))).collect()
        };
        progress.check()?;
        // Padding is at the v of x = 0, where p′ is 0, so only sums of p need weights.
        let v = packed(&|n| sorted.get(n).copied().unwrap_or(ZERO));
        let weight = packed(&|n| if n < sorted.len() { 1.0 } else { 0.0 });
        let grid = CurveGrid::new(&sorted, &ends, &positions);
        Ok(Ok(Self { order, v, weight, ends, positions, limits, grid, unit, middle, half }))
    }

    /// Returns x at a given v.
    pub(super) fn x(&self, v: f64) -> f64 {
        self.unit * (self.middle + self.half * v).exp()
    }

    /// Converts a rise over v to a rise over ln x.
    pub(super) fn over_ln(&self, rise: f64) -> f64 {
        rise / self.half
    }
}

/// Returns ln(x/unit), with full precision even if x is close to `unit`.
fn ln_ratio(x: f64, unit: f64) -> f64 {
    if x > 0.5 * unit && x < 2.0 * unit { ((x - unit) / unit).ln_1p() } else { x.ln() - unit.ln() }
}
