//! Maps of a scene whose objects become geometry ring after ring: map i shows the objects of rings after i.
//!
//! A texel whose first surfaces belong to later rings shows the same in the next map. So each map after the first is
//! traced only where the one before shows the ring that left. Face by face, all maps are drawn into one picture.

use std::sync::atomic::{AtomicU16, Ordering};

use super::bake::{Bake, standing_only};
use super::frame::{Channels, Frame, Sample};
use super::tiles::{Picture, Pixels, RenderView, Spots, draw, redraw};
use super::truth::Truth;
use crate::base::{Error, Progress, Result};
use crate::camera::Footprint;
use crate::scene::Scene;
use crate::trace::{AlphaFilter, Hit, HitFilter, Ray};

/// The maps of all rings.
#[derive(Debug)]
pub struct RingMaps {
    /// Map 0: six faces, one after the other.
    pub first: Frame,
    /// For each ring from 1 on, by how much its map differs from the one before.
    pub changes: Vec<Change>,
}

/// Texels that a ring's map shows anew.
#[derive(Debug, Default)]
pub struct Change {
    /// Their numbers in the six faces, ascending.
    pub texels: Vec<i64>,
    /// Their values.
    pub frame: Frame,
}

/// Bakes the static objects of a scene; `settings.radius` does not matter.
///
/// `rings` has the ring of each object, and last that of all faces without one. Maps 0 to `count` are baked.
pub fn bake_rings(scene: &Scene, settings: &Bake, rings: &[u16], count: u16, progress: &Progress) -> Result<RingMaps> {
    settings.check(scene)?;
    if rings.is_empty() {
        return Err(Error::value("rings", "a ring for faces without an object", "none"));
    }
    settings.channels().check_room(6 * settings.texels() as u64)?;
    let standing = standing_only(scene, progress)?;
    let shown = |after| Shown { scene: &standing, rings, after };
    if standing.has_cutouts() {
        let filter = |after| AlphaFilter { scene: &standing, inner: shown(after) };
        let truth = |after| Truth { scene: &standing, filter: filter(after) };
        maps(settings, count, shown, truth, progress)
    } else {
        maps(settings, count, shown, |after| Truth { scene: &standing, filter: shown(after) }, progress)
    }
}

/// Map 0 and the changes, where `shown` and `truth` tell what a map shows of later rings than a number.
fn maps<'a, F: HitFilter>(
    settings: &Bake,
    count: u16,
    shown: impl Fn(u16) -> Shown<'a>,
    truth: impl Fn(u16) -> Truth<'a, F>,
    progress: &Progress,
) -> Result<RingMaps> {
    let texels = settings.texels();
    let mut maps = RingMaps { first: Frame::default(), changes: Vec::new() };
    maps.changes.resize_with(count.into(), Change::default);
    for face in 0..6 {
        let camera = settings.camera(face)?;
        let view = settings.view(shown(0).scene, &camera);
        let mut least: Vec<AtomicU16> = std::iter::repeat_with(|| AtomicU16::new(u16::MAX)).take(texels).collect();
        let mut frame = draw(&view, &Noted { truth: truth(0), shown: shown(0), least: &least }, progress)?;
        maps.first.append(&frame);
        for (ring, change) in (1..).zip(&mut maps.changes) {
            let mask: Vec<bool> = least.iter_mut().map(|least| *least.get_mut() == ring).collect();
            let drawn: Vec<usize> = (0..texels).filter(|&texel| mask[texel]).collect();
            if drawn.is_empty() {
                continue;
            }
            drawn.iter().for_each(|&texel| *least[texel].get_mut() = u16::MAX);
            let view = RenderView { pixels: Pixels { mask: Some(&mask), ..view.pixels }, ..view };
            let picture = Noted { truth: truth(ring), shown: shown(ring), least: &least };
            redraw(&view, &picture, &mut frame, progress)?;
            change.texels.extend(drawn.iter().map(|texel| (usize::from(face) * texels + texel) as i64));
            change.frame.append_pixels(&frame, &drawn);
        }
    }
    Ok(maps)
}

/// Surfaces of rings after one.
#[derive(Clone, Copy, Debug)]
struct Shown<'a> {
    scene: &'a Scene,
    rings: &'a [u16],
    after: u16,
}

impl Shown<'_> {
    #[inline]
    fn ring(&self, hit: &Hit) -> u16 {
        let object = self.scene.instance(hit.instance).object_of(hit.face);
        let last = self.rings.len() - 1;
        self.rings[usize::try_from(object).map_or(last, |object| object.min(last))]
    }
}

