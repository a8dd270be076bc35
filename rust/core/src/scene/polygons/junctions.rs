//! Removal of T-junctions: points of an outline in the middle of a triangle's edge.
//!
//! Ear clipping drops points in the middle of straight sides. If a neighbouring face has a corner there and the morph
//! moves that corner, a crack opens.

use std::collections::HashSet;

use crate::base::{Progress, Result};

/// Tolerance for the distance of a point from an edge or from its ends, relative to the edge's length.
const ROUNDING: f64 = 1e-9;

/// Splits triangles at the points on their open edges, which belong neither to the outline nor to a second triangle.
/// Changes nothing if more than `limit` triangles would result. `holes` are the first points of all inner rings.
pub(super) fn split_at_points(
    points: &[[f64; 2]],
    holes: &[u32],
    limit: usize,
    triangles: &mut Vec<[u32; 3]>,
    progress: &Progress,
) -> Result<()> {
    let edges = |face: &[u32; 3]| [[face[0], face[1]], [face[1], face[2]], [face[2], face[0]]];
    let all: HashSet<[u32; 2]> = triangles.iter().flat_map(edges).collect();
    let outline: HashSet<[u32; 2]> = outline_edges(points.len() as u32, holes).collect();
    let is_open =
        |&[a, b]: &[u32; 2]| !all.contains(&[b, a]) && !outline.contains(&[a, b]) && !outline.contains(&[b, a]);
    let mut open: HashSet<[u32; 2]> = all.iter().copied().filter(is_open).collect();
    let mut is_candidate = vec![true; points.len()];
    triangles.iter().flatten().for_each(|&corner| is_candidate[corner as usize] = false);
    open.iter().flatten().for_each(|&corner| is_candidate[corner as usize] = true);
    let candidates = (0..points.len() as u32).filter(|&point| is_candidate[point as usize]);
    let tree = Tree::new(points, candidates.collect());
    let (mut pending, mut split) = (triangles.clone(), Vec::new());
    pending.reverse();
    while let Some(face) = pending.pop() {
        let Some(side) = edges(&face).iter().position(|edge| open.contains(edge)) else {
            split.push(face);
            continue;
        };
        progress.check()?;
        let [a, b, c] = std::array::from_fn(|corner| face[(side + corner) % 3]);
        open.remove(&[a, b]);
        let mut between = tree.points_on_edge([a, b].map(|corner| points[corner as usize]));
        between.sort_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
        between.dedup_by(|next, last| next.0 - last.0 < ROUNDING);
        let ends = between.iter().map(|&(_, point)| point).chain([b]);
        let starts = [a].into_iter().chain(between.iter().map(|&(_, point)| point));
        pending.extend(starts.zip(ends).map(|(start, end)| [start, end, c]));
        if pending.len() + split.len() > limit {
            return Ok(());
        }
    }
    *triangles = split;
    Ok(())
}

/// An implicit k-d tree of points: the median of each range, by x and y in turn, is in the middle of the range.
struct Tree<'a> {
    points: &'a [[f64; 2]],
    order: Vec<u32>,
}

impl<'a> Tree<'a> {
    /// Creates a tree of the points with the numbers `order`.
    fn new(points: &'a [[f64; 2]], mut order: Vec<u32>) -> Self {
        sort_medians(points, &mut order, 0);
        Self { points, order }
    }

    /// Returns the points on an edge, except at its ends: the position along the edge and the number of each.
    fn points_on_edge(&self, edge: [[f64; 2]; 2]) -> Vec<(f64, u32)> {
        let [a, b] = edge;
        let greatest = edge.as_flattened().iter().fold(0.0f64, |greatest, value| greatest.max(value.abs()));
        // Each level of the tree may round once.
        let margin = 2.0 * ROUNDING * (b[0] - a[0]).hypot(b[1] - a[1]) + 64.0 * f64::EPSILON * greatest;
        let mut found = Vec::new();
        let mut ranges = vec![(self.order.as_slice(), 0, edge)];
        while let Some((range, axis, [start, end])) = ranges.pop() {
            let Some((&middle, _)) = range[range.len() / 2..].split_first() else { continue };
            let point = self.points[middle as usize];
            found.extend(place_on_edge([a, b, point]).map(|place| (place, middle)));
            // Points before the median can only lie on the part of the edge before it, points after it on the other.
            let [low, high] = if start[axis] <= end[axis] { [start, end] } else { [end, start] };
            let point_at = |value: f64| {
                let share = (value - low[axis]) / (high[axis] - low[axis]);
                [0, 1].map(|axis| low[axis] + share * (high[axis] - low[axis]))
            };
            let [min, max] = [point[axis] - margin, point[axis] + margin];
            if low[axis] <= max {
                let before = &range[..range.len() / 2];
                ranges.push((before, 1 - axis, [low, if high[axis] > max { point_at(max) } else { high }]));
            }
            if high[axis] >= min {
                let after = &range[range.len() / 2 + 1..];
                ranges.push((after, 1 - axis, [if low[axis] < min { point_at(min) } else { low }, high]));
            }
        }
        found
    }
}

