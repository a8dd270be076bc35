//! Both kinds of trees. obvhs builds binary trees; `Wide` converts them to eight children per node.

use glam::Vec3;
use obvhs::aabb;
use obvhs::bvh2::{Bvh2, leaf_collapser::collapse, reinsertion::ReinsertionOptimizer};
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};

use super::blocks::{self, Block, leaf_blocks};
use super::groups::{Groups, MeshArrays};
use super::wide::{Content, LEAF, Slot, Wide};
use crate::base::{Aabb, Progress, Result};

/// A tree over the triangles of one mesh.
pub struct Bvh {
    pub(crate) wide: Wide,
    pub(crate) blocks: Vec<Block>,
    pub(crate) bounds: Aabb,
}

/// A tree over the boxes of instances.
pub struct Tlas {
    pub(crate) wide: Wide,
    pub(crate) order: Vec<u32>,
    pub(crate) bounds: Aabb,
}

/// Greatest number of boxes in a leaf: the number of lanes of a block.
const LEAF_BOXES: u32 = 4;

impl Bvh {
    /// Builds the tree of a mesh with finite triangles.
    pub fn build(mesh: MeshArrays<'_>, progress: &Progress) -> Result<Self> {
        let count = mesh.faces.len();
        blocks::check_count(count)?;
        progress.expect(count as u64);
        let groups = Groups::new(mesh, progress)?;
        let tree = build(&groups.boxes, LEAF_BOXES, progress)?;
        let corners = |face: u32| mesh.faces[face as usize].map(|v| Vec3::from(mesh.positions[v as usize]));
        let mut blocks = Vec::with_capacity(count / 3);
        let wide = Wide::convert(&tree, |members| {
            let mut faces: Vec<u32> = members.iter().flat_map(|&group| groups.faces(group)).copied().collect();
            faces.sort_unstable();
            blocks::push_leaf(&mut blocks, &faces, &corners)
        });
        blocks.shrink_to_fit();
        let bvh = Self { bounds: wide.bounds(), wide, blocks };
        debug_assert_eq!(bvh.validate(), Ok(()));
        progress.report(count as u64)?;
        Ok(bvh)
    }

    /// The blocks of a leaf; empty for `NO_CHILD`, which a ray with NaN may appear to hit.
    #[inline(always)]
    pub(crate) fn leaf(&self, leaf: u32) -> &[Block] {
        self.blocks.get(leaf_blocks(leaf)).unwrap_or_default()
    }

    /// Memory of nodes and triangles, bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.wide.nodes[..]) + size_of_val(&self.blocks[..])
    }

    /// Checks that each box contains its children and that each face is in one leaf; the error describes the fault.
    pub fn validate(&self) -> Result<(), String> {
        let mut seen = vec![];
        self.wide.validate(|leaf| {
            self.leaf(leaf).iter().fold(Aabb::EMPTY, |all, block| {
                seen.extend_from_slice(block.distinct_faces());
                all.union(&block.bounds())
            })
        })?;
        seen.sort_unstable();
        match seen.windows(2).find(|pair| pair[0] == pair[1]) {
            Some(pair) => Err(format!("face {} is in two leaves", pair[0])),
            None => Ok(()),
        }
    }
}

impl Tlas {
    /// Builds the tree of instance boxes; empty boxes are left out.
    pub fn build(boxes: &[Aabb], progress: &Progress) -> Result<Self> {
        let filled: Vec<u32> = (0..boxes.len() as u32).filter(|&i| !boxes[i as usize].is_empty()).collect();
        let tree = build(&filled.iter().map(|&i| boxes[i as usize]).collect::<Vec<_>>(), 1, progress)?;
        let mut order = Vec::with_capacity(filled.len());
        let wide = Wide::convert(&tree, |members| {
            let slots = members.iter().map(|&member| {
                let instance = filled[member as usize];
                order.push(instance);
                Slot { bounds: boxes[instance as usize], content: Content::Leaf(LEAF | (order.len() as u32 - 1)) }
            });
            let mut slots: Vec<Slot> = slots.collect();
            if slots.len() == 1 {
                return slots.remove(0);
            }
            let bounds = slots.iter().fold(Aabb::EMPTY, |all, slot| all.union(&slot.bounds));
            Slot { bounds, content: Content::Many(slots) }
        });
        let tlas = Self { bounds: wide.bounds(), wide, order };
        debug_assert_eq!(tlas.validate(boxes), Ok(()));
        Ok(tlas)
    }

    /// The instance of a leaf; `None` for `NO_CHILD`, which a ray with NaN may appear to hit.
    #[inline(always)]
    pub(crate) fn instance(&self, leaf: u32) -> Option<u32> {
        self.order.get((leaf & !LEAF) as usize).copied()
    }

    /// Checks that each box contains the instances below it; the error describes the fault.
    pub fn validate(&self, boxes: &[Aabb]) -> Result<(), String> {
        self.wide.validate(|leaf| self.instance(leaf).map_or(Aabb::EMPTY, |instance| boxes[instance as usize]))
    }
}

/// Builds the binary tree. The caller can cancel only between its steps, because obvhs has no finer progress.
fn build(boxes: &[Aabb], leaf_boxes: u32, progress: &Progress) -> Result<Bvh2> {
    if boxes.is_empty() {
        return Ok(Bvh2::default());
    }
    let scale = scale_for(boxes);
    let scaled: Vec<aabb::Aabb> =
        boxes.iter().map(|b| aabb::Aabb::new((b.min * scale).into(), (b.max * scale).into())).collect();
    let numbers = (0..boxes.len() as u32).collect();
    let mut tree = PlocBuilder::with_capacity(boxes.len()).build(
        PlocSearchDistance::Medium,
        &scaled,
        numbers,
        SortPrecision::U64,
        3,
    );
    drop(scaled);
    progress.check()?;
    let mut optimizer = ReinsertionOptimizer::default();
    optimizer.run(&mut tree, 0.05, None);
    progress.check()?;
    if leaf_boxes > 1 {
        collapse(&mut tree, leaf_boxes, 3.0);
        progress.check()?;
        optimizer.run(&mut tree, 0.1, None);
    }
    if scale != 1.0 {
        restore(&mut tree, boxes);
    }
    Ok(tree)
}

/// A power of two that scales boxes so that their areas neither overflow nor underflow in float32; usually 1.
fn scale_for(boxes: &[Aabb]) -> f32 {
    let greatest = boxes.iter().map(|b| b.min.abs().max(b.max.abs()).max_element()).fold(0.0, f32::max);
    if greatest == 0.0 || (1e-9..1e12).contains(&greatest) {
        return 1.0;
    }
    // A power of two scales exactly, so only boxes far smaller than the greatest lose digits.
    (-f64::from(greatest).log2().floor()).exp2().clamp(1e-38, 1e38) as f32
}

/// Restores the unscaled boxes of a tree that was built over scaled ones.
fn restore(tree: &mut Bvh2, boxes: &[Aabb]) {
    for node in tree.nodes.iter_mut().filter(|node| node.is_leaf()) {
        let members = &tree.primitive_indices[node.first_index as usize..][..node.prim_count as usize];
        let bounds = members.iter().fold(Aabb::EMPTY, |all, &member| all.union(&boxes[member as usize]));
        node.set_aabb(aabb::Aabb::new(bounds.min.into(), bounds.max.into()));
    }
    tree.refit_all();
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
