//! Simplification by meshoptimizer's edge collapses. Vertices do not move.

use meshopt::{SimplifyOptions, SimplifyVertex, VertexDataAdapter, simplify_with_attributes_and_locks};

use super::surface::check_faces;
use crate::base::memory::{room_for, try_copy};
use crate::base::{Error, Result, ensure};

/// Memory for simplifying a surface, bytes per face, per vertex and per attribute of a vertex; most of it is
/// meshoptimizer's. Surfaces of 500,000 triangles, with shared vertices or three for each triangle, took 95, 56 and 26;
/// a quarter more is a margin.
const SIMPLIFIER_BYTES: [u64; 3] = [120, 72, 32];

/// Maximum number of attributes that meshoptimizer takes into account.
const MAX_ATTRIBUTES: usize = 32;

/// Vertices with attributes that the simplification takes into account.
#[derive(Clone, Copy, Debug)]
pub struct Vertices<'a> {
    /// Positions; vertices with equal positions are one point of the surface.
    pub positions: &'a [[f32; 3]],
    /// Attributes of each vertex, as many as there are weights.
    pub attributes: &'a [f32],
    /// Error of an attribute difference of 1, relative to the surface's extent.
    pub weights: &'a [f32],
    /// Whether the vertex lies on a seam that must be kept: vertices with other attributes share its position.
    pub is_protected: &'a [bool],
}

/// Features that may be removed for fewer triangles. Edge collapses may remove closed parts in any case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Allowance {
    /// No features.
    Nothing,
    /// Attribute seams, except at protected vertices.
    Seams,
    /// Seams, and disconnected parts that cannot be collapsed, such as those with all corners on seams, smallest first.
    Parts,
}

/// Returns about `target` remaining faces of a surface, and the error relative to the surface's extent.
pub fn collapse(
    vertices: Vertices<'_>,
    faces: &[[u32; 3]],
    target: usize,
    allowance: Allowance,
) -> Result<(Vec<[u32; 3]>, f32)> {
    let count = vertices.positions.len();
    check_faces(faces, count)?;
    let width = vertices.weights.len();
    let is_complete = [vertices.attributes.len(), vertices.is_protected.len()] == [count * width, count];
    let is_complete = is_complete && width <= MAX_ATTRIBUTES;
    ensure!(is_complete, "attributes", format!("{width} for each of {count} vertices"), vertices.attributes.len());
    let is_finite = vertices.positions.as_flattened().iter().chain(vertices.attributes).all(|x| x.is_finite());
    ensure!(is_finite, "vertices", "finite coordinates and attributes", "NaN or infinity");
    if let Some(wrong) = vertices.weights.iter().find(|weight| !(0.0..f32::INFINITY).contains(*weight)) {
        return Err(Error::value("weights", "finite numbers of at least 0", wrong));
    }
    if faces.is_empty() || target >= faces.len() {
        return Ok((try_copy(faces)?, 0.0));
    }
    let [of_face, of_vertex, of_attribute] = SIMPLIFIER_BYTES;
    room_for(of_face * faces.len() as u64 + (of_vertex + of_attribute * width as u64) * count as u64)?;
    let adapter = VertexDataAdapter::new(bytemuck::cast_slice(vertices.positions), size_of::<[f32; 3]>(), 0)
        .map_err(|error| Error::value("vertices", "positions", error))?;
    let flag = |&is_protected: &bool| if is_protected { SimplifyVertex::Protect } else { SimplifyVertex::None };
    let locks: Vec<SimplifyVertex> = vertices.is_protected.iter().map(flag).collect();
    let options = match allowance {
        Allowance::Nothing => SimplifyOptions::None,
        Allowance::Seams => SimplifyOptions::Permissive,
        Allowance::Parts => SimplifyOptions::Permissive | SimplifyOptions::Prune,
    };
    let mut error = 0.0;
    let indices = simplify_with_attributes_and_locks(
        faces.as_flattened(),
        &adapter,
        vertices.attributes,
        vertices.weights,
        size_of_val(vertices.weights),
        &locks,
        3 * target,
        f32::MAX,
        options,
        Some(&mut error),
    );
    Ok((indices.as_chunks().0.to_vec(), error))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invalid_weights_are_refused() {
        let positions = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        for weight in [-1.0, f32::NAN, f32::INFINITY] {
            let vertices = Vertices {
                positions: &positions,
                attributes: &[0.0; 3],
                weights: &[weight],
                is_protected: &[false; 3],
            };
            let error = collapse(vertices, &[[0, 1, 2]; 2], 1, Allowance::Nothing).unwrap_err();
            assert!(error.to_string().starts_with("weights: expected finite numbers of at least 0"), "{error}");
        }
    }

    #[test]
    fn a_plane_becomes_few_triangles_and_keeps_its_outline() {
        let side = 33u32;
        let positions: Vec<[f32; 3]> = (0..side * side).map(|i| [(i % side) as f32, 0.0, (i / side) as f32]).collect();
        let mut faces = vec![];
        for z in 0..side - 1 {
            for x in 0..side - 1 {
                let a = z * side + x;
                faces.extend([[a, a + side, a + 1], [a + 1, a + side, a + side + 1]]);
            }
        }
        let is_protected = vec![false; positions.len()];
        let vertices = Vertices { positions: &positions, attributes: &[], weights: &[], is_protected: &is_protected };
        let (found, error) = collapse(vertices, &faces, 2, Allowance::Nothing).unwrap();
        // meshoptimizer's quadrics are float32: the rounding of their root is 2⁻¹² of the extent.
        assert!(found.len() == 2 && error < 1e-3, "{} {error}", found.len());
        let corners = [0, side - 1, side * (side - 1), side * side - 1];
        assert!(corners.iter().all(|corner| found.as_flattened().contains(corner)));
        assert_eq!(collapse(vertices, &faces, faces.len(), Allowance::Nothing).unwrap().0, faces);
        assert!(collapse(Vertices { is_protected: &[], ..vertices }, &faces, 2, Allowance::Nothing).is_err());
    }
}
