//! Fewer triangles by meshoptimizer's edge collapses, which keep vertices as they are.

use meshopt::{SimplifyOptions, SimplifyVertex, VertexDataAdapter, simplify_with_attributes_and_locks};

use super::surface::check_faces;
use crate::base::{Error, Result};

/// Most attributes that meshoptimizer weighs beside places.
const MOST_ATTRIBUTES: usize = 32;

/// Vertices with what is weighed beside their places.
#[derive(Clone, Copy, Debug)]
pub struct Vertices<'a> {
    /// Places; equal ones are one place of the surface.
    pub positions: &'a [[f32; 3]],
    /// As many numbers for each vertex as there are weights.
    pub attributes: &'a [f32],
    /// Error of a difference of 1, as a share of the surface's extent.
    pub weights: &'a [f32],
    /// Vertices at whose place attributes meet that must stay apart.
    pub is_seam: &'a [bool],
}

/// Features that may be given up for fewer triangles. Collapsing edges alone may already remove closed parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Allowance {
    /// Nothing.
    Nothing,
    /// The seams of vertices without a flag.
    Seams,
    /// These, and parts that hang together with nothing else and can't be collapsed, such as those with all corners on
    /// seams: the smallest first.
    Parts,
}

/// Chosen faces that remain of a surface, about `target` of them, and the share of its extent that it may be off by.
pub fn collapse(
    vertices: Vertices<'_>,
    faces: &[[u32; 3]],
    target: usize,
    allowance: Allowance,
) -> Result<(Vec<[u32; 3]>, f32)> {
    let count = vertices.positions.len();
    check_faces(faces, count)?;
    let width = vertices.weights.len();
    if vertices.attributes.len() != count * width || vertices.is_seam.len() != count || width > MOST_ATTRIBUTES {
        return Err(Error::value(
            "attributes",
            format!("{width} for each of {count} vertices"),
            vertices.attributes.len(),
        ));
    }
    if vertices.positions.as_flattened().iter().chain(vertices.attributes).any(|x| !x.is_finite()) {
        return Err(Error::value("vertices", "finite coordinates and attributes", "NaN or infinity"));
    }
    if faces.is_empty() || target >= faces.len() {
        return Ok((faces.to_vec(), 0.0));
    }
    let adapter = VertexDataAdapter::new(bytemuck::cast_slice(vertices.positions), size_of::<[f32; 3]>(), 0)
        .map_err(|error| Error::value("vertices", "positions", error))?;
    let flag = |&seam: &bool| if seam { SimplifyVertex::Protect } else { SimplifyVertex::None };
    let locks: Vec<SimplifyVertex> = vertices.is_seam.iter().map(flag).collect();
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
        let is_seam = vec![false; positions.len()];
        let vertices = Vertices { positions: &positions, attributes: &[], weights: &[], is_seam: &is_seam };
        let (found, error) = collapse(vertices, &faces, 2, Allowance::Nothing).unwrap();
        // Its quadrics are float32: 2⁻¹² of the extent is their root's rounding.
        assert!(found.len() == 2 && error < 1e-3, "{} {error}", found.len());
        let corners = [0, side - 1, side * (side - 1), side * side - 1];
        assert!(corners.iter().all(|corner| found.as_flattened().contains(corner)));
        assert_eq!(collapse(vertices, &faces, faces.len(), Allowance::Nothing).unwrap().0, faces);
        assert!(collapse(Vertices { is_seam: &[], ..vertices }, &faces, 2, Allowance::Nothing).is_err());
    }
}
