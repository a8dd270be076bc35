//! Screen tile with the nearest splat at each of its samples.

use super::lanes::{GROUP, Lanes, SEVERAL_PIXELS};
use super::projector::{Rect, sortable_bits};
use super::splats::SQUARED_RADIUS;
use crate::base::simd::vectorized;

/// Nearest splat at a sample: its nearness in the upper half, and the complement of its number in the lower half. The
/// largest key wins, so the first of equally near splats does. 0 means empty.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Key(pub u64);

/// Splat number in the key of a sample that shows `before` instead of a splat.
pub(super) const BEFORE: u32 = u32::MAX;

impl Key {
    #[inline(always)]
    pub fn new(nearness: f32, number: u32) -> Self {
        Self::from_halves([!number, sortable_bits(nearness)])
    }

    #[inline(always)]
    pub fn number(self) -> u32 {
        !(self.0 as u32)
    }

    /// Returns the lower and the upper half.
    pub fn halves(self) -> [u32; 2] {
        [self.0 as u32, (self.0 >> 32) as u32]
    }

    #[inline(always)]
    pub fn from_halves([low, high]: [u32; 2]) -> Self {
        Self(u64::from(high) << 32 | u64::from(low))
    }

    #[inline(always)]
    pub fn order(self) -> u32 {
        (self.0 >> 32) as u32
    }
}

/// Samples drawn at once.
const STRIDE: usize = 8;

/// Keys of a rectangle of samples.
#[derive(Debug)]
pub(super) struct Screen {
    pub rect: Rect,
    /// Keys per row: those of the rectangle, and `STRIDE` for padding.
    pitch: usize,
    keys: Vec<Key>,
}

impl Screen {
    /// Creates the keys of a rectangle of samples, initialised by `before`.
    pub fn new(rect: Rect, before: impl Fn(i32, i32) -> Key) -> Self {
        let pitch = (rect.high[0] - rect.low[0]) as usize + STRIDE;
        let mut keys = vec![Key::default(); pitch * (rect.high[1] - rect.low[1]) as usize];
        for (y, row) in (rect.low[1]..rect.high[1]).zip(keys.chunks_exact_mut(pitch)) {
            (rect.low[0]..rect.high[0]).zip(row).for_each(|(x, key)| *key = before(x, y));
        }
        Self { rect, pitch, keys }
    }

    #[inline(always)]
    fn slot(&self, x: i32, y: i32) -> usize {
        (y - self.rect.low[1]) as usize * self.pitch + (x - self.rect.low[0]) as usize
    }

    /// Returns the key at a sample.
    #[inline(always)]
    pub fn key(&self, x: i32, y: i32) -> Key {
        self.keys[self.slot(x, y)]
    }

    /// Returns whether all samples of a rectangle already show something nearer.
    pub fn hides(&self, part: &Rect, nearness: f32) -> bool {
        let order = sortable_bits(nearness);
        let columns = (part.high[0] - part.low[0]) as usize;
        (part.low[1]..part.high[1]).all(|y| {
            let first = self.slot(part.low[0], y);
            let farthest = self.keys[first..first + columns].iter().fold(u64::MAX, |least, key| least.min(key.0));
            Key(farthest).order() > order
        })
    }

    /// Returns the keys per row.
    pub fn pitch(&self) -> i32 {
        self.pitch as i32
    }
}

vectorized! {
    /// Draws some splats with consecutive numbers.
    pub(super) fn draw_splats(screen: &mut Screen, lanes: &Lanes, count: usize, first: u32) = draw_all;
}

#[inline(always)]
fn draw_all(screen: &mut Screen, lanes: &Lanes, count: usize, first: u32) {
    for (number, (group, n)) in (first..).zip((0..count).map(|n| (n / GROUP, n % GROUP))) {
        let slot = lanes.slot[group][n];
        if slot != SEVERAL_PIXELS {
            if let Some(key) = screen.keys.get_mut(slot as usize) {
                key.0 = key.0.max(u64::from(lanes.order[group][n]) << 32 | u64::from(!number));
            }
            continue;
        }
        let [left, top] = [lanes.first[0][group][n], lanes.first[1][group][n]];
        let [right, bottom] = [lanes.last[0][group][n], lanes.last[1][group][n]];
        let [a, b] = [lanes.inverse[0][group][n], lanes.inverse[1][group][n]];
        let [c, d] = [lanes.inverse[2][group][n], lanes.inverse[3][group][n]];
        let [x, y] = [lanes.place[0][group][n], lanes.place[1][group][n]];
        let [middle_column, middle_row] = [lanes.middle[0][group][n], lanes.middle[1][group][n]];
        let (nearness, slope) = (lanes.nearness[group][n], [lanes.slope[0][group][n], lanes.slope[1][group][n]]);
        let number = u64::from(!number);
        for row in top..=bottom {
            let offset_y = row as f32 + 0.5 - y;
            let (p_start, q_start, start) = (b * offset_y, d * offset_y, nearness + slope[1] * offset_y);
            // Column of the centre if it lies in this row.
            let middle = if row == middle_row { middle_column } else { i32::MIN };
            let mut from = left;
            while from <= right {
                let slot = screen.slot(from, row);
                let Some(keys) = screen.keys[slot..].first_chunk_mut::<STRIDE>() else { break };
                let offset_x = from as f32 + 0.5 - x;
                for (i, key) in keys.iter_mut().enumerate() {
                    let offset_x = offset_x + i as f32;
                    let (p, q) = (a * offset_x + p_start, c * offset_x + q_start);
                    // With the inverse axes of an edge-on surfel, all samples of a row may be inside.
                    let is_inside = p * p + q * q <= SQUARED_RADIUS && from + i as i32 <= right;
                    let is_middle = from + i as i32 == middle;
                    let nearness = if is_inside { start + slope[0] * offset_x } else { nearness };
                    let splat_key = u64::from(sortable_bits(nearness)) << 32 | number;
                    key.0 = key.0.max(if is_inside | is_middle { splat_key } else { 0 });
                }
                from += STRIDE as i32;
            }
        }
    }
}
