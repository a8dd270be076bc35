//! Triangle meshes and their attributes.

use std::sync::OnceLock;

use glam::Vec3;
use rayon::prelude::*;

use crate::base::mapped::mapped;
use crate::base::memory::try_collect;
use crate::base::{Aabb, Buffer, Error, FaceMap, MAX_COORDINATE, Progress, Result, ensure};
use crate::bvh::{Bvh, MeshArrays};

/// Number of faces or vertices per task: fixed, so that reductions do not depend on the number of threads.
pub(super) const CHUNK: usize = 1 << 16;

/// Number of faces that fit in the first-level cache.
const CACHED_FACES: usize = 1 << 11;

/// An immutable triangle mesh in its own frame.
#[derive(Debug)]
pub struct Mesh {
    /// Vertex positions, metres.
    pub positions: Buffer<[f32; 3]>,
    /// Three vertex numbers per triangle, counter-clockwise from outside.
    pub faces: Buffer<[u32; 3]>,
    /// Texture coordinates per vertex, v upwards.
    pub uvs: Option<Buffer<[f32; 2]>>,
    /// Colour per vertex, sRGB with linear alpha.
    pub colors: Option<Buffer<[u8; 4]>>,
    /// Outward unit normal per vertex; zero for a vertex without one. See `Self::with_normals`.
    pub normals: Option<Buffer<[f32; 3]>>,
    /// Object per face; an instance may override it.
    pub objects: FaceMap,
    /// Material per face.
    pub materials: FaceMap,
    bounds: Aabb,
    bvh: OnceLock<Bvh>,
}

impl Mesh {
    /// Takes the arrays without copies and checks that their sizes and indices are consistent.
    pub fn new(
        positions: Buffer<[f32; 3]>,
        faces: Buffer<[u32; 3]>,
        uvs: Option<Buffer<[f32; 2]>>,
        colors: Option<Buffer<[u8; 4]>>,
        objects: FaceMap,
        materials: FaceMap,
    ) -> Result<Self> {
        let vertex_count = positions.len();
        let is_countable = faces.len() < u32::MAX as usize && vertex_count <= u32::MAX as usize;
        ensure!(is_countable, "faces", "fewer than 2^32 - 1 faces and vertices in one mesh", faces.len());
        check_rows("uvs", uvs.as_deref(), vertex_count)?;
        check_rows("colors", colors.as_deref(), vertex_count)?;
        let greatest = faces.par_chunks(CHUNK).map(|chunk| chunk.as_flattened().iter().copied().max()).max().flatten();
        if let Some(index) = greatest.filter(|&index| index as usize >= vertex_count) {
            return Err(Error::value("faces", format!("vertex indices below {vertex_count}"), index));
        }
        objects.validate("objects", faces.len(), i32::MAX)?;
        materials.validate("materials", faces.len(), i32::MAX)?;
        check_finite("vertices", &positions)?;
        Self::unchecked(positions, faces, uvs, colors, objects, materials).checked_reach()
    }

    /// Returns the mesh if its coordinates are within `MAX_COORDINATE`.
    pub(super) fn checked_reach(self) -> Result<Self> {
        let reach = self.bounds.max_coordinate();
        ensure!(
            reach <= MAX_COORDINATE as f32,
            "vertices",
            format!("coordinates within ±{MAX_COORDINATE:e} m"),
            format!("{reach:e} m")
        );
        Ok(self)
    }

    /// Creates a mesh without normals from arrays known to be consistent.
    pub(super) fn unchecked(
        positions: Buffer<[f32; 3]>,
        faces: Buffer<[u32; 3]>,
        uvs: Option<Buffer<[f32; 2]>>,
        colors: Option<Buffer<[u8; 4]>>,
        objects: FaceMap,
        materials: FaceMap,
    ) -> Self {
        let bounds = bounds_of(&positions, &faces);
        Self { positions, faces, uvs, colors, normals: None, objects, materials, bounds, bvh: OnceLock::new() }
    }

    /// Returns the mesh with other vertex normals for shading; `None` shades faces flat.
    pub fn with_normals(self, normals: Option<Buffer<[f32; 3]>>) -> Result<Self> {
        check_rows("normals", normals.as_deref(), self.positions.len())?;
        check_finite("normals", normals.as_deref().unwrap_or_default())?;
        Ok(self.shaded_by(normals))
    }

    /// Returns the mesh with vertex normals known to be valid.
    pub(super) fn shaded_by(self, normals: Option<Buffer<[f32; 3]>>) -> Self {
        Self { normals, ..self }
    }

