//! Meshes as encoded primitives.

use rayon::prelude::*;

use super::attribute::{Stream, streams};
use super::faces::{Key, Part, Piece, primitives};
use super::gather::gather;
use super::grid::Grid;
use super::statistics::Statistics;
use super::surfaces::Surfaces;
use super::weld::weld;
use crate::base::{Progress, Result};

/// Alignment of arrays in files: that of their widest components.
pub(super) const ALIGNMENT: usize = 4;

/// A primitive as arrays.
#[derive(Clone, Debug)]
pub(super) struct EncodedPrimitive {
    pub key: Key,
    /// Vertex attributes, and last the corners.
    pub streams: Vec<Stream>,
}

/// A mesh as arrays.
#[derive(Clone, Debug, Default)]
pub(super) struct EncodedMesh {
    pub primitives: Vec<EncodedPrimitive>,
    pub statistics: Statistics,
}

impl EncodedMesh {
    /// Encodes the faces of some parts. Position errors are measured in their frame. Reports one unit per face.
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
            let primitive = match weld(gathered) {
                None => None,
                Some(welded) => {
                    progress.check()?;
                    let streams = streams(&welded.primitive, &welded.corners, compressed)?;
                    statistics.triangles = welded.corners.len() as u64 / 3;
                    statistics.vertices = welded.primitive.positions.len() as u64;
                    for stream in &streams {
                        statistics.count(stream.attribute.kind(), stream.bytes.len());
                        statistics.raw_bytes += stream.raw_bytes() as u64;
                        statistics.position_error = statistics.position_error.max(stream.error);
                    }
                    Some(EncodedPrimitive { key: *key, streams })
                }
            };
            progress.report(faces)?;
            Ok((primitive, statistics))
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

    /// Returns all arrays concatenated, each aligned.
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        for stream in self.primitives.iter().flat_map(|primitive| &primitive.streams) {
            append(&mut bytes, &stream.bytes);
        }
        bytes
    }
}

/// Appends an array, padded to the alignment; returns its start.
pub(super) fn append(bytes: &mut Vec<u8>, array: &[u8]) -> usize {
    let start = bytes.len();
    bytes.extend_from_slice(array);
    bytes.resize(bytes.len().next_multiple_of(ALIGNMENT), 0);
    start
}
