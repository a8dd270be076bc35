//! Windowed similarity over tiles that stay in the caches, with one pass over each tile's rows.

use super::super::extremes::{Extremes, LANES};
use super::super::pair::Pair;
use super::super::pixel_rows::PixelRows;
use super::super::plane::{Region, RoundingLimits, mirror};
use super::direct::Patch;
use super::measure::{Measure, WindowRow, measure_row};
use super::moments::{COLUMNS, Moments, row_moments, window_moments};
use super::window::{MapRows, Mask, Selection, SimilaritySums, sum_bands};
use crate::base::Real;
use crate::base::simd::prefetch;

/// Rows per task: fixed, so that sums do not depend on the number of threads.
const ROWS: usize = 90;
/// Bytes of a tile's row in each image. With the moments of a window's rows they stay in the caches.
const TILE_BYTES: usize = 512;
/// Prefetch distance in rows. Hardware prefetchers do not predict jumps from tile to tile.
const PREFETCHED_ROWS: usize = 4;

/// A comparison by windows.
pub(super) struct Windows<'a, P: PixelRows> {
    pair: Pair<'a, P>,
    weights: &'a [f64],
    narrow_weights: Vec<P::Real>,
    constants: [f64; 2],
    selection: Selection<'a>,
    /// Region of the windows that count, before any mask.
    inside: Region,
}

impl<'a, P: PixelRows> Windows<'a, P> {
    pub(super) fn new(pair: Pair<'a, P>, weights: &'a [f64], constants: [f64; 2], selection: Selection<'a>) -> Self {
        let narrow_weights = weights.iter().map(|&w| P::Real::narrow(w)).collect();
        let (height, width, taps) = (pair.reference.height, pair.reference.width, weights.len());
        let (before, after) = (taps / 2, taps - 1 - taps / 2);
        let inside = if selection.includes_border || height < taps || width < taps {
            Region { rows: [0, height], columns: [0, width] }
        } else {
            Region { rows: [before, height - after], columns: [before, width - after] }
        };
        Self { pair, weights, narrow_weights, constants, selection, inside }
    }

    pub(super) fn sums(&self, map: Option<&mut [P::Real]>) -> SimilaritySums {
        let (height, width) = (self.pair.reference.height, self.pair.reference.width);
        let inside = self.inside;
        sum_bands([height, width], ROWS, map, |rows, mut map| {
            let computed = if map.is_some() { Region { rows, columns: [0, width] } } else { inside.within_rows(rows) };
            let mut buffers = TileBuffers::new(self.weights.len(), self.selection.contrast);
            let mut sums = SimilaritySums::default();
            let mut start = computed.columns[0];
            while start < computed.columns[1] && !computed.is_empty() && self.selection.progress.check().is_ok() {
                let end = computed.columns[1].min(start + TILE_BYTES / size_of::<P::Real>());
                let mut region = Region { rows: computed.rows, columns: [start, end] };
                start = end;
                if let (None, Some(mask)) = (&map, &self.selection.mask) {
                    region = mask.plane().bounds(region);
                }
                if !region.is_empty() {
                    sums = sums.plus(self.tile(&region, &mut buffers, map.as_mut()));
                }
            }
            sums
        })
    }

    /// Computes a tile in the pixels' own precision; if that loses digits, in float64, and else window by window.
    fn tile(
        &self,
        region: &Region,
        buffers: &mut TileBuffers<P::Real>,
        mut map: Option<&mut MapRows<'_, P::Real>>,
    ) -> SimilaritySums {
        let levels = self.pair.levels(region, self.selection.mask.as_ref().map(Mask::plane));
        buffers.row.all_required = map.is_some();
        let range_region = self.range_region(region);
        let mut extremes = self.selection.range.then(Extremes::default);
        let load_narrow = |row: usize, positions: &[usize], lines: [&mut [P::Real]; 2]| {
            self.load(row, positions, range_region, levels.map(P::Real::narrow), lines, extremes.as_mut())
        };
        if let Some(sums) = self.pass(region, (levels, &self.narrow_weights), buffers, map.as_deref_mut(), load_narrow)
        {
            return SimilaritySums { range: extremes.unwrap_or_default().range(), ..sums };
        }
        let mut extremes = Extremes::default();
        if self.selection.range {
            self.pair.extend(&range_region, &mut extremes);
        }
        let range = extremes.range();
        let load_wide = |row: usize, positions: &[usize], lines: [&mut [f64]; 2]| {
            self.pair.gather(row, positions.iter().copied(), levels, lines)
        };
        // The pixels' own precision may already be float64.
        if size_of::<P::Real>() < size_of::<f64>() {
            let mut buffers = TileBuffers::new(self.weights.len(), self.selection.contrast);
            buffers.row.all_required = map.is_some();
            if let Some(sums) = self.pass(region, (levels, self.weights), &mut buffers, map.as_deref_mut(), load_wide) {
                return SimilaritySums { range, ..sums };
            }
        }
        SimilaritySums { range, ..self.one_by_one(region, map) }
    }

