//! Face layout of a range map, and the ranges of its codes, which have the same bits on every machine.

use crate::base::{Error, Result, ensure, number};

/// Maximum `Faces::step`: the range of the last code is then exp(700), near the maximum of float64.
pub const MAX_STEP: f64 = 700.0 / 65535.0;

/// Layout of a map's faces, and the tiles that may change.
#[derive(Clone, Copy, Debug)]
pub struct Faces<'a> {
    /// Texels along a face.
    pub size: usize,
    /// Texels along a tile; it divides `size`.
    pub tile: usize,
    /// Ascending numbers of the tiles in which texels may change, by face, row and column.
    pub listed: &'a [u32],
    /// Natural logarithm of the ratio of two consecutive codes' ranges.
    pub step: f64,
}

impl Faces<'_> {
    /// Returns the number of faces for a number of texels.
    pub(super) fn count(&self, texels: usize) -> Result<usize> {
        let Self { size, tile, listed, step } = *self;
        let area = size.checked_mul(size).filter(|&area| area > 0 && texels.is_multiple_of(area));
        let Some(area) = area.filter(|_| tile > 0 && size.is_multiple_of(tile)) else {
            return Err(Error::value("tile", "a divisor of the face size, and whole faces", tile));
        };
        let tiles = texels / (tile * tile);
        let is_list = listed.is_sorted_by(|a, b| a < b) && listed.last().is_none_or(|&last| (last as usize) < tiles);
        ensure!(is_list, "tiles", format!("ascending numbers below {tiles}"), "others");
        ensure!(step > 0.0 && step <= MAX_STEP, "step", format!("a number from 0 to {MAX_STEP}"), number(step));
        Ok(texels / area)
    }

    /// Returns whether a tile is listed.
    pub(super) fn lists(&self, tile: usize) -> bool {
        self.listed.binary_search_by(|&listed| (listed as usize).cmp(&tile)).is_ok()
    }
}

/// Code of texels without a surface.
pub const NOTHING: u16 = u16::MAX;

/// Maximum distance from a guess, in codes, of the codes that are tried before all codes are searched.
const NEARBY: usize = 4;

/// Ranges of all codes, relative to the range of code 0.
pub(super) struct Scale {
    /// exp(−c · step) of each code c.
    reciprocals: Vec<f64>,
    /// exp((c + ½) · step): the range at which code c ends and code c + 1 begins.
    ends: Vec<f64>,
}

impl Scale {
    pub fn new(step: f64) -> Self {
        let (ratio, half) = (exponential(step), exponential(0.5 * step));
        let powers = || std::iter::successors(Some(1.0), move |power| Some(power * ratio));
        let last = usize::from(NOTHING);
        Self {
            reciprocals: powers().take(last).map(|power| 1.0 / power).collect(),
            ends: powers().take(last - 1).map(|power| power * half).collect(),
        }
    }

    /// Returns `distance` divided by the range, with `distance` from the centre to the texel on a face at depth 1. This
    /// reciprocal depth is linear in x and y over the texels of a plane.
    pub fn nearness(&self, code: u16, distance: f64) -> f64 {
        distance * self.reciprocals[usize::from(code)]
    }

    /// Returns the code of a nearness; the last code if the nearness is not positive. `guess` only saves time.
    pub fn code(&self, nearness: f64, distance: f64, guess: u16) -> u16 {
        if nearness <= 0.0 || nearness.is_nan() {
            return NOTHING - 1;
        }
        let range = distance / nearness;
        let (low, high) = (usize::from(guess).saturating_sub(NEARBY), usize::from(guess) + NEARBY);
        let is_below = |code: usize| code == 0 || self.ends[code - 1] <= range;
        let is_above = |code: usize| self.ends.get(code).is_none_or(|&end| range < end);
        let (from, to) =
            if high < self.ends.len() && is_below(low) && is_above(high) { (low, high) } else { (0, self.ends.len()) };
        (from + self.ends[from..to].partition_point(|&end| end <= range)) as u16
    }
}

/// Returns exp(x) of a small x by its power series, because library functions differ in the last digit.
fn exponential(x: f64) -> f64 {
    (1..=10).rev().fold(1.0, |sum, n| 1.0 + x / f64::from(n) * sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_series_is_the_exponential() {
        for x in [1e-9, 1e-6, 0.001, 700.0 / 65535.0] {
            assert!((exponential(x) / x.exp() - 1.0).abs() < 4.0 * f64::EPSILON, "{x}");
        }
    }

    #[test]
    fn codes_are_recovered_from_any_initial_guess() {
        let scale = Scale::new(0.001);
        for code in (0..NOTHING).step_by(97).chain([1, NOTHING - 2, NOTHING - 1]) {
            for guess in [0, code, code.saturating_sub(3), NOTHING - 1] {
                assert_eq!(scale.code(scale.nearness(code, 1.25), 1.25, guess), code);
            }
        }
        for wrong in [0.0, -1.0, f64::NAN, 1e-300] {
            assert_eq!(scale.code(wrong, 1.0, 5), NOTHING - 1);
        }
        assert_eq!(scale.code(f64::INFINITY, 1.0, 5), 0);
    }
}
