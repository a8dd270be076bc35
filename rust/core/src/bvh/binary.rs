//! Binary trees over boxes. The crate obvhs builds them in cancellable steps of a fraction of a second.

use glam::Vec3;
use obvhs::aabb;
use obvhs::bvh2::node::Bvh2Node;
use obvhs::bvh2::{Bvh2, leaf_collapser::collapse, reinsertion::ReinsertionOptimizer};
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};
use rayon::prelude::*;

use crate::base::{Aabb, Progress, Result};

/// Maximum number of boxes that are clustered at once; this takes a tenth of a second and cannot be cancelled.
const MAX_PART_BOXES: usize = 1 << 18;
/// Number of passes of the optimizer. Pass k = 0, 1, … moves 1 / (2 k + 1) of the number of nodes that pass 0 moves.
const PASSES: usize = 16;
/// Maximum number of nodes that the first pass moves in a tree joined from several parts. The optimizer moves the nodes
/// with the largest boxes, which are near the parts' roots.
const MAX_NODES_NEAR_ROOTS: usize = 1 << 16;

/// Builds the tree. Leaves hold one box each, or up to `leaf_boxes` where that lowers the cost.
pub(super) fn build(boxes: &[Aabb], leaf_boxes: u32, progress: &Progress) -> Result<Bvh2> {
    if boxes.is_empty() {
        return Ok(Bvh2::default());
    }
    let scale = scale_for(boxes);
    let mut members: Vec<Member> =
        boxes.iter().zip(0..).map(|(b, number)| Member { center: b.min * 0.5 + b.max * 0.5, number }).collect();
    let mut parts = vec![];
    split(&mut members, &mut parts, progress)?;
    let trees = parts.into_par_iter().map(|part| {
        let mut tree = cluster(part.iter().map(|member| boxes[member.number as usize]), scale);
        optimize(&mut tree, 0.05, progress)?;
        if leaf_boxes > 1 {
            collapse(&mut tree, leaf_boxes, 3.0);
            optimize(&mut tree, 0.1, progress)?;
        }
        Ok(tree)
    });
    let trees: Vec<Bvh2> = trees.collect::<Result<_>>()?;
    let mut tree = join_trees(trees, progress)?;
    // The joined tree numbers boxes in the order of the parts; restore the caller's numbers.
    tree.primitive_indices.par_iter_mut().for_each(|index| *index = members[*index as usize].number);
    if scale != 1.0 {
        restore_boxes(&mut tree, boxes);
    }
    Ok(tree)
}

/// Centre and number of a box.
struct Member {
    center: Vec3,
    number: u32,
}

/// Splits the boxes at the median along the longest axis until each part can be clustered at once.
fn split<'a>(members: &'a mut [Member], parts: &mut Vec<&'a [Member]>, progress: &Progress) -> Result<()> {
    if members.len() <= MAX_PART_BOXES {
        parts.push(members);
        return Ok(());
    }
    progress.check()?;
    let bounds = Aabb::of_points(members.iter().map(|member| member.center));
    let axis = (bounds.max - bounds.min).max_position();
    let middle = members.len() / 2;
    members.select_nth_unstable_by(middle, |a, b| a.center[axis].total_cmp(&b.center[axis]));
    let (low, high) = members.split_at_mut(middle);
    split(low, parts, progress)?;
    split(high, parts, progress)
}

/// Builds a tree over scaled boxes by clustering.
fn cluster(boxes: impl ExactSizeIterator<Item = Aabb>, scale: f32) -> Bvh2 {
    let boxes: Vec<_> = boxes.map(|b| aabb::Aabb::new((b.min * scale).into(), (b.max * scale).into())).collect();
    let numbers = (0..boxes.len() as u32).collect();
    PlocBuilder::with_capacity(boxes.len()).build(PlocSearchDistance::Medium, &boxes, numbers, SortPrecision::U64, 3)
}

/// Joins trees under one root. Boxes are renumbered in the order of the trees.
fn join_trees(mut trees: Vec<Bvh2>, progress: &Progress) -> Result<Bvh2> {
    if trees.len() == 1 {
        return Ok(trees.remove(0));
    }
    let roots: Vec<Aabb> = trees.iter().map(|tree| bounds(&tree.nodes[0])).collect();
    let mut joined = cluster(roots.into_iter(), 1.0);
    let leaves = joined.nodes.iter().enumerate().filter(|(_, node)| node.is_leaf());
    let leaves: Vec<(usize, u32)> =
        leaves.map(|(leaf, node)| (leaf, joined.primitive_indices[node.first_index as usize])).collect();
    joined.primitive_indices.clear();
    let mut first_box = vec![];
    for tree in &trees {
        let first = joined.primitive_indices.len() as u32;
        joined.primitive_indices.extend(tree.primitive_indices.iter().map(|number| first + number));
        first_box.push(first);
    }
    for (leaf, number) in leaves {
        progress.check()?;
        // A tree's root takes the leaf's place; its other nodes are appended.
        let (first_box, first_node) = (first_box[number as usize], joined.nodes.len() as u32 - 1);
        let renumber = |node: &Bvh2Node| {
            let first = if node.is_leaf() { first_box } else { first_node };
            Bvh2Node::new(*node.aabb(), node.prim_count, first + node.first_index)
        };
        let tree = std::mem::take(&mut trees[number as usize]);
        joined.nodes[leaf] = renumber(&tree.nodes[0]);
        joined.nodes.extend(tree.nodes[1..].iter().map(renumber));
        joined.max_depth = joined.max_depth.max(tree.max_depth);
    }
    let fraction = MAX_NODES_NEAR_ROOTS as f32 / joined.nodes.len() as f32;
    optimize(&mut joined, fraction, progress)?;
    Ok(joined)
}

pub(super) fn bounds(node: &Bvh2Node) -> Aabb {
    Aabb { min: node.aabb().min.into(), max: node.aabb().max.into() }
}

/// Moves nodes within the tree to reduce its cost. The first pass moves `fraction` of all nodes.
fn optimize(tree: &mut Bvh2, fraction: f32, progress: &Progress) -> Result<()> {
    let mut optimizer = ReinsertionOptimizer::default();
    for pass in 0..PASSES {
        progress.check()?;
        optimizer.run(tree, fraction, Some(vec![1.0 / (2 * pass + 1) as f32]));
    }
    progress.check()
}

/// Returns the power of two, usually 1, that scales boxes so that areas neither overflow nor underflow in float32.
fn scale_for(boxes: &[Aabb]) -> f32 {
    let greatest = boxes.iter().map(|b| b.min.abs().max(b.max.abs()).max_element()).fold(0.0, f32::max);
    if greatest == 0.0 || (1e-9..1e12).contains(&greatest) {
        return 1.0;
    }
    // Scaling by a power of two is exact unless boxes far smaller than the largest underflow.
    (-f64::from(greatest).log2().floor()).exp2().clamp(1e-38, 1e38) as f32
}

/// Restores the unscaled boxes of a tree that was built over scaled ones.
fn restore_boxes(tree: &mut Bvh2, boxes: &[Aabb]) {
    for node in tree.nodes.iter_mut().filter(|node| node.is_leaf()) {
        let members = &tree.primitive_indices[node.first_index as usize..][..node.prim_count as usize];
        let bounds = members.iter().fold(Aabb::EMPTY, |hull, &member| hull.union(&boxes[member as usize]));
        node.set_aabb(aabb::Aabb::new(bounds.min.into(), bounds.max.into()));
    }
    tree.refit_all();
}