    /// Returns a mesh of the vertices `used` of this mesh, each of which has a face, and faces that number them from 0.
    pub(super) fn with_vertices(
        &self,
        used: &[u32],
        faces: Vec<[u32; 3]>,
        objects: FaceMap,
        materials: FaceMap,
        progress: &Progress,
    ) -> Result<Self> {
        fn attribute<T: Copy + Send + Sync + 'static>(
            values: &Option<Buffer<T>>,
            used: &[u32],
            progress: &Progress,
        ) -> Result<Option<Buffer<T>>> {
            values.as_ref().map(|values| Ok(gather(values, used, progress)?.into())).transpose()
        }
        let positions = gather(&self.positions, used, progress)?;
        Ok(Self {
            bounds: box_of(&positions, |bounds, &point| bounds.extend(point.into())),
            positions: positions.into(),
            faces: faces.into(),
            uvs: attribute(&self.uvs, used, progress)?,
            colors: attribute(&self.colors, used, progress)?,
            normals: attribute(&self.normals, used, progress)?,
            objects,
            materials,
            bvh: OnceLock::new(),
        })
    }

    /// Returns the mesh with its faces turned inside out, for mirrored instances. It shares the vertex arrays. Normals
    /// do not change, because a mirror maps outward normals to outward normals.
    pub fn flipped(&self) -> Result<Self> {
        let faces = try_collect(self.faces.par_iter().map(flipped))?;
        Ok(self.with_faces(faces, self.objects.clone(), self.materials.clone()))
    }

    /// Returns the same faces with other objects and materials; all other arrays are shared.
    pub(super) fn relabeled(&self, objects: FaceMap, materials: FaceMap) -> Self {
        Self {
            positions: self.positions.clone(),
            faces: self.faces.clone(),
            uvs: self.uvs.clone(),
            colors: self.colors.clone(),
            normals: self.normals.clone(),
            objects,
            materials,
            bounds: self.bounds,
            bvh: OnceLock::new(),
        }
    }

    /// Returns other faces on the same, shared vertices.
    pub(super) fn with_faces(&self, faces: Vec<[u32; 3]>, objects: FaceMap, materials: FaceMap) -> Self {
        let bounds = bounds_of(&self.positions, &faces);
        Self { faces: faces.into(), bounds, ..self.relabeled(objects, materials) }
    }

    /// Returns the mesh with its vertices moved; an existing tree is refitted to the new positions.
    pub fn with_positions(&self, positions: Vec<[f32; 3]>) -> Result<Self> {
        check_rows("vertices", Some(&positions), self.positions.len())?;
        let (faces, objects, materials) = (self.faces.clone(), self.objects.clone(), self.materials.clone());
        let mesh = Self::new(positions.into(), faces, self.uvs.clone(), self.colors.clone(), objects, materials)?;
        if let Some(bvh) = self.bvh() {
            let _ = mesh.bvh.set(bvh.refitted(|face| mesh.corners(face))?);
        }
        Ok(mesh)
    }

    /// Returns the number of faces without area: two corners are equal, or all three are collinear, in float64.
    pub fn degenerate_count(&self, progress: &Progress) -> Result<usize> {
        let is_degenerate = |face: &&[u32; 3]| {
            let [a, b, c] = face.map(|vertex| Vec3::from_array(self.positions[vertex as usize]).as_dvec3());
            (b - a).cross(c - a).length_squared() == 0.0
        };
        let count = |chunk: &[[u32; 3]]| progress.check().map(|()| chunk.iter().filter(is_degenerate).count());
        self.faces.par_chunks(CHUNK).map(count).sum()
    }

    /// Returns the size of the arrays and of the tree, bytes.
    pub fn bytes(&self) -> usize {
        fn bytes_of<T>(rows: &Option<Buffer<T>>) -> usize {
            rows.as_deref().map_or(0, size_of_val)
        }
        let required = size_of_val(&self.positions[..]) + size_of_val(&self.faces[..]);
        let optional = bytes_of(&self.uvs) + bytes_of(&self.colors) + bytes_of(&self.normals);
        required + optional + self.objects.bytes() + self.materials.bytes() + self.bvh().map_or(0, Bvh::bytes)
    }

    /// Returns the box of all faces, without unused vertices.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// Returns the corners of a face.
    #[inline]
    pub fn corners(&self, face: u32) -> [Vec3; 3] {
        self.faces[face as usize].map(|vertex| Vec3::from_array(self.positions[vertex as usize]))
    }

    /// Returns an attribute's values at the corners of a face; `None` if the mesh does not have the attribute.
    #[inline]
    pub(super) fn corner_values<T: Copy>(&self, face: u32, values: &Option<Buffer<T>>) -> Option<[T; 3]> {
        let values = values.as_ref()?;
        Some(self.faces[face as usize].map(|vertex| values[vertex as usize]))
    }

    /// Returns the bounding volume hierarchy, if it has been built.
    #[inline]
    pub fn bvh(&self) -> Option<&Bvh> {
        self.bvh.get()
    }

    /// Builds the bounding volume hierarchy on first use. Concurrent callers each build one, and the first is kept. A
    /// lock could deadlock: a thread that waits inside rayon may run a task that needs the same tree.
    pub fn build_bvh(&self, progress: &Progress) -> Result<&Bvh> {
        if let Some(bvh) = self.bvh.get() {
            return Ok(bvh);
        }
        let faces = MeshArrays {
            positions: &self.positions,
            faces: &self.faces,
            uvs: self.uvs.as_deref(),
            colors: self.colors.as_deref(),
            materials: &self.materials,
        };
        let bvh = Bvh::build(faces, progress)?;
        Ok(self.bvh.get_or_init(|| bvh))
    }
}

