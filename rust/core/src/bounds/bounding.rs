//! Bounding spheres of points and of groups of points.
//!
//! The smallest sphere starts from a few points. The farthest outside point is added until no point is outside
//! (Gärtner: Fast and robust smallest enclosing balls, 1999). Only points near the surface are scanned: a point that
//! lies d below it stays inside while the centre moves by less than d.

use glam::DVec3;
use rayon::prelude::*;

use super::scan::{Cloud, Sphere, farthest_of};
use crate::base::memory::try_collect;
use crate::base::{Error, Progress, Real, Result};

/// Points between two checks for cancellation.
const POINTS_PER_CHECK: usize = 1 << 16;

/// Range of extents whose squares neither overflow nor underflow. Other points are scaled by a power of two.
const UNSCALED_EXTENTS: std::ops::Range<f64> = 1e-140..1e140;

/// Maximum number of points that are all scanned in each step. Of more points, only those in the shell are scanned.
const MAX_SCANNED: usize = 1 << 12;
/// Thickness of the shell below the sphere's surface, relative to the radius.
const SHELL: f64 = 0.05;
/// The search ends after this many steps without a smaller sphere; the remaining error is rounding.
const STALLED_STEPS: usize = 24;
/// Relative rounding error of distances.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Method for the bounding sphere of points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SphereMethod {
    /// The smallest sphere.
    Exact,
    /// Grows from two distant points to each outside point in turn (Ritter: An efficient bounding sphere, 1990).
    Ritter,
    /// The sphere about the mean of the points.
    Average,
    /// The sphere about the middle of the bounding box.
    MinMax,
    /// The smaller of `Average` and `MinMax`, after Liebisch (2021).
    Best,
}

/// Returns the bounding sphere of points. No point lies outside by more than the rounding of the radius.
pub fn bounding_sphere<T: Real>(points: &[[T; 3]], method: SphereMethod, progress: &Progress) -> Result<Sphere> {
    let cloud = Cloud::new(points, progress)?;
    let extent = (cloud.bounds[1] - cloud.bounds[0]).max_element();
    if extent == 0.0 {
        return Ok(Sphere { center: cloud.origin, radius: 0.0 });
    }
    if UNSCALED_EXTENTS.contains(&extent) {
        return cloud.to_world(&local_sphere(&cloud, method)?);
    }
    // Scaling by a power of two is exact except for denormals, and those are scaled up.
    let exponent = extent.log2().floor().clamp(-1000.0, 1000.0);
    let scale = (-exponent).exp2();
    let scaled = try_collect(points.par_iter().map(|point| (cloud.local(point) * scale).to_array()))?;
    let small = Cloud::new(&scaled, progress)?;
    let sphere = small.to_world(&local_sphere(&small, method)?)?;
    let center = cloud.origin + sphere.center / scale;
    // Squares of distances would overflow here, so the rounding of the centre is added to the radius instead.
    let rounding = ((center - cloud.origin) - sphere.center / scale).abs().max_element();
    Ok(Sphere { center, radius: sphere.radius / scale + 2.0 * rounding })
}

/// Returns the sphere in the cloud's own frame.
fn local_sphere<T: Real>(cloud: &Cloud<'_, T>, method: SphereMethod) -> Result<Sphere> {
    let average = || cloud.sphere_about(cloud.mean()?);
    let min_max = || cloud.sphere_about((cloud.bounds[0] + cloud.bounds[1]) * 0.5);
    match method {
        SphereMethod::Exact => smallest(cloud),
        SphereMethod::Ritter => ritter(cloud),
        SphereMethod::Average => average(),
        SphereMethod::MinMax => min_max(),
        SphereMethod::Best => {
            let (average, min_max) = (average()?, min_max()?);
            Ok(if average.radius <= min_max.radius { average } else { min_max })
        }
    }
}

/// Returns Ritter's sphere, which grows at each outside point in the order of the points.
fn ritter<T: Real>(cloud: &Cloud<'_, T>) -> Result<Sphere> {
    let (_, first) = cloud.farthest(cloud.local(&cloud.points[0]))?;
    let (distance, second) = cloud.farthest(first)?;
    let (mut center, mut radius) = ((first + second) * 0.5, distance * 0.5);
    for points in cloud.points.chunks(POINTS_PER_CHECK) {
        for point in points {
            let offset = cloud.local(point) - center;
            let squared = offset.length_squared();
            if squared > radius * radius {
                let distance = squared.sqrt();
                let wider = 0.5 * (radius + distance);
                center += offset * ((distance - wider) / distance);
                radius = wider;
            }
        }
        cloud.progress.check()?;
    }
    // Each step rounds, so the farthest point sets the final radius.
    cloud.sphere_about(center)
}

