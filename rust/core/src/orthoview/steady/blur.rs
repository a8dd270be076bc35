//! Motion blur: the mean of a picture warped to several poses.

use rayon::prelude::*;

use super::past::{Color, Image, image_position};
use crate::base::{Error, Progress, Result, ensure, memory::room_for};
use crate::camera::Camera;
use crate::orthoview::splat::Projector;
use crate::render::temporal::cubic;

/// Key of a pixel without a surface.
const NOTHING: u64 = u64::MAX;

/// Averages a picture over the `poses` of cameras of its size. A pixel becomes the mean over the poses that show
/// something there, and keeps its colour if none does.
///
/// Forward warping: each pixel of the picture is drawn where a pose shows its surface, and the nearest surface wins.
pub fn blur(image: &Image<'_>, poses: &[&Camera], blurred: &mut [Color], progress: &Progress) -> Result<()> {
    image.check("frame")?;
    let count = image.color.len();
    ensure!(blurred.len() == count, "blurred", format!("{count} pixels"), blurred.len());
    let size = (image.camera.width, image.camera.height);
    if let Some(other) = poses.iter().find(|pose| (pose.width, pose.height) != size) {
        let got = format!("{:?}", (other.width, other.height));
        return Err(Error::value("poses", format!("cameras of {size:?} pixels"), got));
    }
    room_for((poses.len() * count * (size_of::<u64>() + size_of::<Color>())) as u64)?;
    let warp_to = |pose: &&Camera| progress.check().map(|()| warp(image, pose));
    let warped: Vec<Vec<Option<Color>>> = poses.par_iter().map(warp_to).collect::<Result<_>>()?;
    blurred.par_iter_mut().enumerate().for_each(|(pixel, blurred)| {
        let (mut sum, mut count) = ([0.0f32; 3], 0u32);
        for color in warped.iter().filter_map(|pose| pose[pixel]) {
            (0..3).for_each(|c| sum[c] += color[c]);
            count += 1;
        }
        *blurred = if count > 0 { sum.map(|value| value / count as f32) } else { image.color[pixel] };
    });
    Ok(())
}

/// Returns the picture as seen from a pose; `None` where nothing of the picture is visible.
fn warp(image: &Image<'_>, pose: &Camera) -> Vec<Option<Color>> {
    let (projector, rays) = (Projector::new(pose), image.camera.rays());
    let (width, height) = (pose.width as usize, pose.height as usize);
    let show = |pixel: usize| {
        let (start, direction) = rays.ray((pixel % width) as f64 + 0.5, (pixel / width) as f64 + 0.5);
        let inverse = 1.0 / f64::from(image.range[pixel]);
        let offset = (image.camera.position + start - projector.eye) * inverse + direction;
        let position = image_position(projector.homogeneous(offset, inverse))?;
        Some((position, (projector.distance_of(offset) / inverse) as f32))
    };
    // Key: distance in the upper half, pixel number in the lower. The smallest key wins: the nearest surface, and the
    // first of equally near ones.
    let mut nearest = vec![NOTHING; width * height];
    for pixel in 0..width * height {
        if let Some((position, distance)) = show(pixel) {
            let is_inside = (0.0..width as f64).contains(&position.x) && (0.0..height as f64).contains(&position.y);
            if is_inside && distance >= 0.0 {
                let key = u64::from(distance.to_bits()) << 32 | pixel as u64;
                let target = &mut nearest[position.y as usize * width + position.x as usize];
                *target = key.min(*target);
            }
        }
    }
    let color = |(target, key): (usize, u64)| {
        let pixel = (key & u64::from(u32::MAX)) as usize;
        let (position, _) = (key != NOTHING).then(|| show(pixel)).flatten()?;
        // The warped point misses the centre of its target pixel; the source is offset by as much.
        let offset = [(target % width) as f64 + 0.5 - position.x, (target / width) as f64 + 0.5 - position.y];
        let source = [(pixel % width) as f64 + 0.5 + offset[0], (pixel / width) as f64 + 0.5 + offset[1]];
        Some(cubic(image.color, width, source).map(|value| value.max(0.0)))
    };
    nearest.into_iter().enumerate().map(color).collect()
}
