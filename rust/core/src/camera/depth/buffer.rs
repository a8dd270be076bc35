//! Depth buffer of a view or of a projection matrix.

use rayon::prelude::*;

use super::super::view::Projection;
use super::block::{self, BLOCK, Depth, DepthRow, Ranged};
use crate::base::{Error, Progress, Result, ensure, number};

/// Kernel over one block: (row, first column, values, results). Returns true if it refuses a value, with result NaN.
type Kernel<T, U> = fn(&DepthRow, i32, &[T; BLOCK], &mut [U; BLOCK]) -> bool;

/// Number of pixels in one task.
const TASK: usize = 1 << 15;

/// Near and far plane; geometry between them is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Planes {
    /// Distance of the near plane along the viewing axis, metres.
    pub near: f64,
    /// Distance of the far plane, metres; may be infinite for perspective views.
    pub far: f64,
    /// Whether the near plane has depth 1 instead of 0.
    pub reverse: bool,
}

/// Mapping from the values and pixels of a depth buffer to distances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthBuffer {
    width: usize,
    height: usize,
    /// Inverse distances along the viewing axis at depths 0 and 1; distances for parallel rays.
    ends: [f64; 2],
    /// Depth where nothing was drawn, 0 or 1; an index into `ends`.
    background: usize,
    parallel: bool,
    /// Tangents x, y of the direction through the first pixel's centre.
    first: [f64; 2],
    /// Change of the tangents from one pixel to the next, to the right and downwards.
    steps: [[f64; 2]; 2],
}

impl DepthBuffer {
    /// Creates the buffer of a view.
    pub fn new(projection: Projection, planes: Planes, width: usize, height: usize) -> Result<Self> {
        let Planes { near, far, reverse } = planes;
        let parallel = matches!(projection, Projection::Orthographic(_));
        let least = if parallel { 0.0 } else { f64::MIN_POSITIVE };
        let is_valid = near >= least && near.is_finite();
        ensure!(is_valid, "near", "a finite number above 0 (or 0 for parallel rays)", number(near));
        let is_valid = far > near && (!parallel || far.is_finite());
        let expected = if parallel { "a finite number above near" } else { "a number above near, or infinity" };
        ensure!(is_valid, "far", expected, number(far));
        let fov = projection.fov();
        fov.validate()?;
        let [w, h] = [width as f64, height as f64];
        let (dx, dy) = ((fov.right - fov.left) / w, (fov.down - fov.up) / h);
        let ends = if parallel { [near, far] } else { [1.0 / near, 1.0 / far] };
        Ok(Self {
            width,
            height,
            ends: if reverse { [ends[1], ends[0]] } else { ends },
            background: usize::from(!reverse),
            parallel,
            first: [fov.left + 0.5 * dx, fov.up + 0.5 * dy],
            steps: [[dx, 0.0], [0.0, dy]],
        })
    }

    /// Creates the buffer of a projection matrix, given by rows; it multiplies column vectors (x, y, z, 1). The
    /// projected depth runs from `low` (0 or −1) to 1 and is stored as 0 to 1; y points up. The matrix determines the
    /// planes, whether depth is reversed, an off-axis view, and the viewing direction (−z or z).
    pub fn from_matrix(rows: [[f64; 4]; 4], low: f64, width: usize, height: usize) -> Result<Self> {
        let got = format!("{rows:?}");
        let are_finite = rows.as_flattened().iter().all(|entry| entry.is_finite());
        ensure!(are_finite, "projection", "finite numbers", got);
        let [[a, b, c, x0], [d, e, f, y0], [i, j, g, h], last] = rows;
        let parallel = last == [0.0, 0.0, 0.0, 1.0];
        let towards = last[2];
        let is_known = parallel || (last == [0.0, 0.0, towards, 0.0] && towards.abs() == 1.0);
        let expected = "a matrix with the last row (0, 0, -1, 0), (0, 0, 1, 0) or (0, 0, 0, 1)";
        ensure!(is_known, "projection", expected, got);
        let determinant = a * e - b * d;
        let is_independent = [i, j] == [0.0; 2] && determinant != 0.0;
        let expected = "a matrix whose depth depends on z alone and whose x and y are independent";
        ensure!(is_independent, "projection", expected, got);
        let skew = if parallel { [c, f] } else { [x0, y0] };
        ensure!(skew == [0.0; 2], "projection", "rays from the origin, or parallel to the axis", got);
        // Depth is (g z + h)/w, with w = ±z, or w = 1 for parallel rays.
        let mut ends =
            if parallel { [(low - h) / g, (1.0 - h) / g] } else { [(low - g / towards) / h, (1.0 - g / towards) / h] };
        if parallel && ends.iter().all(|&z| z <= 0.0) {
            ends = [-ends[0], -ends[1]];
        }
        // Index of the near plane's end: the larger inverse distance or, for parallel rays, the smaller distance.
        let near_end = usize::from((ends[1] > ends[0]) != parallel);
        let ahead = if parallel { ends[0].min(ends[1]) >= 0.0 } else { ends[near_end] > 0.0 };
        let is_valid = ahead && ends[0] != ends[1] && ends.iter().all(|end| end.is_finite());
        let expected = "a matrix with its near plane in front of the eye and its far plane beyond the near plane";
        ensure!(is_valid, "projection", expected, got);
        // The inverse of the matrix's 2 × 2 part maps the image's corner and pixel steps to tangents.
        let tangents_of = |p: [f64; 2]| [(e * p[0] - b * p[1]) / determinant, (a * p[1] - d * p[0]) / determinant];
        let middle = if parallel { [x0, y0] } else { [c / towards, f / towards] };
        let (right, down) = (2.0 / width as f64, -2.0 / height as f64);
        Ok(Self {
            width,
            height,
            ends,
            background: 1 - near_end,
            parallel,
            first: tangents_of([0.5 * right - 1.0 - middle[0], 1.0 + 0.5 * down - middle[1]]),
            steps: [tangents_of([right, 0.0]), tangents_of([0.0, down])],
        })
    }

