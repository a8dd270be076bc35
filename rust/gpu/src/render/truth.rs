//! Ground truth: the scene as it is.

use std::sync::Arc;

use nearfar_core::base::{Progress, Result};
use nearfar_core::camera::Camera;
use nearfar_core::render::{Channels, Limits, Pixels};
use nearfar_core::scene::Scene;

use crate::device::Device;
use crate::draw::{Job, Layer, Mask, Picture, Set};
use crate::upload::Residents;

/// Begins a frame of a scene; meshes and materials that the device lacks are sent first.
pub fn begin(
    device: &Arc<Device>,
    scene: &Scene,
    camera: &Camera,
    channels: Channels,
    samples: u32,
    (limits, pixels): (Limits, Pixels<'_>),
    progress: &Progress,
) -> Result<Job> {
    let tables = device.state::<Residents>().scene(device, scene)?;
    let layer = |set| Layer::plain(scene.clone(), Arc::clone(&tables), set);
    let plain = Picture::plain(vec![layer(Set::Standing), layer(Set::Moving)], scene.origin);
    let limits = (!limits.is_none()).then(|| limits.relative_to(scene.origin));
    let picture = Picture { limits, bare: pixels.bare, mask: Mask::of(&pixels, camera)?, ..plain };
    Job::begin(device, picture, camera, channels, samples, progress)
}
