//! Baking of the far part of a scene into an environment map: six faces drawn from the centre, cut at the near
//! cylinder.

use std::sync::Arc;

use glam::DVec3;
use nearfar_core::base::{Progress, Result};
use nearfar_core::render::Frame;
use nearfar_core::render::bake::Bake;
use nearfar_core::scene::Scene;

use super::near_far::{NearFar, Zone};
use crate::device::Device;
use crate::draw::{Job, Layer, Picture, Set};
use crate::upload::Residents;

/// Bakes six faces of the static instances, one after the other; each is read while the next is drawn.
pub fn bake(device: &Arc<Device>, scene: &Scene, settings: &Bake, progress: &Progress) -> Result<Frame> {
    settings.check(scene)?;
    let channels = settings.channels();
    channels.check_room(6 * u64::from(settings.size).pow(2))?;
    let standing = Scene { moving: Default::default(), ..scene.clone() };
    let tables = device.state::<Residents>().scene(device, &standing)?;
    let cut = if settings.radius > 0.0 { Zone::Overlapping } else { Zone::Whole }.cut();
    let layer = Layer { cut, ..Layer::plain(standing, tables, Set::Static) };
    let near_far = NearFar {
        offset: DVec3::ZERO,
        apart: DVec3::ZERO,
        radii: [0.0; 2],
        strength: 1.0,
        split: settings.radius,
        two_texels: settings.two_texels(),
    };
    let picture =
        Picture { parameters: near_far.parameters(), multisampled: false, ..Picture::plain(vec![layer], scene.origin) };
    let begin =
        |face| Job::begin(device, picture.clone(), &settings.camera(face)?, channels, settings.samples, progress);
    let mut whole = Frame::default();
    let mut next = Some(begin(0)?);
    for face in 1..=6 {
        let Some(job) = next.take() else { break };
        if face < 6 {
            next = Some(begin(face)?);
        }
        let part = job.finish(progress)?;
        whole.color.extend(part.color);
        whole.range.extend(part.range);
        whole.object_id.extend(part.object_id);
    }
    Ok(whole)
}
