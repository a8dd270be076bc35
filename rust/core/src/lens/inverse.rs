//! f, f′ and f⁻¹ of many radii. Vector kernels process blocks; radii that a kernel cannot invert are solved one by one.

use std::cmp::Ordering;

use rayon::prelude::*;

use super::exact::{two_product, two_sum};
use super::radial::RadialLens;
use super::solve::{FARTHEST, Radial};
use super::table::Table;
use crate::base::error::number;
use crate::base::simd::vectorized;
use crate::base::{Error, Progress, Real, Result};

/// Number of radii per task: fixed, and small enough for the first-level cache.
const CHUNK: usize = 1 << 10;
/// Number of radii that a kernel processes together.
pub(super) const LANES: usize = 32;

/// float64 copies of a chunk's radii, aligned for vector loads.
#[repr(align(64))]
struct ChunkBuffer([f64; CHUNK]);

/// Method for f⁻¹.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InverseMethod {
    /// Newton's method, to the last bits.
    Newton,
    /// This many iterations of r ← x / (1 + k₁r² + …), as in Liebisch (2021), Alg. 1.
    FixedPoint(u32),
    /// Cubic polynomials between the nodes of a table, with the error bound of `table_bound`.
    Table,
}

impl RadialLens {
    /// Writes f(r) of radii of either sign. Radii beyond r_max give NaN, or an error if `refuse`.
    pub fn distort_all<T: Real>(&self, r: &[T], to: &mut [T], refuse: bool, progress: &Progress) -> Result<()> {
        each_chunk(r, to, refuse.then_some(self.radial.r_max), progress, |chunk| self.distort_blocks(chunk))
    }

    /// Writes f′(r) of radii of either sign; the error is at most 2 (n + 1) roundings of Σ |terms| for n coefficients.
    pub fn derivative_all<T: Real>(&self, r: &[T], to: &mut [T], refuse: bool, progress: &Progress) -> Result<()> {
        let Radial { slope, r_max, .. } = &self.radial;
        each_chunk(r, to, refuse.then_some(*r_max), progress, |chunk| slope_chunk(slope, *r_max, chunk))
    }

    /// Writes f⁻¹(x) of distorted radii of either sign. Radii beyond f(r_max) give NaN, or an error if `refuse`.
    pub fn undistort_all<T: Real>(
        &self,
        x: &[T],
        to: &mut [T],
        method: InverseMethod,
        refuse: bool,
        progress: &Progress,
    ) -> Result<()> {
        if let InverseMethod::FixedPoint(steps) = method {
            return each_chunk(x, to, None, progress, |chunk| fixed_point_chunk(&self.radial.k, steps, chunk));
        }
        let (end, exact) = (refuse.then_some(self.radial.x_max), method == InverseMethod::Newton);
        each_chunk(x, to, end, progress, |chunk| self.undistort_blocks(chunk, exact, T::SLACK))
    }

    /// Replaces each radius r by f(r). The number of radii is a multiple of `LANES`.
    pub(super) fn distort_blocks(&self, chunk: &mut [f64]) {
        distort_chunk(&self.radial.k, self.radial.r_max, chunk);
    }

    /// Replaces each distorted radius x by f⁻¹(x): from the table, or by Newton's method if `exact`. The number of
    /// radii is a multiple of `LANES`. Radii of up to (1 + `slack`) f(r_max) count as f(r_max), because of rounding.
    pub(super) fn undistort_blocks(&self, chunk: &mut [f64], exact: bool, slack: f64) {
        let mut failed = Vec::new();
        match self.table() {
            None => {
                failed.extend((0..chunk.len() as u32).filter(|&n| !(-FARTHEST..=FARTHEST).contains(&chunk[n as usize])))
            }
            Some(table) if exact => newton_chunk(&self.radial.k, &self.radial.slope, table, chunk, &mut failed),
            Some(table) => table_chunk(table, chunk, &mut failed),
        }
        let end = self.radial.x_max;
        for index in failed {
            let x = chunk[index as usize];
            let magnitude = if x.abs() <= end * (1.0 + slack) { x.abs().min(end) } else { x.abs() };
            chunk[index as usize] = self.undistort(magnitude).copysign(x);
        }
    }
}

