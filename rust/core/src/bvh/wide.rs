//! Trees with eight children per node. One SIMD vector holds the same plane of all eight boxes.

use obvhs::bvh2::Bvh2;
use rayon::prelude::*;

use super::binary::bounds;
use crate::base::memory::try_concat;
use crate::base::{Aabb, Progress, Result};

/// Number of children of a node.
pub(crate) const WIDTH: usize = 8;
/// Bit that marks a child as a leaf. The owner of the tree defines the other bits.
pub(crate) const LEAF: u32 = 1 << 31;
/// Marks an unused child slot; no ray hits its box.
pub(crate) const NO_CHILD: u32 = u32::MAX;
/// Trees with more binary nodes are converted in parallel.
const PARALLEL_NODES: usize = 1 << 17;
/// Number of levels that one thread converts first; the hundreds of subtrees below are then converted in parallel.
const TOP_LEVELS: usize = 3;
/// Nodes between two checks for cancellation.
const NODES_PER_CHECK: usize = 1 << 10;

/// Boxes and references of up to eight children.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct Node {
    /// Planes of the children's boxes: minimum x, maximum x, minimum y, …
    pub(crate) planes: [[f32; WIDTH]; 6],
    /// Node number, or leaf reference with the bit `LEAF`.
    pub(crate) children: [u32; WIDTH],
}

impl Node {
    /// A node without children: every box runs from +∞ to −∞, which no ray hits.
    const EMPTY: Self = {
        let (low, high) = ([f32::INFINITY; WIDTH], [f32::NEG_INFINITY; WIDTH]);
        Self { planes: [low, high, low, high, low, high], children: [NO_CHILD; WIDTH] }
    };

    fn set(&mut self, slot: usize, bounds: &Aabb, child: u32) {
        for axis in 0..3 {
            self.planes[2 * axis][slot] = bounds.min[axis];
            self.planes[2 * axis + 1][slot] = bounds.max[axis];
        }
        self.children[slot] = child;
    }

    /// Returns the box of a child.
    pub(crate) fn bounds(&self, slot: usize) -> Aabb {
        let plane = |side: usize| std::array::from_fn::<f32, 3, _>(|axis| self.planes[2 * axis + side][slot]);
        Aabb { min: plane(0).into(), max: plane(1).into() }
    }

    /// Returns the bounding box of all children.
    fn hull(&self) -> Aabb {
        (0..WIDTH).fold(Aabb::EMPTY, |all, slot| all.union(&self.bounds(slot)))
    }
}

/// A tree with eight children per node; node 0 is the root. An empty tree has no nodes.
#[derive(Default)]
pub(crate) struct Wide {
    pub(crate) nodes: Vec<Node>,
    /// Maximum number of stack entries of a depth-first traversal.
    pub(crate) stack: usize,
}

/// Child of a wide node during conversion.
pub(crate) struct Slot {
    pub(crate) bounds: Aabb,
    pub(crate) content: Content,
}

/// Content of a `Slot`.
pub(crate) enum Content {
    /// Number of a node of the binary tree.
    Inner(u32),
    /// Reference to a leaf.
    Leaf(u32),
    /// Several leaves in one slot, because the binary tree's leaf has more triangles than one leaf can hold.
    Many(Vec<Slot>),
}

