//! Passes over all points: extent, mean, extreme points, farthest point.

use glam::DVec3;
use rayon::prelude::*;

use crate::base::memory::try_append;
use crate::base::simd::{prefetch, vectorized};
use crate::base::{Error, Progress, Real, Result};

/// Number of points per task: fixed, so that results do not depend on the number of threads.
const CHUNK: usize = 1 << 12;
/// Number of points scanned between two requests for memory for the copied ones.
const POINTS_PER_REQUEST: usize = CHUNK << 8;
/// Number of points that one vector operation processes.
const LANES: usize = 8;

/// Prefetch distance, blocks.
const PREFETCHED_BLOCKS: usize = 12;

/// Number of directions along which extreme points are found: three axes and four space diagonals.
const DIRECTIONS: usize = 7;
/// Number of axes; they come first among the directions.
const AXES: usize = 3;
/// Only every eighth block is projected onto the diagonals.
const DIAGONAL_STRIDE: usize = 8;

/// A centre and a radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// The centre.
    pub center: DVec3,
    /// The radius, at least 0.
    pub radius: f64,
}

/// Minimum and maximum along each direction.
#[derive(Clone, Copy, Debug)]
pub struct Extremes {
    low: [f64; DIRECTIONS],
    high: [f64; DIRECTIONS],
}

/// Projects a point onto the directions; the diagonals are not normalised.
#[inline(always)]
fn project<T: Real>(&[x, y, z]: &[T; 3]) -> [f64; DIRECTIONS] {
    let (x, y, z) = (x.wide(), y.wide(), z.wide());
    [x, y, z, x + y + z, x + y - z, x - y + z, x - y - z]
}

vectorized! {
    /// Returns the maximum squared distance from a centre, and the index of its point.
    fn farthest<T: Real>(points: &[[T; 3]], origin: DVec3, center: DVec3) -> (f64, usize) = farthest_kernel;
    /// Appends the points, relative to the origin, whose squared distance from a centre exceeds a limit.
    fn collect_beyond<T: Real>(points: &[[T; 3]], origin: DVec3, center: DVec3, limit: f64, outside: &mut Vec<[f64; 3]>)
        = beyond_kernel;
    /// Returns the sum of the points, relative to the origin.
    fn sum<T: Real>(points: &[[T; 3]], origin: DVec3) -> DVec3 = sum_kernel;
    /// Returns the minimum and maximum along each direction; NaN if a coordinate is not finite.
    fn extremes<T: Real>(points: &[[T; 3]]) -> Extremes = extremes_kernel;
}

/// Finite points. Results are relative to the origin, so that they are precise even if all points lie far from zero.
pub(super) struct Cloud<'a, T> {
    pub points: &'a [[T; 3]],
    pub progress: &'a Progress,
    /// The first point.
    pub origin: DVec3,
    /// Minimum and maximum coordinates, relative to the origin.
    pub bounds: [DVec3; 2],
    /// Extreme points along each direction, relative to the origin.
    pub extremes: Vec<DVec3>,
}

