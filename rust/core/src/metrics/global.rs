//! Similarity with one window over the whole image.

use rayon::prelude::*;

use super::measure::{Measure, Measured, Source};
use super::plane::{Part, Plane, Real};
use super::similarity::{Counted, Mask, Pair, Sums};

/// The same similarity for every pixel; the window sees the whole image or what a mask names.
pub(super) fn global<P: Source>(
    pair: &Pair<'_, P>,
    constants: [f64; 2],
    counted: Counted<'_>,
    map: Option<&mut [P::Real]>,
) -> Sums {
    let (height, width) = (pair.reference.height, pair.reference.width);
    let named = counted.mask.map(|mask| *mask.plane());
    let seen = named.filter(|_| matches!(counted.mask, Some(Mask::Windows(_))));
    let whole = Part { rows: [0, height], columns: [0, width] };
    let part = seen.map_or(whole, |mask| mask.bounds(whole));
    if part.is_empty() {
        return Sums::default();
    }
    let levels = [&pair.reference, &pair.test]
        .map(|image| image.level(part.rows[0]..part.rows[1], part.columns[0]..part.columns[1]));
    let rows: Vec<[f64; 5]> =
        (part.rows[0]..part.rows[1]).into_par_iter().map(|row| row_sums(pair, row, part, levels, seen)).collect();
    let [pixels, sums @ ..] = rows.into_iter().fold([0.0; 5], |sums, row| std::array::from_fn(|i| sums[i] + row[i]));
    let [s, d, ss, dd] = sums.map(|sum| sum / pixels);
    let measure = Measure { levels: levels.map(Real::wide), constants };
    let (similarity, contrast) = measure.of::<true>([s, ss - s * s], [d, dd - d * d]);
    if let Some(map) = map {
        map.fill(P::Real::narrow(similarity));
    }
    let count = named.map_or(pixels, |mask| mask.count() as f64);
    Sums { similarity: similarity * count, contrast: contrast * count, pixels: count }
}

/// How many pixels of a row the window sees, and their sums of s, d, s² and d².
fn row_sums<P: Source>(
    pair: &Pair<'_, P>,
    row: usize,
    part: Part,
    levels: [P::Real; 2],
    seen: Option<Plane<'_, u8>>,
) -> [f64; 5] {
    let [first, end] = part.columns;
    let (mut s, mut d) = (vec![P::Real::default(); end - first], vec![P::Real::default(); end - first]);
    pair.load(row, first..end, levels, [&mut s, &mut d]);
    if let Some(mask) = seen {
        for values in [&mut s, &mut d] {
            let mut columns = first..end;
            values.retain(|_| columns.next().is_some_and(|column| mask.names(row, column)));
        }
    }
    let [sum_s, sum_d, sum_ss, sum_dd] = Measured::power_sums(&s, &d);
    [s.len() as f64, sum_s, sum_d, sum_ss, sum_dd]
}
