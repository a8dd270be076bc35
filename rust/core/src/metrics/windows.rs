//! Similarity window by window: images are cut into tiles that stay in the caches, and each tile's rows are passed once.

use rayon::prelude::*;

use super::measure::{Measure, Measured, Row, Source};
use super::moments::{COLUMNS, Kernels, Moments};
use super::plane::{Part, Real, mirror};
use super::similarity::{Counted, Mask, Pair, Sums};
use super::vectors::{LANES, prefetch};

/// Rows of one task: fixed, so that sums do not depend on the number of threads.
const ROWS: usize = 90;
/// Bytes of a row that a tile takes in each image: with the moments of a window's rows they stay in the caches.
const TILE_BYTES: usize = 512;
/// Rows that are asked for ahead of time: their addresses jump from tile to tile, which no machine foresees.
const AHEAD: usize = 4;

/// A comparison by windows.
pub(super) struct Windows<'a, P: Source> {
    pair: Pair<'a, P>,
    weights: Vec<P::Real>,
    constants: [P::Real; 2],
    counted: Counted<'a>,
    /// For each value that windows read along a row or a column, its place in the image.
    places: [Vec<u32>; 2],
}

impl<'a, P: Source> Windows<'a, P> {
    pub(super) fn new(pair: Pair<'a, P>, weights: &[f64], constants: [P::Real; 2], counted: Counted<'a>) -> Self {
        let places = [pair.reference.height, pair.reference.width].map(|length| mirrored(length, weights.len()));
        Self { pair, weights: weights.iter().map(|&w| P::Real::narrow(w)).collect(), constants, counted, places }
    }

    /// Sums over the windows that count.
    pub(super) fn sums(&self, map: Option<&mut [P::Real]>) -> Sums {
        let (height, width) = (self.pair.reference.height, self.pair.reference.width);
        let inside = self.inside();
        let band = |rows: [usize; 2], mut map: Option<&mut [P::Real]>| {
            let wanted = if map.is_some() { Part { rows, columns: [0, width] } } else { inside.within_rows(rows) };
            let mut bench = Bench::new(self.weights.len(), self.counted.contrast);
            let mut sums = Sums::default();
            let mut start = wanted.columns[0];
            while start < wanted.columns[1] && !wanted.is_empty() {
                let end = wanted.columns[1].min(start + TILE_BYTES / size_of::<P::Real>());
                let mut part = Part { rows: wanted.rows, columns: [start, end] };
                start = end;
                if let (None, Some(mask)) = (&map, &self.counted.mask) {
                    part = mask.plane().bounds(part);
                }
                if !part.is_empty() {
                    let map = map.as_deref_mut().map(|map| (map, rows[0]));
                    sums = sums.and(self.tile(&part, inside, &mut bench, map));
                }
            }
            sums
        };
        let bands = height.div_ceil(ROWS);
        let rows = |band: usize| [band * ROWS, height.min((band + 1) * ROWS)];
        let each: Vec<Sums> = match map {
            Some(map) => {
                map.par_chunks_mut(ROWS * width).enumerate().map(|(n, map)| band(rows(n), Some(map))).collect()
            }
            None => (0..bands).into_par_iter().map(|n| band(rows(n), None)).collect(),
        };
        each.into_iter().fold(Sums::default(), Sums::and)
    }

    /// Where windows count that a mask does not rule out.
    fn inside(&self) -> Part {
        let (height, width) = (self.pair.reference.height, self.pair.reference.width);
        let taps = self.weights.len();
        let (before, after) = (taps / 2, taps - 1 - taps / 2);
        if self.counted.all || height < taps || width < taps {
            return Part { rows: [0, height], columns: [0, width] };
        }
        Part { rows: [before, height - after], columns: [before, width - after] }
    }