    /// Computes all windows of a region in one precision; `None` if that precision is insufficient.
    fn pass<R: RoundingLimits>(
        &self,
        region: &Region,
        (levels, weights): ([f64; 2], &[R]),
        buffers: &mut TileBuffers<R>,
        mut map: Option<&mut MapRows<'_, P::Real>>,
        mut load: impl FnMut(usize, &[usize], [&mut [R]; 2]),
    ) -> Option<SimilaritySums> {
        if self.constants.iter().any(|&c| c < R::MIN_CONSTANT || c > R::MAX_LEVEL)
            || levels.iter().any(|l| l.abs() > R::MAX_LEVEL)
        {
            return None;
        }
        let ([first, end], taps) = (region.columns, weights.len());
        let measure = Measure { levels: levels.map(R::narrow), constants: self.constants.map(R::narrow) };
        let blocks = (end - first).div_ceil(LANES);
        buffers.row.blocks = blocks;
        buffers.row.sums = [[0.0; LANES]; 2];
        // Otherwise lanes beyond the region would read values of an earlier region.
        buffers.lines.iter_mut().for_each(|line| line.fill(R::default()));
        let before = taps / 2;
        let positions = |from: usize, to: usize, length: usize| -> Vec<usize> {
            (from..to + taps - 1).map(|position| mirror(position as i64 - before as i64, length)).collect()
        };
        let columns = positions(first, end, self.pair.reference.width);
        let rows = positions(region.rows[0], region.rows[1], self.pair.reference.height);
        let (mut is_counting, mut pixels) = (false, 0.0);
        for (read, &position) in rows.iter().enumerate() {
            let [s, d] = &mut buffers.lines;
            load(position, &columns, [&mut s[..columns.len()], &mut d[..columns.len()]]);
            // The oldest row is replaced.
            let slot = buffers.order[0];
            buffers.order.rotate_left(1);
            for (line, rows) in buffers.lines.iter().zip(&mut buffers.rows) {
                row_moments(line, weights, &mut rows[slot], blocks);
            }
            let Some(row) = (region.rows[0] + read + 1).checked_sub(taps).filter(|&row| row >= region.rows[0]) else {
                continue;
            };
            for (rows, moments) in buffers.rows.iter().zip(&mut buffers.moments) {
                window_moments(rows, &buffers.order, weights, moments, blocks);
            }
            match (self.inside.contains_row(row), self.selection.mask) {
                (true, Some(mask)) => buffers.mask(mask, row, region, self.inside),
                (true, None) if !is_counting => buffers.count(region, self.inside),
                (true, None) => {}
                (false, _) => buffers.count_none(),
            }
            is_counting = self.inside.contains_row(row);
            let [s, d] = &buffers.moments;
            measure_row(&measure, s, d, &mut buffers.row);
            if !buffers.row.is_precise {
                return None;
            }
            pixels += buffers.window_count;
            if let Some(map) = &mut map {
                map.write(row, first, &buffers.row.similarity[..end - first]);
            }
        }
        let [similarity, contrast] = buffers.row.sums.map(|lanes| lanes.iter().sum());
        Some(SimilaritySums { similarity, contrast, pixels, ..SimilaritySums::default() })
    }

    fn one_by_one(&self, region: &Region, mut map: Option<&mut MapRows<'_, P::Real>>) -> SimilaritySums {
        let patch = Patch::new(&self.pair, self.weights, self.constants, region, None);
        let ([first, end], is_mapped) = (region.columns, map.is_some());
        let mut sums = SimilaritySums::default();
        for row in region.rows[0]..region.rows[1] {
            let counts = |n: usize| {
                let is_masked = |mask: Mask<'_>| mask.plane().contains(row, first + n);
                self.inside.contains(row, first + n) && self.selection.mask.is_none_or(is_masked)
            };
            let wanted = |n: usize| first + n < end && (is_mapped || counts(n));
            patch.measure_row(row - region.rows[0], wanted, |n, similarity, contrast| {
                if counts(n) {
                    let contrast = if self.selection.contrast { contrast } else { 0.0 };
                    sums = sums.plus(SimilaritySums { similarity, contrast, pixels: 1.0, ..SimilaritySums::default() });
                }
                if let Some(map) = &mut map {
                    map.write(row, first + n, &[similarity]);
                }
            });
        }
        sums
    }

