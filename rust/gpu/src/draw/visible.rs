//! Draw calls of the visible instances and face runs.

use std::collections::{BTreeMap, HashMap};
use std::ops::Range;
use std::sync::Arc;

use nearfar_core::base::Aabb;
use nearfar_core::scene::Instance;

use super::cull::Frustum;
use crate::upload::{CHUNK, InstanceParts, Page};

/// Vertices of a part and the records, in their batch, that place them.
pub(super) struct Drawn {
    pub vertices: Range<u32>,
    pub records: Vec<u32>,
}

/// Visible part of a set: draws by record and part.
pub(super) struct Visible {
    /// Records of each part and vertex run, in order of first appearance.
    calls: Vec<(Arc<Page>, Range<u32>, Vec<u32>)>,
}

impl Visible {
    /// Finds the instances of a set and the runs of their faces that pass a frustum; all without one. If `seen` is
    /// given, the whole picture's half-spaces are not tested again.
    pub fn new(
        instances: &[Instance],
        placed: &[InstanceParts],
        frustum: Option<&Frustum>,
        seen: Option<&[bool]>,
    ) -> Self {
        let sees = |bounds: &Aabb| frustum.is_none_or(|frustum| frustum.sees(bounds));
        let shows = |n: usize, bounds: &Aabb| match seen {
            Some(seen) => seen[n] && frustum.is_none_or(|frustum| frustum.sees_inside_picture(bounds)),
            None => sees(bounds),
        };
        let mut calls: Vec<(Arc<Page>, Range<u32>, Vec<u32>)> = Vec::new();
        // Whole parts of meshes with many placements are drawn with one call.
        let mut whole: HashMap<(u64, u32), usize> = HashMap::new();
        for (n, (instance, InstanceParts { first_record, parts })) in instances.iter().zip(placed).enumerate() {
            if instance.mesh.faces.is_empty() || !shows(n, &instance.bounds) {
                continue;
            }
            for (i, part) in parts.iter().enumerate() {
                let record = first_record + i as u32;
                let end = 3 * part.face_count;
                if part.chunks.len() == 1 {
                    let call = *whole.entry((part.page.number, part.words[1])).or_insert_with(|| {
                        calls.push((Arc::clone(&part.page), 0..end, Vec::new()));
                        calls.len() - 1
                    });
                    calls[call].2.push(record);
                    continue;
                }
                let mut run: Option<Range<u32>> = None;
                for (n, bounds) in part.chunks.iter().enumerate() {
                    let placed = if instance.in_place { *bounds } else { bounds.transformed(&instance.to_scene) };
                    let start = (3 * n * CHUNK) as u32;
                    let stop = end.min(start + (3 * CHUNK) as u32);
                    match (&mut run, sees(&placed)) {
                        (Some(run), true) if run.end == start => run.end = stop,
                        (_, true) => {
                            let before = run.replace(start..stop);
                            calls.extend(before.map(|run| (Arc::clone(&part.page), run, vec![record])));
                        }
                        _ => {}
                    }
                }
                calls.extend(run.map(|run| (Arc::clone(&part.page), run, vec![record])));
            }
        }
        Self { calls }
    }

    /// Removes and returns the draws of a range of records, page by page, with record numbers relative to the range.
    pub fn remove_within(&mut self, range: &Range<u32>) -> Vec<(Arc<Page>, Vec<Drawn>)> {
        let mut pages: BTreeMap<u64, (Arc<Page>, Vec<Drawn>)> = BTreeMap::new();
        for (page, vertices, records) in &mut self.calls {
            let mine: Vec<u32> = records.iter().filter(|r| range.contains(r)).map(|r| r - range.start).collect();
            if !mine.is_empty() {
                let drawn = Drawn { vertices: vertices.clone(), records: mine };
                pages.entry(page.number).or_insert_with(|| (Arc::clone(page), Vec::new())).1.push(drawn);
            }
        }
        pages.into_values().collect()
    }
}
