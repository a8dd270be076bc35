//! Triangles that the builder cannot tell apart.
//!
//! Clustering pairs of boxes takes quadratic time when thousands of boxes are the same. So each distinct box is
//! built once, and its leaf holds all triangles that have it, without the exact copies among them.

use rayon::prelude::*;

use crate::base::random::bits;
use crate::base::{Aabb, FaceMap, Progress, Result};
/// Groups of one task.
const TILE: usize = 1 << 16;

/// The arrays of a mesh that tell two faces apart.
#[derive(Clone, Copy)]
pub struct MeshArrays<'a> {
    /// Vertices.
    pub positions: &'a [[f32; 3]],
    /// Corners.
    pub faces: &'a [[u32; 3]],
    /// Texture coordinates of the vertices.
    pub uvs: Option<&'a [[f32; 2]]>,
    /// Colours of the vertices.
    pub colors: Option<&'a [[u8; 4]]>,
    /// Materials of the faces.
    pub materials: &'a FaceMap,
}

/// Place, texture coordinates and colour of three corners; material.
type Identity = ([([u32; 3], [u32; 2], [u8; 4]); 3], i32);

impl MeshArrays<'_> {
    fn bounds(&self, face: u32) -> Aabb {
        let mut bounds = Aabb::EMPTY;
        self.faces[face as usize].iter().for_each(|&v| bounds.extend(self.positions[v as usize].into()));
        bounds
    }

    /// All that a cut-out could depend on: the corners with their attributes in a canonical order, and the material.
    fn identity(&self, face: u32) -> Identity {
        let mut corners = self.faces[face as usize].map(|v| {
            let v = v as usize;
            // Adding zero makes −0.0 the same place as 0.0.
            let place = self.positions[v].map(|x| (x + 0.0).to_bits());
            let uv = self.uvs.map_or([0; 2], |uvs| uvs[v].map(f32::to_bits));
            (place, uv, self.colors.map_or([0; 4], |colors| colors[v]))
        });
        corners.sort_unstable();
        (corners, self.materials.get(face))
    }
}

/// Faces in groups of equal boxes.
pub(crate) struct Groups {
    /// One box for each group.
    pub(crate) boxes: Vec<Aabb>,
    /// All faces without copies; those of a group side by side, ascending.
    faces: Vec<u32>,
    /// Where each group starts, and their end.
    starts: Vec<u32>,
}

impl Groups {
    /// Groups the faces of a mesh; the numbers of groups follow their least faces.
    pub(crate) fn new(mesh: MeshArrays<'_>, progress: &Progress) -> Result<Self> {
        let count = mesh.faces.len() as u32;
        // Sorted by a hash of the box, then by face: equal boxes come together.
        let mut order: Vec<(u32, u32)> = (0..count).into_par_iter().map(|f| (hash(&mesh.bounds(f)), f)).collect();
        progress.check()?;
        order.par_sort_unstable();
        progress.check()?;
        let mut groups: Vec<(u32, u32)> = Vec::new();
        let mut shared: Vec<Vec<u32>> = Vec::new();
        for run in order.chunk_by(|a, b| a.0 == b.0) {
            split_run(mesh, run, &mut groups, &mut shared);
        }
        drop(order);
        groups.par_sort_unstable();
        progress.check()?;
        let (mut faces, mut starts) = (Vec::with_capacity(count as usize), vec![0]);
        for &(first, list) in &groups {
            match list.checked_sub(1) {
                None => faces.push(first),
                Some(list) => faces.append(&mut shared[list as usize]),
            }
            starts.push(faces.len() as u32);
        }
        let mut boxes = vec![Aabb::EMPTY; groups.len()];
        boxes.par_chunks_mut(TILE).zip(groups.par_chunks(TILE)).for_each(|(boxes, groups)| {
            boxes.iter_mut().zip(groups).for_each(|(slot, &(first, _))| *slot = mesh.bounds(first));
        });
        Ok(Self { boxes, faces, starts })
    }

    /// Faces of a group.
    pub(crate) fn faces(&self, group: u32) -> &[u32] {
        &self.faces[self.starts[group as usize] as usize..self.starts[group as usize + 1] as usize]
    }
}

/// Splits faces of equal hash into groups of equal boxes: (least face, list + 1 or 0 for a single face).
fn split_run(mesh: MeshArrays<'_>, run: &[(u32, u32)], groups: &mut Vec<(u32, u32)>, shared: &mut Vec<Vec<u32>>) {
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
        // The first of several copies has the lowest face: it wins ties, so the others could never be seen.
        let mut list: Vec<u32> = group.chunk_by(|a, b| a.1 == b.1).map(|copies| copies[0].2).collect();
        list.sort_unstable();
        if list.len() == 1 {
            groups.push((list[0], 0));
        } else {
            shared.push(list);
            groups.push((shared[shared.len() - 1][0], shared.len() as u32));
        }
    }
}

fn hash(bounds: &Aabb) -> u32 {
    let word = |x: f32, y: f32| u64::from((x + 0.0).to_bits()) << 32 | u64::from((y + 0.0).to_bits());
    let (min, max) = (bounds.min, bounds.max);
    bits(word(min.x, min.y), word(min.z, max.x), word(max.y, max.z)) as u32
}
