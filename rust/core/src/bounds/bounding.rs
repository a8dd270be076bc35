//! Bounding spheres of points and of groups of points.

use rayon::prelude::*;

use super::scan::Cloud;
use super::sphere::{Sphere, SphereMethod};
use super::{approximate, exact};
use crate::base::{Error, Progress, Real, Result};

/// Range of extents whose squares neither overflow nor underflow. Points with other extents are scaled by a power of
/// two.
const PLAIN_EXTENTS: std::ops::Range<f64> = 1e-140..1e140;

/// Returns the bounding sphere of points. No point lies outside by more than the rounding of the radius.
pub fn bounding_sphere<T: Real>(points: &[[T; 3]], method: SphereMethod, progress: &Progress) -> Result<Sphere> {
    let cloud = Cloud::new(points, progress)?;
    let extent = cloud.extent();
    if extent == 0.0 {
        return Ok(Sphere { center: cloud.origin, radius: 0.0 });
    }
    if PLAIN_EXTENTS.contains(&extent) {
        return cloud.to_world(&local_sphere(&cloud, method)?);
    }
    // Scaling by a power of two is exact except for denormals, and those are scaled up.
    let exponent = extent.log2().floor().clamp(-1000.0, 1000.0);
    let scale = (-exponent).exp2();
    let scaled: Vec<[f64; 3]> = points.iter().map(|point| (cloud.local(point) * scale).to_array()).collect();
    let small = Cloud::new(&scaled, progress)?;
    let sphere = small.to_world(&local_sphere(&small, method)?)?;
    let center = cloud.origin + sphere.center / scale;
    // Squares of distances would overflow here, so the rounding of the centre is added to the radius instead.
    let moved = ((center - cloud.origin) - sphere.center / scale).abs().max_element();
    Ok(Sphere { center, radius: sphere.radius / scale + 2.0 * moved })
}

/// Returns the sphere in the cloud's own frame.
fn local_sphere<T: Real>(cloud: &Cloud<'_, T>, method: SphereMethod) -> Result<Sphere> {
    match method {
        SphereMethod::Exact => exact::smallest(cloud),
        SphereMethod::Ritter => approximate::ritter(cloud),
        SphereMethod::Average => approximate::average(cloud),
        SphereMethod::MinMax => approximate::min_max(cloud),
        SphereMethod::Best => approximate::best(cloud),
    }
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
            let expected = format!("numbers that rise from one to the next, from 0 to {}", points.len());
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
