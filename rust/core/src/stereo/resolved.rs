//! Assembly without blur: an eye's pixel shows the surface that the third camera sees exactly at the pixel's position.
//!
//! Bilinear interpolation of four pixels would blur textures and edges. Instead, the third camera's ray through the
//! position is intersected with the faces that the four pixels show, because the face there is usually one of them.

use glam::{DVec2, Vec3};

use super::assembly::Taps;
use super::rig::{Rig, Side};
use crate::base::{Progress, Result};
use crate::camera::Camera;
use crate::render::shade::background;
use crate::render::tiles::{ViewRays, sample_offsets};
use crate::render::{Limits, Surface};
use crate::scene::Scene;
use crate::trace::{Hit, Ray};

/// The third camera's picture of a scene.
#[derive(Clone, Copy)]
pub struct FarPicture<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The third camera.
    pub camera: &'a Camera,
    /// Volume that it draws, in world coordinates.
    pub limits: Limits,
    /// Linear RGB of its pixels.
    pub color: &'a [[f32; 3]],
    /// Triangle numbers of its pixels; −1 where it sees no surface.
    pub faces: &'a [i64],
}

/// Look-up state for a `FarPicture`.
struct Resolver<'a> {
    far: FarPicture<'a>,
    view: ViewRays,
    /// Side of the square that a sample represents, pixels.
    scale: f64,
    has_cutouts: bool,
}

impl Rig {
    /// Adds the third camera's view behind an eye's own picture, with `samples` positions per pixel. If a ray hits none
    /// of the four pixels' faces, its colour is the sky's if one of them shows the sky, and interpolated otherwise.
    pub fn resolve(
        &self,
        side: Side,
        coverage: &[f32],
        far: &FarPicture<'_>,
        samples: u32,
        color: &mut [[f32; 3]],
        progress: &Progress,
    ) -> Result<()> {
        self.check_shared("color", far.color.len())?;
        self.check_shared("faces", far.faces.len())?;
        let (map, offsets) = (self.eye_map(side, coverage)?, sample_offsets(samples));
        let resolver = Resolver {
            far: *far,
            view: ViewRays::new(far.camera, far.scene.origin, &far.limits),
            scale: 1.0 / f64::from(samples).sqrt(),
            has_cutouts: far.scene.has_cutouts(),
        };
        let sample_weight = 1.0 / samples as f32;
        self.add_behind(coverage, color, progress, |column, row| {
            let mut sum = [0.0; 3];
            for [x, y] in &offsets {
                let position = map.lookup_position(column as f64 + x, row as f64 + y);
                let taps = map.taps(position);
                let color = resolver.color(&taps, position).unwrap_or_else(|| map.mix(column, row, &taps, far.color));
                (0..3).for_each(|i| sum[i] += sample_weight * color[i]);
            }
            sum
        })
    }
}

impl Resolver<'_> {
    /// Returns the linear RGB at a position; `None` if the faces around do not determine it.
    fn color(&self, taps: &Taps, position: DVec2) -> Option<[f32; 3]> {
        let FarPicture { scene, color, faces, .. } = self.far;
        let around = taps.pixels.map(|pixel| faces[pixel]);
        let is_one_face = around.iter().all(|&face| face == around[0]);
        if is_one_face && around[0] >= 0 && self.is_flat(around[0]) {
            return Some(color[taps.pixels[0]]);
        }
        let ray = self.view.ray(position.x, position.y);
        let mut best = Hit::MISS;
        for (n, &face) in around.iter().enumerate() {
            if face < 0 || around[..n].contains(&face) {
                continue;
            }
            best = self.intersect(&ray, face).filter(|hit| hit.t < best.t).unwrap_or(best);
        }
        if best.is_miss() {
            return around.contains(&-1).then(|| background(ray.direction));
        }
        let width = self.view.rays.footprint(position.x, position.y, self.scale).width_at(best.t);
        Some(Surface::of_hit(scene, &ray, &best).color(scene, width))
    }

    /// Returns whether all points of a face have one colour, so that the pixels around have it too.
    fn is_flat(&self, face: i64) -> bool {
        let scene = self.far.scene;
        let Some((instance, _)) = scene.locate(face) else { return false };
        let mesh = &scene.instance(instance).mesh;
        scene.textures.is_empty() && mesh.colors.is_none() && mesh.normals.is_none()
    }

    /// Intersects a ray with a face, by Möller and Trumbore (1997) in float64.
    fn intersect(&self, ray: &Ray, number: i64) -> Option<Hit> {
        let scene = self.far.scene;
        let (instance, face) = scene.locate(number)?;
        let placed = scene.instance(instance);
        let [a, b, c] = placed.corners(face).map(Vec3::as_dvec3);
        let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
        let (ab, ac) = (b - a, c - a);
        let p = direction.cross(ac);
        let determinant = ab.dot(p);
        let offset = origin - a;
        let q = offset.cross(ab);
        let [t, u, v] = [ac.dot(q), offset.dot(p), direction.dot(q)].map(|x| x / determinant);
        // Faces seen edge-on give NaN, which fails every comparison.
        let is_inside = u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t >= f64::from(ray.t_min) && t <= f64::from(ray.t_max);
        let hit = Hit { t: t as f32, u: u as f32, v: v as f32, instance, face };
        let is_solid = || !self.has_cutouts || scene.is_solid(&placed.mesh, face, (hit.u, hit.v));
        (is_inside && is_solid()).then_some(hit)
    }
}