    /// Returns the pixels whose values a region contributes to the range: its own, and those of the image's margin that
    /// only its windows see. With a mask, these are all pixels that its windows see.
    fn range_region(&self, region: &Region) -> Region {
        let taps = self.weights.len();
        let (before, after) = (taps / 2, taps - 1 - taps / 2);
        let grown = |[from, to]: [usize; 2], inside: [usize; 2], length: usize| match self.selection.mask {
            Some(_) => [from.saturating_sub(before), length.min(to + after)],
            None => [if from <= inside[0] { 0 } else { from }, if to >= inside[1] { length } else { to }],
        };
        Region {
            rows: grown(region.rows, self.inside.rows, self.pair.reference.height),
            columns: grown(region.columns, self.inside.columns, self.pair.reference.width),
        }
    }

    /// Loads sums and differences, minus levels, at the positions of a row that windows read. Extends the extremes, if
    /// given, by at least the region's own columns.
    fn load(
        &self,
        row: usize,
        positions: &[usize],
        range_region: Region,
        levels: [P::Real; 2],
        lines: [&mut [P::Real]; 2],
        extremes: Option<&mut Extremes<P>>,
    ) {
        let (start, last) = (positions[0], positions[positions.len() - 1]);
        if last + 1 != start + positions.len() {
            self.pair.gather(row, positions.iter().copied(), levels, lines);
            return self.pair.extend_row(row, range_region.columns[0]..range_region.columns[1], extremes);
        }
        self.pair.load(row, start..last + 1, levels, lines, extremes);
        let next = (row + PREFETCHED_ROWS).min(self.pair.reference.height - 1);
        for image in [&self.pair.reference, &self.pair.test] {
            image.run(next, start..last + 1).into_iter().for_each(prefetch);
        }
    }
}

/// Buffers of a band's tiles.
struct TileBuffers<R> {
    /// Values of a row, for s and for d.
    lines: [Vec<R>; 2],
    /// Moments along rows: a ring buffer with one slot per window row.
    rows: [Vec<Moments<R>>; 2],
    /// Ring slots of a window's rows, the oldest first.
    order: Vec<usize>,
    moments: [Moments<R>; 2],
    row: WindowRow<R>,
    /// Number of windows of the row that count.
    window_count: f64,
}

impl<R: Real> TileBuffers<R> {
    fn new(taps: usize, contrast: bool) -> Self {
        // Whole vectors are read, whose last lanes may lie outside the image.
        let line = || vec![R::default(); COLUMNS + taps];
        let rows = || vec![Moments::default(); taps];
        Self {
            lines: [line(), line()],
            rows: [rows(), rows()],
            order: (0..taps).collect(),
            moments: [Moments::default(), Moments::default()],
            row: WindowRow {
                counts: [R::default(); COLUMNS],
                similarity: [R::default(); COLUMNS],
                blocks: 0,
                contrast,
                all_required: false,
                is_precise: true,
                sums: [[0.0; LANES]; 2],
            },
            window_count: 0.0,
        }
    }

    /// Marks the windows of a region that count.
    fn count(&mut self, region: &Region, inside: Region) {
        let [from, to] = columns_inside(region, inside);
        self.row.counts.fill(R::default());
        self.row.counts[from..to].fill(R::narrow(1.0));
        self.window_count = (to - from) as f64;
    }

    fn count_none(&mut self) {
        self.row.counts.fill(R::default());
        self.window_count = 0.0;
    }

    /// Marks the windows that a mask's row selects.
    fn mask(&mut self, mask: Mask<'_>, row: usize, region: &Region, inside: Region) {
        let [from, to] = columns_inside(region, inside);
        self.count_none();
        for column in from..to {
            let counts = if mask.plane().contains(row, region.columns[0] + column) { 1.0 } else { 0.0 };
            self.row.counts[column] = R::narrow(counts);
            self.window_count += counts;
        }
    }
}

/// Returns the columns of a region, relative to its first, that lie inside.
fn columns_inside(region: &Region, inside: Region) -> [usize; 2] {
    let [first, end] = region.columns;
    let from = inside.columns[0].clamp(first, end);
    [from - first, inside.columns[1].clamp(from, end) - first]
}
