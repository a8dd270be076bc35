//! Groups of triangles with equal boxes.
//!
//! The builder's clustering takes quadratic time for thousands of equal boxes. So the builder gets each distinct box
//! once, and the box's leaf holds all triangles with this box, except exact copies.

use rayon::prelude::*;

use crate::base::mapped::write_mapped;
use crate::base::random::bits;
use crate::base::sort::sort_by_key;
use crate::base::{Aabb, FaceMap, Progress, Result};

/// Mesh arrays that decide whether two faces are copies.
#[derive(Clone, Copy)]
pub struct MeshArrays<'a> {
    /// Vertex positions.
    pub positions: &'a [[f32; 3]],
    /// Three vertex numbers per face.
    pub faces: &'a [[u32; 3]],
    /// Texture coordinates per vertex.
    pub uvs: Option<&'a [[f32; 2]]>,
    /// Colours per vertex.
    pub colors: Option<&'a [[u8; 4]]>,
    /// Material per face.
    pub materials: &'a FaceMap,
}

/// Position, texture coordinates and colour of the three corners; material.
type Identity = ([([u32; 3], [u32; 2], [u8; 4]); 3], i32);

impl MeshArrays<'_> {
    fn bounds(&self, face: u32) -> Aabb {
        Aabb::of_points(self.faces[face as usize].map(|v| self.positions[v as usize].into()))
    }

    /// Returns a value that is equal for copies: the corners with their attributes in a canonical order, and the
    /// material. Attributes count because alpha cut-outs may depend on them.
    fn identity(&self, face: u32) -> Identity {
        let mut corners = self.faces[face as usize].map(|v| {
            let v = v as usize;
            // Adding zero turns −0.0 into 0.0, the same position.
            let position = self.positions[v].map(|x| (x + 0.0).to_bits());
            let uv = self.uvs.map_or([0; 2], |uvs| uvs[v].map(f32::to_bits));
            (position, uv, self.colors.map_or([0; 4], |colors| colors[v]))
        });
        corners.sort_unstable();
        (corners, self.materials.get(face))
    }
}

/// Faces in groups with equal boxes.
pub(crate) struct Groups {
    /// One box for each group.
    pub(crate) boxes: Vec<Aabb>,
    /// All faces except copies; the faces of a group are consecutive and ascending.
    faces: Vec<u32>,
    /// Index in `faces` of each group's first face; the last entry is the length of `faces`.
    starts: Vec<u32>,
    /// Omitted copies as (the face in the tree, the copy), ascending.
    pub(crate) copies: Vec<(u32, u32)>,
}

impl Groups {
    /// Groups the faces of a mesh. Groups are numbered in the order of their lowest faces.
    pub(crate) fn new(mesh: MeshArrays<'_>, progress: &Progress) -> Result<Self> {
        let count = mesh.faces.len() as u32;
        // Sort by a hash of the box, then by face, so that equal boxes are consecutive.
        let mut order: Vec<(u32, u32)> = (0..count).into_par_iter().map(|f| (hash(&mesh.bounds(f)), f)).collect();
        progress.check()?;
        sort_by_key(&mut order, |&(hash, _)| hash, progress)?;
        let mut groups: Vec<(u32, u32)> = Vec::new();
        let mut shared: Vec<Vec<u32>> = Vec::new();
        let mut copies: Vec<(u32, u32)> = Vec::new();
        for run in order.chunk_by(|a, b| a.0 == b.0) {
            split_run(mesh, run, &mut groups, &mut shared, &mut copies);
        }
        drop(order);
        sort_by_key(&mut groups, |&(first, _)| first, progress)?;
        let (mut faces, mut starts) = (Vec::with_capacity(count as usize), vec![0]);
        for &(first, list) in &groups {
            match list.checked_sub(1) {
                None => faces.push(first),
                Some(list) => faces.append(&mut shared[list as usize]),
            }
            starts.push(faces.len() as u32);
        }
        let mut boxes = vec![Aabb::EMPTY; groups.len()];
        write_mapped(&groups, &mut boxes, |&(first, _)| mesh.bounds(first), progress)?;
        sort_by_key(&mut copies, |&pair| pair, progress)?;
        Ok(Self { boxes, faces, starts, copies })
    }

    /// Returns the faces of a group.
    pub(crate) fn faces(&self, group: u32) -> &[u32] {
        &self.faces[self.starts[group as usize] as usize..self.starts[group as usize + 1] as usize]
    }
}

/// Splits faces of equal hash into groups of equal boxes. A group is (lowest face, 0) if it has one face, otherwise
/// (lowest face, 1 + index of its faces in `shared`).
fn split_run(
    mesh: MeshArrays<'_>,
    run: &[(u32, u32)],
    groups: &mut Vec<(u32, u32)>,
    shared: &mut Vec<Vec<u32>>,
    copies: &mut Vec<(u32, u32)>,
) {
    if let [(_, face)] = run {
        groups.push((*face, 0));
        return;
    }
    let key = |face: u32| {
        let bounds = mesh.bounds(face);
        [bounds.min, bounds.max].map(|p| p.to_array().map(|x| (x + 0.0).to_bits()))
    };
    let mut members: Vec<_> = run.iter().map(|&(_, face)| (key(face), mesh.identity(face), face)).collect();
    members.sort_unstable();
    for group in members.chunk_by(|a, b| a.0 == b.0) {
        // Only the lowest of several copies is listed: it wins ties, so no ray can report the others.
        let mut list: Vec<u32> = Vec::new();
        for duplicates in group.chunk_by(|a, b| a.1 == b.1) {
            list.push(duplicates[0].2);
            copies.extend(duplicates[1..].iter().map(|copy| (duplicates[0].2, copy.2)));
        }
        list.sort_unstable();
        let first = list[0];
        if list.len() > 1 {
            shared.push(list);
            groups.push((first, shared.len() as u32));
        } else {
            groups.push((first, 0));
        }
    }
}

fn hash(bounds: &Aabb) -> u32 {
    let word = |x: f32, y: f32| u64::from((x + 0.0).to_bits()) << 32 | u64::from((y + 0.0).to_bits());
    let (min, max) = (bounds.min, bounds.max);
    bits(word(min.x, min.y), word(min.z, max.x), word(max.y, max.z)) as u32
}
