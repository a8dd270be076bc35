//! Merging of meshes that are used once: one tree is faster than a tree for each of thousands of small meshes.

use std::sync::Arc;

use glam::{DAffine3, Vec3};
use rayon::prelude::*;

use super::instance::Instance;
use super::mesh::{Mesh, flipped};
use super::normal::place_normals;
use crate::base::mapped::{mapped, pieces, starts, write_mapped};
use crate::base::{FaceMap, Progress, Result, ensure};

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
pub(super) fn is_mirror(to_scene: &DAffine3) -> bool {
    to_scene.matrix3.determinant() < 0.0
}

/// Merges placed meshes into one mesh. A single part keeps the arrays that its placement does not change.
pub fn merge(parts: &[PlacedMesh], progress: &Progress) -> Result<Mesh> {
    ensure!(parts.iter().all(|part| part.to_scene.is_finite()), "transform", "finite numbers", "NaN or infinity");
    let face_counts: Vec<usize> = parts.iter().map(|part| part.mesh.faces.len()).collect();
    let (uvs, colors, faces) = match parts {
        [only] => (
            only.mesh.uvs.clone(),
            only.mesh.colors.clone(),
            if is_mirror(&only.to_scene) {
                mapped(&only.mesh.faces, flipped, progress)?.into()
            } else {
                only.mesh.faces.clone()
            },
        ),
        _ => (
            concat_attribute(parts, |mesh| mesh.uvs.as_deref(), [0.0; 2], progress)?.map(Into::into),
            concat_attribute(parts, |mesh| mesh.colors.as_deref(), [255; 4], progress)?.map(Into::into),
            joined_faces(parts, &face_counts, progress)?.into(),
        ),
    };
    let positions = match parts {
        [only] if only.to_scene == DAffine3::IDENTITY => only.mesh.positions.clone(),
        _ => placed_positions(parts, progress)?.into(),
    };
    let uniform: Vec<_> = parts.iter().map(|part| part.object.map(FaceMap::Uniform)).collect();
    let objects = parts.iter().zip(&uniform).map(|(part, map)| map.as_ref().unwrap_or(&part.mesh.objects));
    let objects = FaceMap::concat(objects.zip(face_counts.iter().copied()));
    progress.check()?;
    let materials = FaceMap::concat(parts.iter().map(|part| &part.mesh.materials).zip(face_counts.iter().copied()));
    let normals = match parts {
        [only] if only.to_scene == DAffine3::IDENTITY => only.mesh.normals.clone(),
        _ => placed_normals(parts, progress)?.map(Into::into),
    };
    progress.check()?;
    Mesh::new(positions, faces, uvs, colors, objects, materials)?.with_normals(normals)
}

fn placed_positions(parts: &[PlacedMesh], progress: &Progress) -> Result<Vec<[f32; 3]>> {
    let lengths = || parts.iter().map(|part| part.mesh.positions.len());
    let mut positions = vec![[0.0; 3]; lengths().sum()];
    parts.par_iter().zip(pieces(&mut positions, lengths())).try_for_each(|(part, slots)| {
        if part.to_scene == DAffine3::IDENTITY {
            return write_mapped(&part.mesh.positions, slots, |&position| position, progress);
        }
        let place = |p: &[f32; 3]| part.to_scene.transform_point3(Vec3::from_array(*p).as_dvec3()).as_vec3().to_array();
        write_mapped(&part.mesh.positions, slots, place, progress)
    })?;
    Ok(positions)
}

/// Returns the normals of all parts, zero for parts without normals; `None` if no part has normals.
fn placed_normals(parts: &[PlacedMesh], progress: &Progress) -> Result<Option<Vec<[f32; 3]>>> {
    if parts.iter().all(|part| part.mesh.normals.is_none()) {
        return Ok(None);
    }
    let lengths = || parts.iter().map(|part| part.mesh.positions.len());
    let mut normals = vec![[0.0; 3]; lengths().sum()];
    parts.par_iter().zip(pieces(&mut normals, lengths())).try_for_each(|(part, slots)| match &part.mesh.normals {
        Some(normals) => place_normals(&part.to_scene, normals, slots, progress),
        None => Ok(()),
    })?;
    Ok(Some(normals))
}

fn joined_faces(parts: &[PlacedMesh], counts: &[usize], progress: &Progress) -> Result<Vec<[u32; 3]>> {
    let vertex_count: usize = parts.iter().map(|part| part.mesh.positions.len()).sum();
    ensure!(vertex_count <= u32::MAX as usize, "meshes", "fewer than 2^32 vertices in one merged mesh", vertex_count);
    let mut faces = vec![[0; 3]; counts.iter().sum()];
    let firsts: Vec<usize> = starts(parts.iter().map(|part| part.mesh.positions.len())).collect();
    let slots = pieces(&mut faces, counts.iter().copied());
    parts.par_iter().zip(firsts).zip(slots).try_for_each(|((part, first), slots)| {
        let is_mirrored = is_mirror(&part.to_scene);
        let face =
            |face: &[u32; 3]| if is_mirrored { flipped(face) } else { *face }.map(|vertex| vertex + first as u32);
        write_mapped(&part.mesh.faces, slots, face, progress)
    })?;
    Ok(faces)
}

/// Concatenates an attribute of all parts, with a neutral value for parts without it; `None` if no part has it.
fn concat_attribute<T: Copy + Send + Sync>(
    parts: &[PlacedMesh],
    attribute: impl Fn(&Mesh) -> Option<&[T]>,
    neutral: T,
    progress: &Progress,
) -> Result<Option<Vec<T>>> {
    if parts.iter().all(|part| attribute(&part.mesh).is_none()) {
        return Ok(None);
    }
    let mut all = Vec::with_capacity(parts.iter().map(|part| part.mesh.positions.len()).sum());
    for part in parts {
        match attribute(&part.mesh) {
            Some(values) => all.extend_from_slice(values),
            None => all.resize(all.len() + part.mesh.positions.len(), neutral),
        }
        progress.check()?;
    }
    Ok(Some(all))
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
