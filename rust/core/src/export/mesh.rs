//! Meshes as encoded primitives. Equal vertices are merged; faces and vertices are ordered for compression and drawing.
//!
//! meshoptimizer orders the faces (Kapoulkine, after Forsyth: Linear-speed vertex cache optimisation, 2006).

use meshopt::{VertexStream, generate_vertex_remap_multi, optimize_vertex_cache_in_place};
use rayon::prelude::*;

use super::attribute::{Stream, streams};
use super::faces::{Key, Part, Piece, primitives};
use super::gather::{Primitive, gather};
use super::grid::Grid;
use super::statistics::Statistics;
use super::surfaces::Surfaces;
use crate::base::memory::{room_for, try_with_capacity};
use crate::base::{Progress, Result};

/// Alignment of arrays in files, the size of their largest components.
pub(super) const ALIGNMENT: usize = 4;
/// Memory for encoding a mesh without shared vertices, bytes per face; measured as the growth of the address space.
const ENCODING_BYTES: u64 = 320;
/// Marks vertices that no face uses.
const UNUSED: u32 = u32::MAX;

/// Returns the number of faces of meshes that are encoded in parallel; fails if there is no room for all. If each task
/// asked for itself, all would be granted the same memory.
pub(super) fn room_to_encode(face_counts: impl Iterator<Item = usize>) -> Result<u64> {
    let count = face_counts.sum::<usize>() as u64;
    room_for(ENCODING_BYTES * count)?;
    Ok(count)
}

/// A primitive as arrays.
#[derive(Clone, Debug)]
pub(super) struct EncodedPrimitive {
    pub key: Key,
    /// Arrays of vertex attributes, then the array of corners.
    pub streams: Vec<Stream>,
}

/// A mesh as arrays.
#[derive(Clone, Debug, Default)]
pub(super) struct EncodedMesh {
    pub primitives: Vec<EncodedPrimitive>,
    pub statistics: Statistics,
}

impl EncodedMesh {
    /// Encodes the faces of parts. The caller has called `room_to_encode`. Position errors are in the frame of the
    /// parts. Reports one unit of progress per face.
    pub fn new(
        parts: &[Part<'_>],
        grid: Grid,
        surfaces: &Surfaces,
        compressed: bool,
        progress: &Progress,
    ) -> Result<Self> {
        let encode = |(key, pieces): &(Key, Vec<Piece<'_>>)| {
            let gathered = gather(*key, pieces, grid, surfaces, progress)?;
            let faces = (gathered.faces.len() + gathered.dropped) as u64;
            let mut statistics = Statistics { dropped: gathered.dropped as u64, ..Statistics::default() };
            let mut encoded = None;
            if !gathered.faces.is_empty() {
                let welded = weld(gathered);
                progress.check()?;
                let streams = streams(&welded, compressed)?;
                statistics.triangles = welded.faces.len() as u64;
                statistics.vertices = welded.positions.len() as u64;
                streams.iter().for_each(|stream| stream.add_to(&mut statistics));
                encoded = Some(EncodedPrimitive { key: *key, streams });
            }
            progress.report(faces)?;
            Ok((encoded, statistics))
        };
        let primitives = primitives(parts, surfaces, progress)?;
        let encoded: Vec<_> = primitives.par_iter().map(encode).collect::<Result<_>>()?;
        let mut mesh = Self::default();
        for (primitive, statistics) in encoded {
            mesh.statistics.add(&statistics);
            mesh.primitives.extend(primitive);
        }
        Ok(mesh)
    }

    /// Returns all arrays, concatenated and aligned.
    pub fn bytes(&self) -> Result<Vec<u8>> {
        let mut bytes = try_with_capacity(self.byte_count())?;
        for stream in self.streams() {
            append(&mut bytes, &stream.bytes);
        }
        Ok(bytes)
    }

    /// Returns the length of `bytes`.
    pub fn byte_count(&self) -> usize {
        self.streams().map(|stream| stream.bytes.len().next_multiple_of(ALIGNMENT)).sum()
    }

    fn streams(&self) -> impl Iterator<Item = &Stream> {
        self.primitives.iter().flat_map(|primitive| &primitive.streams)
    }
}

/// Appends an array and padding; returns the array's start.
pub(super) fn append(bytes: &mut Vec<u8>, array: &[u8]) -> usize {
    let start = bytes.len();
    bytes.extend_from_slice(array);
    bytes.resize(bytes.len().next_multiple_of(ALIGNMENT), 0);
    start
}

/// Merges equal vertices, orders the faces, and orders the vertices by their first use.
fn weld(mut primitive: Primitive) -> Primitive {
    let (count, numbers) = distinct_vertices(&primitive);
    let mut vertices = vec![UNUSED; count];
    for (vertex, &number) in numbers.iter().enumerate().filter(|&(_, &number)| number != UNUSED) {
        vertices[number as usize] = vertex as u32;
    }
    let corners = primitive.faces.as_flattened_mut();
    corners.iter_mut().for_each(|corner| *corner = numbers[*corner as usize]);
    optimize_vertex_cache_in_place(corners, count);
    let mut order = renumber_by_first_use(corners, count);
    order.iter_mut().for_each(|number| *number = vertices[*number as usize]);
    reorder(&mut primitive, &order);
    primitive
}

/// Returns the number of distinct vertices that faces use, and for each vertex its number among them or `UNUSED`.
fn distinct_vertices(primitive: &Primitive) -> (usize, Vec<u32>) {
    let mut streams = vec![VertexStream::new(primitive.positions.as_ptr())];
    streams.extend(primitive.normals.as_ref().map(|normals| VertexStream::new(normals.as_ptr())));
    streams.extend(primitive.uvs.as_ref().map(|(uvs, _)| VertexStream::new(uvs.as_ptr())));
    streams.extend(primitive.colors.as_ref().map(|colors| VertexStream::new(colors.as_ptr())));
    generate_vertex_remap_multi(primitive.positions.len(), &streams, Some(primitive.faces.as_flattened()))
}

fn reorder(primitive: &mut Primitive, order: &[u32]) {
    fn rows<T: Copy>(values: &mut Vec<T>, order: &[u32]) {
        *values = order.iter().map(|&vertex| values[vertex as usize]).collect();
    }
    rows(&mut primitive.positions, order);
    primitive.normals.iter_mut().for_each(|normals| rows(normals, order));
    primitive.uvs.iter_mut().for_each(|(uvs, _)| rows(uvs, order));
    primitive.colors.iter_mut().for_each(|colors| rows(colors, order));
}

/// Renumbers vertices in the order of their first use; returns their old numbers in this order.
fn renumber_by_first_use(corners: &mut [u32], count: usize) -> Vec<u32> {
    let mut numbers = vec![UNUSED; count];
    let mut order = Vec::with_capacity(count);
    for corner in corners {
        let number = &mut numbers[*corner as usize];
        if *number == UNUSED {
            *number = order.len() as u32;
            order.push(*corner);
        }
        *corner = *number;
    }
    order
}
