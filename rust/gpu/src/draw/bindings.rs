//! What a frame's batches draw and what is bound for them.

use std::collections::{BTreeMap, HashMap};
use std::ops::Range;
use std::sync::Arc;

use bytemuck::{Pod, Zeroable};
use nearfar_core::base::Aabb;
use nearfar_core::scene::Instance;

use super::slots::BLOCK;
use super::{Frustum, Kind, Layer, Picture, Set};
use crate::upload::{CHUNK, InstanceParts, PART_WORDS, Page, RECORD_WORDS};

/// The uniform block `Batch` of `scene.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct BatchBlock {
    records: [u32; 4],
    shifts: [u32; 4],
    record: [u32; RECORD_WORDS],
    part: [u32; PART_WORDS],
}

/// Where a batch's records are.
#[derive(Clone)]
pub(super) enum RecordsAt {
    /// In a buffer of their own.
    Buffer(Arc<wgpu::Buffer>),
    /// Among what shaders are told.
    Told(Range<usize>),
}

/// Triangles of one page placed by one batch of records, drawn in a layer's way.
pub(super) struct Group {
    pub layer: usize,
    pub page: Arc<Page>,
    pub records: RecordsAt,
    pub calls: Vec<Call>,
    /// Where its uniform block is told.
    pub block: usize,
    /// All pixels of its batch show one record.
    pub single: bool,
}

/// A draw call.
pub(super) struct Call {
    pub vertices: Range<u32>,
    /// Places in the order; without a meaning where the block tells the one record.
    pub instances: Range<u32>,
    /// Where a uniform block with the call's part and first record is told.
    pub block: usize,
    /// That is its only record.
    pub single: bool,
}

/// Consecutive records of one layer, numbered through the frame.
#[derive(Clone, Debug)]
pub(super) struct Numbering {
    pub layer: usize,
    /// Its first number in the frame.
    pub first: u32,
    pub count: u32,
    /// Its first record in the layer's set.
    pub first_in_set: u32,
}

/// All that a frame draws and tells.
pub(super) struct Plan {
    pub groups: Vec<Group>,
    pub numbering: Vec<Numbering>,
    /// What shaders are told; passes stand first.
    pub told: Vec<u8>,
    /// Where the block of a batch without records is told: it resolves pixels that show nothing.
    pub empty: usize,
    /// Places of the order.
    pub order: Range<usize>,
    pub triangles: u64,
}

impl Plan {
    /// Plans what a view sees of layers; `passes` blocks of room are left at the beginning.
    pub fn new(picture: &Picture, frusta: impl Fn(Kind) -> Option<Frustum>, passes: usize) -> Self {
        let empty = passes * BLOCK * PASS_BLOCKS;
        let mut plan =
            Self { groups: Vec::new(), numbering: Vec::new(), told: vec![0; empty], empty, order: 0..0, triangles: 0 };
        let nothing = BatchBlock { records: [0, 0, u32::MAX, 1], ..BatchBlock::zeroed() };
        plan.told.extend_from_slice(bytemuck::bytes_of(&nothing));
        let mut order: Vec<u32> = Vec::new();
        for (number, layer) in picture.layers.iter().enumerate() {
            plan.add(number, layer, frusta(layer.kind).as_ref(), &mut order);
        }
        plan.let_first_write(picture);
        plan.align();
        let start = plan.told.len();
        order.push(0);
        plan.told.extend_from_slice(bytemuck::cast_slice(&order));
        plan.order = start..plan.told.len();
        plan
    }

    fn add(&mut self, number: usize, layer: &Layer, frustum: Option<&Frustum>, order: &mut Vec<u32>) {
        let (set, instances) = match layer.set {
            Set::Standing => (&layer.tables.standing, layer.scene.standing.instances()),
            Set::Moving => (&layer.tables.moving, layer.scene.moving.instances()),
        };
        let batches: Vec<(RecordsAt, u32, u32)> = match layer.set {
            Set::Standing => {
                let one = |r: &crate::upload::Records| (RecordsAt::Buffer(Arc::clone(&r.buffer)), r.first, r.count);
                layer.tables.records.iter().map(one).collect()
            }
            Set::Moving if instances.is_empty() => Vec::new(),
            Set::Moving => {
                self.align();
                let (words, start) = (set.record_words(instances), self.told.len());
                self.told.extend_from_slice(bytemuck::cast_slice(&words));
                let count = (words.len() / RECORD_WORDS) as u32;
                vec![(RecordsAt::Told(start..self.told.len()), 0, count)]
            }
        };
        let mut visible = visible_draws(instances, &set.instances, frustum);
        for (records, first_in_set, count) in batches {
            let first = self.numbering.last().map_or(0, |last| last.first + last.count);
            self.numbering.push(Numbering { layer: number, first, count, first_in_set });
            let range = first_in_set..first_in_set + count;
            for (page, draws) in visible.remove_within(&range) {
                self.push(number, layer, (page, records.clone()), (first, count, first_in_set), draws, order);
            }
        }
    }

