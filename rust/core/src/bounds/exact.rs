//! The smallest sphere: from few points, the farthest one that lies outside is added until none does.
//!
//! Gärtner: Fast and robust smallest enclosing balls, 1999. Points well inside are put aside once: while the centre moves
//! less than they are inside, none of them can come out.

use glam::DVec3;

use super::scan::{Cloud, farthest_of};
use super::sphere::Sphere;
use super::support::Support;
use crate::base::Real;

/// Most points that are all kept: of more, those far inside the sphere are put aside.
const ALL_KEPT: usize = 1 << 12;
/// Share of the radius, inwards from the sphere, within which points are kept.
const SHELL: f64 = 0.05;
/// Steps without a smaller sphere after which the last digits are left to rounding.
const STALLED_STEPS: usize = 24;
/// Relative rounding error of distances.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// In the cloud's frame.
pub(super) fn smallest<T: Real>(cloud: &Cloud<'_, T>) -> Sphere {
    let extremes: Vec<[f64; 3]> = cloud.extremes.iter().map(|point| point.to_array()).collect();
    let mut support = widened(&extremes, DVec3::ZERO, Support::point(cloud.extremes[0])).1;
    if cloud.points.len() > ALL_KEPT {
        for _ in 0..STALLED_STEPS {
            let kept_from = support.radius * (1.0 - SHELL);
            let kept = cloud.beyond(support.center, kept_from);
            if kept.len() > cloud.points.len() / 2 {
                break;
            }
            let before = support.center;
            let sphere;
            (sphere, support) = widened(&kept, DVec3::ZERO, support);
            if kept_from + (sphere.center - before).length() < sphere.radius {
                return sphere;
            }
        }
    }
    widened(cloud.points, cloud.origin, support).0
}

/// Adds the farthest point until none lies outside; the sphere about all points and what it rests on.
fn widened<T: Real>(points: &[[T; 3]], origin: DVec3, mut support: Support) -> (Sphere, Support) {
    let mut best = (Sphere { center: support.center, radius: f64::INFINITY }, support);
    let mut stale = 0;
    loop {
        let (distance, point) = farthest_of(points, origin, support.center);
        stale += 1;
        if distance < best.0.radius {
            best = (Sphere { center: support.center, radius: distance }, support);
            stale = 0;
        }
        if distance <= support.radius * (1.0 + ROUNDING) || stale > STALLED_STEPS {
            return best;
        }
        support = support.with(point);
    }
}
