//! Baking of the far part of a scene into an environment map: six faces drawn from the centre, cut at the near
//! cylinder.

use std::sync::Arc;

use glam::DVec3;
use nearfar_core::base::{Progress, Result};
use nearfar_core::render::Frame;
use nearfar_core::render::bake::Bake;
use nearfar_core::scene::Scene;

use super::near_far::{NearFar, ZoneCut};
use crate::device::Device;
use crate::draw::{Job, Layer, Picture, Set};
use crate::upload::Residents;

/// Bakes six faces of the static instances, one after the other; each is read while the next is drawn.
pub fn bake(device: &Arc<Device>, scene: &Scene, settings: &Bake, progress: &Progress) -> Result<Frame> {
    settings.check(scene)?;
    let channels = settings.channels();
    channels.check_room(6 * u64::from(settings.size).pow(2))?;
    let static_scene = Scene { moving: Default::default(), ..scene.clone() };
    let tables = device.state::<Residents>().scene(device, &static_scene)?;
    let cut = if settings.radius > 0.0 { ZoneCut::OutsideOverlapping } else { ZoneCut::None }.cut();
    let layer = Layer { cut, ..Layer::plain(static_scene, tables, Set::Static) };
    let near_far = NearFar {
        offset: DVec3::ZERO,
        camera_offset: DVec3::ZERO,
        radii: [0.0; 2],
        strength: 1.0,
        cut_radius: settings.radius,
        two_texels: settings.two_texels(),
    };
    let picture =
        Picture { parameters: near_far.parameters(), multisampled: false, ..Picture::plain(vec![layer], scene.origin) };
    let begin =
        |face| Job::begin(device, picture.clone(), &settings.camera(face)?, channels, settings.samples, progress);
    let mut faces = Frame::default();
    let (mut next, mut numbers) = (Some(begin(0)?), 1..6);
    while let Some(job) = next {
        next = numbers.next().map(begin).transpose()?;
        let face = job.finish(progress)?;
        faces.color.extend(face.color);
        faces.range.extend(face.range);
        faces.object_id.extend(face.object_id);
    }
    Ok(faces)
}
