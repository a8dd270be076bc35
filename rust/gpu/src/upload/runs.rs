//! Runs: consecutive faces of a mesh as words, with the vertices that they use.

use std::ops::Range;
use std::sync::Arc;

use nearfar_core::base::{Aabb, FaceMap, Progress, Result};
use nearfar_core::scene::Mesh;
use rayon::prelude::*;

/// Number of consecutive faces that are culled together.
pub(crate) const CHUNK: usize = 4096;
/// Offset of a missing attribute.
pub(crate) const NONE: u32 = u32::MAX;

/// Faces of a mesh, and the range of vertices that contains their corners.
pub(super) struct Run<'a> {
    pub mesh: &'a Mesh,
    pub faces: Range<usize>,
    pub vertices: Range<usize>,
}

impl<'a> Run<'a> {
    /// Returns all faces of a mesh.
    pub fn whole(mesh: &'a Mesh) -> Self {
        Self { mesh, faces: 0..mesh.faces.len(), vertices: 0..mesh.positions.len() }
    }

    /// Returns the number of words of all its arrays.
    pub fn words(&self) -> u64 {
        let (vertices, faces) = (self.vertices.len() as u64, self.faces.len() as u64);
        let flags = [self.mesh.uvs.is_some(), self.mesh.colors.is_some(), self.mesh.normals.is_some()];
        let [uvs, colors, normals] = flags.map(u64::from);
        vertices * (3 + 2 * uvs + colors + 3 * normals) + faces * (3 + u64::from(self.uniform_material().is_none()))
    }

    /// Returns the material of all faces, if they share one.
    pub fn uniform_material(&self) -> Option<i32> {
        match self.mesh.materials {
            FaceMap::Uniform(material) => Some(material),
            _ => None,
        }
    }

    /// Returns the first word of each array, relative to the run, and the number of words.
    pub fn layout(&self) -> ([u32; 6], u64) {
        let (vertices, faces) = (self.vertices.len() as u32, self.faces.len() as u32);
        let mut end = 3 * vertices + 3 * faces;
        let mut section = |present: bool, words: u32| {
            let start = if present { end } else { NONE };
            end += if present { words } else { 0 };
            start
        };
        let uvs = section(self.mesh.uvs.is_some(), 2 * vertices);
        let colors = section(self.mesh.colors.is_some(), vertices);
        let normals = section(self.mesh.normals.is_some(), 3 * vertices);
        let materials = section(self.uniform_material().is_none(), faces);
        ([0, 3 * vertices, uvs, colors, materials, normals], self.words())
    }

    /// Appends its arrays.
    pub fn write(&self, words: &mut Vec<u32>) {
        let (mesh, faces, vertices) = (self.mesh, self.faces.clone(), self.vertices.clone());
        words.extend_from_slice(bytemuck::cast_slice(&mesh.positions[vertices.clone()]));
        if vertices.start == 0 {
            words.extend_from_slice(mesh.faces[faces.clone()].as_flattened());
        } else {
            let first = vertices.start as u32;
            words.extend(mesh.faces[faces.clone()].as_flattened().iter().map(|&vertex| vertex - first));
        }
        if let Some(uvs) = &mesh.uvs {
            words.extend_from_slice(bytemuck::cast_slice(&uvs[vertices.clone()]));
        }
        if let Some(colors) = &mesh.colors {
            words.extend(colors[vertices.clone()].iter().map(|&color| u32::from_le_bytes(color)));
        }
        if let Some(normals) = &mesh.normals {
            words.extend_from_slice(bytemuck::cast_slice(&normals[vertices]));
        }
        if self.uniform_material().is_none() {
            words.extend(faces.map(|face| mesh.materials.get(face as u32) as u32));
        }
    }

    /// Returns the boxes of `CHUNK` faces each, in the mesh's frame.
    pub fn chunk_boxes(&self) -> Arc<[Aabb]> {
        let faces = &self.mesh.faces[self.faces.clone()];
        let box_of = |faces: &[[u32; 3]]| {
            let mut bounds = Aabb::EMPTY;
            faces.as_flattened().iter().for_each(|&vertex| bounds.extend(self.mesh.positions[vertex as usize].into()));
            bounds
        };
        faces.par_chunks(CHUNK).map(box_of).collect::<Vec<_>>().into()
    }
}

