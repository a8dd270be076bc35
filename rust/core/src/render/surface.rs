//! Surface points hit by rays, with the data for shading and storing them.

use glam::Vec3;

use super::frame::{Channels, Sample};
use super::shade::irradiance;
use crate::camera::Footprint;
use crate::scene::{Instance, Mesh, Scene, Spot, facing_normals};
use crate::trace::{Hit, Ray};

/// A point of a surface as a viewer sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Instance in the scene.
    pub instance: u32,
    /// Face in the instance's mesh.
    pub face: u32,
    /// Weights of the face's second and third corner.
    pub weights: (f32, f32),
    /// The point relative to the scene's origin.
    pub point: Vec3,
    /// Unit geometric normal towards the viewer; the colour may use another normal.
    pub normal: Vec3,
    /// Cosine of the angle between normal and ray, 0 to 1.
    pub cosine: f32,
    /// Twice the area of the face, square metres.
    pub doubled_area: f32,
}

/// Data shared by all points of an instance's face. It is reused, because neighbouring rays usually hit the same face.
#[derive(Clone, Copy, Debug)]
pub struct Facet {
    instance: u32,
    face: u32,
    corner: Vec3,
    sides: [Vec3; 2],
    /// Unit normal of the counter-clockwise side; zero for a face without area.
    outside: Vec3,
    doubled_area: f32,
}

impl Facet {
    /// Computes the data of an instance's face.
    #[inline]
    pub fn new(scene: &Scene, instance: u32, face: u32) -> Self {
        let [a, b, c] = scene.instance(instance).corners(face);
        let (ab, ac) = (b - a, c - a);
        // In float64, because float32 rounds the squared area of a face of square millimetres to zero.
        let cross = ab.as_dvec3().cross(ac.as_dvec3());
        let doubled_area = cross.length();
        let outside = if doubled_area > 0.0 { (cross / doubled_area).as_vec3() } else { Vec3::ZERO };
        Self { instance, face, corner: a, sides: [ab, ac], outside, doubled_area: doubled_area as f32 }
    }

    /// Returns whether a hit lies on this face.
    #[inline]
    pub fn contains(&self, hit: &Hit) -> bool {
        self.face == hit.face && self.instance == hit.instance
    }

    /// Returns the point at weights (u, v), seen along a unit direction.
    #[inline]
    pub fn surface(&self, weights: (f32, f32), direction: Vec3) -> Surface {
        let outside = if self.outside == Vec3::ZERO { -direction } else { self.outside };
        let cosine = outside.dot(direction);
        Surface {
            instance: self.instance,
            face: self.face,
            weights,
            point: self.corner + self.sides[0] * weights.0 + self.sides[1] * weights.1,
            normal: if cosine > 0.0 { -outside } else { outside },
            cosine: cosine.abs().min(1.0),
            doubled_area: self.doubled_area,
        }
    }
}

/// Adds the colours of surfaces along neighbouring rays to their sums. `scene_hit` converts a hit to one on the scene's
/// face, `miss_color` gives the colour of a ray without a hit.
pub(super) fn add_colors(
    scene: &Scene,
    rays: &[Ray],
    hits: &[Hit],
    footprint: impl Fn(usize) -> Footprint,
    scene_hit: impl Fn(&Hit) -> Hit,
    miss_color: impl Fn(usize) -> [f32; 3],
    sums: &mut [[f32; 3]],
) {
    let mut last: Option<Facet> = None;
    // Only textures need the width, which takes two square roots.
    let is_textured = !scene.textures.is_empty();
    for (n, (ray, hit)) in rays.iter().zip(hits).enumerate() {
        if hit.is_miss() {
            add(&mut sums[n], miss_color(n));
            continue;
        }
        let hit = scene_hit(hit);
        let facet = match last {
            Some(facet) if facet.contains(&hit) => facet,
            _ => *last.insert(Facet::new(scene, hit.instance, hit.face)),
        };
        let surface = facet.surface((hit.u, hit.v), ray.direction);
        let width = if is_textured { footprint(n).width_at(hit.t) } else { 0.0 };
        add(&mut sums[n], surface.color(scene, width));
    }
}

#[inline]
fn add(sum: &mut [f32; 3], color: [f32; 3]) {
    (0..3).for_each(|i| sum[i] += color[i]);
}

impl Surface {
    /// Returns the surface hit by a ray with a unit direction; the hit must not be a miss.
    #[inline]
    pub fn of_hit(scene: &Scene, ray: &Ray, hit: &Hit) -> Self {
        Facet::new(scene, hit.instance, hit.face).surface((hit.u, hit.v), ray.direction)
    }

    /// Returns the surface at weights (u, v) of an instance's face, seen along a direction of any length.
    pub fn new(scene: &Scene, instance: u32, face: u32, weights: (f32, f32), direction: Vec3) -> Self {
        Facet::new(scene, instance, face).surface(weights, direction.normalize_or(Vec3::NEG_Z))
    }

    /// Returns the linear RGB for a ray that is `width` metres wide at the surface (`Footprint::width_at`).
    #[inline]
    pub fn color(&self, scene: &Scene, width: f32) -> [f32; 3] {
        let instance = scene.instance(self.instance);
        let (material, spot) = (scene.material_of(&instance.mesh, self.face), self.spot(&instance.mesh, width));
        let mut color = scene.albedo(&material, &spot);
        if !material.unlit {
            let light = irradiance(self.shading_normal(instance));
            (0..3).for_each(|i| color[i] *= light[i]);
        }
        if material.emits() {
            let emission = scene.emission(&material, &spot);
            (0..3).for_each(|i| color[i] += emission[i]);
        }
        color
    }

    /// Returns the spot on the mesh for a ray that is `width` metres wide at the surface.
    #[inline]
    fn spot<'a>(&self, mesh: &'a Mesh, width: f32) -> Spot<'a> {
        let footprint = width / self.cosine.max(MIN_COSINE).sqrt();
        Spot { mesh, face: self.face, at: self.weights, footprint, doubled_area: self.doubled_area }
    }

    /// Returns the channels of a pixel that shows this point at a displayed distance, for a ray of `width` metres.
    /// Unwanted channels may keep their values for a miss.
    pub fn sample(&self, scene: &Scene, range: f32, width: impl FnOnce() -> f32, channels: Channels) -> Sample {
        let instance = scene.instance(self.instance);
        let mut sample = Sample {
            range,
            object_id: instance.object_of(self.face),
            face_id: scene.triangle_offset(self.instance) + i64::from(self.face),
            position: self.point.to_array(),
            normal: self.normal.to_array(),
            ..Sample::default()
        };
        if channels.albedo {
            let mesh = &instance.mesh;
            sample.albedo = scene.albedo(&scene.material_of(mesh, self.face), &self.spot(mesh, width()));
        }
        if channels.shading_normal {
            sample.shading_normal = self.shading_normal(instance).to_array();
        }
        sample
    }

    /// Returns the unit normal for shading, interpolated between the corner normals if the mesh has normals. Near a
    /// silhouette it may point away from the viewer, although the face itself points towards the viewer.
    #[inline]
    fn shading_normal(&self, instance: &Instance) -> Vec3 {
        let corners = instance.corner_normals(self.face);
        match corners.and_then(|corners| facing_normals(corners, self.normal)) {
            Some([a, b, c]) => (a + (b - a) * self.weights.0 + (c - a) * self.weights.1).normalize_or(self.normal),
            None => self.normal,
        }
    }
}

/// Minimum cosine by which a footprint is divided; at smaller cosines a texture shows its mean anyway.
const MIN_COSINE: f32 = 1e-4;
