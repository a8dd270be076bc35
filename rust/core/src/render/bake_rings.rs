//! Maps of a scene whose objects become geometry ring after ring: a map shows the objects of later rings.
//!
//! A texel whose first surfaces belong to later rings shows the same in the next map. So each map after the first is
//! traced only where the one before shows the ring that left.

use std::sync::atomic::{AtomicU16, Ordering};

use super::bake::{Bake, faces, standing_only};
use super::frame::{Channels, Frame, Sample};
use super::tiles::{Picture, Spots};
use super::truth::Truth;
use crate::base::{Error, Progress, Result};
use crate::camera::Footprint;
use crate::scene::Scene;
use crate::trace::{AlphaFilter, Hit, HitFilter, Ray};

/// Rings of objects, and the part of them that a map shows.
#[derive(Clone, Copy, Debug)]
pub struct Shown<'a> {
    /// Ring of each object, and last that of all faces without one.
    pub rings: &'a [u16],
    /// The map shows the objects of greater rings.
    pub after: u16,
}

/// A map, and the rings that its texels show.
#[derive(Debug)]
pub struct RingFaces {
    /// Six faces, one after the other.
    pub frame: Frame,
    /// Least ring among the surfaces that a texel's samples meet; `u16::MAX` without any.
    pub least: Vec<u16>,
}

/// Bakes the static objects of greater rings, over the texels of a mask; `settings.radius` does not matter.
pub fn bake_rings(
    scene: &Scene,
    settings: &Bake,
    shown: Shown<'_>,
    mask: Option<&[bool]>,
    progress: &Progress,
) -> Result<RingFaces> {
    settings.check(scene)?;
    let texels = 6 * (settings.size as usize).pow(2);
    if shown.rings.is_empty() {
        return Err(Error::value("rings", "a ring for faces without an object", "none"));
    }
    if let Some(mask) = mask.filter(|mask| mask.len() != texels) {
        return Err(Error::value("mask", format!("{texels} texels"), mask.len()));
    }
    let standing = standing_only(scene, progress)?;
    let least: Vec<AtomicU16> = (0..texels).map(|_| AtomicU16::new(u16::MAX)).collect();
    let filter = Later { scene: &standing, shown };
    let of_face = |face: usize| &least[face * texels / 6..][..texels / 6];
    let frame = if standing.has_cutouts() {
        let truth = || Truth { scene: &standing, filter: AlphaFilter { scene: &standing, inner: &filter } };
        faces(scene, settings, mask, |face| Noted { truth: truth(), shown, least: of_face(face) }, progress)?
    } else {
        let truth = || Truth { scene: &standing, filter: &filter };
        faces(scene, settings, mask, |face| Noted { truth: truth(), shown, least: of_face(face) }, progress)?
    };
    Ok(RingFaces { frame, least: least.into_iter().map(AtomicU16::into_inner).collect() })
}

impl Shown<'_> {
    #[inline]
    fn ring(&self, scene: &Scene, hit: &Hit) -> u16 {
        let object = scene.instance(hit.instance).object_of(hit.face);
        let last = self.rings.len() - 1;
        self.rings[usize::try_from(object).map_or(last, |object| object.min(last))]
    }
}

/// Surfaces of later rings.
struct Later<'a> {
    scene: &'a Scene,
    shown: Shown<'a>,
}

impl HitFilter for &Later<'_> {
    #[inline]
    fn accepts(&self, _ray: &Ray, candidate: &Hit) -> bool {
        self.shown.ring(self.scene, candidate) > self.shown.after
    }
}

/// A picture that notes the rings of what its pixels show.
struct Noted<'a, F> {
    truth: Truth<'a, F>,
    shown: Shown<'a>,
    least: &'a [AtomicU16],
}

impl<F: HitFilter> Picture for Noted<'_, F> {
    fn trace(&self, rays: &mut [Ray], hits: &mut [Hit], spots: &Spots<'_>) {
        self.truth.trace(rays, hits, spots);
        for (n, hit) in hits.iter().enumerate().filter(|(_, hit)| !hit.is_miss()) {
            let ring = self.shown.ring(self.truth.scene, hit);
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
    fn maps_traced_where_a_ring_left_are_those_traced_everywhere() {
        let scene = scene();
        let rings: Vec<u16> = (0..40).map(|n| 1 + n * 5 % 4).collect();
        for samples in [1, 5] {
            let settings = Bake { center: DVec3::ZERO, radius: 0.0, size: 24, samples, range: true, object_id: true };
            let bake = |after, mask: Option<&[bool]>| {
                bake_rings(&scene, &settings, Shown { rings: &rings, after }, mask, &Progress::new()).unwrap()
            };
            let mut kept = bake(0, None);
            let mut traced = 0;
            for after in 1..4 {
                let mask: Vec<bool> = kept.least.iter().map(|&least| least == after).collect();
                let (changed, whole) = (bake(after, Some(&mask)), bake(after, None));
                for (texel, _) in mask.iter().enumerate().filter(|(_, mask)| **mask) {
                    kept.frame.color[texel] = changed.frame.color[texel];
                    kept.frame.range[texel] = changed.frame.range[texel];
                    kept.frame.object_id[texel] = changed.frame.object_id[texel];
                    kept.least[texel] = changed.least[texel];
                    traced += 1;
                }
                assert_eq!(kept.frame.color, whole.frame.color);
                assert_eq!(kept.frame.range, whole.frame.range);
                assert_eq!(kept.frame.object_id, whole.frame.object_id);
                assert_eq!(kept.least, whole.least);
                assert!(whole.least.iter().all(|&least| least > after));
            }
            assert!(traced > 100 && traced < 3 * 6 * 24 * 24 / 2, "{traced}");
        }
    }

    #[test]
    fn impossible_settings_are_refused() {
        let scene = scene();
        let settings = Bake { center: DVec3::ZERO, radius: 0.0, size: 4, samples: 1, range: false, object_id: false };
        let bake = |rings: &[u16], mask: Option<&[bool]>| {
            bake_rings(&scene, &settings, Shown { rings, after: 0 }, mask, &Progress::new())
        };
        assert!(bake(&[], None).is_err());
        assert!(bake(&[1], Some(&[true; 95])).is_err());
        assert!(bake(&[1], Some(&[true; 96])).is_ok());
    }
}
