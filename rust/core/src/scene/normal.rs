//! Vertex normals of placed meshes.
//!
//! Normals are transformed by the inverse transpose, which differs from the matrix itself for mirrors and non-uniform
//! scales. Placed normals have length 1, so a merged mesh is shaded like its instances.

use glam::{DAffine3, DMat3, Vec3};

use super::instance::Instance;
use crate::base::mapped::write_mapped;
use crate::base::memory::try_vec;
use crate::base::{Progress, Result};

/// Returns the matrix that transforms normals, up to their length: the placement's cofactor matrix, which exists even
/// for singular placements.
pub(super) fn normal_matrix(to_scene: &DAffine3) -> DMat3 {
    let m = to_scene.matrix3;
    let cofactors = DMat3::from_cols(m.y_axis.cross(m.z_axis), m.z_axis.cross(m.x_axis), m.x_axis.cross(m.y_axis));
    if m.determinant() < 0.0 { -cofactors } else { cofactors }
}

/// Returns the unit normal of the placed mesh; zero stays zero.
#[inline]
pub(super) fn place_normal(matrix: &DMat3, normal: [f32; 3]) -> Vec3 {
    (*matrix * Vec3::from_array(normal).as_dvec3()).normalize_or_zero().as_vec3()
}

/// Writes the normals of the placed mesh.
pub(super) fn place_normals(
    to_scene: &DAffine3,
    normals: &[[f32; 3]],
    slots: &mut [[f32; 3]],
    progress: &Progress,
) -> Result<()> {
    if *to_scene == DAffine3::IDENTITY {
        return write_mapped(normals, slots, Clone::clone, progress);
    }
    let matrix = normal_matrix(to_scene);
    write_mapped(normals, slots, |&normal| place_normal(&matrix, normal).to_array(), progress)
}

impl Instance {
    /// Returns the unit normals of a face's placed corners, or zero if missing; `None` if the mesh has no normals.
    #[inline]
    pub fn corner_normals(&self, face: u32) -> Option<[Vec3; 3]> {
        let normals = self.mesh.corner_values(face, &self.mesh.normals)?;
        if self.in_place {
            return Some(normals.map(|normal| Vec3::from_array(normal).normalize_or_zero()));
        }
        let matrix = normal_matrix(&self.to_scene);
        Some(normals.map(|normal| place_normal(&matrix, normal)))
    }

    /// Returns the placed normals of all vertices, bit-identical if the transform is the identity.
    pub fn vertex_normals(&self, progress: &Progress) -> Result<Option<Vec<[f32; 3]>>> {
        let Some(normals) = self.mesh.normals.as_deref() else { return Ok(None) };
        let mut slots = try_vec([0.0; 3], normals.len())?;
        place_normals(&self.to_scene, normals, &mut slots, progress)?;
        Ok(Some(slots))
    }
}

