//! Splitting of meshes: assembly of pieces into faces and new vertices. Neighbouring pieces share vertices if the
//! source's faces do.

use std::collections::HashMap;
use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;
use rayon::prelude::*;

use super::rule::Rule;
use super::settings::Precision;
use super::split::Piece;
use crate::base::memory::{room_for, try_copy, try_grow, try_list, try_with_capacity};
use crate::base::{Progress, Result, ensure};

/// Number of faces per task: fixed, so that the result does not depend on the number of threads.
const CHUNK: usize = 1 << 12;
/// Peak memory per piece, bytes: the piece, its face and its part of the new vertices.
const BYTES_PER_PIECE: u64 = size_of::<Piece>() as u64 + 64;

/// Numbers of triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SplitCounts {
    /// Triangles of the source.
    pub before: u64,
    /// Triangles of the result.
    pub after: u64,
    /// Triangles of the source that were examined; the others move, or lie within r₁ or beyond r₂.
    pub examined: u64,
    /// Triangles of the source that were split.
    pub split: u64,
}

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
    rule.require_bound()?;
    let mut counts = SplitCounts { before: faces.len() as u64, ..SplitCounts::default() };
    let corners = |face: u32| Some(faces[face as usize].map(|vertex| DVec3::from_array(vertices[vertex as usize])));
    progress.expect(faces.len() as u64);
    let limits = (&Budget::default(), &mut counts);
    let split = assemble(faces, vertices.len(), corners, (rule, Precision::Double), limits, progress)?;
    let Some(split) = split else {
        counts.after = counts.before;
        let (faces, sources) = (try_copy(faces)?, try_list(0..faces.len() as u32)?);
        return Ok(Arrays { faces, sources, counts, ..Arrays::default() });
    };
    counts.after = split.faces.len() as u64;
    Ok(Arrays {
        points: try_list(split.new.iter().map(|new| new.point.to_array()))?,
        point_faces: try_list(split.new.iter().map(|new| new.face))?,
        weights: try_list(split.new.iter().map(|new| new.weights))?,
        faces: split.faces,
        sources: split.sources,
        counts,
    })
}

/// A new vertex on a face of the source.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct NewVertex {
    pub point: DVec3,
    pub face: u32,
    pub weights: [f64; 3],
}

/// A face of the source and its pieces.
type Split = (u32, Vec<Piece>);

/// Faces of a split mesh. Vertices from `vertex_count` on are new.
#[derive(Debug, Default)]
pub(super) struct Assembled {
    pub faces: Vec<[u32; 3]>,
    /// Source face that contains each face.
    pub sources: Vec<u32>,
    pub new: Vec<NewVertex>,
}

/// Counter of the pieces of all tasks; fails if the system lacks the memory.
#[derive(Debug, Default)]
pub(super) struct Budget(AtomicU64);

impl Budget {
    /// Adds a number of created pieces.
    pub fn add(&self, pieces: usize, progress: &Progress) -> Result<()> {
        let all = self.0.fetch_add(pieces as u64, Ordering::Relaxed) + pieces as u64;
        let expected = "a tolerance reached by fewer than 2^32 triangles";
        ensure!(all <= u64::from(u32::MAX), "tolerance_px", expected, format!("{all} triangles"));
        // Twice the memory, because the result is assembled while the pieces still exist.
        room_for(2 * BYTES_PER_PIECE * all)?;
        progress.check()
    }
}