/// Exchanges the second and third corner of a face.
pub(crate) fn flipped(&[a, b, c]: &[u32; 3]) -> [u32; 3] {
    [a, c, b]
}

fn check_rows<T>(argument: &'static str, rows: Option<&[T]>, vertex_count: usize) -> Result<()> {
    match rows.map(<[T]>::len).filter(|&length| length != vertex_count) {
        Some(length) => Err(Error::value(argument, format!("one row for each of {vertex_count} vertices"), length)),
        None => Ok(()),
    }
}

pub(super) fn check_finite(argument: &'static str, rows: &[[f32; 3]]) -> Result<()> {
    let is_wrong = |p: &&[f32; 3]| !p.iter().all(|x| x.is_finite());
    match rows.par_chunks(CHUNK).map(|chunk| chunk.iter().filter(is_wrong).count()).sum::<usize>() {
        0 => Ok(()),
        wrong => Err(Error::value(argument, "finite coordinates", format!("{wrong} {argument} with NaN or infinity"))),
    }
}

/// Returns the box of all faces. Reading vertices through faces is random access. So for a large mesh this first tests
/// whether faces use six vertices that define the box of all vertices, as they do unless some vertices are unused.
fn bounds_of(positions: &[[f32; 3]], faces: &[[u32; 3]]) -> Aabb {
    if faces.len() > CHUNK {
        let all = box_of(positions, |bounds, &point| bounds.extend(point.into()));
        let extremes = extremes(positions, &all);
        // One vertex is compared at a time with a piece that stays in the cache; the compiler vectorises this loop.
        let contains =
            |corners: &[u32], vertex: u32| corners.iter().fold(0, |any, &v| any | u32::from(v == vertex)) != 0;
        let found_in = |piece: &[[u32; 3]]| extremes.map(|vertex| contains(piece.as_flattened(), vertex));
        let either = |a: [bool; 6], b: [bool; 6]| std::array::from_fn(|i| a[i] | b[i]);
        if faces.par_chunks(CACHED_FACES).map(found_in).reduce(|| [false; 6], either) == [true; 6] {
            return all;
        }
    }
    box_of(faces, |bounds, face| face.iter().for_each(|&v| bounds.extend(positions[v as usize].into())))
}

/// Returns, for each side of a tight box, the number of a vertex on it.
fn extremes(positions: &[[f32; 3]], bounds: &Aabb) -> [u32; 6] {
    std::array::from_fn(|side| {
        let axis = side % 3;
        let limit = if side < 3 { bounds.min[axis] } else { bounds.max[axis] };
        let vertex = positions.par_iter().with_min_len(CHUNK).position_any(|p| p[axis] == limit);
        vertex.map_or(u32::MAX, |vertex| vertex as u32)
    })
}

pub(super) fn box_of<T: Sync>(rows: &[T], extend: impl Fn(&mut Aabb, &T) + Sync) -> Aabb {
    let chunk_bounds = |chunk: &[T]| {
        let mut bounds = Aabb::EMPTY;
        chunk.iter().for_each(|row| extend(&mut bounds, row));
        bounds
    };
    rows.par_chunks(CHUNK).map(chunk_bounds).reduce(|| Aabb::EMPTY, |a, b| a.union(&b))
}

pub(super) fn gather<T: Copy + Send + Sync>(values: &[T], rows: &[u32], progress: &Progress) -> Result<Vec<T>> {
    mapped(rows, |&row| values[row as usize], progress)
}

#[cfg(test)]
mod tests {
    use super::*;

    impl Mesh {
        /// Returns a mesh of triangles without shared vertices and without materials.
        pub(crate) fn of_triangles(triangles: &[[[f32; 3]; 3]], objects: FaceMap) -> std::sync::Arc<Self> {
            let faces = (0..triangles.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
            let positions = triangles.as_flattened().to_vec().into();
            Self::new(positions, faces, None, None, objects, FaceMap::Uniform(-1)).unwrap().into()
        }
    }

    #[test]
    fn a_large_mesh_has_the_box_of_its_faces_with_and_without_unused_vertices() {
        let count = CHUNK + 10;
        let corner = |i: usize| [i as f32, (i % 7) as f32, -(i as f32)];
        let mut positions: Vec<[f32; 3]> = (0..count + 2).map(corner).collect();
        let faces: Vec<[u32; 3]> = (0..count as u32).map(|i| [i, i + 1, i + 2]).collect();
        let expected = box_of(&positions, |bounds, &point| bounds.extend(point.into()));
        assert_eq!(bounds_of(&positions, &faces), expected);
        positions.push([-1e6, 0.0, 1e6]);
        assert_eq!(bounds_of(&positions, &faces), expected);
        assert_eq!(bounds_of(&positions, &[]), Aabb::EMPTY);
    }
}
