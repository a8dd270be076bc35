//! Random numbers as a pure function of (seed, cell, index). There is no state, so results depend neither on the order
//! of draws nor on the number of threads.
//!
//! The mixing function is SplitMix64's finaliser (Steele, Lea, Flood: Fast splittable pseudorandom number generators,
//! 2014); it runs after each word is combined with the state.

use super::mapped::write_mapped;
use super::{Progress, Result};

/// 2⁶⁴ divided by the golden ratio.
const GOLDEN: u64 = 0x9E37_79B9_7F4A_7C15;

fn mix(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

/// Returns 64 random bits for one draw.
pub fn bits(seed: u64, cell: u64, index: u64) -> u64 {
    [cell, index].iter().fold(mix(seed.wrapping_add(GOLDEN)), |state, &word| mix((state ^ word).wrapping_add(GOLDEN)))
}

/// Returns a float64 in [0, 1) with 53 random bits.
pub fn uniform(seed: u64, cell: u64, index: u64) -> f64 {
    (bits(seed, cell, index) >> 11) as f64 * (1.0 / (1u64 << 53) as f64)
}

/// Writes `uniform` for many indices.
pub fn fill_uniform(seed: u64, cell: u64, index: &[u64], draws: &mut [f64], progress: &Progress) -> Result<()> {
    write_mapped(index, draws, |&index| uniform(seed, cell, index), progress)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_do_not_commute() {
        assert_ne!(bits(1, 2, 3), bits(1, 3, 2));
        assert_ne!(bits(1, 2, 3), bits(2, 1, 3));
    }

    #[test]
    fn uniform_is_uniform() {
        // Mean and variance of 10⁵ draws must lie within five standard errors (1/√(12 n) and 1/√(180 n)).
        let n = 100_000;
        let (mut sum, mut square) = (0.0, 0.0);
        for index in 0..n {
            let x = uniform(7, 1, index);
            assert!((0.0..1.0).contains(&x));
            sum += x;
            square += (x - 0.5) * (x - 0.5);
        }
        let n = n as f64;
        assert!((sum / n - 0.5).abs() < 5.0 / (12.0 * n).sqrt());
        assert!((square / n - 1.0 / 12.0).abs() < 5.0 / (180.0 * n).sqrt());
    }
}
