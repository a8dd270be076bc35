//! Triangles of leaves, four side by side.

use glam::Vec3;

use super::wide::{Content, LEAF, Slot, WIDTH};
use crate::base::{Aabb, Error, Result};

/// Triangles of a block.
pub(crate) const LANES: usize = 4;
/// Blocks of a leaf at most.
const MAX_BLOCKS: usize = 8;
/// Bits of a leaf's reference that hold its first block; three more hold the number of blocks less one.
const START_BITS: u32 = 28;

/// Up to four triangles. Unused lanes repeat the last triangle.
#[derive(Clone, Debug)]
#[repr(C, align(32))]
pub(crate) struct Block {
    /// Corner, axis, lane.
    pub(crate) corners: [[[f32; LANES]; 3]; 3],
    /// Faces of the mesh, ascending; repeated where a lane is unused.
    pub(crate) faces: [u32; LANES],
}

/// First block and number of blocks of a leaf.
#[inline(always)]
pub(crate) fn leaf_blocks(reference: u32) -> std::ops::Range<usize> {
    let start = (reference & ((1 << START_BITS) - 1)) as usize;
    start..start + (reference >> START_BITS & (MAX_BLOCKS as u32 - 1)) as usize + 1
}

/// Fails where a mesh has too many triangles to be numbered so.
pub(crate) fn check_count(faces: usize) -> Result<()> {
    // The worst case is a block for each triangle; all ones would look like a place without a child.
    if faces >= 1 << START_BITS {
        return Err(Error::value("faces", format!("fewer than {} in one mesh", 1u32 << START_BITS), faces));
    }
    Ok(())
}

/// Appends the triangles' blocks and returns what stands for them in the tree.
pub(crate) fn push_leaf(blocks: &mut Vec<Block>, faces: &[u32], corners: &impl Fn(u32) -> [Vec3; 3]) -> Slot {
    if faces.len() > LANES * MAX_BLOCKS {
        // Many triangles with one and the same box: no tree can tell them apart.
        let part = faces.len().div_ceil(WIDTH).max(LANES * MAX_BLOCKS);
        let parts: Vec<Slot> = faces.chunks(part).map(|part| push_leaf(blocks, part, corners)).collect();
        let bounds = parts.iter().fold(Aabb::EMPTY, |all, part| all.union(&part.bounds));
        return Slot { bounds, content: Content::Many(parts) };
    }
    let start = blocks.len() as u32;
    let mut bounds = Aabb::EMPTY;
    for part in faces.chunks(LANES) {
        let mut block = Block { corners: [[[0.0; LANES]; 3]; 3], faces: [0; LANES] };
        for lane in 0..LANES {
            let face = part[lane.min(part.len() - 1)];
            block.faces[lane] = face;
            for (corner, p) in corners(face).into_iter().enumerate() {
                bounds.extend(p);
                (0..3).for_each(|axis| block.corners[corner][axis][lane] = p[axis]);
            }
        }
        blocks.push(block);
    }
    let count = blocks.len() as u32 - start - 1;
    Slot { bounds, content: Content::Leaf(LEAF | count << START_BITS | start) }
}

impl Block {
    /// Box of all triangles.
    pub(crate) fn bounds(&self) -> Aabb {
        let mut bounds = Aabb::EMPTY;
        for corner in &self.corners {
            (0..LANES).for_each(|lane| bounds.extend(Vec3::new(corner[0][lane], corner[1][lane], corner[2][lane])));
        }
        bounds
    }

    /// Its faces without repetitions.
    pub(crate) fn distinct_faces(&self) -> &[u32] {
        let last = self.faces[LANES - 1];
        let count = self.faces.iter().position(|&face| face == last).map_or(LANES, |at| at + 1);
        &self.faces[..count]
    }
}
