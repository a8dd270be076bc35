//! Ground truth: rendering of the unchanged scene.

use std::sync::Arc;

use nearfar_core::base::{Error, Progress, Result};
use nearfar_core::camera::Camera;
use nearfar_core::render::{Channels, Limits, Pixels};
use nearfar_core::scene::Scene;

use crate::device::Device;
use crate::draw::{Job, Layer, Mask, Picture, Set, draws_both};
use crate::upload::Residents;

/// Begins frames of a scene, one per camera; uploads meshes and materials that the device lacks. Two cameras may share
/// one job, which draws both frames at once.
pub fn begin(
    device: &Arc<Device>,
    scene: &Scene,
    cameras: &[Camera],
    channels: Channels,
    samples: u32,
    (limits, pixels): (Limits, Pixels<'_>),
    progress: &Progress,
) -> Result<Vec<Job>> {
    let tables = device.state::<Residents>().scene(device, scene)?;
    let seen = seen_of(scene, &pixels)?;
    let layer = |set, seen| Layer { seen, ..Layer::plain(scene.clone(), Arc::clone(&tables), set) };
    let [standing, moving] = seen;
    let plain = Picture::plain(vec![layer(Set::Standing, standing), layer(Set::Moving, moving)], scene.origin);
    let limits = (!limits.is_none()).then(|| limits.relative_to(scene.origin));
    let plain = Picture { limits, bare: pixels.bare, ..plain };
    if pixels.mask.is_none() && draws_both(device, &plain, cameras, channels, samples) {
        return Ok(vec![Job::begin_views(device, plain, cameras.to_vec(), channels, samples, progress)?]);
    }
    let begin = |camera| {
        let picture = Picture { mask: Mask::from_pixels(&pixels, camera)?, ..plain.clone() };
        Job::begin(device, picture, camera, channels, samples, progress)
    };
    cameras.iter().map(begin).collect()
}

/// Returns flags of the static and of the moving instances that the picture may show, if known.
fn seen_of(scene: &Scene, pixels: &Pixels<'_>) -> Result<[Option<Arc<[bool]>>; 2]> {
    let Some(seen) = pixels.instances else { return Ok([None, None]) };
    let counts = [scene.standing.instances().len(), scene.moving.instances().len()];
    if seen.len() != counts[0] + counts[1] {
        return Err(Error::value("instances", format!("{} flags", counts[0] + counts[1]), seen.len()));
    }
    let (standing, moving) = seen.split_at(counts[0]);
    Ok([standing, moving].map(|part| Some(part.into())))
}
