//! Splitting of meshes given as plain arrays.

use glam::DVec3;

use super::assemble::{Budget, assemble};
use super::counts::SplitCounts;
use super::rule::Rule;
use super::settings::Precision;
use crate::base::{Progress, Result};

/// A split mesh: the source's vertices, followed by new ones.
#[derive(Debug, Default)]
pub struct Arrays {
    /// New vertices.
    pub points: Vec<[f64; 3]>,
    /// Face of the source on which each new vertex lies.
    pub point_faces: Vec<u32>,
    /// Weights of that face's corners.
    pub weights: Vec<[f64; 3]>,
    /// Three vertex numbers per face.
    pub faces: Vec<[u32; 3]>,
    /// Source face that contains each face.
    pub sources: Vec<u32>,
    /// Numbers of triangles before and after splitting.
    pub counts: SplitCounts,
}

/// Splits the faces of a mesh. Vertex numbers must be below the number of vertices.
pub fn tessellate_arrays(
    vertices: &[[f64; 3]],
    faces: &[[u32; 3]],
    rule: &Rule,
    progress: &Progress,
) -> Result<Arrays> {
    rule.demand()?;
    let mut counts = SplitCounts { before: faces.len() as u64, ..SplitCounts::default() };
    let corners = |face: u32| Some(faces[face as usize].map(|vertex| DVec3::from_array(vertices[vertex as usize])));
    progress.expect(faces.len() as u64);
    let how = (rule, Precision::Double);
    let made = assemble(faces, vertices.len(), corners, how, (&Budget::default(), &mut counts), progress)?;
    let Some(made) = made else {
        counts.after = counts.before;
        let sources = (0..faces.len() as u32).collect();
        return Ok(Arrays { faces: faces.to_vec(), sources, counts, ..Arrays::default() });
    };
    counts.after = made.faces.len() as u64;
    Ok(Arrays {
        points: made.new.iter().map(|new| new.point.to_array()).collect(),
        point_faces: made.new.iter().map(|new| new.face).collect(),
        weights: made.new.iter().map(|new| new.weights).collect(),
        faces: made.faces,
        sources: made.sources,
        counts,
    })
}
