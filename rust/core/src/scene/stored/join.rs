//! Joining of placed stored meshes. Their bytes are read once, into the arrays of the result.

use glam::{DAffine3, Vec3};
use rayon::prelude::*;

use super::meshes::{Attributes, FaceSet, StoredMesh, StoredMeshes, VertexSet};
use super::rows::ComponentType;
use crate::base::mapped::{pieces, starts};
use crate::base::memory::try_vec;
use crate::base::{Buffer, FaceMap, Progress, Result, ensure};
use crate::scene::merge::is_mirror;
use crate::scene::mesh::{CHUNK, Mesh, check_finite, flipped};
use crate::scene::normal::{normal_matrix, place_normal};

/// Tolerance on the squared length of a unit normal, so that normals of four digits count as unit.
const UNIT_TOLERANCE: f32 = 1e-4;

/// A stored mesh to be joined.
#[derive(Clone, Copy, Debug)]
pub struct StoredPart {
    /// Number of the mesh; it must be usable.
    pub mesh: usize,
    /// Transform object→scene; need not be invertible.
    pub to_scene: DAffine3,
    /// Object of all faces; −1 for none.
    pub object: i32,
}

impl StoredMeshes {
    /// Returns a mesh in its own frame, without objects. Arrays that the file stores in usable form are not copied.
    pub fn mesh(&self, mesh: usize, progress: &Progress) -> Result<Mesh> {
        self.join(&[StoredPart { mesh, to_scene: DAffine3::IDENTITY, object: -1 }], progress)
    }

    /// Returns several meshes, as `mesh` does.
    pub fn meshes(&self, chosen: &[usize], progress: &Progress) -> Result<Vec<Mesh>> {
        chosen.par_iter().map(|&mesh| self.mesh(mesh, progress)).collect()
    }

    /// Joins meshes in order. If only some vertices have an attribute, the others get a neutral value: white, no
    /// normal, texture coordinates 0.
    pub fn join(&self, parts: &[StoredPart], progress: &Progress) -> Result<Mesh> {
        ensure!(parts.iter().all(|part| part.to_scene.is_finite()), "transform", "finite numbers", "NaN or infinity");
        let vertex_count: usize = parts.iter().map(|part| self.vertex_count(part.mesh)).sum();
        let face_count: usize = parts.iter().map(|part| self.face_count(part.mesh)).sum();
        let is_numbered = vertex_count.max(face_count) < u32::MAX as usize;
        ensure!(is_numbered, "meshes", "fewer than 2^32 vertices in one merged mesh", vertex_count);
        let has = |attribute: fn(&Attributes) -> Option<usize>| {
            let mut sets = parts.iter().flat_map(|part| &self.meshes[part.mesh].vertices);
            sets.any(|set| attribute(&set.attributes).is_some())
        };
        let positions = self.borrowed_positions(parts).map_or_else(|| self.positions(parts, progress), Ok)?;
        let faces = self.borrowed_faces(parts).map_or_else(|| self.faces(parts, progress), Ok)?;
        let uvs = has(|attributes| attributes.uvs).then(|| self.uvs(parts, progress)).transpose()?;
        let colors = has(|attributes| attributes.colors).then(|| self.colors(parts, progress)).transpose()?;
        let normals = has(|attributes| attributes.normals).then(|| self.normals(parts, progress)).transpose()?;
        let objects: Vec<_> =
            parts.iter().map(|part| (FaceMap::Uniform(part.object), self.face_count(part.mesh))).collect();
        let face_sets = parts.iter().flat_map(|part| &self.meshes[part.mesh].faces);
        let materials: Vec<_> = face_sets.map(|faces| (FaceMap::Uniform(faces.material), faces.count)).collect();
        let joined = |maps: &[(FaceMap, usize)]| FaceMap::concat(maps.iter().map(|(map, count)| (map, *count)));
        let (objects, materials) = (joined(&objects)?, joined(&materials)?);
        progress.check()?;
        Mesh::unchecked(positions, faces, uvs, colors, objects, materials).shaded_by(normals).checked_reach()
    }