/// Returns the normals of a face's corners for shading, flipped to the side of the face's own `normal`. A corner
/// without a normal gets `normal`. `None` if the corners' normals add up to zero.
///
/// The sum of the corners' normals decides the side for the whole face, because files order the corners of faces
/// inconsistently and poses may be mirrored.
#[inline]
pub fn facing_normals(corners: [Vec3; 3], normal: Vec3) -> Option<[Vec3; 3]> {
    let sum = corners[0] + corners[1] + corners[2];
    if sum == Vec3::ZERO {
        return None;
    }
    let side = if sum.dot(normal) < 0.0 { -1.0 } else { 1.0 };
    Some(corners.map(|corner| if corner == Vec3::ZERO { normal } else { corner * side }))
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::DVec3;

    use super::*;
    use crate::base::{Buffer, FaceMap};
    use crate::scene::{Mesh, PlacedMesh, merge};

    /// A triangle whose vertex normals differ from the plane's normal; the third vertex has none.
    fn leaning() -> Arc<Mesh> {
        let positions: Buffer<[f32; 3]> = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].into();
        let normals = vec![[0.6, 0.0, 0.8], [0.0, -0.6, 0.8], [0.0; 3]];
        let flat = FaceMap::Uniform(0);
        let mesh = Mesh::new(positions, vec![[0, 1, 2]].into(), None, None, flat.clone(), flat).unwrap();
        Arc::new(mesh.with_normals(Some(normals.into())).unwrap())
    }

    fn slanted() -> DAffine3 {
        DAffine3::from_scale(DVec3::new(2.0, 0.5, -3.0)) * DAffine3::from_axis_angle(DVec3::ONE.normalize(), 0.7)
    }

    #[test]
    fn transformed_normals_stay_perpendicular() {
        let instance = Instance::new(leaning(), slanted(), None).unwrap();
        let [a, b, none] = instance.corner_normals(0).unwrap();
        // Two tangents of the plane perpendicular to each normal, transformed like points.
        for (normal, tangents) in [(a, [[0.8, 0.0, -0.6], [0.0, 1.0, 0.0]]), (b, [[1.0, 0.0, 0.0], [0.0, 0.8, 0.6]])] {
            assert!(normal.is_normalized());
            for tangent in tangents {
                let placed = slanted().transform_vector3(DVec3::from_array(tangent)).normalize();
                assert!(placed.dot(normal.as_dvec3()).abs() < 1e-6, "{tangent:?}");
            }
            // Orientation is preserved: a direction in front of the face stays in front of it.
            assert!(slanted().transform_vector3(DVec3::Z).dot(normal.as_dvec3()) > 0.0);
        }
        assert_eq!(none, Vec3::ZERO);
    }

    #[test]
    fn a_merged_mesh_has_the_normals_of_its_instances() {
        let part = |to_scene| PlacedMesh { mesh: leaning(), to_scene, object: None };
        let flat = PlacedMesh {
            mesh: Arc::new(leaning().selected(&[0], &Progress::new()).unwrap().with_normals(None).unwrap()),
            ..part(slanted())
        };
        let merged = merge(&[part(slanted()), flat, part(DAffine3::IDENTITY)], &Progress::new()).unwrap();
        let instance = Instance::new(leaning(), slanted(), None).unwrap();
        let expected = instance.corner_normals(0).unwrap().map(|n| n.to_array());
        let normals = merged.normals.as_deref().unwrap();
        // The mirrored part's faces are turned, its normals are not.
        assert_eq!(normals[..3], expected);
        assert_eq!(normals[3..6], [[0.0; 3]; 3]);
        assert_eq!(&normals[6..], leaning().normals.as_deref().unwrap());
        let lone = merge(&[part(slanted())], &Progress::new()).unwrap();
        assert_eq!(lone.normals.as_deref().unwrap(), expected);
    }

    #[test]
    fn normals_of_flattened_meshes_are_perpendicular_to_the_plane() {
        let flat = DAffine3::from_scale(DVec3::new(1.0, 0.0, 1.0));
        let merged = merge(&[PlacedMesh { mesh: leaning(), to_scene: flat, object: None }], &Progress::new()).unwrap();
        assert_eq!(merged.normals.as_deref().unwrap(), [[0.0; 3], [0.0, -1.0, 0.0], [0.0; 3]]);
    }

    #[test]
    fn corners_take_the_side_of_their_face() {
        let corners = [Vec3::new(0.6, 0.0, 0.8), Vec3::ZERO, Vec3::new(0.0, -0.6, 0.8)];
        let back = facing_normals(corners, Vec3::NEG_Z).unwrap();
        assert_eq!(back, [-corners[0], Vec3::NEG_Z, -corners[2]]);
        assert_eq!(facing_normals(corners, Vec3::Z).unwrap(), [corners[0], Vec3::Z, corners[2]]);
        assert!(facing_normals([Vec3::ZERO; 3], Vec3::Z).is_none());
    }

    #[test]
    fn rows_must_fit_and_be_finite() {
        let mesh = || leaning().selected(&[0], &Progress::new()).unwrap();
        assert!(mesh().with_normals(Some(vec![[0.0, 0.0, 1.0]; 2].into())).is_err());
        assert!(mesh().with_normals(Some(vec![[f32::NAN, 0.0, 1.0]; 3].into())).is_err());
        assert!(mesh().with_normals(None).unwrap().normals.is_none());
    }
}
