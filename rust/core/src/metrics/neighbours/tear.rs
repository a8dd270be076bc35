//! Tear map of a frame.

use std::ops::Range;

use glam::DVec3;
use rayon::prelude::*;

use super::affine::{LaneMoments, Moments, WIDE};
use super::points::{BANDS, LANES, TruthPoints, reach};
use crate::base::simd::vectorized;
use crate::base::{Progress, Result};
use crate::camera::Camera;

/// Root-mean-square residual of the best affine map of a disc that is torn by one pixel along a diameter: its x, of
/// variance ¼, explains (2/3π)² / ¼ of the step's variance ¼, which leaves √(¼ − 4 (2/3π)²).
const UNIT_STEP: f64 = 0.264_335_868_4;
/// Points between two reports of progress.
const REPORTED_POINTS: usize = 1 << 10;

/// Per-pixel flags that select pixels and mark the border.
#[derive(Clone, Copy, Default)]
pub struct Border<'a> {
    /// Side of the border that each pixel's surface lies on.
    pub side: Option<&'a [bool]>,
    /// Pixels to compute; by default all.
    pub wanted: Option<&'a [bool]>,
}

/// Tears of a frame's pixels.
pub struct Tears {
    /// Tear in pixels, rows of the frame's width; NaN for pixels that are not wanted, without a surface, behind the
    /// truth's camera, or without neighbours.
    pub tear: Vec<f32>,
    /// Whether a pixel's neighbourhood lies on both sides; empty if no sides were given.
    pub parted: Vec<bool>,
}

/// Computes the tear of each pixel of a frame. Positions are relative to `origin`; ε is in pixels of the truth.
pub fn tear(
    position: &[[f32; 3]],
    origin: DVec3,
    width: usize,
    truth: &Camera,
    epsilon: f64,
    border: Border<'_>,
    progress: &Progress,
) -> Result<Tears> {
    let points = TruthPoints::new(position, origin, width, truth, epsilon, progress)?;
    progress.expect(points.len() as u64);
    let sides: Vec<f32> = match border.side {
        // Padding for a vector's lanes, as in the points.
        Some(side) => points.pixel.iter().map(|&pixel| if side[pixel as usize] { 1.0 } else { 0.0 }).collect(),
        None => vec![0.0; points.len()],
    };
    let sides = [sides, vec![0.0; LANES]].concat();
    let band = |band: usize| {
        let own = points.bands[band].1.clone();
        let targets = targets(&points, band, epsilon);
        let mut found = Vec::with_capacity(own.len());
        for from in own.clone().step_by(REPORTED_POINTS) {
            let source = from..own.end.min(from + REPORTED_POINTS);
            progress.report(source.len() as u64)?;
            gather(&points, &sides, border.wanted, source, &targets, epsilon as f32, &mut found);
        }
        Ok(found)
    };
    let found: Vec<Vec<Moments>> = (0..points.bands.len()).into_par_iter().map(band).collect::<Result<_>>()?;
    let mut tears = Tears {
        tear: vec![f32::NAN; position.len()],
        parted: vec![false; if border.side.is_some() { position.len() } else { 0 }],
    };
    for (n, moments) in found.iter().flatten().enumerate() {
        let pixel = points.pixel[n] as usize;
        if moments.count > 1.0 {
            tears.tear[pixel] = (moments.residual() / UNIT_STEP) as f32;
        }
        if let Some(parted) = tears.parted.get_mut(pixel) {
            *parted = moments.side > 0.0 && moments.side < moments.count;
        }
    }
    Ok(tears)
}

/// Points of a band that may be neighbours, by their x in the truth.
struct Target {
    range: Range<usize>,
    reach: f32,
}

/// Returns the bands that may contain neighbours of a band's points: itself and those on both sides.
fn targets(points: &TruthPoints, band: usize, epsilon: f64) -> Vec<Target> {
    let number = points.bands[band].0;
    let (before, behind) = points.bands.split_at(band);
    let sides = before.iter().rev().take(BANDS + 1).chain(behind.iter().take(BANDS + 2));
    let sides = sides.filter_map(|(other, range)| {
        Some(Target { range: range.clone(), reach: reach(other.abs_diff(number), epsilon)? })
    });
    sides.collect()
}

vectorized! {
    fn gather(
        points: &TruthPoints,
        sides: &[f32],
        wanted: Option<&[bool]>,
        source: Range<usize>,
        targets: &[Target],
        epsilon: f32,
        found: &mut Vec<Moments>,
    ) = fused moments;
}

/// Computes the moments of some of a band's points.
#[inline(always)]
fn moments<const FUSED: bool>(
    points: &TruthPoints,
    sides: &[f32],
    wanted: Option<&[bool]>,
    source: Range<usize>,
    targets: &[Target],
    epsilon: f32,
    found: &mut Vec<Moments>,
) {
    for n in source {
        if wanted.is_some_and(|wanted| !wanted[points.pixel[n] as usize]) {
            found.push(Moments::default());
            continue;
        }
        let truth = points.truth_x[n];
        let mut sums = LaneMoments::default();
        for target in targets {
            let near = &points.truth_x[target.range.clone()];
            // float32 steps at positions of millions of pixels.
            let reach = target.reach + 1e-6 * truth.abs();
            let from = target.range.start + near.partition_point(|&x| x < truth - reach);
            let to = target.range.start + near.partition_point(|&x| x <= truth + reach);
            let mut at = from;
            while at < to {
                sums.add::<FUSED>(points, sides, [at, to - at, n], epsilon * epsilon);
                at += WIDE;
            }
        }
        found.push(sums.total());
    }
}