    /// Writes the distances from the eye in metres, ∞ where nothing was drawn. `depth` holds one or more images.
    pub fn ranges<T: Depth>(&self, depth: &[T], ranges: &mut [T::Range], progress: &Progress) -> Result<()> {
        self.run_kernel(depth, ranges, block::ranges, ("depth", T::EXPECTED), progress)
    }

    /// Writes the depths at distances from the eye, the inverse of `ranges`; background beyond the far plane.
    pub fn depths<T: Ranged>(&self, ranges: &[T], depth: &mut [T], progress: &Progress) -> Result<()> {
        let refusal = ("ranges", "distances at or beyond the near plane");
        self.run_kernel(ranges, depth, block::depths, refusal, progress)
    }

    /// Runs a kernel over all rows. Fails at the first refused value, with the argument's name and accepted values.
    fn run_kernel<T: Copy + Into<f64> + Sync, U: Copy + Default + Into<f64> + Send>(
        &self,
        values: &[T],
        results: &mut [U],
        kernel: Kernel<T, U>,
        (argument, expected): (&'static str, &str),
        progress: &Progress,
    ) -> Result<()> {
        assert_eq!(values.len(), results.len(), "as many results as values");
        let rows = (TASK / self.width).max(1);
        let task = |(n, (values, results)): (usize, (&[T], &mut [U]))| {
            if progress.check().is_err() {
                return None;
            }
            let mut refused = false;
            let pairs = values.chunks(self.width).zip(results.chunks_mut(self.width));
            for (row, (values, results)) in (n * rows..).zip(pairs) {
                refused |= run_row(&self.depth_row(row % self.height), values, results, kernel);
            }
            let refused_index = if refused { results.iter().position(|&result| result.into().is_nan()) } else { None };
            refused_index.map(|index| (n * rows * self.width + index, values[index].into()))
        };
        let size = rows * self.width;
        let tasks = values.par_chunks(size).zip(results.par_chunks_mut(size)).enumerate();
        let first = tasks.filter_map(task).min_by_key(|(pixel, _)| *pixel);
        progress.check()?;
        first.map_or(Ok(()), |(pixel, value)| {
            let (row, column) = (pixel / self.width, pixel % self.width);
            let (image, row) = (row / self.height, row % self.height);
            let got = format!("{} in row {row}, column {column} of image {image}", number(value));
            Err(Error::value(argument, expected, got))
        })
    }

    fn depth_row(&self, row: usize) -> DepthRow {
        let coordinate = |axis: usize| self.first[axis] + row as f64 * self.steps[1][axis];
        DepthRow {
            start: [coordinate(0), coordinate(1)],
            step: self.steps[0],
            ends: self.ends,
            background: self.background as f64,
            parallel: self.parallel,
        }
    }
}

/// Runs a kernel over one row. Returns whether a value may have been refused; only refused values have the result NaN.
fn run_row<T: Copy, U: Copy + Default>(row: &DepthRow, values: &[T], results: &mut [U], kernel: Kernel<T, U>) -> bool {
    let (blocks, remaining) = values.as_chunks::<BLOCK>();
    let (block_results, remaining_results) = results.as_chunks_mut::<BLOCK>();
    let (mut column, mut refused) = (0, false);
    for (block, results) in blocks.iter().zip(block_results) {
        refused |= kernel(row, column, block, results);
        column += BLOCK as i32;
    }
    if let Some(&last) = remaining.last() {
        // The remaining values are padded to a block. The kernel may refuse a padded column although it accepts the same
        // value inside the image, so the caller searches the results for NaN.
        let (mut block, mut padded) = ([last; BLOCK], [U::default(); BLOCK]);
        block[..remaining.len()].copy_from_slice(remaining);
        refused |= kernel(row, column, &block, &mut padded);
        remaining_results.copy_from_slice(&padded[..remaining.len()]);
    }
    refused
}
