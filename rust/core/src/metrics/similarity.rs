//! Structural similarity. Wang, Bovik, Sheikh, Simoncelli: Image quality assessment: from error visibility to structural
//! similarity, 2004: weighted means, variances and covariance in a window that moves over both images.

use rayon::prelude::*;

use crate::base::{Error, Result, memory::room_for};

/// What is averaged around each pixel.
#[derive(Clone, Debug, PartialEq)]
pub enum Window {
    /// Separable weights that sum to 1; an even number of them reaches one pixel further up and left.
    Weights(Vec<f64>),
    /// The whole image at once.
    Global,
}

impl Window {
    /// A Gaussian of σ pixels, cut off at `size` pixels.
    pub fn gaussian(size: usize, sigma: f64) -> Self {
        let middle = (size as f64 - 1.0) / 2.0;
        let weights = (0..size).map(|i| (-0.5 * ((i as f64 - middle) / sigma).powi(2)).exp());
        let weights: Vec<f64> = weights.collect();
        let sum: f64 = weights.iter().sum();
        Self::Weights(weights.into_iter().map(|weight| weight / sum).collect())
    }

    /// All `size` pixels alike.
    pub fn uniform(size: usize) -> Self {
        Self::Weights(vec![1.0 / size as f64; size])
    }
}

/// Constants of the measure: (k₁ L)² and (k₂ L)² keep it defined where means or variances vanish.
#[derive(Clone, Copy, Debug)]
pub struct Similarity {
    /// For the means.
    pub c1: f64,
    /// For the variances.
    pub c2: f64,
}

impl Similarity {
    /// Symmetric in both images, and exactly 1 where they are the same.
    #[inline]
    fn of(&self, [x, y, xx, yy, xy]: [f64; 5]) -> f64 {
        let (vx, vy, covariance) = (xx - x * x, yy - y * y, xy - x * y);
        let means = (2.0 * (x * y) + self.c1) / (x * x + y * y + self.c1);
        means * ((2.0 * covariance + self.c2) / (vx + vy + self.c2))
    }
}

/// The similarity around each pixel of two images, rows of `width`; outside them they are mirrored.
pub fn similarity(
    reference: &[f64],
    test: &[f64],
    width: usize,
    window: &Window,
    constants: Similarity,
) -> Result<Vec<f64>> {
    let pixels = reference.len();
    if test.len() != pixels || width == 0 || pixels == 0 || !pixels.is_multiple_of(width) {
        return Err(Error::value("test", format!("{pixels} values in rows of {width}, more than none"), test.len()));
    }
    room_for(7 * size_of::<f64>() as u64 * pixels as u64)?;
    let products = |at: usize| {
        let (x, y) = (reference[at], test[at]);
        [x, y, x * x, y * y, x * y]
    };
    let Window::Weights(weights) = window else {
        return Ok(vec![constants.of(whole(pixels, width, products)); pixels]);
    };
    let height = pixels / width;
    let columns: Vec<usize> = mirrored(width, weights.len());
    let rows: Vec<usize> = mirrored(height, weights.len());
    let mut across = vec![[0.0; 5]; pixels];
    across.par_chunks_mut(width).enumerate().for_each(|(row, out)| {
        for (column, out) in out.iter_mut().enumerate() {
            let taps = weights.iter().zip(&columns[column..]);
            *out = sum(taps.map(|(weight, &tap)| (*weight, products(row * width + tap))));
        }
    });
    let mut map = vec![0.0; pixels];
    map.par_chunks_mut(width).enumerate().for_each(|(row, out)| {
        for (column, out) in out.iter_mut().enumerate() {
            let taps = weights.iter().zip(&rows[row..]);
            *out = constants.of(sum(taps.map(|(weight, &tap)| (*weight, across[tap * width + column]))));
        }
    });
    Ok(map)
}

/// Means over a whole image, row by row.
fn whole(pixels: usize, width: usize, products: impl Fn(usize) -> [f64; 5] + Sync) -> [f64; 5] {
    let weight = 1.0 / pixels as f64;
    let row = |row: usize| sum((row * width..(row + 1) * width).map(|at| (1.0, products(at))));
    let rows: Vec<[f64; 5]> = (0..pixels / width).into_par_iter().map(row).collect();
    sum(rows.into_iter().map(|row| (weight, row)))
}

#[inline]
fn sum(taps: impl Iterator<Item = (f64, [f64; 5])>) -> [f64; 5] {
    taps.fold([0.0; 5], |sums, (weight, values)| std::array::from_fn(|i| sums[i] + weight * values[i]))
}

/// For each tap of a window over a line, the place that it reads: d c b a | a b c d | d c b a.
fn mirrored(length: usize, taps: usize) -> Vec<usize> {
    let (length, before) = (length as i64, (taps / 2) as i64);
    let place = |i: i64| {
        let there = i.rem_euclid(2 * length);
        if there < length { there } else { 2 * length - 1 - there }
    };
    (-before..length + taps as i64 - 1 - before).map(|i| place(i) as usize).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_mirrored_at_their_ends() {
        assert_eq!(mirrored(3, 5), [1, 0, 0, 1, 2, 2, 1]);
        assert_eq!(mirrored(2, 4), [1, 0, 0, 1, 1]);
        assert_eq!(mirrored(1, 5), [0; 5]);
    }

    #[test]
    fn equal_images_are_exactly_alike_and_order_does_not_matter() {
        let a: Vec<f64> = (0..35).map(|i| f64::from(i * i % 17) / 16.0).collect();
        let b: Vec<f64> = (0..35).map(|i| f64::from(i * 7 % 13) / 12.0).collect();
        let constants = Similarity { c1: 1e-4, c2: 9e-4 };
        for window in [Window::gaussian(11, 1.5), Window::uniform(4), Window::Global] {
            let of = |a: &[f64], b: &[f64]| similarity(a, b, 7, &window, constants).unwrap();
            assert!(of(&a, &a).iter().all(|&value| value == 1.0));
            assert_eq!(of(&a, &b), of(&b, &a));
            assert!(of(&a, &b).iter().all(|&value| value < 1.0));
        }
    }
}
