//! Triangles that the morph bends, split once for all users at about the same distance from the centre. For each user
//! their vertices are morphed, and the tree over them is refitted.

use std::cell::Cell;
use std::collections::HashMap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, OnceLock};

use glam::{DAffine3, DVec3};
use rayon::prelude::*;

use crate::base::memory::{room_for, try_copy, try_grow, try_grow_map, try_list, try_vec, try_with_capacity};
use crate::base::{Error, FaceMap, Progress, Result};
use crate::morph::Morph;
use crate::scene::{Instance, Mesh, Scene};
use crate::tessellate::{self, Precision, Rule, Settings};

/// Maximum number of pieces that a split may add, about a gigabyte.
const MAX_PIECES: u64 = 1 << 22;
/// Maximum number of bytes per triangle that stays whole, while triangles are cut: a block with the piece and the
/// allocator's part, and three references to blocks, because lists of tasks double when they grow and are then joined.
const PIECE_BYTES: u64 = (size_of::<Placed>() + 16 + 3 * size_of::<Box<[Placed]>>()) as u64;
/// Tolerance in radians from which on triangles are not split.
const MAX_TOLERANCE: f64 = 0.5;
/// Vertices morphed between two checks for cancellation.
const CHUNK: usize = 1 << 14;

/// A piece of a scene's face, given by its three corners on the face.
#[derive(Clone, Copy, Debug)]
pub(super) struct NearPiece {
    pub instance: u32,
    pub face: u32,
    /// Whether the whole piece lies in the near part's cylinder, so that its points need not be tested.
    pub is_within: bool,
    /// Weights of the face's second and third corner at the piece's corners.
    corners: [[f32; 2]; 3],
}

impl NearPiece {
    /// Converts weights on the piece to weights on the face; bit-equal for a whole face.
    #[inline]
    pub fn face_weights(&self, u: f32, v: f32) -> (f32, f32) {
        let [a, b, c] = self.corners;
        let mix = |i: usize| a[i] + u * (b[i] - a[i]) + v * (c[i] - a[i]);
        (mix(0), mix(1))
    }
}

/// Pieces, one per face of the traced mesh.
#[derive(Clone, Debug)]
pub(super) struct NearPart {
    pub pieces: Arc<Vec<NearPiece>>,
    pub instance: Instance,
    /// Number of vertices that user and centre see in opposite directions.
    pub opposed: u64,
    /// Whether the tolerance is an upper bound.
    pub bounded: bool,
}

impl NearPart {
    /// Creates unmorphed whole faces.
    pub fn fixed(faces: Vec<(u32, u32)>, scene: &Scene) -> Result<Self> {
        let split = Split::new(&faces, scene, None, false, |_| true, &Progress::new())?;
        let positions = try_list(split.vertices.iter().map(|vertex| vertex.as_vec3().to_array()))?;
        split.near_part(split.mesh_of(positions)?, 0)
    }
}

/// Cuts triangles (instance, face) into pieces; `None` if the triangles that are split give more than `MAX_PIECES`.
fn cut(
    sources: &[(u32, u32)],
    scene: &Scene,
    rule: Option<&Rule>,
    moves: bool,
    is_within: &(impl Fn(DVec3) -> bool + Sync),
    progress: &Progress,
) -> Result<Option<Vec<Box<[Placed]>>>> {
    room_for(PIECE_BYTES * sources.len() as u64)?;
    let piece_count = AtomicU64::new(0);
    let count = |pieces: usize| {
        let all = piece_count.fetch_add(pieces as u64, Ordering::Relaxed) + pieces as u64;
        if all > MAX_PIECES { Err(Error::Cancelled) } else { progress.check() }
    };
    let split = |triangle: tessellate::Piece| {
        let Some(rule) = rule else { return Ok(vec![triangle]) };
        let is_invisible =
            |corners: &[DVec3; 3]| tessellate::Piece::is_thin(corners) || (!moves && rule.is_beyond(corners));
        let counted = Cell::new(0);
        let pieces = triangle.split(rule, Precision::Double, is_invisible, |pieces| {
            counted.set(counted.get() + pieces);
            count(pieces)
        })?;
        // Whole triangles are not counted, because a coarser split does not reduce their number.
        if pieces.len() > 1 {
            count(pieces.len() - counted.get())?;
        }
        Ok(pieces)
    };
    let triangles = sources.par_iter().map(|&(instance, face)| {
        let corners = scene.instance(instance).corners(face).map(|corner| corner.as_dvec3());
        let place_piece = |piece: tessellate::Piece| {
            let corners = piece.weights.map(|[_, u, v]| [u as f32, v as f32]);
            // The cylinder is convex.
            let is_within = piece.corners.iter().all(|&corner| is_within(corner));
            (NearPiece { instance, face, is_within, corners }, piece.corners)
        };
        Ok(split(tessellate::Piece::of_triangle(corners))?.into_iter().map(place_piece).collect())
    });
    // A slice instead of a vector, whose least capacity is four pieces.
    let triangles: Result<Vec<Box<[Placed]>>> = triangles.collect();
    // Whether the total exceeds the limit does not depend on the order of threads.
    if piece_count.into_inner() > MAX_PIECES {
        progress.check()?;
        return Ok(None);
    }
    triangles.map(Some)
}