/// Splits a mesh into runs of faces that each fit into a page together with the range of vertices that they use;
/// `None` if a range is too large.
pub(super) fn split_into_runs(mesh: &Mesh, limit: u64) -> Option<Vec<Run<'_>>> {
    let whole = Run::whole(mesh);
    if mesh.faces.is_empty() {
        return Some(Vec::new());
    }
    if whole.words() <= limit {
        return Some(vec![whole]);
    }
    let min_count = whole.words().div_ceil(limit) as usize;
    [min_count, 2 * min_count, 4 * min_count].into_iter().find_map(|count| {
        let faces_per_run = mesh.faces.len().div_ceil(count);
        let runs = (0..mesh.faces.len()).step_by(faces_per_run).map(|start| {
            let faces = start..(start + faces_per_run).min(mesh.faces.len());
            let used = mesh.faces[faces.clone()].as_flattened();
            let ends = used.par_iter().fold(|| (u32::MAX, 0), |(a, b), &v| (a.min(v), b.max(v)));
            let (first, last) = ends.reduce(|| (u32::MAX, 0), |a, b| (a.0.min(b.0), a.1.max(b.1)));
            let run = Run { mesh, faces, vertices: first as usize..last as usize + 1 };
            (run.words() <= limit).then_some(run)
        });
        runs.collect()
    })
}

/// Splits a mesh that `split_into_runs` cannot split into several meshes with their own vertices; `None` if it can.
pub(super) fn gather_pieces(mesh: &Arc<Mesh>, limit: u64) -> Result<Option<Vec<Arc<Mesh>>>> {
    if split_into_runs(mesh, limit).is_some() {
        return Ok(None);
    }
    // A face has at most three unshared vertices with all attributes: 3 × (3 + 2 + 1 + 3) + 4 words.
    let faces_per_piece = (limit / 31).max(1) as usize;
    let faces: Vec<u32> = (0..mesh.faces.len() as u32).collect();
    let piece = |faces: &[u32]| mesh.selected(faces, &Progress::new()).map(Arc::new);
    faces.chunks(faces_per_piece).map(piece).collect::<Result<_>>().map(Some)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nearfar_core::base::random;

    /// A strip of triangles, each between a vertex and the next two, or, if scattered, between any three. Normals equal
    /// positions.
    fn mesh(faces: u32, scattered: bool) -> Arc<Mesh> {
        let count = faces + 2;
        let positions: Vec<[f32; 3]> = (0..count).map(|i| [i as f32, 0.0, (i % 2) as f32]).collect();
        let vertex = |face: u32, corner: u32| match scattered {
            true => random::bits(1, u64::from(face), u64::from(corner)) as u32 % count,
            false => face + corner,
        };
        let faces: Vec<[u32; 3]> = (0..faces).map(|face| [0, 1, 2].map(|corner| vertex(face, corner))).collect();
        let materials = FaceMap::PerFace((0..faces.len() as i32).collect());
        let normals = Some(positions.clone().into());
        let mesh = Mesh::new(positions.into(), faces.into(), None, None, FaceMap::Uniform(0), materials).unwrap();
        Arc::new(mesh.with_normals(normals).unwrap())
    }

    /// Reads corners and material of a run's faces from its words, as a shader does.
    fn read(run: &Run<'_>) -> Vec<([[f32; 3]; 3], u32)> {
        let mut words = Vec::new();
        run.write(&mut words);
        let (layout, size) = run.layout();
        assert_eq!(words.len() as u64, size);
        let float = |word: u32| f32::from_bits(words[word as usize]);
        let vertex = |v: u32| {
            let [position, normal] = [layout[0], layout[5]].map(|start| [0, 1, 2].map(|i| float(start + 3 * v + i)));
            assert_eq!(position, normal);
            position
        };
        let corner = |face: u32, i: u32| vertex(words[(layout[1] + 3 * face + i) as usize]);
        let face = |f: u32| ([0, 1, 2].map(|i| corner(f, i)), words[(layout[4] + f) as usize]);
        (0..run.faces.len() as u32).map(face).collect()
    }

    #[test]
    fn runs_hold_every_face_once_and_fit() {
        let mesh = mesh(1000, false);
        let all: Vec<_> = (0..1000).map(|face| (mesh.corners(face).map(|p| p.to_array()), face)).collect();
        for limit in [20_000, 3000, 500, 80] {
            let runs = split_into_runs(&mesh, limit).unwrap();
            assert!(runs.iter().all(|run| run.words() <= limit), "{limit}");
            assert_eq!(runs.iter().flat_map(read).collect::<Vec<_>>(), all);
            assert!(gather_pieces(&mesh, limit).unwrap().is_none());
        }
    }

    #[test]
    fn scattered_faces_get_copies_of_their_vertices() {
        let mesh = mesh(1000, true);
        let limit = 2000;
        assert!(split_into_runs(&mesh, limit).is_none());
        let pieces = gather_pieces(&mesh, limit).unwrap().unwrap();
        let read_piece = |piece: &Arc<Mesh>| {
            let run = Run::whole(piece);
            assert!(run.words() <= limit);
            read(&run)
        };
        let all: Vec<_> = (0..1000).map(|face| (mesh.corners(face).map(|p| p.to_array()), face)).collect();
        assert_eq!(pieces.iter().flat_map(read_piece).collect::<Vec<_>>(), all);
    }
}
