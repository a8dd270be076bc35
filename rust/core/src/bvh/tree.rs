//! Trees over triangles and over instances. obvhs builds binary trees; `Wide` converts them.

use std::sync::Arc;

use glam::Vec3;
use rayon::prelude::*;

use super::binary::build;
use super::blocks::{self, Block, leaf_blocks};
use super::groups::{Groups, MeshArrays};
use super::wide::{Content, LEAF, Slot, Wide};
use crate::base::memory::{room_for, try_collect};
use crate::base::{Aabb, Progress, Result};

/// A tree over the triangles of one mesh.
pub struct Bvh {
    pub(crate) wide: Wide,
    pub(crate) blocks: Vec<Block>,
    pub(crate) bounds: Aabb,
    /// Faces that are left out because the tree has a copy of them: (face in the tree, omitted face), ascending.
    copies: Arc<Vec<(u32, u32)>>,
}

/// A tree over the boxes of instances.
pub struct Tlas {
    pub(crate) wide: Wide,
    pub(crate) order: Vec<u32>,
    pub(crate) bounds: Aabb,
}

/// Memory for building a tree, bytes per box or face, mostly the builder's; measured as growth of the address space.
const BUILD_BYTES: u64 = 320;

/// Maximum number of boxes in a leaf: the number of lanes of a block.
const LEAF_BOXES: u32 = 4;

impl Bvh {
    /// Builds the tree of a mesh with finite triangles.
    pub fn build(mesh: MeshArrays<'_>, progress: &Progress) -> Result<Self> {
        let count = mesh.faces.len();
        blocks::check_count(count)?;
        room_for(BUILD_BYTES * count as u64)?;
        progress.expect(count as u64);
        let groups = Groups::new(mesh, progress)?;
        let tree = build(&groups.boxes, LEAF_BOXES, progress)?;
        let corners = |face: u32| mesh.faces[face as usize].map(|v| Vec3::from(mesh.positions[v as usize]));
        let leaf = |members: &[u32], blocks: &mut Vec<Block>| {
            let mut faces: Vec<u32> = members.iter().flat_map(|&group| groups.faces(group)).copied().collect();
            faces.sort_unstable();
            blocks::push_leaf(blocks, &faces, &corners)
        };
        let (wide, mut blocks) = Wide::convert(&tree, leaf, progress)?;
        blocks.shrink_to_fit();
        let bvh = Self { bounds: wide.bounds(), wide, blocks, copies: Arc::new(groups.copies) };
        debug_assert_eq!(bvh.validate(), Ok(()));
        progress.report(count as u64)?;
        Ok(bvh)
    }

    /// Returns the tree refitted to moved corners. Traversal becomes slower if they move far.
    pub fn refitted(&self, corners: impl Fn(u32) -> [Vec3; 3] + Sync) -> Result<Self> {
        let blocks = try_collect(self.blocks.par_iter().map(|block| block.clone().with_corners(&corners)))?;
        let wide = self.wide.refitted(|leaf| {
            let blocks: &[Block] = blocks.get(leaf_blocks(leaf)).unwrap_or_default();
            blocks.iter().fold(Aabb::EMPTY, |all, block| all.union(&block.bounds()))
        })?;
        Ok(Self { bounds: wide.bounds(), wide, blocks, copies: Arc::clone(&self.copies) })
    }

    /// Appends the omitted copies of the given faces; returns whether there are any.
    pub(crate) fn add_copies(&self, faces: &mut Vec<u32>) -> bool {
        if self.copies.is_empty() {
            return false;
        }
        let count = faces.len();
        for index in 0..count {
            let face = faces[index];
            let first = self.copies.partition_point(|&(in_tree, _)| in_tree < face);
            let copies = self.copies[first..].iter().take_while(|&&(in_tree, _)| in_tree == face);
            faces.extend(copies.map(|&(_, copy)| copy));
        }
        faces.len() > count
    }

    /// Returns the blocks of a leaf; empty for `NO_CHILD`, which a ray with a NaN component may reach.
    #[inline(always)]
    pub(crate) fn leaf(&self, leaf: u32) -> &[Block] {
        self.blocks.get(leaf_blocks(leaf)).unwrap_or_default()
    }