impl HitFilter for Shown<'_> {
    #[inline]
    fn accepts(&self, _ray: &Ray, candidate: &Hit) -> bool {
        self.ring(candidate) > self.after
    }
}

/// A picture that notes the least ring among the surfaces that a texel's samples meet.
struct Noted<'a, F> {
    truth: Truth<'a, F>,
    shown: Shown<'a>,
    least: &'a [AtomicU16],
}

impl<F: HitFilter> Picture for Noted<'_, F> {
    fn trace(&self, rays: &mut [Ray], hits: &mut [Hit], spots: &Spots<'_>) {
        self.truth.trace(rays, hits, spots);
        for (n, hit) in hits.iter().enumerate().filter(|(_, hit)| !hit.is_miss()) {
            let ring = self.shown.ring(hit);
            self.least[spots.index(n)].fetch_min(ring, Ordering::Relaxed);
        }
    }

    fn add_colors(&self, rays: &[Ray], hits: &[Hit], footprint: impl Fn(usize) -> Footprint, sums: &mut [[f32; 3]]) {
        self.truth.add_colors(rays, hits, footprint, sums);
    }

    fn sample(&self, ray: &Ray, hit: &Hit, footprint: impl FnOnce() -> Footprint, wanted: Channels) -> Sample {
        self.truth.sample(ray, hit, footprint, wanted)
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::{DAffine3, DVec3};

    use super::*;
    use crate::base::FaceMap;
    use crate::base::random::uniform;
    use crate::scene::{Instance, Mesh};

    /// Four hundred triangles around the centre, of 40 objects.
    fn scene() -> Scene {
        let at = |n: u64, k| (uniform(7, n, k) * 2.0 - 1.0) as f32;
        let corner = |face: u64, k: u64| {
            let distance = 2.0 + 30.0 * uniform(7, face, 9) as f32;
            let middle = [0, 1, 2].map(|axis| distance * at(face, axis));
            [0, 1, 2].map(|axis| middle[axis as usize] + 3.0 * at(face, 10 + 3 * k + axis))
        };
        let positions: Vec<[f32; 3]> = (0..1200).map(|n| corner(n / 3, n % 3)).collect();
        let faces: Vec<[u32; 3]> = (0..400).map(|n| [3 * n, 3 * n + 1, 3 * n + 2]).collect();
        let objects = FaceMap::PerFace((0..400).map(|n| n / 10 - 1).collect());
        let mesh = Mesh::new(positions.into(), faces.into(), None, None, objects, FaceMap::Uniform(-1)).unwrap();
        let instance = Instance::new(Arc::new(mesh), DAffine3::IDENTITY, None).unwrap();
        Scene::new(DVec3::ZERO, vec![instance], vec![], Arc::default(), Arc::default()).unwrap()
    }

    #[test]
    fn changed_maps_are_those_traced_everywhere() {
        let scene = scene();
        let rings: Vec<u16> = (0..40).map(|n| 1 + n * 5 % 4).collect();
        for samples in [1, 5] {
            let settings = Bake { center: DVec3::ZERO, radius: 0.0, size: 24, samples, range: true, object_id: true };
            let bake = |rings: &[u16], count| bake_rings(&scene, &settings, rings, count, &Progress::new()).unwrap();
            let maps = bake(&rings, 3);
            let mut kept = maps.first;
            let mut traced = 0;
            for (after, change) in (1..).zip(maps.changes) {
                traced += change.texels.len();
                for (number, &texel) in change.texels.iter().enumerate() {
                    kept.color[texel as usize] = change.frame.color[number];
                    kept.range[texel as usize] = change.frame.range[number];
                    kept.object_id[texel as usize] = change.frame.object_id[number];
                }
                // Objects of ring 0 are in no map.
                let later: Vec<u16> = rings.iter().map(|&ring| if ring > after { ring } else { 0 }).collect();
                let whole = bake(&later, 0).first;
                assert_eq!(kept.color, whole.color);
                assert_eq!(kept.range, whole.range);
                assert_eq!(kept.object_id, whole.object_id);
            }
            assert!(traced > 100 && traced < 3 * 6 * 24 * 24 / 2, "{traced}");
        }
    }

    #[test]
    fn impossible_settings_are_refused() {
        let scene = scene();
        let settings = Bake { center: DVec3::ZERO, radius: 0.0, size: 4, samples: 1, range: false, object_id: false };
        assert!(bake_rings(&scene, &settings, &[], 0, &Progress::new()).is_err());
        assert!(bake_rings(&scene, &settings, &[1], 1, &Progress::new()).is_ok());
    }
}
