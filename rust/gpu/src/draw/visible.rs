//! Draw calls of the visible instances and face runs.

use std::collections::{BTreeMap, HashMap};
use std::ops::Range;
use std::sync::Arc;

use nearfar_core::base::Aabb;
use nearfar_core::scene::Instance;

use super::cull::Frustum;
use crate::upload::{CHUNK, InstanceParts, Page};

/// Vertices of a part and the records, in their set or batch, that place them.
pub(super) struct DrawCall {
    pub vertices: Range<u32>,
    pub records: Vec<u32>,
}

/// Finds the instances of a set and the runs of their faces that pass a frustum; all without one. If `may_show` is
/// given, the whole picture's half-spaces are not tested again. Returns calls in order of the first appearance of their
/// part, and the pages of their parts.
pub(super) fn visible_calls(
    instances: &[Instance],
    instance_parts: &[InstanceParts],
    frustum: Option<&Frustum>,
    may_show: Option<&[bool]>,
) -> Vec<(Arc<Page>, DrawCall)> {
    let sees = |bounds: &Aabb| frustum.is_none_or(|frustum| frustum.sees(bounds));
    let shows = |n: usize, bounds: &Aabb| match may_show {
        Some(flags) => flags[n] && frustum.is_none_or(|frustum| frustum.sees_inside_picture(bounds)),
        None => sees(bounds),
    };
    let mut calls: Vec<(Arc<Page>, DrawCall)> = Vec::new();
    // Parts without several runs, of meshes that may have many placements, are drawn with one call.
    let mut call_of_part: HashMap<(u64, u32), usize> = HashMap::new();
    for (n, (instance, InstanceParts { first_record, parts })) in instances.iter().zip(instance_parts).enumerate() {
        if instance.mesh.faces.is_empty() || !shows(n, &instance.bounds) {
            continue;
        }
        for (record, part) in (*first_record..).zip(parts.iter()) {
            let end = 3 * part.face_count;
            if part.chunks.len() == 1 {
                let call = *call_of_part.entry((part.page.number, part.words[1])).or_insert_with(|| {
                    calls.push((Arc::clone(&part.page), DrawCall { vertices: 0..end, records: Vec::new() }));
                    calls.len() - 1
                });
                calls[call].1.records.push(record);
                continue;
            }
            let mut run: Option<Range<u32>> = None;
            let call = |vertices| (Arc::clone(&part.page), DrawCall { vertices, records: vec![record] });
            for (chunk, bounds) in part.chunks.iter().enumerate() {
                let placed = if instance.in_place { *bounds } else { bounds.transformed(&instance.to_scene) };
                if !sees(&placed) {
                    continue;
                }
                let start = (3 * chunk * CHUNK) as u32;
                let stop = end.min(start + (3 * CHUNK) as u32);
                match &mut run {
                    Some(run) if run.end == start => run.end = stop,
                    _ => calls.extend(run.replace(start..stop).map(call)),
                }
            }
            calls.extend(run.map(call));
        }
    }
    calls
}

/// Returns the calls of a range of records, page by page, with record numbers relative to the range.
pub(super) fn calls_within(calls: &[(Arc<Page>, DrawCall)], range: &Range<u32>) -> Vec<(Arc<Page>, Vec<DrawCall>)> {
    let mut pages: BTreeMap<u64, (Arc<Page>, Vec<DrawCall>)> = BTreeMap::new();
    for (page, call) in calls {
        let records: Vec<u32> = call.records.iter().filter(|r| range.contains(r)).map(|r| r - range.start).collect();
        if !records.is_empty() {
            let call = DrawCall { vertices: call.vertices.clone(), records };
            pages.entry(page.number).or_insert_with(|| (Arc::clone(page), Vec::new())).1.push(call);
        }
    }
    pages.into_values().collect()
}