/// Moves the median along `axis` to the middle of `order`, then those of both halves along the other axis, and so on.
fn sort_medians(points: &[[f64; 2]], order: &mut [u32], axis: usize) {
    if order.len() < 2 {
        return;
    }
    let value = |&point: &u32| points[point as usize][axis];
    let (before, _, after) =
        order.select_nth_unstable_by(order.len() / 2, |one, other| value(one).total_cmp(&value(other)));
    sort_medians(points, before, 1 - axis);
    sort_medians(points, after, 1 - axis);
}

/// Returns the edges of rings as pairs of successive points.
fn outline_edges(count: u32, holes: &[u32]) -> impl Iterator<Item = [u32; 2]> {
    let starts = [0].into_iter().chain(holes.iter().copied());
    let ends = holes.iter().copied().chain([count]);
    starts.zip(ends).flat_map(|(start, end)| {
        (start..end).map(move |point| [point, if point + 1 == end { start } else { point + 1 }])
    })
}

/// Returns the position of a point along an edge, from 0 to 1; `None` if the point is off the edge or at an end.
fn place_on_edge([a, b, point]: [[f64; 2]; 3]) -> Option<f64> {
    let (edge, offset) = ([b[0] - a[0], b[1] - a[1]], [point[0] - a[0], point[1] - a[1]]);
    let squared = edge[0] * edge[0] + edge[1] * edge[1];
    let along = (edge[0] * offset[0] + edge[1] * offset[1]) / squared;
    let across = (edge[0] * offset[1] - edge[1] * offset[0]) / squared;
    (along > ROUNDING && along < 1.0 - ROUNDING && across.abs() <= ROUNDING).then_some(along)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::scene::polygons::{Polygons, triangulate};

    /// Ground with square holes that have a point in the middle of each side: all points are corners, and the triangles
    /// have the polygon's area. In the second case no side is parallel to an axis.
    #[test]
    fn a_large_polygon_with_holes_keeps_the_points_of_its_sides() {
        const ACROSS: i64 = 12;
        let square = |x: i64, y: i64, size: i64| {
            [[0, 0], [1, 0], [2, 0], [2, 1], [2, 2], [1, 2], [0, 2], [0, 1]]
                .map(|[right, up]| [(x + right * size) as f64, (y + up * size) as f64])
        };
        let holes = (0..ACROSS * ACROSS).map(|n| square(4 * (n % ACROSS) + 1, 4 * (n / ACROSS) + 1, 1));
        let flat: Vec<[f64; 2]> = [square(0, 0, 2 * ACROSS)].into_iter().chain(holes).flatten().collect();
        let rings: Vec<i64> = (0..=flat.len() as i64 / 8).map(|ring| 8 * ring).collect();
        let hole_count = (ACROSS * ACROSS) as usize;
        for (points, factor) in
            [(flat.clone(), 1.0), (flat.iter().map(|[x, y]| [2.0 * x - y, x + 3.0 * y]).collect(), 7.0)]
        {
            let counts = [0, rings.len() as i64 - 1];
            let polygons = Polygons::new(&points, &rings, &counts).unwrap();
            let found = triangulate(&polygons, &Progress::new()).unwrap().0.faces;
            assert_eq!(found.len(), points.len() + 2 * hole_count - 2);
            let areas = found.iter().map(|face| {
                let [a, b, c] = face.map(|corner| points[corner as usize]);
                ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2.0
            });
            let areas: Vec<f64> = areas.collect();
            assert!(areas.iter().all(|&area| area > 0.0));
            assert_eq!(areas.iter().sum::<f64>(), factor * (16 - 4) as f64 * hole_count as f64);
        }
    }

    #[test]
    fn the_caller_can_cancel() {
        // A triangle, and a point in the middle of a side that is not a corner of it.
        let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
        let progress = Progress::new();
        let mut triangles = vec![[0, 2, 3]];
        split_at_points(&points, &[], 2, &mut triangles, &progress).unwrap();
        assert_eq!(triangles, [[1, 2, 3], [0, 1, 3]]);
        progress.cancel();
        assert!(split_at_points(&points, &[], 2, &mut vec![[0, 2, 3]], &progress).is_err());
    }

    proptest! {
        /// Compares the tree with a search of all points, which lie on a small grid so that many are collinear or equal.
        #[test]
        fn the_tree_finds_all_points_on_an_edge(
            places in proptest::collection::vec((-6..6i8, -6..6i8), 2..80),
            (scale, offset) in (1e-3..1e3f64, -1e6..1e6f64),
        ) {
            let place = |&(x, y): &(i8, i8)| [offset + scale * f64::from(x), scale * f64::from(y) - offset];
            let points: Vec<[f64; 2]> = places.iter().map(place).collect();
            let tree = Tree::new(&points, (0..points.len() as u32).collect());
            for edge in points.windows(2).map(|pair| [pair[0], pair[1]]) {
                let mut found: Vec<u32> = tree.points_on_edge(edge).into_iter().map(|(_, point)| point).collect();
                found.sort_unstable();
                let is_on_edge = |&point: &u32| place_on_edge([edge[0], edge[1], points[point as usize]]).is_some();
                let expected: Vec<u32> = (0..points.len() as u32).filter(is_on_edge).collect();
                prop_assert_eq!(found, expected);
            }
        }
    }
}
