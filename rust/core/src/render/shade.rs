//! The one shading formula: linear albedo × (sky(n) + sun · max(0, n·l)), two-sided, at most 1 for white.

use glam::Vec3;

use crate::scene::Scene;

/// Direction towards the sun.
pub const SUN_DIRECTION: Vec3 = Vec3::new(0.408_248_3, 0.816_496_6, 0.408_248_3);
/// Strength of the sun.
pub const SUN: f32 = 0.6;
/// Strength of the sky from straight below and from straight above.
pub const SKY: [f32; 2] = [0.15, 0.4];

/// What arrives from where nothing was hit, by direction (unit).
pub fn background(direction: Vec3) -> [f32; 3] {
    let up = direction.y.max(0.0).sqrt();
    [0.72 - 0.42 * up, 0.80 - 0.32 * up, 0.88 - 0.16 * up]
}

/// Light that a surface with unit normal `n` (towards the viewer) reflects for albedo 1.
#[inline]
pub fn irradiance(n: Vec3) -> f32 {
    SKY[0] + (SKY[1] - SKY[0]) * (0.5 + 0.5 * n.y) + SUN * n.dot(SUN_DIRECTION).max(0.0)
}

/// Linear RGB of a surface point: face of an instance, weights (u, v) of its second and third corner, unit normal
/// towards the viewer, and the width in metres of the ray's footprint across the surface (texture level).
pub fn surface_color(
    scene: &Scene,
    instance: u32,
    face: u32,
    (u, v): (f32, f32),
    normal: Vec3,
    footprint: f32,
) -> [f32; 3] {
    let _ = (u, v, footprint);
    let placed = scene.instance(instance);
    let material = usize::try_from(placed.mesh.materials.get(face)).ok().and_then(|m| scene.materials.get(m));
    let albedo = material.copied().unwrap_or_default().base_color;
    let light = irradiance(normal);
    [albedo[0] * light, albedo[1] * light, albedo[2] * light]
}