impl<'a, T: Real> Cloud<'a, T> {
    /// Scans all points; fails for an empty array and for points that are not finite.
    pub fn new(points: &'a [[T; 3]], progress: &'a Progress) -> Result<Self> {
        let Some(first) = points.first() else {
            return Err(Error::value("points", "at least one point", "none"));
        };
        let origin = DVec3::from_array(first.map(T::wide));
        let chunks: Vec<Extremes> = each_chunk(points, progress, |_, points| extremes(points))?;
        let all = Extremes {
            low: std::array::from_fn(|n| chunks.iter().fold(f64::INFINITY, |low, chunk| lesser(chunk.low[n], low))),
            high: std::array::from_fn(|n| -chunks.iter().fold(f64::INFINITY, |low, chunk| lesser(-chunk.high[n], low))),
        };
        let bounds = [all.low, all.high].map(|values| DVec3::new(values[0], values[1], values[2]));
        if !(bounds[0].is_finite() && bounds[1].is_finite()) {
            let index = points.iter().position(|point| !point.iter().all(|x| x.wide().is_finite())).unwrap_or(0);
            let got = points[index].map(T::wide);
            return Err(Error::value("points", "finite coordinates", format!("{got:?} at index {index}")));
        }
        // Chunks store extreme values, not points: the point is found by a second scan of the chunk with that value.
        let point = |is_extreme: &dyn Fn(&[f64; DIRECTIONS]) -> bool, chunk: Option<usize>| {
            let from = chunk.unwrap_or(0) * CHUNK;
            let near = points[from..].iter().take(CHUNK);
            near.copied().find(|point| is_extreme(&project(point)))
        };
        let extremes = (0..DIRECTIONS).flat_map(|n| {
            let (low, high) = (all.low[n], all.high[n]);
            [
                point(&|values| values[n] == low, chunks.iter().position(|chunk| chunk.low[n] == low)),
                point(&|values| values[n] == high, chunks.iter().position(|chunk| chunk.high[n] == high)),
            ]
        });
        let extremes = extremes.flatten().map(|point| DVec3::from_array(point.map(T::wide)) - origin).collect();
        Ok(Self { points, progress, origin, bounds: bounds.map(|corner| corner - origin), extremes })
    }

    /// Returns a point relative to the cloud's origin.
    #[inline(always)]
    pub fn local(&self, point: &[T; 3]) -> DVec3 {
        DVec3::from_array(point.map(T::wide)) - self.origin
    }

    /// Returns the maximum distance from a centre, and the first point at this distance.
    pub fn farthest(&self, center: DVec3) -> Result<(f64, DVec3)> {
        farthest_of(self.points, self.origin, center, self.progress)
    }

    /// Returns the smallest sphere about a centre.
    pub fn sphere_about(&self, center: DVec3) -> Result<Sphere> {
        Ok(Sphere { center, radius: self.farthest(center)?.0 })
    }

    pub fn mean(&self) -> Result<DVec3> {
        let chunks: Vec<DVec3> = each_chunk(self.points, self.progress, |_, points| sum(points, self.origin))?;
        Ok(chunks.into_iter().sum::<DVec3>() / self.points.len() as f64)
    }

    /// Returns the points farther than a distance from a centre, in order.
    pub fn points_beyond(&self, center: DVec3, distance: f64) -> Result<Vec<[f64; 3]>> {
        let chunk = |_: usize, points: &[[T; 3]]| {
            let mut outside = Vec::new();
            collect_beyond(points, self.origin, center, distance * distance, &mut outside);
            outside
        };
        let mut all = Vec::new();
        for part in self.points.chunks(POINTS_PER_REQUEST) {
            let chunks: Vec<Vec<[f64; 3]>> = each_chunk(part, self.progress, chunk)?;
            chunks.iter().try_for_each(|outside| try_append(&mut all, outside))?;
        }
        Ok(all)
    }

    /// Converts a sphere from the cloud's frame to world coordinates. If that rounds the centre, the radius is measured
    /// again from the rounded centre.
    pub fn to_world(&self, sphere: &Sphere) -> Result<Sphere> {
        let center = sphere.center + self.origin;
        let is_exact = center - self.origin == sphere.center;
        let radius = if is_exact { sphere.radius } else { self.farthest(center - self.origin)?.0 };
        Ok(Sphere { center, radius })
    }
}

