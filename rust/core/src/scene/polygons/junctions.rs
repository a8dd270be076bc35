//! Removal of T-junctions: points of an outline in the middle of a triangle's edge.
//!
//! Ear clipping drops points of straight outlines. A neighbouring face may have a corner there; where the morph moves
//! it, a crack would open.

use std::collections::HashSet;

/// Distance from an edge, and from its ends, relative to its length, below which a point is on it.
const ROUNDING: f64 = 1e-9;

/// Splits triangles at points that lie on their edges, unless more than `limit` triangles result. Only edges are split
/// that are neither an edge of the outline nor one of a neighbouring triangle. `holes` are the first points of all
/// rings but the first.
pub(super) fn split_at_points(points: &[[f64; 2]], holes: &[u32], limit: usize, triangles: &mut Vec<[u32; 3]>) {
    let edges = |face: &[u32; 3]| [[face[0], face[1]], [face[1], face[2]], [face[2], face[0]]];
    let all: HashSet<[u32; 2]> = triangles.iter().flat_map(edges).collect();
    let outline: HashSet<[u32; 2]> = outline_edges(points.len() as u32, holes).collect();
    let is_open =
        |&[a, b]: &[u32; 2]| !all.contains(&[b, a]) && !outline.contains(&[a, b]) && !outline.contains(&[b, a]);
    let mut open: HashSet<[u32; 2]> = all.iter().copied().filter(is_open).collect();
    let mut is_candidate = vec![true; points.len()];
    triangles.iter().flatten().for_each(|&corner| is_candidate[corner as usize] = false);
    open.iter().flatten().for_each(|&corner| is_candidate[corner as usize] = true);
    let candidates: Vec<u32> = (0..points.len() as u32).filter(|&point| is_candidate[point as usize]).collect();
    let (mut pending, mut split) = (triangles.clone(), Vec::new());
    pending.reverse();
    while let Some(face) = pending.pop() {
        let Some(side) = edges(&face).iter().position(|edge| open.contains(edge)) else {
            split.push(face);
            continue;
        };
        let [a, b, c] = std::array::from_fn(|corner| face[(side + corner) % 3]);
        open.remove(&[a, b]);
        let place = |&point: &u32| Some((place_on_edge([a, b, point].map(|corner| points[corner as usize]))?, point));
        let mut between: Vec<(f64, u32)> = candidates.iter().filter_map(place).collect();
        between.sort_by(|one, other| one.0.total_cmp(&other.0));
        between.dedup_by(|next, last| next.0 - last.0 < ROUNDING);
        let ends = between.iter().map(|&(_, point)| point).chain([b]);
        let starts = [a].into_iter().chain(between.iter().map(|&(_, point)| point));
        pending.extend(starts.zip(ends).map(|(start, end)| [start, end, c]));
        if pending.len() + split.len() > limit {
            return;
        }
    }
    *triangles = split;
}

/// Returns the edges of rings as pairs of successive points.
fn outline_edges(count: u32, holes: &[u32]) -> impl Iterator<Item = [u32; 2]> {
    let starts = [0].into_iter().chain(holes.iter().copied());
    let ends = holes.iter().copied().chain([count]);
    starts.zip(ends).flat_map(|(start, end)| {
        (start..end).map(move |point| [point, if point + 1 == end { start } else { point + 1 }])
    })
}

/// Returns the place of a point on an edge, from 0 to 1; `None` if it is not on it, or at one of its ends.
fn place_on_edge([a, b, point]: [[f64; 2]; 3]) -> Option<f64> {
    let (edge, offset) = ([b[0] - a[0], b[1] - a[1]], [point[0] - a[0], point[1] - a[1]]);
    let squared = edge[0] * edge[0] + edge[1] * edge[1];
    let along = (edge[0] * offset[0] + edge[1] * offset[1]) / squared;
    let across = (edge[0] * offset[1] - edge[1] * offset[0]) / squared;
    (along > ROUNDING && along < 1.0 - ROUNDING && across.abs() <= ROUNDING).then_some(along)
}
