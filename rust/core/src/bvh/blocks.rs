//! Blocks of four triangles, the contents of leaves.

use glam::Vec3;

use super::wide::{Content, LEAF, Slot, WIDTH};
use crate::base::{Aabb, Result, ensure};

/// Number of triangles in a block.
pub(crate) const LANES: usize = 4;
/// Maximum number of blocks in a leaf.
const MAX_BLOCKS: usize = 8;
/// Number of bits in a leaf reference for its first block; the next three bits are the number of blocks minus one.
const START_BITS: u32 = 28;

/// Up to four triangles. Unused lanes repeat the last triangle.
#[derive(Clone, Debug)]
#[repr(C, align(32))]
pub(crate) struct Block {
    /// Coordinates, indexed by corner, axis and lane.
    pub(crate) corners: [[[f32; LANES]; 3]; 3],
    /// Faces of the mesh, ascending; an unused lane repeats the last face.
    pub(crate) faces: [u32; LANES],
}

/// Returns the blocks of a leaf, decoded from its reference.
#[inline(always)]
pub(crate) fn leaf_blocks(reference: u32) -> std::ops::Range<usize> {
    let start = (reference & ((1 << START_BITS) - 1)) as usize;
    start..start + (reference >> START_BITS & (MAX_BLOCKS as u32 - 1)) as usize + 1
}

/// Fails if a mesh has more triangles than a leaf's reference can address.
pub(crate) fn check_count(faces: usize) -> Result<()> {
    // In the worst case each triangle has a block to itself. A reference of all ones would equal `NO_CHILD`.
    ensure!(faces < 1 << START_BITS, "faces", format!("fewer than {} in one mesh", 1u32 << START_BITS), faces);
    Ok(())
}

/// Appends the blocks of some triangles and returns the slot that refers to them.
pub(crate) fn push_leaf(blocks: &mut Vec<Block>, faces: &[u32], corners: &impl Fn(u32) -> [Vec3; 3]) -> Slot {
    if faces.len() > LANES * MAX_BLOCKS {
        // These triangles share one box, so no tree can separate them, but they are too many for one leaf.
        let part = faces.len().div_ceil(WIDTH).max(LANES * MAX_BLOCKS);
        let parts: Vec<Slot> = faces.chunks(part).map(|part| push_leaf(blocks, part, corners)).collect();
        let bounds = parts.iter().fold(Aabb::EMPTY, |all, part| all.union(&part.bounds));
        return Slot { bounds, content: Content::Many(parts) };
    }
    let start = blocks.len() as u32;
    let mut bounds = Aabb::EMPTY;
    for part in faces.chunks(LANES) {
        let faces = std::array::from_fn(|lane| part[lane.min(part.len() - 1)]);
        let block = Block { corners: [[[0.0; LANES]; 3]; 3], faces }.with_corners(corners);
        bounds = bounds.union(&block.bounds());
        blocks.push(block);
    }
    let count = blocks.len() as u32 - start - 1;
    Slot { bounds, content: Content::Leaf(LEAF | count << START_BITS | start) }
}

impl Block {
    /// Replaces the corners of the block's faces.
    pub(crate) fn with_corners(mut self, corners: &impl Fn(u32) -> [Vec3; 3]) -> Self {
        for (lane, &face) in self.faces.iter().enumerate() {
            for (corner, p) in corners(face).into_iter().enumerate() {
                (0..3).for_each(|axis| self.corners[corner][axis][lane] = p[axis]);
            }
        }
        self
    }

    /// Returns the bounding box of all triangles.
    pub(crate) fn bounds(&self) -> Aabb {
        let mut bounds = Aabb::EMPTY;
        for corner in &self.corners {
            (0..LANES).for_each(|lane| bounds.extend(Vec3::new(corner[0][lane], corner[1][lane], corner[2][lane])));
        }
        bounds
    }

    /// Returns the faces without the repetitions of unused lanes.
    pub(crate) fn distinct_faces(&self) -> &[u32] {
        let last = self.faces[LANES - 1];
        let count = self.faces.iter().position(|&face| face == last).map_or(LANES, |lane| lane + 1);
        &self.faces[..count]
    }
}
