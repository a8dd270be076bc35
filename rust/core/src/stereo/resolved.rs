//! Assembly without blur: an eye's pixel shows the surface that the third camera sees exactly at the pixel's place.
//!
//! Bilinear interpolation mixes four pixels, which softens textures and edges. The surface at the place between them is
//! mostly one of theirs, so the third camera's ray through the place is intersected with these faces only.

use glam::{DVec2, DVec3, Vec3};

use super::assembly::Taps;
use super::rig::{Rig, Side};
use crate::base::{Progress, Result};
use crate::camera::{Camera, Rays};
use crate::render::shade::background;
use crate::render::tiles::{ray_at, sample_offsets};
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
    /// The part of space that it draws, in world positions.
    pub limits: Limits,
    /// Linear RGB of its pixels.
    pub color: &'a [[f32; 3]],
    /// Triangle numbers of its pixels; −1 where it sees none.
    pub faces: &'a [i64],
}

/// The same, ready to be looked up.
struct Resolver<'a> {
    far: FarPicture<'a>,
    rays: Rays,
    /// Relative to the scene's origin, as the limits.
    eye: DVec3,
    limits: Limits,
    /// Side of the square that a sample stands for, pixels.
    scale: f64,
    cutouts: bool,
}

impl Rig {
    /// Adds what the third camera sees behind an eye's own picture, with `samples` places for each pixel. Where its ray
    /// meets none of the faces around, it sees the sky if one of them does, and else their bilinear mixture.
    pub fn resolve(
        &self,
        side: Side,
        coverage: &[f32],
        far: &FarPicture<'_>,
        samples: u32,
        color: &mut [[f32; 3]],
        progress: &Progress,
    ) -> Result<()> {
        self.check_center("color", far.color.len())?;
        self.check_center("faces", far.faces.len())?;
        let (map, offsets, origin) = (self.eye_map(side, coverage)?, sample_offsets(samples), far.scene.origin);
        let resolver = Resolver {
            far: *far,
            rays: far.camera.rays(),
            eye: far.camera.position - origin,
            limits: far.limits.relative_to(origin),
            scale: 1.0 / f64::from(samples).sqrt(),
            cutouts: far.scene.has_cutouts(),
        };
        let share = 1.0 / samples as f32;
        self.behind(coverage, color, progress, |column, row| {
            let mut sum = [0.0; 3];
            for [x, y] in &offsets {
                let at = map.place(column as f64 + x, row as f64 + y);
                let taps = map.taps(at);
                let color = resolver.color(&taps, at).unwrap_or_else(|| map.mix(column, row, &taps, far.color));
                (0..3).for_each(|i| sum[i] += share * color[i]);
            }
            sum
        })
    }
}

impl Resolver<'_> {
    /// Linear RGB at a place; none where the faces around don't tell it.
    fn color(&self, taps: &Taps, at: DVec2) -> Option<[f32; 3]> {
        let FarPicture { scene, color, faces, .. } = self.far;
        let around = taps.pixels.map(|pixel| faces[pixel]);
        let is_one = around.iter().all(|&face| face == around[0]);
        if is_one && around[0] >= 0 && self.is_flat(around[0]) {
            return Some(color[taps.pixels[0]]);
        }
        let ray = ray_at(&self.rays, self.eye, at.x, at.y, &self.limits);
        let mut best = Hit::MISS;
        for (n, &face) in around.iter().enumerate().filter(|(_, face)| **face >= 0) {
            if around[..n].contains(&face) {
                continue;
            }
            if let Some(hit) = self.meet(&ray, face)
                && hit.t < best.t
            {
                best = hit;
            }
        }
        if best.is_miss() {
            return around.contains(&-1).then(|| background(ray.direction));
        }
        let width = self.rays.footprint(at.x, at.y, self.scale).at(best.t);
        Some(Surface::of_hit(scene, &ray, &best).color(scene, width))
    }

    /// Whether all points of a face have one colour, so that the pixels around have it too.
    fn is_flat(&self, face: i64) -> bool {
        let scene = self.far.scene;
        let Some((instance, _)) = scene.locate(face) else { return false };
        let mesh = &scene.instance(instance).mesh;
        scene.textures.is_empty() && mesh.colors.is_none() && mesh.normals.is_none()
    }

    /// Where a ray meets a face, by Möller and Trumbore (1997) in float64.
    fn meet(&self, ray: &Ray, number: i64) -> Option<Hit> {
        let scene = self.far.scene;
        let (instance, face) = scene.locate(number)?;
        let placed = scene.instance(instance);
        let [a, b, c] = placed.corners(face).map(Vec3::as_dvec3);
        let (origin, way) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
        let (ab, ac) = (b - a, c - a);
        let p = way.cross(ac);
        let determinant = ab.dot(p);
        let from = origin - a;
        let q = from.cross(ab);
        let [t, u, v] = [ac.dot(q), from.dot(p), way.dot(q)].map(|x| x / determinant);
        // NaN, of faces seen edge-on, is nowhere.
        let is_inside = u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t >= f64::from(ray.t_min) && t <= f64::from(ray.t_max);
        let hit = Hit { t: t as f32, u: u as f32, v: v as f32, instance, face };
        let is_solid = || !self.cutouts || scene.is_solid(&placed.mesh, face, (hit.u, hit.v));
        (is_inside && is_solid()).then_some(hit)
    }
}