/// Splits the faces of a mesh; `corners` returns the corners of a face that may be split. `None` if no face is split.
pub(super) fn assemble(
    source: &[[u32; 3]],
    vertex_count: usize,
    corners: impl Fn(u32) -> Option<[DVec3; 3]> + Sync,
    (rule, precision): (&Rule, Precision),
    (budget, counts): (&Budget, &mut SplitCounts),
    progress: &Progress,
) -> Result<Option<Assembled>> {
    let chunks = source.par_chunks(CHUNK).enumerate().map(|(chunk, faces)| {
        let (mut examined, mut split) = (0, Vec::new());
        for face in (chunk * CHUNK) as u32..(chunk * CHUNK + faces.len()) as u32 {
            let Some(corners) = corners(face).filter(|corners| !rule.can_skip(corners)) else {
                continue;
            };
            examined += 1;
            let count = |pieces| budget.add(pieces, progress);
            let pieces = Piece::of_triangle(corners).split(rule, precision, |_| false, count)?;
            if pieces.len() > 1 {
                split.push((face, pieces));
            }
        }
        progress.report(faces.len() as u64)?;
        Ok((examined, split))
    });
    let chunks: Vec<(u64, Vec<Split>)> = chunks.collect::<Result<_>>()?;
    counts.examined += chunks.iter().map(|(examined, _)| examined).sum::<u64>();
    let mut split: Vec<Split> = Vec::new();
    for (_, mut chunk_split) in chunks {
        try_grow(&mut split, chunk_split.len())?;
        split.append(&mut chunk_split);
    }
    counts.split += split.len() as u64;
    if split.is_empty() {
        return Ok(None);
    }
    join(source, vertex_count, &split, progress).map(Some)
}

/// Identity of a new vertex: its edge or face on the source, and the bits of its position.
type Key = ([u32; 2], [u64; 3]);

fn join(source: &[[u32; 3]], vertex_count: usize, split: &[Split], progress: &Progress) -> Result<Assembled> {
    let pieces: usize = split.iter().map(|(_, pieces)| pieces.len()).sum();
    let face_count = source.len() - split.len() + pieces;
    let mut all =
        Assembled { faces: try_with_capacity(face_count)?, sources: try_with_capacity(face_count)?, new: Vec::new() };
    let mut new_numbers: HashMap<Key, u32> = HashMap::new();
    let mut next = 0;
    for (face, pieces) in split {
        progress.check()?;
        all.faces.extend_from_slice(&source[next..*face as usize]);
        all.sources.extend(next as u32..*face);
        next = *face as usize + 1;
        let vertices = source[*face as usize];
        for piece in pieces {
            let mut numbers = [0; 3];
            for ((number, point), weights) in numbers.iter_mut().zip(piece.corners).zip(piece.weights) {
                *number = match place_on_source(vertices, *face, weights) {
                    VertexPlace::Corner(vertex) => vertex,
                    VertexPlace::New(place) => {
                        let next_number = (vertex_count + all.new.len()) as u32;
                        let key = (place, point.to_array().map(f64::to_bits));
                        *new_numbers.entry(key).or_insert_with(|| {
                            all.new.push(NewVertex { point, face: *face, weights });
                            next_number
                        })
                    }
                };
            }
            all.faces.push(numbers);
            all.sources.push(*face);
        }
        let is_numbered = vertex_count + all.new.len() <= u32::MAX as usize;
        ensure!(is_numbered, "tolerance_px", "a tolerance reached by fewer than 2^32 vertices", "more");
    }
    all.faces.extend_from_slice(&source[next..]);
    all.sources.extend(next as u32..source.len() as u32);
    Ok(all)
}

enum VertexPlace {
    Corner(u32),
    New([u32; 2]),
}

/// Returns the position on the source of a point with these weights. Two zero weights mark a corner, one marks an edge.
fn place_on_source(vertices: [u32; 3], face: u32, weights: [f64; 3]) -> VertexPlace {
    let used: [bool; 3] = weights.map(|weight| weight != 0.0);
    match used {
        [true, false, false] => VertexPlace::Corner(vertices[0]),
        [false, true, false] => VertexPlace::Corner(vertices[1]),
        [false, false, true] => VertexPlace::Corner(vertices[2]),
        [true, true, false] => VertexPlace::New(ascending(vertices[0], vertices[1])),
        [false, true, true] => VertexPlace::New(ascending(vertices[1], vertices[2])),
        [true, false, true] => VertexPlace::New(ascending(vertices[2], vertices[0])),
        // No edge has two equal ends, so such a pair can stand for the inside of a face.
        _ => VertexPlace::New([face, face]),
    }
}

fn ascending(a: u32, b: u32) -> [u32; 2] {
    [a.min(b), a.max(b)]
}