impl Wide {
    /// Converts a binary tree; also returns the contents of its leaves. As in Embree, a wide node replaces its child
    /// with the largest box by that child's children until it has eight. `leaf` converts a leaf of the binary tree: it
    /// appends the contents to a list and returns a slot. References in the slot consist of `LEAF`, an index into this
    /// list in the low bits, and bits above it that `leaf` chooses.
    pub(crate) fn convert<B: Send>(
        tree: &Bvh2,
        leaf: impl Fn(&[u32], &mut Vec<B>) -> Slot + Sync,
        progress: &Progress,
    ) -> Result<(Self, Vec<B>)> {
        if tree.nodes.is_empty() {
            return Ok((Self::default(), vec![]));
        }
        let levels = if tree.nodes.len() > PARALLEL_NODES { TOP_LEVELS } else { usize::MAX };
        let mut all = Piece::new(tree, 0, levels, &leaf, progress)?;
        let subtrees = std::mem::take(&mut all.subtrees);
        let pieces = subtrees.par_iter().map(|subtree| Piece::new(tree, subtree.root, usize::MAX, &leaf, progress));
        let pieces: Vec<Piece<B>> = pieces.collect::<Result<_>>()?;
        all.nodes.reserve_exact(pieces.iter().map(|piece| piece.nodes.len()).sum());
        all.contents.reserve_exact(pieces.iter().map(|piece| piece.contents.len()).sum());
        for (subtree, piece) in subtrees.into_iter().zip(pieces) {
            progress.check()?;
            all.join(subtree, piece);
        }
        Ok((Self { nodes: all.nodes, stack: all.depth * (WIDTH - 1) + 1 }, all.contents))
    }

    /// Returns the tree with refitted boxes; `leaf` returns the box of a leaf's contents.
    pub(crate) fn refitted(&self, leaf: impl Fn(u32) -> Aabb + Sync) -> Result<Self> {
        let mut nodes = try_concat(&[&self.nodes])?;
        nodes.par_iter_mut().for_each(|node| {
            for (slot, child) in node.children.into_iter().enumerate() {
                if child != NO_CHILD && child & LEAF != 0 {
                    node.set(slot, &leaf(child), child);
                }
            }
        });
        // Children follow their parents, so this loop runs bottom-up.
        for number in (0..nodes.len()).rev() {
            for slot in 0..WIDTH {
                let child = nodes[number].children[slot];
                if child & LEAF == 0 {
                    let inner = nodes[child as usize].hull();
                    nodes[number].set(slot, &inner, child);
                }
            }
        }
        Ok(Self { nodes, stack: self.stack })
    }

    /// Returns the bounding box of the tree.
    pub(crate) fn bounds(&self) -> Aabb {
        self.nodes.first().map_or(Aabb::EMPTY, Node::hull)
    }

    /// Checks that each child lies inside its slot's box and that each node is referenced once; the error describes the
    /// fault. `leaf` returns the box of a leaf's contents.
    pub(crate) fn validate(&self, mut leaf: impl FnMut(u32) -> Aabb) -> Result<(), String> {
        let mut references = vec![0u32; self.nodes.len()];
        for (number, node) in self.nodes.iter().enumerate() {
            for (slot, &child) in node.children.iter().enumerate() {
                let outer = node.bounds(slot);
                if child == NO_CHILD {
                    if outer != Aabb::EMPTY {
                        return Err(format!("node {number}, slot {slot}: a box without a child"));
                    }
                    continue;
                }
                let inner = if child & LEAF != 0 {
                    leaf(child)
                } else {
                    let Some(node) = self.nodes.get(child as usize) else {
                        return Err(format!("node {number}, slot {slot}: refers to {child}"));
                    };
                    references[child as usize] += 1;
                    node.hull()
                };
                if outer.union(&inner) != outer {
                    return Err(format!("node {number}, slot {slot}: {inner:?} is not inside {outer:?}"));
                }
            }
        }
        match references.iter().enumerate().find(|&(number, &count)| count != u32::from(number > 0)) {
            Some((number, count)) => Err(format!("node {number} is referred to {count} times")),
            None => Ok(()),
        }
    }
}

/// A part of a tree that one thread converts. Its node numbers and content indices begin at 0.
struct Piece<B> {
    nodes: Vec<Node>,
    contents: Vec<B>,
    depth: usize,
    /// Subtrees that other threads convert.
    subtrees: Vec<Subtree>,
}

/// A subtree: its root in the binary tree, the wide node and slot that refer to it, and the level of its root.
struct Subtree {
    root: u32,
    parent: (u32, usize),
    level: usize,
}