    /// Returns the memory of nodes and triangles, bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.wide.nodes[..]) + size_of_val(&self.blocks[..]) + size_of_val(&self.copies[..])
    }

    /// Checks that each box contains its children and that each face is in one leaf; the error describes the fault.
    pub fn validate(&self) -> Result<(), String> {
        let mut faces = vec![];
        self.wide.validate(|leaf| {
            self.leaf(leaf).iter().fold(Aabb::EMPTY, |all, block| {
                faces.extend_from_slice(block.distinct_faces());
                all.union(&block.bounds())
            })
        })?;
        faces.sort_unstable();
        match faces.windows(2).find(|pair| pair[0] == pair[1]) {
            Some(pair) => Err(format!("face {} is in two leaves", pair[0])),
            None => Ok(()),
        }
    }
}

impl Tlas {
    /// Builds the tree of instance boxes; empty boxes are left out.
    pub fn build(boxes: &[Aabb], progress: &Progress) -> Result<Self> {
        room_for(BUILD_BYTES * boxes.len() as u64)?;
        let filled: Vec<u32> = (0..boxes.len() as u32).filter(|&i| !boxes[i as usize].is_empty()).collect();
        let tree = build(&filled.iter().map(|&i| boxes[i as usize]).collect::<Vec<_>>(), 1, progress)?;
        let leaf = |members: &[u32], order: &mut Vec<u32>| {
            // With at most one box in a leaf, each leaf has one member.
            debug_assert_eq!(members.len(), 1);
            let instance = filled[members[0] as usize];
            order.push(instance);
            Slot { bounds: boxes[instance as usize], content: Content::Leaf(LEAF | (order.len() as u32 - 1)) }
        };
        let (wide, order) = Wide::convert(&tree, leaf, progress)?;
        let tlas = Self { bounds: wide.bounds(), wide, order };
        debug_assert_eq!(tlas.validate(boxes), Ok(()));
        Ok(tlas)
    }

    /// Returns the instance of a leaf; `None` for `NO_CHILD`, which a ray with a NaN component may reach.
    #[inline(always)]
    pub(crate) fn instance(&self, leaf: u32) -> Option<u32> {
        self.order.get((leaf & !LEAF) as usize).copied()
    }

    /// Checks that each box contains the instances below it; the error describes the fault.
    pub fn validate(&self, boxes: &[Aabb]) -> Result<(), String> {
        self.wide.validate(|leaf| self.instance(leaf).map_or(Aabb::EMPTY, |instance| boxes[instance as usize]))
    }
}

impl std::fmt::Debug for Bvh {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Bvh({} nodes, {} blocks)", self.wide.nodes.len(), self.blocks.len())
    }
}

impl std::fmt::Debug for Tlas {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Tlas({} nodes, {} instances)", self.wide.nodes.len(), self.order.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::{Error, random};

    /// Boxes with sides of up to 1 m in a cube of 100 m.
    fn boxes(count: u64) -> Vec<Aabb> {
        let number = |box_: u64, n: u64| random::uniform(7, box_, n) as f32;
        let corner = |b: u64, first: u64| Vec3::new(number(b, first), number(b, first + 1), number(b, first + 2));
        let at = |b, min| Aabb { min, max: min + corner(b, 3) };
        (0..count).map(|b| at(b, 100.0 * corner(b, 0))).collect()
    }

    #[test]
    fn a_tree_of_several_parts_contains_each_box_once() {
        let boxes = boxes(600_000);
        let tlas = Tlas::build(&boxes, &Progress::new()).unwrap();
        assert_eq!(tlas.validate(&boxes), Ok(()));
        let mut order = tlas.order.clone();
        order.sort_unstable();
        assert!(order.into_iter().eq(0..600_000));
    }

    #[test]
    fn a_cancelled_tree_is_an_error() {
        let progress = Progress::new();
        progress.cancel();
        assert_eq!(Tlas::build(&boxes(10), &progress).err(), Some(Error::Cancelled));
    }
}
