//! Splitting of scenes. Static meshes are split as placed; moving ones change their pose and are not split.

use std::sync::Arc;

use glam::{DAffine3, DVec3, Vec3};
use rayon::prelude::*;

use super::assemble::{Assembled, Budget, NewVertex, SplitCounts, assemble};
use super::rule::Rule;
use super::settings::Precision;
use crate::base::memory::{try_extend, try_with_capacity};
use crate::base::{Buffer, Progress, Result};
use crate::scene::srgb::{linear_from_srgb, srgb_from_linear};
use crate::scene::{Instance, InstanceSet, Mesh, Scene, facing_normals};

/// Returns the scene with the static triangles of chosen objects split; fails unless the rule's tolerance is a bound.
/// Faces without an object have the number −1.
pub fn tessellate_scene(
    scene: &Scene,
    rule: &Rule,
    is_chosen: impl Fn(i32) -> bool + Sync,
    progress: &Progress,
) -> Result<(Scene, SplitCounts)> {
    rule.require_bound()?;
    split_scene(scene, rule, is_chosen, progress)
}

/// Same as `tessellate_scene`, even if the rule's tolerance is not a bound. Meshes that need no split are shared with
/// the source. The rule's centre is relative to the scene's origin.
pub fn split_scene(
    scene: &Scene,
    rule: &Rule,
    is_chosen: impl Fn(i32) -> bool + Sync,
    progress: &Progress,
) -> Result<(Scene, SplitCounts)> {
    let mut counts = SplitCounts { before: scene.triangle_count() as u64, ..SplitCounts::default() };
    let standing = scene.standing.instances();
    let touches = |instance: &Instance| instance.object.is_none_or(&is_chosen) && touches(instance, rule);
    let touched = standing.iter().filter(|instance| touches(instance));
    progress.expect(touched.map(|instance| instance.mesh.faces.len() as u64).sum());
    let budget = Budget::default();
    let mut is_changed = false;
    let mut instances = try_with_capacity(standing.len())?;
    for instance in standing {
        let split = if touches(instance) {
            let corners = |face| {
                is_chosen(instance.object_of(face)).then(|| instance.corners(face).map(|corner| corner.as_dvec3()))
            };
            let (faces, vertices) = (&instance.mesh.faces, instance.mesh.positions.len());
            assemble(faces, vertices, corners, (rule, Precision::Single), (&budget, &mut counts), progress)?
        } else {
            None
        };
        is_changed |= split.is_some();
        instances.push(match split {
            Some(split) => {
                Instance::new(Arc::new(mesh_of(instance, split, progress)?), DAffine3::IDENTITY, instance.object)?
            }
            None => instance.clone(),
        });
    }
    let split = scene.with_sets(is_changed.then(|| InstanceSet::new(instances)), None);
    counts.after = split.triangle_count() as u64;
    Ok((split, counts))
}

/// Returns whether an instance reaches between the radii and has edges that need a split.
pub fn needs_split(instance: &Instance, rule: &Rule) -> bool {
    let longest = || {
        let faces = (0..instance.mesh.faces.len() as u32).into_par_iter();
        let edge = |face| {
            let [a, b, c] = instance.corners(face);
            (b - a).length_squared().max((c - b).length_squared()).max((a - c).length_squared())
        };
        f64::from(faces.map(edge).reduce(|| 0.0, f32::max)).sqrt()
    };
    touches(instance, rule) && longest() > rule.harmless_length()
}

/// Returns false if an instance's box proves that it has no point where edges are split.
fn touches(instance: &Instance, rule: &Rule) -> bool {
    let [low, high] =
        [instance.bounds.min, instance.bounds.max].map(|corner| rule.settings.on_ground(corner.as_dvec3()));
    let (nearest, farthest) = (low.max(-high).max(glam::DVec2::ZERO), low.abs().max(high.abs()));
    !instance.mesh.faces.is_empty() && nearest.length() < rule.outer() && !rule.is_within(farthest.length())
}

