//! Pixels of the third camera's picture that an eye looks up.
//!
//! For each of its pixels that has samples without an own surface, an eye looks up the pixels around the corresponding
//! position. If eyes are not rotated, their rows lie along rows of the third camera, and runs of pixels are marked.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

use rayon::prelude::*;

use super::assembly::{EyeMap, neighbours, pixels};
use super::rig::{Rig, Side};
use crate::base::memory::{room_for, try_vec};
use crate::base::{Progress, Result};
use crate::render::tiles::sample_offsets;

/// Maximum tilt of straight rows, pixels.
const MAX_TILT: f64 = 1e-9;
/// Margin around a run, pixels; far more than rounding.
const MARGIN: f64 = 1e-6;
/// Pixels of a row tested at once.
const BLOCK: usize = 64;

impl Rig {
    /// Returns, for each pixel of the third camera, whether an eye looks it up. `coverage` has the fraction of each
    /// eye pixel that its own surfaces cover. Resolved pictures look up `samples` positions per pixel, others one.
    pub fn needed(&self, coverage: [&[f32]; 2], samples: u32, progress: &Progress) -> Result<Vec<bool>> {
        room_for(pixels(self.center_size) as u64)?;
        let [left, right] = coverage;
        let maps = [self.eye_map(Side::Left, left)?, self.eye_map(Side::Right, right)?];
        if samples == 1 && maps.iter().all(EyeMap::is_straight) {
            self.mark_runs(&maps, progress)
        } else {
            self.mark_pixels(&maps, samples, progress)
        }
    }

    fn mark_runs(&self, maps: &[EyeMap<'_>; 2], progress: &Progress) -> Result<Vec<bool>> {
        let lines: Vec<Vec<Line>> = maps.iter().map(EyeMap::lines).collect();
        let (width, height) = self.center_size;
        let mut mask = try_vec(false, width as usize * height as usize)?;
        mask.par_chunks_mut(width as usize).enumerate().try_for_each(|(y, row)| {
            for lines in &lines {
                // Lines ascend, because rows have the same order in both pictures.
                let first = lines.partition_point(|line| line.rows.end <= y);
                for line in lines[first..].iter().take_while(|line| line.rows.start <= y) {
                    line.runs.iter().for_each(|run| row[run.clone()].fill(true));
                }
            }
            progress.check()
        })?;
        Ok(mask)
    }

    fn mark_pixels(&self, maps: &[EyeMap<'_>; 2], samples: u32, progress: &Progress) -> Result<Vec<bool>> {
        let mask: Vec<AtomicBool> = (0..pixels(self.center_size)).map(|_| AtomicBool::new(false)).collect();
        let offsets = sample_offsets(samples);
        for map in maps {
            map.coverage.par_chunks(map.eye.0).enumerate().try_for_each(|(row, coverage)| {
                for (column, _) in coverage.iter().enumerate().filter(|(_, covered)| **covered < 1.0) {
                    for [x, y] in &offsets {
                        let taps = map.taps(map.lookup_position(column as f64 + x, row as f64 + y));
                        taps.pixels.iter().for_each(|&pixel| mask[pixel].store(true, Ordering::Relaxed));
                    }
                }
                progress.check()
            })?;
        }
        Ok(mask.into_iter().map(AtomicBool::into_inner).collect())
    }
}

/// Third-camera pixels that a row of an eye looks up: runs of columns in several rows.
struct Line {
    rows: Range<usize>,
    runs: Vec<Range<usize>>,
}

impl EyeMap<'_> {
    /// Returns whether the eye's rows lie along rows of the third camera, as for eyes that are not rotated.
    fn is_straight(&self) -> bool {
        let [x, y, z] = [self.to_center.x_axis, self.to_center.y_axis, self.to_center.z_axis];
        let (width, height) = (self.eye.0 as f64, self.eye.1 as f64);
        let tilt = [x.y * width, y.x * height, x.z * width, y.z * height].map(f64::abs);
        x.x * z.z > 0.0 && y.y * z.z > 0.0 && tilt.into_iter().fold(0.0, f64::max) < MAX_TILT * z.z.abs()
    }

    fn lines(&self) -> Vec<Line> {
        let line = |(row, coverage): (usize, &[f32])| {
            let y = self.lookup_position(0.5, row as f64 + 0.5).y;
            let columns = |run: Range<usize>| {
                let [from, to] =
                    [run.start, run.end - 1].map(|x| self.lookup_position(x as f64 + 0.5, row as f64 + 0.5).x);
                pixels_around(from, to, self.size.0)
            };
            Line {
                rows: pixels_around(y, y, self.size.1),
                runs: uncovered_runs(coverage).into_iter().map(columns).collect(),
            }
        };
        self.coverage.par_chunks(self.eye.0).enumerate().map(line).collect()
    }
}

/// Returns the pixels around all positions in an interval.
fn pixels_around(from: f64, to: f64, count: u32) -> Range<usize> {
    neighbours(from - MARGIN, count).0..neighbours(to + MARGIN, count).1 + 1
}

/// Returns the runs of pixels that have samples without a surface.
fn uncovered_runs(coverage: &[f32]) -> Vec<Range<usize>> {
    let mut runs: Vec<Range<usize>> = Vec::new();
    let mut add = |run: Range<usize>| match runs.last_mut() {
        Some(last) if last.end == run.start => last.end = run.end,
        _ => runs.push(run),
    };
    for (n, block) in coverage.chunks(BLOCK).enumerate() {
        let (start, uncovered) =
            (n * BLOCK, block.iter().map(|covered| u32::from(*covered < 1.0)).sum::<u32>() as usize);
        if uncovered == block.len() {
            add(start..start + block.len());
        } else if uncovered > 0 {
            let pixels = block.iter().enumerate().filter(|(_, covered)| **covered < 1.0);
            pixels.for_each(|(k, _)| add(start + k..start + k + 1));
        }
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random::uniform;

    #[test]
    fn runs_are_the_pixels_below_one() {
        for (length, fraction) in [(0, 0.5), (1, 0.5), (64, 0.0), (200, 1.0), (517, 0.5), (517, 0.02), (517, 0.98)] {
            let covered = |n: usize| uniform(9, n as u64, 0) < fraction;
            let coverage: Vec<f32> = (0..length).map(|n| if covered(n) { 1.0 } else { 0.7 }).collect();
            let runs = uncovered_runs(&coverage);
            let listed: Vec<usize> = runs.iter().cloned().flatten().collect();
            let expected: Vec<usize> = (0..length).filter(|&n| !covered(n)).collect();
            assert_eq!(listed, expected, "{length} {fraction}");
            assert!(runs.windows(2).all(|pair| pair[0].end < pair[1].start));
        }
    }
}
