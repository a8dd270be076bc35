//! Points of a frame sorted by their position in the truth, so that neighbours are close in memory.

use std::ops::Range;

use glam::{DVec2, DVec3, Vec3};
use rayon::prelude::*;

use crate::base::mapped::pieces;
use crate::base::memory::{room_for_values, try_collect, try_vec};
use crate::base::sort::{sort_by_key, total_order};
use crate::base::{Progress, Result, ensure};
use crate::camera::Camera;

/// Points per vector operation.
pub(super) const LANES: usize = 16;
/// Bands per ε. Narrower bands contain fewer points that are too far away, but there are more of them.
pub(super) const BANDS: usize = 4;
/// Points between two reports of progress.
pub(super) const REPORTED_POINTS: usize = 1 << 10;
/// Maximum coordinate, pixels of the truth. Points beyond it, where float32 has no fractions, have no neighbours.
const MAX_COORDINATE: f64 = 1e7;

/// Points sorted by their position in the truth: in bands of y, and by x within a band. A position is the pixel plus a
/// separate shift, because a single float32 number would be wrong by up to 1e-4 pixels. The arrays end with padding for
/// a vector's lanes.
#[derive(Default)]
pub(super) struct TruthPoints {
    pub x: Vec<f32>,
    pub y: Vec<f32>,
    pub shift_x: Vec<f32>,
    pub shift_y: Vec<f32>,
    /// Position in the truth, used only by the search.
    pub truth_x: Vec<f32>,
    pub pixel: Vec<u32>,
    /// Non-empty bands in order: number and points.
    pub bands: Vec<(i64, Range<usize>)>,
}

/// A point before sorting.
#[derive(Clone, Copy)]
struct TruthPosition {
    band: i64,
    pixel: u32,
    truth: DVec2,
}

/// Points of a band that may be neighbours: their x in the truth differs by at most `reach`.
pub(super) struct Target {
    pub range: Range<usize>,
    pub reach: f32,
}

/// Returns the maximum distance in x between neighbours whose band numbers differ by `steps`; `None` if there are none.
fn reach(steps: u64, epsilon: f64) -> Option<f32> {
    if steps > BANDS as u64 {
        return None;
    }
    // Between bands whose numbers differ by two lies one whole band.
    let gap = steps.saturating_sub(1) as f64 * epsilon / BANDS as f64;
    // Widened by more than float32's rounding, so that no neighbour is missed.
    Some(((epsilon * epsilon - gap * gap).max(0.0).sqrt() * (1.0 + 1e-6)) as f32)
}

/// Fails for implausible lengths in pixels.
pub(super) fn check_pixels(argument: &'static str, length: f64) -> Result<()> {
    ensure!((1e-6..=1e4).contains(&length), argument, "from a millionth of a pixel to 10,000 pixels", length);
    Ok(())
}

impl TruthPoints {
    pub fn new(
        position: &[[f32; 3]],
        origin: DVec3,
        width: usize,
        truth: &Camera,
        epsilon: f64,
        progress: &Progress,
    ) -> Result<Self> {
        check_pixels("epsilon", epsilon)?;
        let is_valid = u32::try_from(position.len()).is_ok() && width > 0;
        ensure!(is_valid, "frame", "fewer than 2³² pixels", position.len());
        let position_of = |(pixel, position): (usize, &[f32; 3])| {
            if pixel % REPORTED_POINTS == 0 {
                progress.check().ok()?;
            }
            let point = Vec3::from_array(*position).as_dvec3() + origin;
            let truth = truth.project(point).filter(|position| position.is_finite())?.truncate();
            let is_near = truth.abs().max_element() < MAX_COORDINATE;
            // The cast saturates.
            let band = (truth.y * BANDS as f64 / epsilon).floor() as i64;
            is_near.then_some(TruthPosition { band, pixel: pixel as u32, truth })
        };
        // The threads' arrays, and the array of all points.
        room_for_values::<[TruthPosition; 2]>(position.len())?;
        let mut positions: Vec<TruthPosition> = position.par_iter().enumerate().filter_map(position_of).collect();
        sort_by_key(&mut positions, |point| point.band, progress)?;
        let mut bands: Vec<(i64, Range<usize>)> = Vec::new();
        for (n, point) in positions.iter().enumerate() {
            match bands.last_mut() {
                Some((band, range)) if *band == point.band => range.end = n + 1,
                _ => bands.push((point.band, n..n + 1)),
            }
        }
        let points_of_bands = pieces(&mut positions, bands.iter().map(|(_, range)| range.len()));
        let by_x = |points| sort_by_key(points, |point: &TruthPosition| total_order(point.truth.x), progress);
        points_of_bands.into_par_iter().try_for_each(by_x)?;
        let pixel_center = |point: &TruthPosition| {
            let (column, row) = (point.pixel as usize % width, point.pixel as usize / width);
            DVec2::new(column as f64 + 0.5, row as f64 + 0.5)
        };
        let values = |value: &(dyn Fn(&TruthPosition) -> f64 + Sync)| {
            let mut values = try_vec(0.0f32, positions.len() + LANES)?;
            positions.par_iter().zip(&mut values).for_each(|(point, slot)| *slot = value(point) as f32);
            progress.check().map(|()| values)
        };
        Ok(Self {
            x: values(&|point| pixel_center(point).x)?,
            y: values(&|point| pixel_center(point).y)?,
            shift_x: values(&|point| point.truth.x - pixel_center(point).x)?,
            shift_y: values(&|point| point.truth.y - pixel_center(point).y)?,
            truth_x: values(&|point| point.truth.x)?,
            pixel: try_collect(positions.par_iter().map(|point| point.pixel))?,
            bands,
        })
    }

    /// Returns the bands among `others` that may contain neighbours of a band's points.
    pub fn targets<'a>(
        &self,
        band: usize,
        others: impl Iterator<Item = &'a (i64, Range<usize>)>,
        epsilon: f64,
    ) -> Vec<Target> {
        let number = self.bands[band].0;
        let target = |(other, range): &(i64, Range<usize>)| {
            Some(Target { range: range.clone(), reach: reach(other.abs_diff(number), epsilon)? })
        };
        others.filter_map(target).collect()
    }

    pub fn len(&self) -> usize {
        self.pixel.len()
    }
}
