//! Search for the meshes that can be used without a copy, in one pass over the file's bytes.

use glam::Vec3;
use rayon::prelude::*;

use super::meshes::{FaceSet, StoredMesh, StoredMeshes, VertexSet};
use crate::base::{Aabb, MAX_COORDINATE, Progress, Result};

/// Rows read at a time; they fit in the first-level cache.
pub(super) const ROWS_PER_PIECE: usize = 1 << 10;

/// Maximum number of vertices in a shared range per corner. Vertices that faces do not use cost memory.
const MAX_SPREAD: usize = 2;

/// Range of a set's vertices that faces use, and the number of the faces' corners.
#[derive(Clone)]
struct UsedRange {
    start: usize,
    end: usize,
    corners: usize,
}

impl StoredMeshes {
    /// Sets `is_usable` and `bounds` of all meshes, and the ranges of shared vertices.
    pub(super) fn find_usable(&mut self, progress: &Progress) -> Result<()> {
        let examine = |mesh: &StoredMesh| progress.check().map(|()| self.examine(mesh));
        self.meshes = self.meshes.par_iter().map(examine).collect::<Result<_>>()?;
        Ok(())
    }

    fn examine(&self, mesh: &StoredMesh) -> StoredMesh {
        let mut mesh = mesh.clone();
        let mut uses = vec![UsedRange { start: usize::MAX, end: 0, corners: 0 }; mesh.vertices.len()];
        for faces in mesh.faces.iter().filter(|faces| faces.count > 0) {
            let (min, max) = self.vertex_range(faces, &mesh.vertices);
            let used = &mut uses[faces.set];
            used.start = used.start.min(min as usize);
            used.end = used.end.max(max as usize + 1);
            used.corners += 3 * faces.count;
        }
        let mut is_usable = true;
        for (set, used) in mesh.vertices.iter_mut().zip(&uses) {
            is_usable &= used.end <= set.count;
            if set.is_shared {
                (set.first, set.count) = (used.start.min(used.end), used.end.saturating_sub(used.start));
                is_usable &= set.count <= MAX_SPREAD * used.corners;
            }
        }
        if is_usable {
            let bounds = mesh.vertices.par_iter().map(|set| self.box_of(set)).collect::<Option<Vec<_>>>();
            mesh.bounds = bounds.iter().flatten().fold(Aabb::EMPTY, |all, bounds| all.union(bounds));
            mesh.is_usable = bounds.is_some() && f64::from(mesh.bounds.max_coordinate()) <= MAX_COORDINATE;
        }
        mesh
    }

    /// Returns the smallest and largest vertex number of faces.
    fn vertex_range(&self, faces: &FaceSet, vertices: &[VertexSet]) -> (u32, u32) {
        let Some(rows) = faces.corners else { return (0, (vertices[faces.set].count as u32).saturating_sub(1)) };
        let table = self.table(rows);
        let piece_range = |first: usize, slots: &mut [[u32; 3]]| {
            table.corners(first, slots);
            let numbers = slots.as_flattened();
            numbers.iter().fold((u32::MAX, 0), |(min, max), &number| (min.min(number), max.max(number)))
        };
        map_pieces(faces.count, piece_range).reduce(|| (u32::MAX, 0), |a, b| (a.0.min(b.0), a.1.max(b.1)))
    }

    /// Returns the boxes of the faces of usable meshes, each in its own frame. `bounds` may be larger, because it includes
    /// unused vertices.
    pub fn face_bounds(&self, progress: &Progress) -> Result<Vec<[[f64; 3]; 2]>> {
        let bounds_of_mesh = |mesh: &StoredMesh| {
            progress.check()?;
            let sets = mesh.faces.par_iter().filter(|_| mesh.is_usable).map(|faces| self.box_of_faces(faces, mesh));
            Ok(self.sides(&sets.reduce(|| Aabb::EMPTY, |a, b| a.union(&b))))
        };
        self.meshes.par_iter().map(bounds_of_mesh).collect()
    }

    fn box_of_faces(&self, faces: &FaceSet, mesh: &StoredMesh) -> Aabb {
        let vertices = self.table(mesh.vertices[faces.set].attributes.positions);
        let bounds_of_piece = |first: usize, slots: &mut [[u32; 3]]| {
            self.write_faces(faces, first, slots);
            slots.as_flattened().iter().fold(Aabb::EMPTY, |mut bounds, &vertex| {
                let mut point = [[0.0; 3]];
                vertices.floats(vertex as usize, &mut point);
                bounds.extend(point[0].into());
                bounds
            })
        };
        map_pieces(faces.count, bounds_of_piece).reduce(|| Aabb::EMPTY, |a, b| a.union(&b))
    }

    /// Returns the box of a set's vertices; `None` if one is not finite.
    fn box_of(&self, set: &VertexSet) -> Option<Aabb> {
        let table = self.table(set.attributes.positions);
        let bounds_of_piece = |first: usize, slots: &mut [[f32; 3]]| {
            table.floats(set.first + first, slots);
            let mut bounds = Aabb::EMPTY;
            let mut sum = Vec3::ZERO;
            for slot in slots {
                bounds.extend((*slot).into());
                // Multiplying by zero keeps NaN and turns infinity into NaN.
                sum += Vec3::from_array(*slot) * 0.0;
            }
            (sum == Vec3::ZERO).then_some(bounds)
        };
        map_pieces(set.count, bounds_of_piece).try_reduce(|| Aabb::EMPTY, |a, b| Some(a.union(&b)))
    }
}

/// Divides `count` rows into pieces. `read` gets a piece's first row and slots for its rows; its results are returned.
pub(super) fn map_pieces<T: Copy + Default, const W: usize, R: Send>(
    count: usize,
    read: impl Fn(usize, &mut [[T; W]]) -> R + Sync + Send,
) -> impl IndexedParallelIterator<Item = R> {
    let starts = (0..count.div_ceil(ROWS_PER_PIECE)).into_par_iter().with_min_len(64);
    starts.map(move |piece| {
        let (first, mut slots) = (piece * ROWS_PER_PIECE, [[T::default(); W]; ROWS_PER_PIECE]);
        read(first, &mut slots[..ROWS_PER_PIECE.min(count - first)])
    })
}