/// Runs a kernel over float64 copies of chunks. Fails for NaN if `end`, the largest defined radius, is given.
fn each_chunk<T: Real>(
    from: &[T],
    to: &mut [T],
    end: Option<f64>,
    progress: &Progress,
    kernel: impl Fn(&mut [f64]) + Sync,
) -> Result<()> {
    let chunks = from.par_chunks(CHUNK).zip(to.par_chunks_mut(CHUNK)).map(|(from, to)| {
        // Chunks are padded with zeros to whole blocks, so that kernels need no loop for a remainder.
        let mut buffer = ChunkBuffer([0.0; CHUNK]);
        for (value, radius) in buffer.0.iter_mut().zip(from) {
            *value = radius.wide();
        }
        kernel(&mut buffer.0[..from.len().next_multiple_of(LANES)]);
        let mut has_nan = false;
        for (result, value) in to.iter_mut().zip(&buffer.0) {
            *result = T::narrow(*value);
            has_nan |= value.is_nan();
        }
        progress.check().map(|()| has_nan)
    });
    let has_nan = chunks.try_reduce(|| false, |a, b| Ok(a | b))?;
    let Some(end) = end.filter(|_| has_nan) else { return Ok(()) };
    let index = to.iter().position(|value| value.wide().is_nan()).unwrap_or(0);
    let expected = if end < FARTHEST {
        format!("radii up to {}, where the lens folds", number(end))
    } else {
        format!("numbers with a result below {}", number(FARTHEST))
    };
    Err(Error::value("r", expected, format!("{} at index {index}", number(from[index].wide()))))
}

vectorized! {
    fn distort_chunk(k: &[f64], r_max: f64, chunk: &mut [f64]) = fused distort_kernel;
    fn slope_chunk(slope: &[f64], r_max: f64, chunk: &mut [f64]) = fused slope_kernel;
    fn fixed_point_chunk(k: &[f64], steps: u32, chunk: &mut [f64]) = fused fixed_point_kernel;
    fn table_chunk(table: &Table, chunk: &mut [f64], failed: &mut Vec<u32>) = fused table_kernel;
    fn newton_chunk(k: &[f64], slope: &[f64], table: &Table, chunk: &mut [f64], failed: &mut Vec<u32>) =
        fused newton_kernel;
}

#[inline(always)]
fn distort_kernel<const FUSED: bool>(k: &[f64], r_max: f64, chunk: &mut [f64]) {
    for block in chunk.as_chunks_mut::<LANES>().0 {
        let r = *block;
        residual_block::<FUSED>(k, &r, &[0.0; LANES], block);
        for n in 0..LANES {
            let is_defined = (r[n].abs() <= r_max) & (block[n].abs() <= FARTHEST);
            // f is odd; copying the sign also restores the sign of zero.
            block[n] = if is_defined { block[n].copysign(r[n]) } else { f64::NAN };
        }
    }
}

/// Writes `exact::distort` minus x for a block, with the same operations.
#[inline(always)]
fn residual_block<const FUSED: bool>(k: &[f64], r: &[f64; LANES], x: &[f64; LANES], to: &mut [f64; LANES]) {
    let (mut square, mut square_low) = ([0.0; LANES], [0.0; LANES]);
    for n in 0..LANES {
        (square[n], square_low[n]) = two_product::<FUSED>(r[n], r[n]);
    }
    let (mut high, mut low) = ([0.0; LANES], [0.0; LANES]);
    for &c in k.iter().rev() {
        for n in 0..LANES {
            let (sum, sum_error) = two_sum(high[n], c);
            let (product, product_error) = two_product::<FUSED>(sum, square[n]);
            low[n] = product_error + (sum * square_low[n] + (low[n] + sum_error) * square[n]);
            high[n] = product;
        }
    }
    for n in 0..LANES {
        let (sum, sum_error) = two_sum(high[n], 1.0);
        let (product, product_error) = two_product::<FUSED>(sum, r[n]);
        to[n] = (product - x[n]) + (product_error + (low[n] + sum_error) * r[n]);
    }
}

#[inline(always)]
fn slope_kernel<const FUSED: bool>(slope: &[f64], r_max: f64, chunk: &mut [f64]) {
    for block in chunk.as_chunks_mut::<LANES>().0 {
        let r = *block;
        let (highest, lower) = slope.split_last().unwrap_or((&1.0, &[]));
        *block = [*highest; LANES];
        for &c in lower.iter().rev() {
            for n in 0..LANES {
                block[n] = block[n] * (r[n] * r[n]) + c;
            }
        }
        for n in 0..LANES {
            block[n] = if (r[n].abs() <= r_max) & (r[n].abs() <= FARTHEST) { block[n] } else { f64::NAN };
        }
    }
}

#[inline(always)]
fn fixed_point_kernel<const FUSED: bool>(k: &[f64], steps: u32, chunk: &mut [f64]) {
    for block in chunk.as_chunks_mut::<LANES>().0 {
        let x = *block;
        for _ in 0..steps {
            let mut factor = [0.0; LANES];
            for &c in k.iter().rev() {
                for n in 0..LANES {
                    factor[n] = (factor[n] + c) * (block[n] * block[n]);
                }
            }
            for n in 0..LANES {
                block[n] = x[n] / (1.0 + factor[n]);
            }
        }
    }
}