/// A piece and its corners.
type Placed = (NearPiece, [DVec3; 3]);

/// Pieces of triangles before the morph.
#[derive(Debug)]
pub(super) struct Split {
    pieces: Arc<Vec<NearPiece>>,
    vertices: Vec<DVec3>,
    faces: Vec<[u32; 3]>,
    bounded: bool,
    /// Mesh of the first user, whose tree is refitted for others.
    first: OnceLock<Arc<Mesh>>,
}

impl Split {
    /// Splits triangles (instance, face) by settings, if given. If these give more than `MAX_PIECES` pieces, the split
    /// is coarser and has no error bound. Pieces that are not drawn are omitted, except those of moving objects
    /// (`moves`), which are drawn everywhere. `is_within` returns whether a point lies in the near part's cylinder.
    pub fn new(
        sources: &[(u32, u32)],
        scene: &Scene,
        settings: Option<Settings>,
        moves: bool,
        is_within: impl Fn(DVec3) -> bool + Sync,
        progress: &Progress,
    ) -> Result<Self> {
        let (mut bounded, mut settings) = (settings.is_some(), settings);
        let triangles = loop {
            let rule = settings.map(|settings| Rule::new(&settings, Precision::Double)).transpose()?;
            bounded &= rule.as_ref().is_some_and(Rule::holds);
            if let Some(triangles) = cut(sources, scene, rule.as_ref(), moves, &is_within, progress)? {
                break triangles;
            }
            bounded = false;
            let coarser = |settings: Settings| Settings { tolerance: 2.0 * settings.tolerance, ..settings };
            settings = settings.map(coarser).filter(|settings| settings.tolerance < MAX_TOLERANCE);
        };
        progress.check()?;
        let count = triangles.iter().map(|pieces| pieces.len()).sum();
        let (mut pieces, mut faces) = (try_with_capacity(count)?, try_with_capacity(count)?);
        // The cut of an edge depends on the edge alone, so neighbours have bit-equal vertices.
        let (mut vertices, mut numbers) = (vec![], HashMap::new());
        for (piece, corners) in triangles.into_iter().flatten() {
            try_grow(&mut vertices, corners.len())?;
            try_grow_map(&mut numbers, corners.len())?;
            pieces.push(piece);
            faces.push(corners.map(|corner| {
                *numbers.entry(corner.to_array().map(f64::to_bits)).or_insert_with(|| {
                    vertices.push(corner);
                    vertices.len() as u32 - 1
                })
            }));
        }
        Ok(Self { pieces: Arc::new(pieces), vertices, faces, bounded, first: OnceLock::new() })
    }

    /// Returns the pieces morphed for one user, with a tree over them.
    pub fn morphed(&self, morph: &Morph, progress: &Progress) -> Result<NearPart> {
        let mut positions = try_vec([0.0; 3], self.vertices.len())?;
        let morph_chunk = |(chunk, positions): (&[DVec3], &mut [[f32; 3]])| -> Result<u64> {
            progress.check()?;
            let mut opposed = 0;
            for (position, &vertex) in positions.iter_mut().zip(chunk) {
                let point = morph.examine(vertex);
                *position = point.point.as_vec3().to_array();
                opposed += u64::from(point.opposed);
            }
            Ok(opposed)
        };
        let chunks = self.vertices.par_chunks(CHUNK).zip(positions.par_chunks_mut(CHUNK)).map(morph_chunk);
        let opposed = chunks.try_reduce(|| 0, |a, b| Ok(a + b))?;
        let mesh = match self.first.get() {
            Some(first) => Arc::new(first.with_positions(positions)?),
            None => {
                let mesh = self.mesh_of(positions)?;
                mesh.build_bvh(progress)?;
                Arc::clone(self.first.get_or_init(|| mesh))
            }
        };
        self.near_part(mesh, opposed)
    }

    fn mesh_of(&self, positions: Vec<[f32; 3]>) -> Result<Arc<Mesh>> {
        let (objects, materials) = (FaceMap::Uniform(-1), FaceMap::Uniform(-1));
        let faces = try_copy(&self.faces)?;
        Ok(Arc::new(Mesh::new(positions.into(), faces.into(), None, None, objects, materials)?))
    }

    fn near_part(&self, mesh: Arc<Mesh>, opposed: u64) -> Result<NearPart> {
        let instance = Instance::new(mesh, DAffine3::IDENTITY, None)?;
        Ok(NearPart { pieces: Arc::clone(&self.pieces), instance, opposed, bounded: self.bounded })
    }
}
