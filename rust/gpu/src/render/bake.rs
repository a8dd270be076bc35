//! The far part of a scene as an environment map: six faces drawn from the centre, cut where the near cylinder ends.

use std::sync::Arc;

use nearfar_core::base::{Progress, Result};
use nearfar_core::render::Frame;
use nearfar_core::render::bake::Bake;
use nearfar_core::scene::Scene;

use crate::device::Device;
use crate::draw::{Job, Kind, Layer, Names, Picture, Set, Split};

/// Six faces, one after the other, of what stands; the next one is drawn while one is read.
pub fn bake(device: &Arc<Device>, scene: &Scene, settings: &Bake, progress: &Progress) -> Result<Frame> {
    settings.check(scene)?;
    let channels = settings.channels();
    channels.check_room(6 * u64::from(settings.size).pow(2))?;
    let standing = Scene { moving: Default::default(), ..scene.clone() };
    let layer = Layer {
        tables: device.residents.scene(device, &standing)?,
        scene: standing,
        set: Set::Standing,
        kind: Kind::AsItIs,
        split: if settings.radius > 0.0 { Split::Overlapping } else { Split::Whole },
        hidden: false,
        covers: false,
        names: Names::Own,
    };
    let picture = Picture {
        layers: vec![layer],
        map: None,
        far_objects: None,
        center: settings.center - scene.origin,
        radii: [0.0, 0.0, settings.radius],
        origin: scene.origin,
        two_texels: settings.two_texels(),
        missed: Kind::AsItIs,
        multisampled: false,
    };
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
