//! Pictures of an unreduced scene: the ground truth, and the six faces of an environment map of its far part, which are
//! drawn from the centre and cut at the near cylinder.

use std::sync::Arc;

use glam::DVec3;
use nearfar_core::base::{Error, Progress, Result};
use nearfar_core::camera::Camera;
use nearfar_core::render::bake::Bake;
use nearfar_core::render::{Channels, Frame, Limits, Pixels};
use nearfar_core::scene::Scene;

use super::near_far::{NearFar, ZoneCut};
use crate::device::Device;
use crate::draw::{Job, Layer, Mask, Picture, Set};
use crate::upload::Residents;

/// Begins frames of a scene, one per camera; uploads meshes and materials that the device lacks. The frames of two
/// cameras may be drawn at once, by one job.
pub fn begin_truth(
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
        return Ok(vec![Job::begin(device, unmasked, cameras, channels, samples, progress)?]);
    }
    let begin = |camera: &[Camera]| {
        let picture = Picture { mask: Mask::from_pixels(&pixels, &camera[0])?, ..unmasked.clone() };
        Job::begin(device, picture, camera, channels, samples, progress)
    };
    cameras.chunks(1).map(begin).collect()
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
        |face| Job::begin(device, picture.clone(), &[settings.camera(face)?], channels, settings.samples, progress);
    let mut faces = Frame::default();
    let (mut next, mut numbers) = (Some(begin(0)?), 1..6);
    while let Some(job) = next {
        next = numbers.next().map(begin).transpose()?;
        let face = job.finish(progress)?.swap_remove(0);
        faces.color.extend(face.color);
        faces.range.extend(face.range);
        faces.object_id.extend(face.object_id);
    }
    Ok(faces)
}