/// Builds the placed mesh. Vertices of unsplit faces keep their bits.
fn mesh_of(instance: &Instance, split: Assembled, progress: &Progress) -> Result<Mesh> {
    let mesh = &instance.mesh;
    let place = |p: &[f32; 3]| match instance.in_place {
        true => *p,
        false => instance.to_scene.transform_point3(Vec3::from_array(*p).as_dvec3()).as_vec3().to_array(),
    };
    let new = &split.new;
    let mut positions = try_with_capacity(mesh.positions.len() + new.len())?;
    positions.extend(mesh.positions.iter().map(place));
    positions.extend(new.iter().map(|new| new.point.as_vec3().to_array()));
    let uvs = mesh.uvs.as_deref().map(|uvs| extend(mesh, uvs, new, interpolate_uv)).transpose()?;
    let colors = mesh.colors.as_deref().map(|colors| extend(mesh, colors, new, interpolate_color)).transpose()?;
    let objects = mesh.objects.selected(&split.sources, progress)?;
    let materials = mesh.materials.selected(&split.sources, progress)?;
    let mut normals = instance.vertex_normals(progress)?;
    if let Some(normals) = &mut normals {
        try_extend(normals, new.iter().map(|new| interpolate_normal(instance, new)))?;
    }
    let normals = normals.map(Buffer::from);
    Mesh::new(positions.into(), split.faces.into(), uvs, colors, objects, materials)?.with_normals(normals)
}

/// Interpolates a normal as in shading; zero between corners without normals.
fn interpolate_normal(instance: &Instance, new: &NewVertex) -> [f32; 3] {
    let rows = instance.corner_normals(new.face).unwrap_or_default();
    let is_plain = |(row, weight): (&Vec3, f64)| *row == Vec3::ZERO || weight == 0.0;
    if rows.iter().zip(new.weights).all(is_plain) {
        return [0.0; 3];
    }
    let [a, b, c] = instance.corners(new.face).map(|corner| corner.as_dvec3());
    let plane = (b - a).cross(c - a).normalize_or_zero().as_vec3();
    // The plane's normal is flipped to the side of the corners' normals, so that these are not flipped.
    let side = if rows.iter().sum::<Vec3>().dot(plane) < 0.0 { -plane } else { plane };
    let corners = facing_normals(rows, side).unwrap_or_default();
    let sum: DVec3 = corners.iter().zip(new.weights).map(|(corner, weight)| corner.as_dvec3() * weight).sum();
    sum.normalize_or_zero().as_vec3().to_array()
}

fn extend<T: Copy + Send + Sync + 'static>(
    mesh: &Mesh,
    values: &[T],
    new: &[NewVertex],
    interpolate: impl Fn([T; 3], [f64; 3]) -> T,
) -> Result<Buffer<T>> {
    let value =
        |new: &NewVertex| interpolate(mesh.faces[new.face as usize].map(|vertex| values[vertex as usize]), new.weights);
    let mut all = try_with_capacity(values.len() + new.len())?;
    all.extend_from_slice(values);
    all.extend(new.iter().map(value));
    Ok(all.into())
}

fn interpolate_uv(uvs: [[f32; 2]; 3], weights: [f64; 3]) -> [f32; 2] {
    [0, 1].map(|i| (0..3).map(|k| f64::from(uvs[k][i]) * weights[k]).sum::<f64>() as f32)
}

/// Interpolates a colour in linear light, as in shading; alpha is linear already.
fn interpolate_color(colors: [[u8; 4]; 3], weights: [f64; 3]) -> [u8; 4] {
    let linear = linear_from_srgb();
    let mix = |value: &dyn Fn(usize) -> f64| (0..3).map(|k| value(k) * weights[k]).sum::<f64>();
    let light = |i: usize| srgb_from_linear(mix(&|k| f64::from(linear[usize::from(colors[k][i])])) as f32);
    [light(0), light(1), light(2), mix(&|k| f64::from(colors[k][3])).round() as u8]
}
