//! Triangles with their attributes: what instances place in the world.

use std::sync::{Mutex, OnceLock, PoisonError};

use glam::Vec3;
use rayon::prelude::*;

use super::{Aabb, FaceMap};
use crate::base::{Buffer, Error, Progress, Result};
use crate::bvh::Bvh;

/// Faces or vertices handled by one task: fixed, so that reductions do not depend on the number of threads.
const TILE: usize = 1 << 16;

/// An immutable triangle mesh in its own frame.
#[derive(Debug)]
pub struct Mesh {
    /// Vertices, metres.
    pub positions: Buffer<[f32; 3]>,
    /// Three vertices of each triangle, counter-clockwise from outside.
    pub faces: Buffer<[u32; 3]>,
    /// Texture coordinates of each vertex, v upwards.
    pub uvs: Option<Buffer<[f32; 2]>>,
    /// Colour of each vertex, sRGB with linear alpha.
    pub colors: Option<Buffer<[u8; 4]>>,
    /// Object of each face; an instance may override it.
    pub objects: FaceMap,
    /// Material of each face.
    pub materials: FaceMap,
    bounds: Aabb,
    bvh: OnceLock<Bvh>,
    building: Mutex<()>,
}

impl Mesh {
    /// Takes the arrays as they are (no copies) and checks that they fit together.
    pub fn new(
        positions: Buffer<[f32; 3]>,
        faces: Buffer<[u32; 3]>,
        uvs: Option<Buffer<[f32; 2]>>,
        colors: Option<Buffer<[u8; 4]>>,
        objects: FaceMap,
        materials: FaceMap,
    ) -> Result<Self> {
        let vertex_count = positions.len();
        if faces.len() > u32::MAX as usize - 1 || vertex_count > u32::MAX as usize {
            return Err(Error::value("faces", "fewer than 2^32 - 1 faces and vertices in one mesh", faces.len()));
        }
        for (argument, length) in [("uvs", uvs.as_ref().map(|a| a.len())), ("colors", colors.as_ref().map(|a| a.len()))]
        {
            if length.is_some_and(|length| length != vertex_count) {
                return Err(Error::value(
                    argument,
                    format!("one row for each of {vertex_count} vertices"),
                    length.unwrap_or_default(),
                ));
            }
        }
        let greatest = faces.par_chunks(TILE).map(|tile| tile.iter().flatten().copied().max()).max().flatten();
        if greatest.is_some_and(|index| index as usize >= vertex_count) {
            return Err(Error::value(
                "faces",
                format!("vertex indices below {vertex_count}"),
                greatest.unwrap_or_default(),
            ));
        }
        let wrong = count_non_finite(&positions);
        if wrong > 0 {
            return Err(Error::value(
                "vertices",
                "finite coordinates",
                format!("{wrong} vertices with NaN or infinity"),
            ));
        }
        let bounds = bounds_of(&positions);
        let bvh = OnceLock::new();
        Ok(Self { positions, faces, uvs, colors, objects, materials, bounds, bvh, building: Mutex::new(()) })
    }

    /// Box of all vertices.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// Corners of a face.
    #[inline]
    pub fn corners(&self, face: u32) -> [Vec3; 3] {
        self.faces[face as usize].map(|vertex| Vec3::from_array(self.positions[vertex as usize]))
    }

    /// The acceleration structure, where it has been built.
    #[inline]
    pub fn bvh(&self) -> Option<&Bvh> {
        self.bvh.get()
    }

    /// Builds the acceleration structure on first use.
    pub fn build_bvh(&self, progress: &Progress) -> Result<&Bvh> {
        let _one_builder = self.building.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(bvh) = self.bvh.get() {
            return Ok(bvh);
        }
        let bvh = Bvh::build(&self.positions, &self.faces, progress)?;
        Ok(self.bvh.get_or_init(|| bvh))
    }
}

fn count_non_finite(positions: &[[f32; 3]]) -> usize {
    let is_wrong = |p: &&[f32; 3]| !p.iter().all(|x| x.is_finite());
    positions.par_chunks(TILE).map(|tile| tile.iter().filter(is_wrong).count()).sum()
}

fn bounds_of(positions: &[[f32; 3]]) -> Aabb {
    let tile_bounds = |tile: &[[f32; 3]]| {
        let mut bounds = Aabb::EMPTY;
        tile.iter().for_each(|&p| bounds.extend(Vec3::from_array(p)));
        bounds
    };
    positions.par_chunks(TILE).map(tile_bounds).reduce(|| Aabb::EMPTY, |a, b| a.union(&b))
}
