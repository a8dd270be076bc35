//! Baking of the far part of a scene into an environment map, by rays from the centre that start where they leave the
//! near cylinder.

use glam::{DQuat, DVec3};

use super::frame::{Channels, Frame};
use super::limits::Limits;
use super::tiles::{Pixels, RenderView, check_position, draw};
use super::truth::Truth;
use crate::base::{Progress, Result, ensure};
use crate::camera::{Camera, Projection};
use crate::cubemap::MAX_SIZE;
use crate::scene::Scene;
use crate::trace::{AlphaFilter, Hit, HitFilter, Ray};

/// Settings of a baked map.
#[derive(Clone, Copy, Debug)]
pub struct Bake {
    /// World position of the centre O.
    pub center: DVec3,
    /// Radius, in metres, of the cylinder about the vertical axis through O; nothing inside it is baked.
    pub radius: f64,
    /// Width of a face, texels.
    pub size: u32,
    /// Number of colour samples per texel. Range and object number are those of its centre.
    pub samples: u32,
    /// Whether to store the distances from O.
    pub range: bool,
    /// Whether to store object numbers.
    pub object_id: bool,
}

impl Bake {
    /// Fails for invalid settings.
    pub fn check(&self, scene: &Scene) -> Result<()> {
        let is_valid = (1..=MAX_SIZE).contains(&self.size);
        ensure!(is_valid, "face_size", format!("1 to {MAX_SIZE} texels"), self.size);
        let is_valid = self.radius.is_finite() && self.radius >= 0.0;
        ensure!(is_valid, "radius", "a finite radius of at least 0", self.radius);
        check_position("center", self.center - scene.origin)
    }

    /// Returns the images of each face.
    pub fn channels(&self) -> Channels {
        Channels { color: true, range: self.range, object_id: self.object_id, ..Channels::default() }
    }

    /// Returns the camera of a face.
    pub fn camera(&self, face: u8) -> Result<Camera> {
        Camera::new(self.center, DQuat::IDENTITY, Projection::CubeFace(face), self.size, self.size)
    }

    pub(super) fn view<'a>(&self, scene: &Scene, camera: &'a Camera) -> RenderView<'a> {
        let (channels, samples) = (self.channels(), self.samples);
        RenderView { camera, origin: scene.origin, channels, samples, limits: Limits::NONE, pixels: Pixels::default() }
    }

    /// Returns the number of texels of a face.
    pub(super) fn texels(&self) -> usize {
        (self.size as usize).pow(2)
    }

    /// Returns the width in metres, at 1 m distance, of the two texels by which the map reaches inside the radius.
    pub fn two_texels(&self) -> f64 {
        4.0 / f64::from(self.size)
    }
}

/// Bakes six faces, one after the other, of the static geometry; moving objects are never in the map. Geometry is
/// traced in place, without copies.
pub fn bake(scene: &Scene, settings: &Bake, progress: &Progress) -> Result<Frame> {
    settings.check(scene)?;
    let static_scene = without_moving(scene, progress)?;
    let beyond = BeyondRadius { scene: &static_scene, radius: settings.radius, two_texels: settings.two_texels() };
    let picture = Truth { scene: &static_scene, filter: &AlphaFilter::new(&static_scene, beyond) };
    let mut faces = Frame::with_capacity(settings.channels(), 6 * settings.texels())?;
    for face in 0..6 {
        faces.append(&draw(&settings.view(scene, &settings.camera(face)?), &picture, progress)?)?;
    }
    Ok(faces)
}

/// Returns the scene without its moving instances, built.
pub(crate) fn without_moving(scene: &Scene, progress: &Progress) -> Result<Scene> {
    let static_scene = Scene { moving: Default::default(), ..scene.clone() };
    static_scene.build_to_shade(progress)?;
    Ok(static_scene)
}

/// Returns the number of rays that a bake traces.
pub fn rays(settings: &Bake) -> u64 {
    let surface = settings.samples > 1 && (settings.range || settings.object_id);
    6 * u64::from(settings.size).pow(2) * (u64::from(settings.samples) + u64::from(surface))
}

/// Filter for surfaces beyond the cylinder, and surfaces inside it whose two-texel footprint reaches beyond.
///
/// The overlap is needed where the near geometry ends, because look-ups just beyond r₂ also read texels inside. It is
/// measured on the surface: rays at eye height meet the ground at an angle of a few degrees, so the ground needs metres
/// of overlap, and walls that face the centre need none. Measured across the ray, it would be a few centimetres and
/// leave a crack in the ground.
struct BeyondRadius<'a> {
    scene: &'a Scene,
    radius: f64,
    /// Width of two texels in metres at 1 m distance.
    two_texels: f64,
}

impl HitFilter for BeyondRadius<'_> {
    fn accepts(&self, ray: &Ray, candidate: &Hit) -> bool {
        // Rays start at the centre and have unit direction.
        let (direction, t) = (ray.direction.as_dvec3(), f64::from(candidate.t));
        let horizontal = DVec3::new(direction.x, 0.0, direction.z);
        let rho = t * horizontal.length();
        rho >= self.radius || rho + self.reach(candidate, direction, horizontal, t) >= self.radius
    }
}