/// Returns the maximum distance from a centre, and its first point; centre and point are relative to the origin.
pub(super) fn farthest_of<T: Real>(
    points: &[[T; 3]],
    origin: DVec3,
    center: DVec3,
    progress: &Progress,
) -> Result<(f64, DVec3)> {
    let chunk = |n: usize, points: &[[T; 3]]| {
        let (squared, index) = farthest(points, origin, center);
        (squared, n * CHUNK + index)
    };
    let chunks: Vec<(f64, usize)> = each_chunk(points, progress, chunk)?;
    let first = |a: (f64, usize), b: (f64, usize)| if b.0 > a.0 { b } else { a };
    let (squared, index) = chunks.into_iter().fold((f64::NEG_INFINITY, 0), first);
    Ok((squared.sqrt(), DVec3::from_array(points[index].map(T::wide)) - origin))
}

/// Calls a kernel with the number and points of each chunk; returns its results in order.
fn each_chunk<T: Sync, R: Send>(
    points: &[[T; 3]],
    progress: &Progress,
    kernel: impl Fn(usize, &[[T; 3]]) -> R + Sync,
) -> Result<Vec<R>> {
    let chunk = |(n, points): (usize, &[[T; 3]])| progress.check().map(|()| kernel(n, points));
    points.par_chunks(CHUNK).enumerate().map(chunk).collect()
}

/// Returns the smaller value; NaN if the first is NaN.
#[inline(always)]
fn lesser(a: f64, b: f64) -> f64 {
    if a.is_nan() || a < b { a } else { b }
}

/// Transposes a block to rows of x, y and z.
#[inline(always)]
fn gather<T: Real>(block: &[[T; 3]; LANES]) -> [[f64; LANES]; 3] {
    let mut lanes = [[0.0; LANES]; 3];
    for (i, point) in block.iter().enumerate() {
        lanes[0][i] = point[0].wide();
        lanes[1][i] = point[1].wide();
        lanes[2][i] = point[2].wide();
    }
    lanes
}

#[inline(always)]
fn extremes_kernel<T: Real>(points: &[[T; 3]]) -> Extremes {
    let mut low = [[f64::INFINITY; LANES]; DIRECTIONS];
    let mut high = [[f64::NEG_INFINITY; LANES]; DIRECTIONS];
    // 0 × value is 0, or NaN if the value is not finite.
    let mut zeros = [0.0; LANES];
    let (blocks, remainder) = points.as_chunks::<LANES>();
    for (n, block) in blocks.iter().enumerate() {
        prefetch(blocks.get(n + PREFETCHED_BLOCKS).unwrap_or(block));
        let lanes = gather(block);
        for i in 0..LANES {
            zeros[i] += 0.0 * (lanes[0][i] + lanes[1][i] + lanes[2][i]);
            for n in 0..AXES {
                let value = lanes[n][i];
                low[n][i] = if value < low[n][i] { value } else { low[n][i] };
                high[n][i] = if value > high[n][i] { value } else { high[n][i] };
            }
        }
    }
    // Extremes along diagonals only start the search. They need not be the most extreme points, so blocks are skipped.
    for block in blocks.iter().step_by(DIAGONAL_STRIDE) {
        let [x, y, z] = gather(block);
        for i in 0..LANES {
            let projections = project(&[x[i], y[i], z[i]]);
            for n in AXES..DIRECTIONS {
                low[n][i] = if projections[n] < low[n][i] { projections[n] } else { low[n][i] };
                high[n][i] = if projections[n] > high[n][i] { projections[n] } else { high[n][i] };
            }
        }
    }
    for point in remainder {
        let projections = project(point);
        zeros[0] += 0.0 * projections[3];
        for n in 0..DIRECTIONS {
            low[n][0] = low[n][0].min(projections[n]);
            high[n][0] = high[n][0].max(projections[n]);
        }
    }
    let zero = zeros.iter().sum::<f64>();
    Extremes {
        low: low.map(|lanes| lanes.into_iter().fold(f64::INFINITY, f64::min) + zero),
        high: high.map(|lanes| lanes.into_iter().fold(f64::NEG_INFINITY, f64::max) + zero),
    }
}