    fn positions(&self, parts: &[StoredPart], progress: &Progress) -> Result<Buffer<[f32; 3]>> {
        let positions = self.collect_by_vertex(parts, [0.0; 3], progress, |part, set, first, slots| {
            self.table(set.attributes.positions).floats(first, slots);
            if self.scale != 1.0 || part.to_scene != DAffine3::IDENTITY {
                for slot in slots {
                    // Rounded only after placement, which may make coordinates smaller and float32 more precise.
                    let point = Vec3::from_array(*slot).as_dvec3() * self.scale;
                    *slot = part.to_scene.transform_point3(point).as_vec3().to_array();
                }
            }
        })?;
        check_finite("vertices", &positions)?;
        Ok(positions)
    }

    fn normals(&self, parts: &[StoredPart], progress: &Progress) -> Result<Buffer<[f32; 3]>> {
        self.collect_by_vertex(parts, [0.0; 3], progress, |part, set, first, slots| {
            let Some(rows) = set.attributes.normals else { return };
            self.table(rows).floats(first, slots);
            // Quantised normals are always normalised: their length is never exactly 1.
            let tolerance = if self.rows[rows].component == ComponentType::F32 { UNIT_TOLERANCE } else { 0.0 };
            slots.iter_mut().for_each(|slot| *slot = unit(*slot, tolerance));
            if part.to_scene != DAffine3::IDENTITY {
                let matrix = normal_matrix(&part.to_scene);
                slots.iter_mut().for_each(|slot| *slot = place_normal(&matrix, *slot).to_array());
            }
        })
    }

    fn uvs(&self, parts: &[StoredPart], progress: &Progress) -> Result<Buffer<[f32; 2]>> {
        self.collect_by_vertex(parts, [0.0; 2], progress, |_, set, first, slots| {
            let Some(rows) = set.attributes.uvs else { return };
            self.table(rows).floats(first, slots);
            // v points down in files.
            slots.iter_mut().for_each(|[_, v]| *v = 1.0 - *v);
        })
    }

    fn colors(&self, parts: &[StoredPart], progress: &Progress) -> Result<Buffer<[u8; 4]>> {
        self.collect_by_vertex(parts, [255; 4], progress, |_, set, first, slots| {
            if let Some(rows) = set.attributes.colors {
                self.table(rows).colors(first, slots);
            }
        })
    }

