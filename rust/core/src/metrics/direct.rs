//! One window by itself: means first, then distances from them. Slow, and right for any values that squares hold; it is
//! the last resort where one level for many windows loses digits.

use super::measure::Source;
use super::plane::{Plane, Real, mirror};
use super::similarity::Pair;

/// Similarity of the window around a pixel and its second factor; it sees a mirrored image, or what a mask names of it.
pub(super) fn window<P: Source>(
    pair: &Pair<'_, P>,
    weights: &[f64],
    [row, column]: [usize; 2],
    mask: Option<&Plane<'_, u8>>,
    [c1, c2]: [f64; 2],
) -> (f64, f64) {
    let size = [pair.reference.height, pair.reference.width];
    let before = weights.len() / 2;
    let value = |row: usize, column: usize| [&pair.reference, &pair.test].map(|image| image.at(row, column).wide());
    let levels = value(row, column);
    let sum = |mut add: Box<dyn FnMut(f64, f64, f64) + '_>| {
        for (i, down) in weights.iter().enumerate() {
            for (j, across) in weights.iter().enumerate() {
                let place = [row + i, column + j].map(|place| place as i64 - before as i64);
                let [at_row, at_column] = [mirror(place[0], size[0]), mirror(place[1], size[1])];
                let within = place[0] == at_row as i64 && place[1] == at_column as i64;
                if mask.is_none_or(|mask| within && mask.names(at_row, at_column)) {
                    let [x, y] = value(at_row, at_column);
                    add(down * across, x - levels[0], y - levels[1]);
                }
            }
        }
    };
    let (mut total, mut mean) = (0.0, [0.0; 2]);
    sum(Box::new(|weight, x, y| {
        total += weight;
        mean = [mean[0] + weight * x, mean[1] + weight * y];
    }));
    let mean = mean.map(|sum| sum / total);
    let [mut variances, mut apart] = [0.0; 2];
    sum(Box::new(|weight, x, y| {
        let (x, y) = (x - mean[0], y - mean[1]);
        variances += weight * (x * x + y * y);
        apart += weight * (x - y) * (x - y);
    }));
    let (x, y) = (levels[0] + mean[0], levels[1] + mean[1]);
    let difference = (levels[0] - levels[1]) + (mean[0] - mean[1]);
    measured([x * x + y * y + c1, difference * difference], [variances / total + c2, apart / total])
}

/// Similarity and its second factor by two divisions, because the product of what is divided by would overflow: from
/// the sum of both squared means and c₁, the square of their difference, the sum of both variances and c₂, and the
/// variance of the difference.
pub(super) fn measured([means, difference]: [f64; 2], [variances, apart]: [f64; 2]) -> (f64, f64) {
    let contrast = (variances - apart) / variances;
    ((means - difference) / means * contrast, contrast)
}