impl<B> Piece<B> {
    /// Converts the top levels of a subtree of the binary tree. Inner nodes below them become entries of `subtrees`.
    fn new(
        tree: &Bvh2,
        root: u32,
        levels: usize,
        leaf: &impl Fn(&[u32], &mut Vec<B>) -> Slot,
        progress: &Progress,
    ) -> Result<Self> {
        let mut piece = Self { nodes: vec![], contents: vec![], depth: 0, subtrees: vec![] };
        let slot = |index: u32, contents: &mut Vec<B>| {
            let node = &tree.nodes[index as usize];
            if node.is_leaf() {
                let first = node.first_index as usize;
                return leaf(&tree.primitive_indices[first..first + node.prim_count as usize], contents);
            }
            Slot { bounds: bounds(node), content: Content::Inner(index) }
        };
        // Pending wide nodes: slots to open, the node and slot that refer to the pending node, and its level.
        let mut pending = vec![(vec![slot(root, &mut piece.contents)], None, 1usize)];
        while let Some((mut slots, parent, level)) = pending.pop() {
            piece.depth = piece.depth.max(level);
            open(&mut slots, |index| {
                let first = tree.nodes[index as usize].first_index;
                [slot(first, &mut piece.contents), slot(first + 1, &mut piece.contents)]
            });
            let number = piece.nodes.len() as u32;
            if (number as usize).is_multiple_of(NODES_PER_CHECK) {
                progress.check()?;
            }
            let mut node = Node::EMPTY;
            // In reverse, because the last pending node is converted first: so children are stored in slot order.
            for (index, slot) in slots.into_iter().enumerate().rev() {
                let (bounds, parent) = (slot.bounds, (number, index));
                let child = if let Content::Leaf(reference) = slot.content { reference } else { NO_CHILD };
                node.set(index, &bounds, child);
                match slot.content {
                    Content::Leaf(_) => (),
                    Content::Inner(root) if level >= levels => {
                        piece.subtrees.push(Subtree { root, parent, level: level + 1 });
                    }
                    Content::Inner(_) => pending.push((vec![slot], Some(parent), level + 1)),
                    Content::Many(slots) => pending.push((slots, Some(parent), level + 1)),
                }
            }
            piece.nodes.push(node);
            if let Some((parent, index)) = parent {
                let parent: &mut Node = &mut piece.nodes[parent as usize];
                parent.children[index] = number;
            }
        }
        Ok(piece)
    }

    /// Appends a subtree and stores its number in the node that refers to it.
    fn join(&mut self, subtree: Subtree, piece: Self) {
        let (first_node, first_content) = (self.nodes.len() as u32, self.contents.len() as u32);
        let (parent, slot) = subtree.parent;
        self.nodes[parent as usize].children[slot] = first_node;
        self.nodes.extend(piece.nodes.into_iter().map(|mut node| {
            for child in node.children.iter_mut().filter(|child| **child != NO_CHILD) {
                *child += if *child & LEAF == 0 { first_node } else { first_content };
            }
            node
        }));
        self.contents.extend(piece.contents);
        self.depth = self.depth.max(subtree.level - 1 + piece.depth);
    }
}

/// Replaces the slot with the largest box by its two children until there are eight slots or none can be opened.
fn open(slots: &mut Vec<Slot>, mut children: impl FnMut(u32) -> [Slot; 2]) {
    let area = |bounds: &Aabb| {
        let size = bounds.max - bounds.min;
        size.x * size.y + size.y * size.z + size.z * size.x
    };
    while slots.len() < WIDTH {
        let candidates = slots.iter().enumerate().filter_map(|(number, slot)| match slot.content {
            Content::Inner(node) => Some((number, node, area(&slot.bounds))),
            _ => None,
        });
        let Some((number, node, _)) = candidates.max_by(|a, b| a.2.total_cmp(&b.2)) else { return };
        let [first, second] = children(node);
        slots[number] = first;
        slots.push(second);
    }
}
