//! Smallest bounding sphere: starting from a few points, the farthest outside point is added until none is outside.
//!
//! Gärtner: Fast and robust smallest enclosing balls, 1999. Points deep inside are set aside: a point inside by a
//! distance d stays inside while the centre moves less than d.

use glam::DVec3;

use super::scan::{Cloud, farthest_of};
use super::sphere::Sphere;
use super::support::Support;
use crate::base::{Progress, Real, Result};

/// Number of points up to which all are scanned in each step. For more points, those deep inside are set aside.
const ALL_KEPT: usize = 1 << 12;
/// Thickness of the shell in which points are kept, relative to the radius.
const SHELL: f64 = 0.05;
/// Steps without a smaller sphere after which the search ends; the remaining error is rounding.
const STALLED_STEPS: usize = 24;
/// Relative rounding error of distances.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The smallest sphere, in the cloud's frame.
pub(super) fn smallest<T: Real>(cloud: &Cloud<'_, T>) -> Result<Sphere> {
    let progress = cloud.progress;
    let extremes: Vec<[f64; 3]> = cloud.extremes.iter().map(|point| point.to_array()).collect();
    let mut support = widened(&extremes, DVec3::ZERO, Support::point(cloud.extremes[0]), progress)?.1;
    if cloud.points.len() > ALL_KEPT {
        for _ in 0..STALLED_STEPS {
            let kept_from = support.radius * (1.0 - SHELL);
            let kept = cloud.points_beyond(support.center, kept_from)?;
            if kept.len() > cloud.points.len() / 2 {
                break;
            }
            let before = support.center;
            let sphere;
            (sphere, support) = widened(&kept, DVec3::ZERO, support, progress)?;
            if kept_from + (sphere.center - before).length() < sphere.radius {
                return Ok(sphere);
            }
        }
    }
    Ok(widened(cloud.points, cloud.origin, support, progress)?.0)
}

/// Adds the farthest point until none lies outside. Returns the sphere about all points and its support.
fn widened<T: Real>(
    points: &[[T; 3]],
    origin: DVec3,
    mut support: Support,
    progress: &Progress,
) -> Result<(Sphere, Support)> {
    let mut best = (Sphere { center: support.center, radius: f64::INFINITY }, support);
    let mut stale = 0;
    loop {
        let (distance, point) = farthest_of(points, origin, support.center, progress)?;
        stale += 1;
        if distance < best.0.radius {
            best = (Sphere { center: support.center, radius: distance }, support);
            stale = 0;
        }
        if distance <= support.radius * (1.0 + ROUNDING) || stale > STALLED_STEPS {
            return Ok(best);
        }
        support = support.extend(point);
    }
}
