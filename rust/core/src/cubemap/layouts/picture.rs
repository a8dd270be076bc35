//! Panoramas, and look-ups in flat ones.

use glam::DVec3;

use super::super::lookup::{BLOCK, MIN_WEIGHT, Positions, SampledPicture, Sampler, TexelFilter, extreme, keys};
use super::flat;
use super::layout::Grid;
use crate::base::{Real, Result, ensure};

/// A picture of all directions (panorama).
#[derive(Clone, Copy, Debug)]
pub struct Panorama<'a, T> {
    pub(super) grid: Grid,
    pub(super) values: &'a [T],
    pub(super) channels: usize,
}

impl<'a, T> Panorama<'a, T> {
    /// Creates a panorama; checks that the values fill the grid.
    pub fn new(grid: Grid, values: &'a [T], channels: usize) -> Result<Self> {
        let expected = grid.texels() * channels;
        ensure!(values.len() == expected, "values", format!("{expected} values"), values.len());
        Ok(Self { grid, values, channels })
    }
}

/// Prepares look-ups in a flat layout. Directions must be finite, not zero, and neither so long nor so short that their
/// squares overflow or underflow.
pub(super) fn flat_sampler<T: Real>(picture: Panorama<'_, T>, filter: TexelFilter) -> Sampler<'_, T, Panorama<'_, T>> {
    let Grid { width, height, .. } = picture.grid;
    Sampler::new((picture.values, width, picture.channels), width.min(height), filter, picture)
}

impl<T: Real> SampledPicture<T> for Panorama<'_, T> {
    fn locate<D: Real>(&self, block: &[[D; 3]; BLOCK], filter_extent: [u32; 2], positions: &mut Positions) -> u32 {
        let mut wide = [[0.0; 3]; BLOCK];
        for (wide, d) in wide.iter_mut().zip(block) {
            *wide = d.map(Real::wide);
        }
        flat::locate(&wide, self.grid, filter_extent, positions);
        0
    }

    fn sample(&self, d: DVec3, filter: TexelFilter, out: &mut [T]) {
        let p = self.grid.position(d) - 0.5;
        let before = p.floor();
        let (s, t) = (p.x - before.x, p.y - before.y);
        let (across, down) = if filter == TexelFilter::Cubic {
            (keys(s), keys(t))
        } else {
            ([0.0, 1.0 - s, s, 0.0], [0.0, 1.0 - t, t, 0.0])
        };
        let least = if matches!(filter, TexelFilter::Min | TexelFilter::Max) { MIN_WEIGHT } else { 0.0 };
        let mut taps = [(0usize, 0.0f64); 16];
        let mut count = 0;
        for (row, y) in (before.y as i64 - 1..).zip(down) {
            for (column, x) in (before.x as i64 - 1..).zip(across) {
                // Taps without weight are skipped, because 0 × ∞ is NaN.
                if (x * y).abs() > least {
                    taps[count] = (self.grid.wrap(row, column) * self.channels, x * y);
                    count += 1;
                }
            }
        }
        for (channel, value) in out.iter_mut().enumerate() {
            let texel = |&(start, _): &(usize, f64)| self.values[start + channel];
            let taps = taps[..count].iter();
            *value = match filter {
                TexelFilter::Min => extreme(taps.map(texel), |a, b| a < b),
                TexelFilter::Max => extreme(taps.map(texel), |a, b| a > b),
                _ => T::narrow(taps.map(|tap| texel(tap).wide() * tap.1).sum()),
            };
        }
    }
}
