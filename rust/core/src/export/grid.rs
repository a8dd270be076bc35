//! Quantisation grid of positions and texture coordinates. Its points are multiples of a power of two, of a larger
//! power for numbers that do not fit into 24 bits. Float32 and the EXPONENTIAL filter of `EXT_meshopt_compression` (per
//! number a signed 24-bit mantissa and an exponent) represent them exactly. Rounding depends only on the number, so
//! equal corners of different meshes stay equal.

/// Maximum mantissa.
const MAX_MANTISSA: i32 = (1 << 23) - 1;

/// Maximum number of steps, so that products of differences are exact in 64 bits.
const MAX_STEPS: i32 = 1 << 29;

/// Exponents of the extension, with a reserve at the end for the larger powers of large numbers.
const EXPONENTS: std::ops::RangeInclusive<i32> = -100..=94;

/// Multiples of 2^exponent; beyond 2²³ steps, of the smallest larger power of two with a mantissa that fits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Grid {
    exponent: i32,
}

impl Grid {
    /// Creates the coarsest grid with a step of at most `step`, a positive number. If numbers up to `reach` do not fit
    /// into it, the grid is coarser.
    pub fn new(step: f64, reach: f64) -> Self {
        let mut grid = Self { exponent: exponent(step).clamp(*EXPONENTS.start(), *EXPONENTS.end()) };
        while grid.exponent < *EXPONENTS.end() && reach > f64::from(MAX_STEPS) * grid.step() {
            grid.exponent += 1;
        }
        grid
    }

    /// Returns the distance between neighbouring points near 0.
    pub fn step(self) -> f64 {
        power(self.exponent)
    }

    /// Returns the maximum error of numbers that round to this many steps.
    pub fn error(self, steps: i32) -> f64 {
        power(self.exponent + shift(steps)) / 2.0
    }

    /// Returns the nearest point as a number of steps, clamped to the grid's range; 0 for NaN.
    #[inline]
    pub fn round(self, x: f64) -> i32 {
        let near = ((x * power(-self.exponent)).round_ties_even() as i32).clamp(-MAX_STEPS, MAX_STEPS);
        if near.unsigned_abs() <= MAX_MANTISSA.unsigned_abs() {
            return near;
        }
        let shift = shift(near);
        ((x * power(-self.exponent - shift)).round_ties_even() as i32).clamp(-(MAX_STEPS >> shift), MAX_STEPS >> shift)
            << shift
    }

    /// Returns the value of a point.
    #[inline]
    pub fn value(self, steps: i32) -> f32 {
        (f64::from(steps) * self.step()) as f32
    }

    /// Returns a point in the EXPONENTIAL filter's format: exponent in the upper 8 bits, mantissa in the lower 24.
    #[inline]
    pub fn pack(self, steps: i32) -> u32 {
        let shift = shift(steps);
        ((self.exponent + shift) as u32) << 24 | ((steps >> shift) as u32 & 0x00ff_ffff)
    }
}

/// Returns the number of low bits that do not fit into the mantissa. `Grid::round` makes them 0.
#[inline]
fn shift(steps: i32) -> i32 {
    (9 - steps.unsigned_abs().leading_zeros() as i32).max(0)
}

/// Returns the exponent of the largest power of two not above a positive, normal number.
fn exponent(x: f64) -> i32 {
    (x.to_bits() >> 52) as i32 - 1023
}

/// Returns 2^exponent, for exponents of normal numbers.
#[inline]
fn power(exponent: i32) -> f64 {
    f64::from_bits(((exponent + 1023) as u64) << 52)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random::uniform;

    #[test]
    fn steps_are_sufficient_powers_of_two() {
        let step = |step, reach| Grid::new(step, reach).step();
        assert_eq!(step(1.0, 0.0), 1.0);
        assert_eq!(step(0.9, 0.0), 0.5);
        assert_eq!(step(1.0 / 1024.0, 524_288.0), 1.0 / 1024.0);
        assert_eq!(step(1.0 / 1024.0, 524_289.0), 1.0 / 512.0);
        assert_eq!(step(1.0, f64::MAX), power(94));
    }

    #[test]
    fn points_survive_the_filter_bit_for_bit_and_are_near() {
        let grid = Grid::new(1.0 / 1024.0, 0.0);
        let ends = [0.0, -8191.999, 8191.9995, 8192.0, 16383.9999, -524_288.0, 0.4999 / 1024.0, 1e30];
        let random = (0..10_000).map(|i| (2.0 * uniform(1, 0, i) - 1.0) * 10f64.powf(6.0 * uniform(1, 1, i) - 0.3));
        for x in ends.into_iter().chain(random).map(|x| x.clamp(-524_288.0, 524_288.0)) {
            let steps = grid.round(x);
            let mut packed = [[grid.pack(steps)]];
            meshopt::decode_filter_exp(&mut packed);
            let value = f32::from_bits(packed[0][0]);
            assert_eq!(value, grid.value(steps), "{x}");
            assert!((f64::from(value) - x).abs() <= grid.error(steps), "{x}");
        }
        assert_eq!((grid.error(8_388_607), grid.error(-8_388_608)), (power(-11), power(-10)));
        assert_eq!((grid.round(f64::INFINITY), grid.round(f64::NAN)), (MAX_STEPS, 0));
    }
}