    fn tile(
        &self,
        part: &Part,
        inside: Part,
        bench: &mut Bench<P::Real>,
        mut map: Option<(&mut [P::Real], usize)>,
    ) -> Sums {
        let [first, end] = part.columns;
        let taps = self.weights.len();
        let levels =
            [&self.pair.reference, &self.pair.test].map(|plane| plane.level(part.rows[0]..part.rows[1], first..end));
        let measure = Measure { levels, constants: self.constants };
        let blocks = (end - first).div_ceil(LANES);
        bench.row.blocks = blocks;
        bench.count(part, inside);
        let mut sums = Sums::default();
        // The window of an output row reads `taps` rows from its own number on, in places mirrored at the borders.
        for read in part.rows[0]..part.rows[1] + taps - 1 {
            self.load(self.places[0][read] as usize, part.columns, levels, bench);
            // The row that was read longest ago makes room.
            let slot = bench.order[0];
            bench.order.rotate_left(1);
            for (line, rows) in bench.lines.iter().zip(&mut bench.rows) {
                Kernels::across(line, &self.weights, &mut rows[slot], blocks);
            }
            let Some(row) = (read + 1).checked_sub(taps).filter(|&row| row >= part.rows[0]) else { continue };
            for (rows, moments) in bench.rows.iter().zip(&mut bench.moments) {
                Kernels::down(rows, &bench.order, &self.weights, moments, blocks);
            }
            let counts = row >= inside.rows[0] && row < inside.rows[1];
            if let (true, Some(mask)) = (counts, self.counted.mask) {
                bench.mask(mask, row, part, inside);
            }
            let [s, d] = &bench.moments;
            let [similarity, contrast] = Measured::measure(&measure, s, d, &mut bench.row);
            if counts {
                sums = sums.and(Sums { similarity, contrast, pixels: bench.counted });
            }
            if let Some((map, top)) = &mut map {
                let at = (row - *top) * self.pair.reference.width + first;
                map[at..at + end - first].copy_from_slice(&bench.row.similarity[..end - first]);
            }
        }
        sums
    }

    /// Sum and difference of both images along the values of a row that windows from `first` to `end` read, both less
    /// their levels.
    fn load(&self, row: usize, [first, end]: [usize; 2], levels: [P::Real; 2], bench: &mut Bench<P::Real>) {
        let places = &self.places[1][first..end + self.weights.len() - 1];
        let (start, last) = (places[0] as usize, places[places.len() - 1] as usize);
        let [s, d] = &mut bench.lines;
        let (s, d) = (&mut s[..places.len()], &mut d[..places.len()]);
        if last + 1 != start + places.len() {
            for ((s, d), &place) in s.iter_mut().zip(d).zip(places) {
                (*s, *d) = self.pair.at(row, place as usize, levels);
            }
            return;
        }
        self.pair.load(row, start..last + 1, levels, [s, d]);
        let next = (row + AHEAD).min(self.pair.reference.height - 1);
        for image in [&self.pair.reference, &self.pair.test] {
            image.run(next, start..last + 1).into_iter().for_each(prefetch);
        }
    }
}

/// Everything that a band's tiles write into.
struct Bench<R> {
    /// Of s and d: a row's values.
    lines: [Vec<R>; 2],
    /// The moments along rows, a ring of as many as a window has.
    rows: [Vec<Moments<R>>; 2],
    /// Where in the ring the last rows are that were read, the earliest first: those of a window.
    order: Vec<usize>,
    moments: [Moments<R>; 2],
    row: Row<R>,
    /// Windows of the row that count.
    counted: f64,
}

impl<R: Real> Bench<R> {
    fn new(taps: usize, contrast: bool) -> Self {
        // Whole lanes are read, of which the last may be none of the image.
        let line = || vec![R::default(); COLUMNS + taps];
        let rows = || vec![Moments::default(); taps];
        Self {
            lines: [line(), line()],
            rows: [rows(), rows()],
            order: (0..taps).collect(),
            moments: [Moments::default(), Moments::default()],
            row: Row { counts: [R::default(); COLUMNS], similarity: [R::default(); COLUMNS], blocks: 0, contrast },
            counted: 0.0,
        }
    }

    /// Marks the windows of a part that count.
    fn count(&mut self, part: &Part, inside: Part) {
        let [from, to] = columns_inside(part, inside);
        self.row.counts.fill(R::default());
        self.row.counts[from..to].fill(R::narrow(1.0));
        self.counted = (to - from) as f64;
    }

    /// The same for a row of a mask.
    fn mask(&mut self, mask: Mask<'_>, row: usize, part: &Part, inside: Part) {
        let [from, to] = columns_inside(part, inside);
        self.counted = 0.0;
        for column in from..to {
            let counts = if mask.plane().names(row, part.columns[0] + column) { 1.0 } else { 0.0 };
            self.row.counts[column] = R::narrow(counts);
            self.counted += counts;
        }
    }
}

/// Columns of a part, from its first one, that lie inside.
fn columns_inside(part: &Part, inside: Part) -> [usize; 2] {
    let [first, end] = part.columns;
    let from = inside.columns[0].clamp(first, end);
    [from - first, inside.columns[1].clamp(from, end) - first]
}

/// For each value that windows read along a line, its place.
fn mirrored(length: usize, taps: usize) -> Vec<u32> {
    let before = (taps / 2) as i64;
    (-before..(length + taps - 1) as i64 - before).map(|i| mirror(i, length) as u32).collect()
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
}
