//! Trees with eight children per node. One vector holds the same plane of all eight children's boxes.

use obvhs::bvh2::Bvh2;

use crate::base::Aabb;

/// Number of children of a node.
pub(crate) const WIDTH: usize = 8;
/// Bit that marks a child as a leaf; the other bits belong to the tree's owner.
pub(crate) const LEAF: u32 = 1 << 31;
/// Marks an unused child slot; no ray hits its box.
pub(crate) const NO_CHILD: u32 = u32::MAX;

/// Boxes and references of up to eight children.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct Node {
    /// Planes of the children's boxes: least x, greatest x, least y, …
    pub(crate) planes: [[f32; WIDTH]; 6],
    /// Number of a node, or reference to a leaf with the bit `LEAF`.
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

    /// The box of a child.
    pub(crate) fn bounds(&self, slot: usize) -> Aabb {
        let plane = |side: usize| std::array::from_fn::<f32, 3, _>(|axis| self.planes[2 * axis + side][slot]);
        Aabb { min: plane(0).into(), max: plane(1).into() }
    }
}

/// A tree with eight children per node; node 0 is the root. An empty tree has no nodes.
#[derive(Default)]
pub(crate) struct Wide {
    pub(crate) nodes: Vec<Node>,
    /// Greatest number of stack entries of a depth-first traversal.
    pub(crate) stack: usize,
}

/// An inner node of the binary tree, or a leaf, that becomes a child of a wide node.
pub(crate) struct Slot {
    pub(crate) bounds: Aabb,
    /// A node to open, or a finished leaf.
    pub(crate) content: Content,
}

/// The content of a `Slot`.
pub(crate) enum Content {
    /// Number of a node of the binary tree.
    Inner(u32),
    /// Reference to a leaf.
    Leaf(u32),
    /// Several leaves in one slot, because the binary tree's leaf has more triangles than one leaf can hold.
    Many(Vec<Slot>),
}

impl Wide {
    /// Converts a binary tree. Each wide node opens the child with the largest box until it has eight children, as
    /// Embree does. `leaf` converts a leaf of the binary tree to a slot.
    pub(crate) fn convert(tree: &Bvh2, mut leaf: impl FnMut(&[u32]) -> Slot) -> Self {
        let mut wide = Self::default();
        if tree.nodes.is_empty() {
            return wide;
        }
        let mut slot = |index: u32| {
            let node = &tree.nodes[index as usize];
            if node.is_leaf() {
                let first = node.first_index as usize;
                return leaf(&tree.primitive_indices[first..first + node.prim_count as usize]);
            }
            let bounds = Aabb { min: node.aabb().min.into(), max: node.aabb().max.into() };
            Slot { bounds, content: Content::Inner(index) }
        };
        // Pending wide nodes: the slots to open, the node and slot that refer to it, and its depth.
        let mut pending = vec![(vec![slot(0)], None, 1usize)];
        let mut depth = 0;
        while let Some((mut slots, place, level)) = pending.pop() {
            depth = depth.max(level);
            open(&mut slots, |index| {
                let first = tree.nodes[index as usize].first_index;
                [slot(first), slot(first + 1)]
            });
            let number = wide.nodes.len() as u32;
            let mut node = Node::EMPTY;
            // In reverse order, because the last pending node is opened first; so children follow their parent in
            // order.
            for (at, slot) in slots.into_iter().enumerate().rev() {
                match slot.content {
                    Content::Leaf(reference) => node.set(at, &slot.bounds, reference),
                    content => {
                        node.set(at, &slot.bounds, NO_CHILD);
                        let inside = match content {
                            Content::Many(inside) => inside,
                            content => vec![Slot { bounds: slot.bounds, content }],
                        };
                        pending.push((inside, Some((number, at)), level + 1));
                    }
                }
            }
            wide.nodes.push(node);
            if let Some((parent, at)) = place {
                let parent: &mut Node = &mut wide.nodes[parent as usize];
                parent.children[at] = number;
            }
        }
        wide.stack = depth * (WIDTH - 1) + 1;
        wide
    }

    /// The bounding box of the tree.
    pub(crate) fn bounds(&self) -> Aabb {
        let root = self.nodes.first().unwrap_or(&Node::EMPTY);
        (0..WIDTH).fold(Aabb::EMPTY, |all, slot| all.union(&root.bounds(slot)))
    }

    /// Checks that each child lies inside its slot's box and is referred to once; the error describes the fault. `leaf`
    /// returns the box of a leaf's contents.
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
                    (0..WIDTH).fold(Aabb::EMPTY, |all, slot| all.union(&node.bounds(slot)))
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

/// Replaces the slot with the largest box by its two children until there are eight slots or none can be opened.
fn open(slots: &mut Vec<Slot>, mut children: impl FnMut(u32) -> [Slot; 2]) {
    let area = |bounds: &Aabb| {
        let size = bounds.max - bounds.min;
        size.x * size.y + size.y * size.z + size.z * size.x
    };
    while slots.len() < WIDTH {
        let candidates = slots.iter().enumerate().filter_map(|(at, slot)| match slot.content {
            Content::Inner(index) => Some((at, index, area(&slot.bounds))),
            _ => None,
        });
        let Some((at, index, _)) = candidates.max_by(|a, b| a.2.total_cmp(&b.2)) else { return };
        let [first, second] = children(index);
        slots[at] = first;
        slots.push(second);
    }
}