/// Returns the bounding spheres of groups of points; group n is `points[offsets[n]..offsets[n + 1]]`.
pub fn bounding_spheres<T: Real>(
    points: &[[T; 3]],
    offsets: &[i64],
    method: SphereMethod,
    progress: &Progress,
) -> Result<Vec<Sphere>> {
    let group = |n: usize| {
        let range = usize::try_from(offsets[n]).ok().zip(usize::try_from(offsets[n + 1]).ok());
        let group = range.and_then(|(from, to)| points.get(from..to)).filter(|group| !group.is_empty());
        group.ok_or_else(|| {
            let expected = format!("strictly ascending numbers from 0 to {}", points.len());
            Error::value("offsets", expected, format!("{} and {} at index {n}", offsets[n], offsets[n + 1]))
        })
    };
    let count = offsets.len().saturating_sub(1);
    (0..count).try_for_each(|n| group(n).map(drop))?;
    progress.expect(count as u64);
    let sphere = |n: usize| {
        let sphere = bounding_sphere(group(n)?, method, progress)?;
        progress.report(1)?;
        Ok(sphere)
    };
    (0..count).into_par_iter().map(sphere).collect()
}

/// Returns the smallest sphere, in the cloud's frame.
fn smallest<T: Real>(cloud: &Cloud<'_, T>) -> Result<Sphere> {
    let progress = cloud.progress;
    let extremes: Vec<[f64; 3]> = cloud.extremes.iter().map(|point| point.to_array()).collect();
    let mut support = widen(&extremes, DVec3::ZERO, Support::point(cloud.extremes[0]), progress)?.1;
    if cloud.points.len() > MAX_SCANNED {
        for _ in 0..STALLED_STEPS {
            let inner_radius = support.radius * (1.0 - SHELL);
            let shell = cloud.points_beyond(support.center, inner_radius)?;
            if shell.len() > cloud.points.len() / 2 {
                break;
            }
            let old_center = support.center;
            let sphere;
            (sphere, support) = widen(&shell, DVec3::ZERO, support, progress)?;
            if inner_radius + (sphere.center - old_center).length() < sphere.radius {
                return Ok(sphere);
            }
        }
    }
    Ok(widen(cloud.points, cloud.origin, support, progress)?.0)
}

/// Adds the farthest point to the support until no point lies outside. Returns the sphere and its support.
fn widen<T: Real>(
    points: &[[T; 3]],
    origin: DVec3,
    mut support: Support,
    progress: &Progress,
) -> Result<(Sphere, Support)> {
    let mut best = (Sphere { center: support.center, radius: f64::INFINITY }, support);
    let mut steps_since_best = 0;
    loop {
        let (distance, point) = farthest_of(points, origin, support.center, progress)?;
        steps_since_best += 1;
        if distance < best.0.radius {
            best = (Sphere { center: support.center, radius: distance }, support);
            steps_since_best = 0;
        }
        if distance <= support.radius * (1.0 + ROUNDING) || steps_since_best > STALLED_STEPS {
            return Ok(best);
        }
        support = support.extend(point);
    }
}

/// The support of a sphere: at most four points on its surface that determine it.
#[derive(Clone, Copy, Debug, Default)]
struct Support {
    points: [DVec3; 4],
    count: usize,
    center: DVec3,
    radius: f64,
}

impl Support {
    /// Creates the sphere of radius 0 about one point.
    fn point(point: DVec3) -> Self {
        Self { points: [point; 4], count: 1, center: point, radius: 0.0 }
    }

    /// Returns the smallest sphere around this support and a new point outside it. The new point lies on the surface,
    /// so the centre is that of a sphere through the new point and a subset of the others. Each centre gets the radius
    /// that contains all points, and the smallest sphere is taken; a degenerate subset has a NaN centre and never wins.
    fn extend(&self, new: DVec3) -> Self {
        let old = &self.points[..self.count];
        let mut best = Self { radius: f64::INFINITY, ..Self::point(new) };
        for subset in 0u32..1 << old.len() {
            let count = subset.count_ones() as usize;
            if count > 3 {
                continue;
            }
            let mut points = [new; 4];
            let members = (0..old.len()).filter(|n| subset >> n & 1 == 1);
            for (slot, n) in points[1..].iter_mut().zip(members) {
                *slot = old[n];
            }
            let center = equidistant(&points[..=count]);
            let squared = old.iter().chain([&new]).map(|point| (*point - center).length_squared());
            let radius = squared.fold(0.0, larger).sqrt();
            if radius < best.radius {
                best = Self { points, count: count + 1, center, radius };
            }
        }
        best
    }
}

/// Returns the larger value; NaN if either is NaN.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// Returns the point at equal distances from one to four points: on the line through two points, in the plane of three.
pub(super) fn equidistant(points: &[DVec3]) -> DVec3 {
    let from = points[0];
    match *points {
        [_, b] => from + (b - from) * 0.5,
        [_, b, c] => {
            let (u, v) = (b - from, c - from);
            let normal = u.cross(v);
            let numerator = (v * u.length_squared() - u * v.length_squared()).cross(normal);
            from + numerator / (2.0 * normal.length_squared())
        }
        [_, b, c, d] => {
            let (u, v, w) = (b - from, c - from, d - from);
            let sum =
                v.cross(w) * u.length_squared() + w.cross(u) * v.length_squared() + u.cross(v) * w.length_squared();
            from + sum / (2.0 * u.dot(v.cross(w)))
        }
        _ => from,
    }
}
