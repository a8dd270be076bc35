//! Ground truth: the scene as it is.

use std::sync::Arc;

use glam::DVec3;
use nearfar_core::base::{Progress, Result};
use nearfar_core::camera::Camera;
use nearfar_core::render::Channels;
use nearfar_core::scene::Scene;

use crate::device::Device;
use crate::draw::{Job, Kind, Layer, Names, Picture, Set, Split};

/// Begins a frame of a scene; what of it is not on the device is sent first.
pub fn begin(
    device: &Arc<Device>,
    scene: &Scene,
    camera: &Camera,
    channels: Channels,
    samples: u32,
    progress: &Progress,
) -> Result<Job> {
    let tables = device.residents.scene(device, scene)?;
    let layer = |set| Layer {
        scene: scene.clone(),
        tables: Arc::clone(&tables),
        set,
        kind: Kind::AsItIs,
        split: Split::Whole,
        hidden: false,
        covers: false,
        names: Names::Own,
    };
    let picture = Picture {
        layers: vec![layer(Set::Standing), layer(Set::Moving)],
        map: None,
        far_objects: None,
        center: DVec3::ZERO,
        radii: [0.0; 3],
        origin: scene.origin,
        two_texels: 0.0,
        missed: Kind::AsItIs,
        multisampled: true,
    };
    Job::begin(device, picture, camera, channels, samples, progress)
}
