//! Approximate bounding spheres, from one or a few passes over the points.

use super::scan::Cloud;
use super::sphere::Sphere;
use crate::base::{Real, Result};

/// Points between two checks for cancellation.
const POINTS_PER_CHECK: usize = 1 << 16;

/// Returns the sphere about the mean of the points.
pub(super) fn average<T: Real>(cloud: &Cloud<'_, T>) -> Result<Sphere> {
    let center = cloud.mean()?;
    Ok(Sphere { center, radius: cloud.farthest(center)?.0 })
}

/// Returns the sphere about the middle of the bounding box.
pub(super) fn min_max<T: Real>(cloud: &Cloud<'_, T>) -> Result<Sphere> {
    let center = (cloud.bounds[0] + cloud.bounds[1]) * 0.5;
    Ok(Sphere { center, radius: cloud.farthest(center)?.0 })
}

/// Returns the smaller of the two spheres above.
pub(super) fn best<T: Real>(cloud: &Cloud<'_, T>) -> Result<Sphere> {
    let (one, other) = (average(cloud)?, min_max(cloud)?);
    Ok(if one.radius <= other.radius { one } else { other })
}

/// Returns Ritter's sphere: it starts from two distant points and grows to contain each outside point, in order.
pub(super) fn ritter<T: Real>(cloud: &Cloud<'_, T>) -> Result<Sphere> {
    let (_, one) = cloud.farthest(cloud.local(&cloud.points[0]))?;
    let (apart, other) = cloud.farthest(one)?;
    let (mut center, mut radius) = ((one + other) * 0.5, apart * 0.5);
    for points in cloud.points.chunks(POINTS_PER_CHECK) {
        for point in points {
            let away = cloud.local(point) - center;
            let squared = away.length_squared();
            if squared > radius * radius {
                let distance = squared.sqrt();
                let wider = 0.5 * (radius + distance);
                center += away * ((distance - wider) / distance);
                radius = wider;
            }
        }
        cloud.progress.check()?;
    }
    // Each step rounds, so the farthest point sets the final radius.
    Ok(Sphere { center, radius: cloud.farthest(center)?.0 })
}
