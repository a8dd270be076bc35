//! Grouping of faces into primitives. The faces of a primitive have one material and the same vertex attributes.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::surfaces::Surfaces;
use crate::base::mapped::in_ranges;
use crate::base::{Progress, Result};
use crate::scene::{Instance, Mesh};

/// Number of faces per task.
const CHUNK: usize = 1 << 16;

/// Maximum number of faces per primitive. Larger primitives are divided so that several threads share the work,
/// cancelling takes less than a second, and all viewers can draw the meshes.
const MAX_FACES: usize = 1 << 18;

/// Material and attributes of a primitive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Key {
    /// Number of the material, −1 for none.
    pub material: i32,
    /// Whether vertices have texture coordinates.
    pub textured: bool,
    /// Whether vertices have colours.
    pub colored: bool,
    /// Whether vertices have normals.
    pub lit: bool,
}

/// Coordinate frame of the written vertices.
#[derive(Clone, Copy, Debug)]
pub(super) enum Frame<'a> {
    /// Scene coordinates; the instance places the vertices.
    Scene(&'a Instance),
    /// Mesh coordinates. For a mirrored placement faces are written `flipped`, and the placement flips them back.
    Own { flipped: bool },
}

/// Faces of a mesh.
pub(super) struct Part<'a> {
    pub mesh: &'a Mesh,
    pub frame: Frame<'a>,
    /// Numbers of the faces; `None` for all.
    pub faces: Option<&'a [u32]>,
}

/// Faces of a part that belong to one primitive.
pub(super) struct Piece<'a> {
    pub mesh: &'a Mesh,
    pub frame: Frame<'a>,
    pub faces: Vec<u32>,
}

impl Part<'_> {
    pub fn count(&self) -> usize {
        self.faces.map_or(self.mesh.faces.len(), <[u32]>::len)
    }

    /// Returns the number of the face at an index of the list.
    fn face(&self, index: usize) -> u32 {
        self.faces.map_or(index as u32, |faces| faces[index])
    }
}

/// Groups the faces of all parts by primitive, in the order of keys, parts and faces.
pub(super) fn primitives<'a>(
    parts: &[Part<'a>],
    surfaces: &Surfaces,
    progress: &Progress,
) -> Result<Vec<(Key, Vec<Piece<'a>>)>> {
    let by_part: Vec<BTreeMap<Key, Vec<u32>>> =
        parts.par_iter().map(|part| group_by_key(part, surfaces, progress)).collect::<Result<_>>()?;
    let mut by_primitive: BTreeMap<Key, Vec<Piece<'a>>> = BTreeMap::new();
    for (part, by_key) in parts.iter().zip(by_part) {
        for (key, faces) in by_key {
            by_primitive.entry(key).or_default().push(Piece { mesh: part.mesh, frame: part.frame, faces });
        }
    }
    let divided = by_primitive.into_iter().flat_map(|(key, pieces)| divide(pieces).into_iter().map(move |p| (key, p)));
    Ok(divided.collect())
}

/// Groups the faces of a part by primitive.
fn group_by_key(part: &Part<'_>, surfaces: &Surfaces, progress: &Progress) -> Result<BTreeMap<Key, Vec<u32>>> {
    let chunks = in_ranges(part.count(), CHUNK, |indices| {
        progress.check()?;
        let faces = indices.map(|index| part.face(index));
        let mut keyed: Vec<(Key, u32)> = faces.map(|face| (key_of(part.mesh, face, surfaces), face)).collect();
        keyed.sort_by_key(|&(key, _)| key);
        Ok(keyed)
    })?;
    let mut joined: BTreeMap<Key, Vec<u32>> = BTreeMap::new();
    for run in chunks.iter().flat_map(|chunk| chunk.chunk_by(|a, b| a.0 == b.0)) {
        joined.entry(run[0].0).or_default().extend(run.iter().map(|&(_, face)| face));
    }
    Ok(joined)
}

fn key_of(mesh: &Mesh, face: u32, surfaces: &Surfaces) -> Key {
    let material = surfaces.drawn_material(mesh.materials.get(face));
    let has_normal = |normals: &[[f32; 3]]| mesh.faces[face as usize].iter().any(|&v| normals[v as usize] != [0.0; 3]);
    Key {
        material,
        textured: mesh.uvs.is_some() && surfaces.is_textured(material),
        colored: mesh.colors.is_some(),
        lit: mesh.normals.as_deref().is_some_and(has_normal),
    }
}

/// Divides pieces into primitives of at most `MAX_FACES` faces.
fn divide(pieces: Vec<Piece<'_>>) -> Vec<Vec<Piece<'_>>> {
    let (mut primitives, mut primitive, mut capacity) = (Vec::new(), Vec::new(), MAX_FACES);
    for mut piece in pieces {
        while piece.faces.len() > capacity {
            let remaining_faces = piece.faces.split_off(capacity);
            primitive.push(Piece { faces: std::mem::replace(&mut piece.faces, remaining_faces), ..piece });
            primitives.push(std::mem::take(&mut primitive));
            capacity = MAX_FACES;
        }
        capacity -= piece.faces.len();
        primitive.push(piece);
    }
    primitives.push(primitive);
    primitives
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::FaceMap;

    #[test]
    fn large_primitives_are_divided_and_no_face_is_lost() {
        let none = FaceMap::Uniform(-1);
        let mesh = Mesh::new(vec![].into(), vec![].into(), None, None, none.clone(), none).unwrap();
        let piece =
            |count: u32| Piece { mesh: &mesh, frame: Frame::Own { flipped: false }, faces: (0..count).collect() };
        let most = MAX_FACES as u32;
        let counts = |pieces: Vec<Piece<'_>>| -> Vec<Vec<usize>> {
            divide(pieces).iter().map(|pieces| pieces.iter().map(|piece| piece.faces.len()).collect()).collect()
        };
        assert_eq!(counts(vec![piece(3), piece(4)]), [[3, 4]]);
        assert_eq!(counts(vec![piece(3), piece(2 * most)]), [vec![3, MAX_FACES - 3], vec![MAX_FACES], vec![3]]);
        assert_eq!(counts(vec![piece(most)]), [[MAX_FACES]]);
    }
}
