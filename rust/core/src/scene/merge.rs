//! Merging of meshes that are used once: one tree is faster than thousands of trees of small meshes.

use std::sync::Arc;

use glam::{DAffine3, Vec3};
use rayon::prelude::*;

use super::instance::Instance;
use super::mesh::{Mesh, flipped};
use super::normal::place_normals;
use crate::base::mapped::{pieces, starts, write_mapped};
use crate::base::memory::try_vec;
use crate::base::{Buffer, FaceMap, Progress, Result, ensure};

/// A mesh to be merged.
#[derive(Clone, Debug)]
pub struct PlacedMesh {
    /// The mesh in its own frame.
    pub mesh: Arc<Mesh>,
    /// Transform object→scene; it may be singular.
    pub to_scene: DAffine3,
    /// Object of all faces; `None` if the mesh's face map names the objects.
    pub object: Option<i32>,
}

impl PlacedMesh {
    /// Returns an instance's mesh with its placement.
    pub fn from_instance(instance: &Instance) -> Self {
        Self { mesh: Arc::clone(&instance.mesh), to_scene: instance.to_scene, object: instance.object }
    }
}

/// Returns whether a transform is a mirror. The corners of placed faces are then reordered, because a mirror turns
/// faces inside out.
pub(crate) fn is_mirror(to_scene: &DAffine3) -> bool {
    to_scene.matrix3.determinant() < 0.0
}

/// Merges placed meshes into one mesh. A single part keeps the arrays that its placement does not change.
pub fn merge(parts: &[PlacedMesh], progress: &Progress) -> Result<Mesh> {
    ensure!(parts.iter().all(|part| part.to_scene.is_finite()), "transform", "finite numbers", "NaN or infinity");
    let face_counts: Vec<usize> = parts.iter().map(|part| part.mesh.faces.len()).collect();
    let (uvs, colors) = match parts {
        [only] => (only.mesh.uvs.clone(), only.mesh.colors.clone()),
        _ => (
            collect_attribute(
                parts,
                |mesh| &mesh.uvs,
                [0.0; 2],
                |_, uvs, slots| write_mapped(uvs, slots, Clone::clone, progress),
            )?,
            collect_attribute(
                parts,
                |mesh| &mesh.colors,
                [255; 4],
                |_, colors, slots| write_mapped(colors, slots, Clone::clone, progress),
            )?,
        ),
    };
    let faces = match parts {
        [only] if !is_mirror(&only.to_scene) => only.mesh.faces.clone(),
        _ => joined_faces(parts, &face_counts, progress)?,
    };
    let (positions, normals) = match parts {
        [only] if only.to_scene == DAffine3::IDENTITY => (only.mesh.positions.clone(), only.mesh.normals.clone()),
        _ => {
            let place = |part: &PlacedMesh, normals: &[[f32; 3]], slots: &mut [[f32; 3]]| {
                place_normals(&part.to_scene, normals, slots, progress)
            };
            (placed_positions(parts, progress)?, collect_attribute(parts, |mesh| &mesh.normals, [0.0; 3], place)?)
        }
    };
    let uniform: Vec<_> = parts.iter().map(|part| part.object.map(FaceMap::Uniform)).collect();
    let objects = parts.iter().zip(&uniform).map(|(part, map)| map.as_ref().unwrap_or(&part.mesh.objects));
    let objects = FaceMap::concat(objects.zip(face_counts.iter().copied()))?;
    progress.check()?;
    let materials = FaceMap::concat(parts.iter().map(|part| &part.mesh.materials).zip(face_counts.iter().copied()))?;
    progress.check()?;
    Mesh::new(positions, faces, uvs, colors, objects, materials)?.with_normals(normals)
}

fn placed_positions(parts: &[PlacedMesh], progress: &Progress) -> Result<Buffer<[f32; 3]>> {
    collect_by_vertex(parts, [0.0; 3], |part, slots| {
        if part.to_scene == DAffine3::IDENTITY {
            return write_mapped(&part.mesh.positions, slots, Clone::clone, progress);
        }
        let place = |p: &[f32; 3]| part.to_scene.transform_point3(Vec3::from_array(*p).as_dvec3()).as_vec3().to_array();
        write_mapped(&part.mesh.positions, slots, place, progress)
    })
}