    /// Collects a value for each vertex. `write` gets a part, one of its vertex sets, the first row and slots for rows.
    fn collect_by_vertex<T: Copy + Send + Sync + 'static>(
        &self,
        parts: &[StoredPart],
        neutral: T,
        progress: &Progress,
        write: impl Fn(&StoredPart, &VertexSet, usize, &mut [T]) + Sync,
    ) -> Result<Buffer<T>> {
        let lengths = || parts.iter().map(|part| self.vertex_count(part.mesh));
        let mut values = try_vec(neutral, lengths().sum())?;
        parts.par_iter().zip(pieces(&mut values, lengths())).try_for_each(|(part, slots)| {
            let sets = &self.meshes[part.mesh].vertices;
            let slots = pieces(slots, sets.iter().map(|set| set.count));
            sets.par_iter().zip(slots).try_for_each(|(set, slots)| {
                slots.par_chunks_mut(CHUNK).enumerate().try_for_each(|(chunk, slots)| {
                    write(part, set, set.first + chunk * CHUNK, slots);
                    progress.check()
                })
            })
        })?;
        Ok(values.into())
    }

    fn faces(&self, parts: &[StoredPart], progress: &Progress) -> Result<Buffer<[u32; 3]>> {
        let lengths = || parts.iter().map(|part| self.face_count(part.mesh));
        let mut faces = try_vec([0; 3], lengths().sum())?;
        let firsts: Vec<usize> = starts(parts.iter().map(|part| self.vertex_count(part.mesh))).collect();
        parts.par_iter().zip(firsts).zip(pieces(&mut faces, lengths())).try_for_each(|((part, first), slots)| {
            let mesh = &self.meshes[part.mesh];
            let shifts = mesh.shifts(first);
            let slots = pieces(slots, mesh.faces.iter().map(|faces| faces.count));
            mesh.faces.par_iter().zip(slots).try_for_each(|(faces, slots)| {
                let (shift, is_mirrored) = (shifts[faces.set], is_mirror(&part.to_scene));
                slots.par_chunks_mut(CHUNK).enumerate().try_for_each(|(chunk, slots)| {
                    self.write_faces(faces, chunk * CHUNK, slots);
                    for slot in slots {
                        let face = slot.map(|vertex| vertex.wrapping_add(shift));
                        *slot = if is_mirrored { flipped(&face) } else { face };
                    }
                    progress.check()
                })
            })
        })?;
        Ok(faces.into())
    }

    /// Writes faces from number `first` on, with the file's vertex numbers.
    pub(super) fn write_faces(&self, faces: &FaceSet, first: usize, slots: &mut [[u32; 3]]) {
        match faces.corners {
            Some(rows) => self.table(rows).corners(first, slots),
            None => {
                for (row, slot) in slots.iter_mut().enumerate() {
                    let corner = 3 * (first + row) as u32;
                    *slot = [corner, corner + 1, corner + 2];
                }
            }
        }
    }

    /// Returns the file's own positions, for a single mesh that is not moved.
    fn borrowed_positions(&self, parts: &[StoredPart]) -> Option<Buffer<[f32; 3]>> {
        let [part] = parts else { return None };
        let [set] = &self.meshes[part.mesh].vertices[..] else { return None };
        let is_plain = self.scale == 1.0 && part.to_scene == DAffine3::IDENTITY;
        is_plain.then(|| self.borrowed(set.attributes.positions, ComponentType::F32, set.first, set.count))?
    }

    /// Returns the file's own faces, for a single mesh with a single face set.
    fn borrowed_faces(&self, parts: &[StoredPart]) -> Option<Buffer<[u32; 3]>> {
        let [part] = parts else { return None };
        let mesh = &self.meshes[part.mesh];
        let [faces] = &mesh.faces[..] else { return None };
        let is_plain = mesh.vertices[0].first == 0 && !is_mirror(&part.to_scene);
        is_plain.then(|| self.borrowed(faces.corners?, ComponentType::U32, 0, 3 * faces.count))?
    }

    fn borrowed<T: bytemuck::AnyBitPattern + Send + Sync>(
        &self,
        rows: usize,
        component: ComponentType,
        first: usize,
        count: usize,
    ) -> Option<Buffer<T>> {
        let rows = &self.rows[rows];
        let range = rows.tight(first, count).filter(|_| rows.component == component)?;
        let block = self.blocks[rows.block].clone();
        bytemuck::try_cast_slice::<u8, T>(&block[range.clone()]).ok()?;
        Some(Buffer::from_owner(Borrowed { block, range, of: std::marker::PhantomData }))
    }
}

/// A range of a block, viewed as aligned values.
struct Borrowed<T> {
    block: Buffer<u8>,
    range: std::ops::Range<usize>,
    of: std::marker::PhantomData<fn() -> T>,
}

impl<T: bytemuck::AnyBitPattern> AsRef<[T]> for Borrowed<T> {
    fn as_ref(&self) -> &[T] {
        bytemuck::cast_slice(&self.block[self.range.clone()])
    }
}

impl StoredMesh {
    /// Returns the offset to add to each set's vertex numbers if the mesh's first vertex is `first`.
    fn shifts(&self, first: usize) -> Vec<u32> {
        let starts = starts(self.vertices.iter().map(|set| set.count));
        starts.zip(&self.vertices).map(|(start, set)| (first + start).wrapping_sub(set.first) as u32).collect()
    }
}

/// Normalises a normal unless its squared length is within `tolerance` of 1. Returns zeros if it is not finite.
fn unit(normal: [f32; 3], tolerance: f32) -> [f32; 3] {
    let vector = Vec3::from_array(normal);
    if (vector.length_squared() - 1.0).abs() <= tolerance {
        return normal;
    }
    if vector.is_finite() { vector.as_dvec3().normalize_or_zero().as_vec3().to_array() } else { [0.0; 3] }
}
