//! Ground truth: rendering of the unchanged scene.

use std::sync::Arc;

use nearfar_core::base::{Error, Progress, Result};
use nearfar_core::camera::Camera;
use nearfar_core::render::{Channels, Limits, Pixels};
use nearfar_core::scene::Scene;

use crate::device::Device;
use crate::draw::{Job, Layer, Mask, Picture, Set};
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
    let flags = instance_flags(scene, &pixels)?;
    let layer = |(set, may_show)| Layer { may_show, ..Layer::plain(scene.clone(), Arc::clone(&tables), set) };
    let layers = [Set::Static, Set::Moving].into_iter().zip(flags).map(layer).collect();
    let limits = (!limits.is_none()).then(|| limits.relative_to(scene.origin));
    let unmasked = Picture { limits, bare: pixels.bare, ..Picture::plain(layers, scene.origin) };
    if pixels.mask.is_none() && unmasked.draws_both(device, cameras, channels, samples) {
        return Ok(vec![Job::begin_views(device, unmasked, cameras.to_vec(), channels, samples, progress)?]);
    }
    let begin = |camera| {
        let picture = Picture { mask: Mask::from_pixels(&pixels, camera)?, ..unmasked.clone() };
        Job::begin(device, picture, camera, channels, samples, progress)
    };
    cameras.iter().map(begin).collect()
}

/// Returns flags of the static and of the moving instances that the picture may show, if known.
fn instance_flags(scene: &Scene, pixels: &Pixels<'_>) -> Result<[Option<Arc<[bool]>>; 2]> {
    let Some(flags) = pixels.instances else { return Ok([None, None]) };
    let [static_count, moving_count] = scene.sets().map(|set| set.instances().len());
    if flags.len() != static_count + moving_count {
        return Err(Error::value("instances", format!("{} flags", static_count + moving_count), flags.len()));
    }
    let (static_flags, moving_flags) = flags.split_at(static_count);
    Ok([static_flags, moving_flags].map(|flags| Some(flags.into())))
}