fn joined_faces(parts: &[PlacedMesh], counts: &[usize], progress: &Progress) -> Result<Buffer<[u32; 3]>> {
    let vertex_count: usize = parts.iter().map(|part| part.mesh.positions.len()).sum();
    ensure!(vertex_count <= u32::MAX as usize, "meshes", "fewer than 2^32 vertices in one merged mesh", vertex_count);
    let mut faces = try_vec([0; 3], counts.iter().sum())?;
    let firsts: Vec<usize> = starts(parts.iter().map(|part| part.mesh.positions.len())).collect();
    let slots = pieces(&mut faces, counts.iter().copied());
    parts.par_iter().zip(firsts).zip(slots).try_for_each(|((part, first), slots)| {
        let is_mirrored = is_mirror(&part.to_scene);
        let face =
            |face: &[u32; 3]| if is_mirrored { flipped(face) } else { *face }.map(|vertex| vertex + first as u32);
        write_mapped(&part.mesh.faces, slots, face, progress)
    })?;
    Ok(faces.into())
}

/// Collects a value for each vertex; `write` gets a part and the slots of its vertices.
fn collect_by_vertex<T: Copy + Send + Sync + 'static>(
    parts: &[PlacedMesh],
    neutral: T,
    write: impl Fn(&PlacedMesh, &mut [T]) -> Result<()> + Sync,
) -> Result<Buffer<T>> {
    let lengths = || parts.iter().map(|part| part.mesh.positions.len());
    let mut values = try_vec(neutral, lengths().sum())?;
    parts.par_iter().zip(pieces(&mut values, lengths())).try_for_each(|(part, slots)| write(part, slots))?;
    Ok(values.into())
}

/// Collects an attribute of all vertices, neutral for parts without it; `None` if no part has it.
fn collect_attribute<T: Copy + Send + Sync + 'static>(
    parts: &[PlacedMesh],
    attribute: impl Fn(&Mesh) -> &Option<Buffer<T>> + Sync,
    neutral: T,
    write: impl Fn(&PlacedMesh, &[T], &mut [T]) -> Result<()> + Sync,
) -> Result<Option<Buffer<T>>> {
    let write = |part: &PlacedMesh, slots: &mut [T]| match attribute(&part.mesh) {
        Some(values) => write(part, values, slots),
        None => Ok(()),
    };
    let is_any = parts.iter().any(|part| attribute(&part.mesh).is_some());
    is_any.then(|| collect_by_vertex(parts, neutral, write)).transpose()
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    fn triangle(objects: FaceMap, colored: bool) -> Arc<Mesh> {
        let positions = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let colors = colored.then(|| vec![[1, 2, 3, 4]; 3].into());
        let materials = FaceMap::Uniform(0);
        Arc::new(Mesh::new(positions.into(), vec![[0, 1, 2]].into(), None, colors, objects, materials).unwrap())
    }

    fn normal(mesh: &Mesh, face: u32) -> Vec3 {
        let [a, b, c] = mesh.corners(face);
        (b - a).cross(c - a).normalize()
    }

    #[test]
    fn parts_are_transformed_and_keep_objects_and_colors() {
        let part = |mesh, to_scene, object| PlacedMesh { mesh, to_scene, object };
        let merged = merge(
            &[
                part(triangle(FaceMap::Uniform(5), false), DAffine3::IDENTITY, None),
                part(triangle(FaceMap::Uniform(5), true), DAffine3::from_translation(DVec3::X), Some(7)),
            ],
            &Progress::new(),
        )
        .unwrap();
        assert_eq!(merged.corners(1), merged.corners(0).map(|p| p + Vec3::X));
        assert_eq!((merged.objects.get(0), merged.objects.get(1)), (5, 7));
        let colors = merged.colors.as_deref().unwrap();
        assert_eq!((colors[0], colors[3]), ([255; 4], [1, 2, 3, 4]));
        assert!(merged.uvs.is_none());
    }

    #[test]
    fn mirrored_parts_keep_their_orientation() {
        let mirror = DAffine3::from_scale(DVec3::new(1.0, 1.0, -1.0));
        for count in [1, 2] {
            let part = PlacedMesh { mesh: triangle(FaceMap::Uniform(0), false), to_scene: mirror, object: None };
            let merged = merge(&vec![part; count], &Progress::new()).unwrap();
            // The triangle's front faces +z, the front of its mirror image −z.
            assert_eq!(normal(&merged, 0), -Vec3::Z);
        }
    }

    #[test]
    fn a_lone_part_in_place_shares_its_arrays() {
        let mesh = triangle(FaceMap::Uniform(3), true);
        let part = PlacedMesh { mesh: Arc::clone(&mesh), to_scene: DAffine3::IDENTITY, object: None };
        let merged = merge(&[part], &Progress::new()).unwrap();
        assert_eq!(merged.positions.as_ptr(), mesh.positions.as_ptr());
        assert_eq!(merged.faces.as_ptr(), mesh.faces.as_ptr());
    }

    #[test]
    fn nothing_merges_to_nothing() {
        assert_eq!(merge(&[], &Progress::new()).unwrap().faces.len(), 0);
    }
}