    fn push(
        &mut self,
        layer_number: usize,
        layer: &Layer,
        (page, records): (Arc<Page>, RecordsAt),
        (first, count, first_in_set): (u32, u32, u32),
        draws: Vec<Drawn>,
        order: &mut Vec<u32>,
    ) {
        let shift = layer.tables.materials.texels.shift;
        let block = BatchBlock {
            records: [first, count, page.number as u32, 0],
            shifts: [shift, 0, 0, 0],
            record: [0; RECORD_WORDS],
            part: [0; PART_WORDS],
        };
        let tell_first = |plan: &mut Self, local: u32| {
            let record = layer.record(first_in_set + local);
            let part = layer.tables.part_of(&record);
            plan.tell(&BatchBlock { shifts: [shift, local, 0, 0], record, part, ..block })
        };
        let at = if count == 1 { tell_first(self, 0) } else { self.tell(&block) };
        let (mut calls, mut last) = (Vec::with_capacity(draws.len()), None);
        for Drawn { vertices, records } in draws {
            self.triangles += u64::from(vertices.end - vertices.start) / 3 * records.len() as u64;
            // All records of a call place one part. Looking it up for every vertex takes longer than telling it once.
            let known =
                if count == 1 { Some(at) } else { last.filter(|(first, _)| *first == records[0]).map(|(_, at)| at) };
            let block = known.unwrap_or_else(|| tell_first(self, records[0]));
            last = Some((records[0], block));
            let single = records.len() == 1;
            let start = order.len() as u32;
            order.extend(records.iter().filter(|_| !single));
            let instances = if single { 0..1 } else { start..order.len() as u32 };
            calls.push(Call { vertices, instances, block, single });
        }
        self.groups.push(Group { layer: layer_number, page, records, calls, block: at, single: count == 1 });
    }

    fn tell(&mut self, block: &BatchBlock) -> usize {
        self.align();
        let at = self.told.len();
        self.told.extend_from_slice(bytemuck::bytes_of(block));
        at
    }

    /// Has the first batch resolve pixels that show nothing too, where it treats them as they are to be.
    fn let_first_write(&mut self, picture: &Picture) {
        if let Some(first) = self.groups.first().filter(|first| picture.layers[first.layer].kind == picture.missed) {
            let flag = first.block + 3 * size_of::<u32>();
            self.told[flag..flag + size_of::<u32>()].copy_from_slice(bytemuck::bytes_of(&1u32));
        }
    }

    /// Whether pixels that show nothing need a batch of their own.
    pub fn needs_empty(&self, picture: &Picture) -> bool {
        self.groups.first().is_none_or(|first| picture.layers[first.layer].kind != picture.missed)
    }

    fn align(&mut self) {
        self.told.resize(self.told.len().next_multiple_of(BLOCK), 0);
    }
}

/// Blocks that a pass takes.
pub(super) const PASS_BLOCKS: usize = 2;

/// Vertices of a part and the records, in their batch, that place them.
struct Drawn {
    vertices: Range<u32>,
    records: Vec<u32>,
}

/// What is seen of a set: draws by record and part.
struct Visible {
    /// Records of each part and run of vertices, in order of their first appearance.
    calls: Vec<(Arc<Page>, Range<u32>, Vec<u32>)>,
}

impl Visible {
    /// Draws of the records in a range, page by page, their records counted from the range's start.
    fn remove_within(&mut self, range: &Range<u32>) -> Vec<(Arc<Page>, Vec<Drawn>)> {
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

fn visible_draws(instances: &[Instance], placed: &[InstanceParts], frustum: Option<&Frustum>) -> Visible {
    let sees = |bounds: &Aabb| frustum.is_none_or(|frustum| frustum.sees(bounds));
    let mut calls: Vec<(Arc<Page>, Range<u32>, Vec<u32>)> = Vec::new();
    // Whole parts of meshes that are placed many times are drawn with one call.
    let mut whole: HashMap<(u64, u32), usize> = HashMap::new();
    for (instance, InstanceParts { first_record, parts }) in instances.iter().zip(placed) {
        if instance.mesh.faces.is_empty() || !sees(&instance.bounds) {
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
    Visible { calls }
}
