//! Piecewise cubic table of f⁻¹, with an error bound.
//!
//! Nodes are floats whose mantissas end in zeros. So the high bits of x are the number of its interval, and the low
//! bits its position in the interval. The distance between nodes grows with x, while the curvature of f⁻¹ falls.

use super::polynomial::{derivative, range, size};
use super::solve::Radial;

/// Maximum relative error of the table. For a headset's radii, up to 2, the error is then at most 10⁻⁹.
const TOLERANCE: f64 = 5e-10;
/// Maximum relative error of start values for Newton's method, which the table gives beyond `end`.
const START_TOLERANCE: f64 = 1e-5;
/// Range of log₂ x, relative to the lens's unit, that has nodes. One interval lies below it.
const OCTAVES: std::ops::Range<i32> = -8..4;
/// log₂ of the number of intervals per octave. The smallest number that meets the tolerance is used.
const FINENESS: std::ops::RangeInclusive<u32> = 5..=9;
/// Radius up to which a table should meet its tolerance: fraction of r_max or, without a fold, multiple of the unit.
const REQUIRED_RANGE: (f64, f64) = (0.9, 4.0);

const MANTISSA: u32 = f64::MANTISSA_DIGITS - 1;

/// Piecewise cubic approximation of f⁻¹.
#[derive(Clone, Debug)]
pub(super) struct Table {
    /// c₀ + t (c₁ + t (c₂ + t c₃)) for t from 0 to 1 in each interval; at least one.
    pub cubics: Vec<[f64; 4]>,
    /// End of the first interval, a power of two.
    pub first: f64,
    /// Bits of `first`, shifted. The interval that begins at `first` has number 1.
    pub base: u64,
    /// Right shift that turns the bits of x into an interval number.
    pub shift: u32,
    /// End of the range of x in which the error is at most START_TOLERANCE.
    pub start_end: f64,
    /// End of the range of x in which the error is at most TOLERANCE.
    pub end: f64,
    /// Upper bound of the relative error of all cubics below `end`.
    pub bound: f64,
}

impl Table {
    /// Creates a table with the number of nodes that the tolerance requires.
    pub fn new(lens: &Radial) -> Self {
        let (fraction, multiple) = REQUIRED_RANGE;
        let end = lens.distort(if lens.r_max.is_finite() { fraction * lens.r_max } else { multiple * lens.unit });
        let mut table = Self::with_fineness(lens, *FINENESS.start());
        for fineness in FINENESS.skip(1) {
            if table.end >= end.min(table.start_end) {
                break;
            }
            table = Self::with_fineness(lens, fineness);
        }
        table
    }

    fn with_fineness(lens: &Radial, fineness: u32) -> Self {
        let scale = lens.unit.log2().floor() as i32;
        let first = f64::powi(2.0, scale + OCTAVES.start);
        let last = f64::powi(2.0, scale + OCTAVES.end).min(lens.x_max);
        let shift = MANTISSA - fineness;
        let base = first.to_bits() >> shift;
        let mut table = Self { cubics: Vec::new(), first, base, shift, start_end: 0.0, end: 0.0, bound: 0.0 };
        let derivatives = Derivatives::new(lens);
        let mut from = InverseNode::new(lens, 0.0);
        for number in 0u64.. {
            let x = f64::from_bits((base + number) << shift);
            if x > last {
                break;
            }
            let to = InverseNode::new(lens, x);
            let bound = derivatives.bound(&from, &to);
            if bound > START_TOLERANCE || !bound.is_finite() {
                break;
            }
            if table.end == from.x && bound <= TOLERANCE {
                table.end = x;
                table.bound = table.bound.max(bound);
            }
            table.cubics.push(cubic(&from, &to));
            table.start_end = x;
            from = to;
        }
        if table.cubics.is_empty() {
            // Kernels always read a cubic, but ignore its value because `end` is 0.
            table.cubics.push([0.0; 4]);
        }
        table
    }
}

/// Value and slope of f⁻¹ at a node.
struct InverseNode {
    x: f64,
    r: f64,
    slope: f64,
}

impl InverseNode {
    fn new(lens: &Radial, x: f64) -> Self {
        let r = lens.undistort(x);
        Self { x, r, slope: 1.0 / lens.derivative(r) }
    }
}

/// Returns the Hermite cubic between two nodes.
fn cubic(start: &InverseNode, end: &InverseNode) -> [f64; 4] {
    let (width, rise) = (end.x - start.x, end.r - start.r);
    let (start_slope, end_slope) = (width * start.slope, width * end.slope);
    [start.r, start_slope, 3.0 * rise - 2.0 * start_slope - end_slope, start_slope + end_slope - 2.0 * rise]
}

/// Derivatives f′ to f⁗ as polynomials in r.
struct Derivatives([Vec<f64>; 4]);

impl Derivatives {
    fn new(lens: &Radial) -> Self {
        let first = derivative(&lens.coefficients());
        let second = derivative(&first);
        let third = derivative(&second);
        let fourth = derivative(&third);
        Self([first, second, third, fourth])
    }

    /// Returns the maximum relative error of the Hermite cubic: x² (h−x)² max |g⁗| / 24 with g = f⁻¹ and h the
    /// interval's width, plus four roundings of the result. g⁗ = −(15 f″³ − 10 f′f″f‴ + f′²f⁗) / f′⁷.
    fn bound(&self, from: &InverseNode, to: &InverseNode) -> f64 {
        let Self([first, second, third, fourth]) = self;
        // The interval is widened by more than the nodes' rounding error.
        let (low, high) = (from.r * (1.0 - 1e-14), to.r * (1.0 + 1e-14));
        let steepness = size(first, low, high);
        let (two, three, four) = (size(second, low, high), size(third, low, high), size(fourth, low, high));
        let numerator = 15.0 * two.powi(3) + 10.0 * steepness * two * three + steepness * steepness * four;
        let denominator = range(first, low, high).0.max(0.0).powi(7);
        let width = to.x - from.x;
        // The error relative to r: x² (h−x)² is at most h⁴/16, and r is at least that of the first node. For an
        // interval from zero, x² (h−x)²/x is at most 4h³/27, and r ≥ x / max f′.
        let factor = if from.x > 0.0 { width.powi(4) / 16.0 / from.r } else { 4.0 / 27.0 * width.powi(3) * steepness };
        factor / 24.0 * numerator / denominator + 4.0 * f64::EPSILON
    }
}
