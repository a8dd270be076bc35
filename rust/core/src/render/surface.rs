//! What a ray meets: a point of a face with its normal, ready to be shaded or stored.

use glam::Vec3;

use super::shade::irradiance;
use crate::scene::Scene;
use crate::trace::{Hit, Ray};

/// A point of a surface as a viewer sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Instance in the scene.
    pub instance: u32,
    /// Face in the instance's mesh.
    pub face: u32,
    /// Weights of the face's second and third corner.
    pub at: (f32, f32),
    /// The point, relative to the scene's origin.
    pub point: Vec3,
    /// Unit geometric normal, towards the viewer.
    pub normal: Vec3,
    /// Cosine of the angle between normal and ray, 0..1.
    pub cosine: f32,
    /// Twice the area of the face, square metres.
    pub doubled_area: f32,
}

impl Surface {
    /// The surface that a ray hit; not for a miss.
    #[inline]
    pub fn of_hit(scene: &Scene, ray: &Ray, hit: &Hit) -> Self {
        Self::new(scene, hit.instance, hit.face, (hit.u, hit.v), ray.direction)
    }

    /// The surface at weights (u, v) of an instance's face, seen along a direction of any length.
    pub fn new(scene: &Scene, instance: u32, face: u32, at: (f32, f32), direction: Vec3) -> Self {
        let [a, b, c] = scene.instance(instance).corners(face);
        let (ab, ac) = (b - a, c - a);
        // In float64, because the square of a millimetre's area is below what float32 tells from zero.
        let cross = ab.as_dvec3().cross(ac.as_dvec3());
        let direction = direction.normalize_or(Vec3::NEG_Z);
        let doubled_area = cross.length();
        let outside = if doubled_area > 0.0 { (cross / doubled_area).as_vec3() } else { -direction };
        let cosine = outside.dot(direction);
        Self {
            instance,
            face,
            at,
            point: a + ab * at.0 + ac * at.1,
            normal: if cosine > 0.0 { -outside } else { outside },
            cosine: cosine.abs().min(1.0),
            doubled_area: doubled_area as f32,
        }
    }

    /// Linear RGB, for a ray that is `width` metres wide where it arrives (`Footprint::at`).
    pub fn color(&self, scene: &Scene, width: f32) -> [f32; 3] {
        let mesh = &scene.instance(self.instance).mesh;
        let footprint = width / self.cosine.max(GRAZING).sqrt();
        let albedo = scene.albedo(mesh, self.face, self.at, footprint, self.doubled_area);
        let light = irradiance(self.normal);
        std::array::from_fn(|i| albedo[i] * light[i])
    }

    /// Object of the face.
    pub fn object_id(&self, scene: &Scene) -> i32 {
        scene.instance(self.instance).object_of(self.face)
    }

    /// Triangle number of the face.
    pub fn face_id(&self, scene: &Scene) -> i64 {
        scene.triangle_offset(self.instance) + i64::from(self.face)
    }
}

/// Least cosine that a footprint is divided by: at smaller angles a texture is its mean anyway.
const GRAZING: f32 = 1e-4;