#[inline(always)]
fn sum_kernel<T: Real>(points: &[[T; 3]], origin: DVec3) -> DVec3 {
    let origin_xyz = origin.to_array();
    let (blocks, remainder) = points.as_chunks::<LANES>();
    let mut sums = [[0.0; LANES]; 3];
    for block in blocks {
        let lanes = gather(block);
        for axis in 0..3 {
            for i in 0..LANES {
                sums[axis][i] += lanes[axis][i] - origin_xyz[axis];
            }
        }
    }
    for point in remainder {
        for axis in 0..3 {
            sums[axis][0] += point[axis].wide() - origin_xyz[axis];
        }
    }
    DVec3::from_array(sums.map(|lanes| lanes.iter().sum()))
}

/// Returns the squared distances of a block's points from a centre.
#[inline(always)]
fn squares<T: Real>(block: &[[T; 3]; LANES], origin: [f64; 3], center: [f64; 3]) -> [f64; LANES] {
    let lanes = gather(block);
    let mut squared = [0.0; LANES];
    for i in 0..LANES {
        let x = (lanes[0][i] - origin[0]) - center[0];
        let y = (lanes[1][i] - origin[1]) - center[1];
        let z = (lanes[2][i] - origin[2]) - center[2];
        squared[i] = x * x + y * y + z * z;
    }
    squared
}

#[inline(always)]
fn farthest_kernel<T: Real>(points: &[[T; 3]], origin: DVec3, center: DVec3) -> (f64, usize) {
    let (origin, center) = (origin.to_array(), center.to_array());
    let (blocks, remainder) = points.as_chunks::<LANES>();
    // Maximum of each lane, and the first block that has it.
    let (mut max_squared, mut block_of_max) = ([f64::NEG_INFINITY; LANES], [0.0; LANES]);
    let mut number = 0.0;
    for (n, block) in blocks.iter().enumerate() {
        prefetch(blocks.get(n + PREFETCHED_BLOCKS).unwrap_or(block));
        let squared = squares(block, origin, center);
        for i in 0..LANES {
            let farther = squared[i] > max_squared[i];
            max_squared[i] = if farther { squared[i] } else { max_squared[i] };
            block_of_max[i] = if farther { number } else { block_of_max[i] };
        }
        number += 1.0;
    }
    let mut best = (f64::NEG_INFINITY, usize::MAX);
    let mut include = |squared: f64, index: usize| {
        if squared > best.0 || (squared == best.0 && index < best.1) {
            best = (squared, index);
        }
    };
    if !blocks.is_empty() {
        for i in 0..LANES {
            include(max_squared[i], block_of_max[i] as usize * LANES + i);
        }
    }
    for (n, point) in remainder.iter().enumerate() {
        include(squares(&[*point; LANES], origin, center)[0], blocks.len() * LANES + n);
    }
    best
}

#[inline(always)]
fn beyond_kernel<T: Real>(points: &[[T; 3]], origin: DVec3, center: DVec3, limit: f64, outside: &mut Vec<[f64; 3]>) {
    let (origin_xyz, center_xyz) = (origin.to_array(), center.to_array());
    let (blocks, remainder) = points.as_chunks::<LANES>();
    let mut push_if_beyond = |point: &[T; 3], squared: f64| {
        if squared > limit {
            outside.push([0, 1, 2].map(|axis| point[axis].wide() - origin_xyz[axis]));
        }
    };
    for (n, block) in blocks.iter().enumerate() {
        prefetch(blocks.get(n + PREFETCHED_BLOCKS).unwrap_or(block));
        let squared = squares(block, origin_xyz, center_xyz);
        let mut greatest = 0.0;
        for value in squared {
            greatest = if value > greatest { value } else { greatest };
        }
        if greatest > limit {
            for i in 0..LANES {
                push_if_beyond(&block[i], squared[i]);
            }
        }
    }
    for point in remainder {
        push_if_beyond(point, squares(&[*point; LANES], origin_xyz, center_xyz)[0]);
    }
}