/// Evaluates the table's cubic polynomials at |x| for a block. Results beyond the last interval are undefined.
#[inline(always)]
pub(super) fn cubic_block(table: &Table, x: &[f64; LANES], to: &mut [f64; LANES]) {
    const MANTISSA: u64 = (1 << (f64::MANTISSA_DIGITS - 1)) - 1;
    let last = table.cubics.len() as u64 - 1;
    let fineness = f64::MANTISSA_DIGITS - 1 - table.shift;
    let scale = 1.0 / table.first;
    let (mut index, mut position) = ([0u64; LANES], [0.0; LANES]);
    for n in 0..LANES {
        let x = x[n].abs();
        let bits = x.to_bits();
        let is_first = x < table.first;
        // The high bits of the mantissa belong to the interval's number; the low bits are the position in it, 0 to 1.
        let fraction = f64::from_bits((bits << fineness) & MANTISSA | 1.0f64.to_bits()) - 1.0;
        position[n] = if is_first { x * scale } else { fraction };
        let number = (bits >> table.shift).wrapping_sub(table.base - 1);
        let number = if is_first { 0 } else { number };
        index[n] = if number < last { number } else { last };
    }
    for n in 0..LANES {
        // SAFETY: the index was clamped to the table, which has at least one cubic.
        let [a, b, c, d] = *unsafe { table.cubics.get_unchecked(index[n] as usize) };
        to[n] = a + position[n] * (b + position[n] * (c + position[n] * d));
    }
}

#[inline(always)]
fn table_kernel<const FUSED: bool>(table: &Table, chunk: &mut [f64], failed: &mut Vec<u32>) {
    for (number, block) in chunk.as_chunks_mut::<LANES>().0.iter_mut().enumerate() {
        let x = *block;
        let mut r = [0.0; LANES];
        cubic_block(table, &x, &mut r);
        let mut has_failed = false;
        for n in 0..LANES {
            let is_inside = x[n].abs() < table.end;
            has_failed |= !is_inside;
            block[n] = if is_inside { r[n].copysign(x[n]) } else { x[n] };
        }
        if has_failed {
            let lanes = (0..LANES).filter(|&n| x[n].abs().partial_cmp(&table.end) != Some(Ordering::Less));
            failed.extend(lanes.map(|n| (number * LANES + n) as u32));
        }
    }
}

/// Refines the table's value by two Newton steps; the second computes its residual with twice the precision.
#[inline(always)]
fn newton_kernel<const FUSED: bool>(k: &[f64], slope: &[f64], table: &Table, chunk: &mut [f64], failed: &mut Vec<u32>) {
    for (number, block) in chunk.as_chunks_mut::<LANES>().0.iter_mut().enumerate() {
        let mut x = *block;
        for x in &mut x {
            *x = x.abs();
        }
        let mut start = [0.0; LANES];
        cubic_block(table, &x, &mut start);

        let (mut factor, mut steepness) = ([0.0; LANES], [0.0; LANES]);
        for i in (0..k.len()).rev() {
            for n in 0..LANES {
                let square = start[n] * start[n];
                factor[n] = (factor[n] + k[i]) * square;
                steepness[n] = (steepness[n] + slope[i + 1]) * square;
            }
        }
        let (mut r, mut inverse) = ([0.0; LANES], [0.0; LANES]);
        for n in 0..LANES {
            inverse[n] = 1.0 / (1.0 + steepness[n]);
            r[n] = start[n] - (start[n] * (1.0 + factor[n]) - x[n]) * inverse[n];
        }

        let mut residual = [0.0; LANES];
        residual_block::<FUSED>(k, &r, &x, &mut residual);
        let mut is_solved = [false; LANES];
        let mut all_solved = true;
        for n in 0..LANES {
            let (first_step, second_step) = ((r[n] - start[n]).abs(), (residual[n] * inverse[n]).abs());
            let root = r[n] - residual[n] * inverse[n];
            // With the slope at the start, the second step's error is 2 second_step² / first_step, at most ¼ ulp.
            let is_accurate = second_step * second_step <= 1e-17 * (root * first_step)
                || second_step <= 1e-14 * root && first_step <= 1e-9 * root;
            is_solved[n] = is_accurate && x[n] < table.start_end;
            all_solved &= is_solved[n];
            block[n] = if is_solved[n] { root.copysign(block[n]) } else { block[n] };
        }
        if !all_solved {
            failed.extend((0..LANES).filter(|&n| !is_solved[n]).map(|n| (number * LANES + n) as u32));
        }
    }
}