impl BeyondRadius<'_> {
    /// Returns the growth of ρ along the surface when the direction turns by two texels. Turning the direction d by δ
    /// moves the point by t (δ − d (n·δ)/(n·d)) and ρ by the component of this along r. Here n is the surface normal,
    /// t the distance, and r the outward horizontal unit vector.
    #[cold]
    fn reach(&self, hit: &Hit, direction: DVec3, horizontal: DVec3, t: f64) -> f64 {
        let [a, b, c] = self.scene.instance(hit.instance).corners(hit.face).map(|corner| corner.as_dvec3());
        let normal = (b - a).cross(c - a);
        let outward = horizontal.normalize_or_zero();
        let slant = outward.dot(direction) / normal.dot(direction);
        // A surface seen edge-on has no footprint: 0 × ∞ is NaN, which the caller's comparison rejects.
        (outward - normal * slant).length() * t * self.two_texels
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::{Error, FaceMap};
    use crate::cubemap::EnvironmentMap;
    use crate::scene::{Instance, Mesh};
    use glam::DAffine3;

    fn scene(quads: &[[[f32; 3]; 4]]) -> Scene {
        let triangles: Vec<_> = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        let mesh =
            Mesh::of_triangles(&triangles, FaceMap::PerFace((0..triangles.len() as i32).map(|n| n / 2).collect()));
        Scene::of_instances(vec![Instance::new(mesh, DAffine3::IDENTITY, None).unwrap()], vec![])
    }

    fn wall(x: f32, half: f32) -> [[f32; 3]; 4] {
        [[x, -half, -half], [x, -half, half], [x, half, half], [x, half, -half]]
    }

    fn bake_map(scene: &Scene, radius: f64, size: u32) -> EnvironmentMap {
        let settings = Bake { center: DVec3::ZERO, radius, size, samples: 1, range: true, object_id: true };
        let frame = bake(scene, &settings, &Progress::new()).unwrap();
        EnvironmentMap::new(size, frame.color.into(), Some(frame.range.into()), Some(frame.object_id.into())).unwrap()
    }

    #[test]
    fn walls_inside_the_cylinder_do_not_hide_walls_beyond() {
        let map = bake_map(&scene(&[wall(5.0, 3.0), wall(20.0, 50.0)]), 10.0, 16);
        let (range, object) = map.surface(glam::Vec3::X);
        assert_eq!(object, 1);
        // The centre of the texel next to the axis is offset by 1/16 of the distance in both directions.
        let expected = 20.0 * (1.0f32 + 2.0 / 256.0).sqrt();
        assert!((range - expected).abs() < 1e-5 * expected);
        assert_eq!(map.surface(glam::Vec3::NEG_X), (f32::INFINITY, -1));
    }

    #[test]
    fn vertical_rays_miss_everything() {
        let roof = [[-8.0, 9.0, -8.0], [8.0, 9.0, -8.0], [8.0, 9.0, 8.0], [-8.0, 9.0, 8.0]];
        let map = bake_map(&scene(&[roof]), 40.0, 8);
        assert!(map.object_id.unwrap().iter().all(|&object| object == -1));
    }

    #[test]
    fn ground_overlaps_by_its_footprint_and_no_more() {
        // Ground 1.7 m below: at ρ = 10 m a texel of 1/128 covers 0.47 m of it, so the overlap is about 0.9 m.
        let far = 1000.0;
        let ground = [[-far, -1.7, -far], [-far, -1.7, far], [far, -1.7, far], [far, -1.7, -far]];
        let size = 256;
        let map = bake_map(&scene(&[ground]), 10.0, size);
        let range = map.range.unwrap();
        let mut min_rho = f64::INFINITY;
        for texel in 0..6 * size * size {
            let d = crate::cubemap::direction_from_texel(texel, size).normalize();
            let expected = -1.7 / d.y;
            let rho = expected * d.x.hypot(d.z);
            let range_found = f64::from(range[texel as usize]);
            if d.y < 0.0 && rho > 10.0 {
                // Sheared corners 1,400 m away are rounded by 6e-8 of that: 5e-5 of the 1.7 m of the descent.
                assert!((range_found - expected).abs() < 1e-4 * expected, "{d} {range_found} {expected}");
            } else if range_found.is_finite() {
                min_rho = min_rho.min(rho);
            }
        }
        assert!((8.5..9.8).contains(&min_rho), "{min_rho}");
    }

    #[test]
    fn refuses_impossible_settings() {
        let scene = scene(&[wall(5.0, 1.0)]);
        let good = Bake { center: DVec3::ZERO, radius: 1.0, size: 4, samples: 1, range: false, object_id: false };
        let wrong = [
            Bake { center: DVec3::NAN, ..good },
            Bake { radius: f64::NAN, ..good },
            Bake { radius: -1.0, ..good },
            Bake { size: 0, ..good },
            Bake { size: MAX_SIZE + 1, ..good },
            Bake { samples: 0, ..good },
        ];
        assert!(bake(&scene, &good, &Progress::new()).is_ok());
        for settings in wrong {
            assert!(bake(&scene, &settings, &Progress::new()).is_err(), "{settings:?}");
        }
        let cancelled = Progress::new();
        cancelled.cancel();
        assert_eq!(bake(&scene, &good, &cancelled).unwrap_err(), Error::Cancelled);
    }
}
