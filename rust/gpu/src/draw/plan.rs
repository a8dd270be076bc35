//! Batches of a frame: the draw calls of each, and their shader inputs.

use std::ops::Range;
use std::sync::Arc;

use bytemuck::{Pod, Zeroable};

use super::cull::Frustum;
use super::inputs::{BLOCK, PASS_BLOCKS};
use super::layers::{Layer, Set};
use super::picture::Picture;
use super::visible::{Drawn, Visible};
use crate::upload::{PART_WORDS, Page, RECORD_WORDS, Records};

/// The uniform block `Batch` of `scene.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct BatchBlock {
    records: [u32; 4],
    shifts: [u32; 4],
    record: [u32; RECORD_WORDS],
    part: [u32; PART_WORDS],
}

/// Location of a batch's records.
#[derive(Clone)]
pub(super) enum RecordsAt {
    /// In their own buffer.
    Buffer(Arc<wgpu::Buffer>),
    /// Among the frame's inputs.
    Inputs(Range<usize>),
}

/// Triangles of one page placed by one batch of a layer's records.
pub(super) struct Group {
    pub layer: usize,
    pub page: Arc<Page>,
    pub records: RecordsAt,
    pub calls: Vec<Call>,
    /// Offset of its uniform block in the inputs.
    pub block: usize,
    /// Whether all pixels of its batch show one record.
    pub single: bool,
}

/// A draw call.
pub(super) struct Call {
    pub vertices: Range<u32>,
    /// Range in the order of records; unused if the block has the only record.
    pub instances: Range<u32>,
    /// Offset in the inputs of a uniform block with the call's part and first record.
    pub block: usize,
    /// Whether the first record is the only one.
    pub single: bool,
}

/// Consecutive records of one layer and their numbers in the frame.
#[derive(Clone, Debug)]
pub(super) struct Numbering {
    pub layer: usize,
    /// First number in the frame.
    pub first: u32,
    pub count: u32,
    /// First record in the layer's set.
    pub first_in_set: u32,
}

/// Draw plan of a frame, with its inputs.
pub(super) struct Plan {
    pub groups: Vec<Group>,
    pub numbering: Vec<Numbering>,
    /// Bytes of the shader inputs; blocks of passes come first.
    pub inputs: Vec<u8>,
    /// Offset of the block of the batch without records, which resolves pixels without a face.
    pub empty: usize,
    /// Order of records, among the inputs.
    pub order: Range<usize>,
    pub triangles: u64,
    /// Bit mask of the window's pixels, among the inputs, if not all are drawn.
    pub mask: Option<Range<usize>>,
}

impl Plan {
    /// Plans the visible part of the layers; the inputs begin with space for the blocks of `passes` passes.
    pub fn new(picture: &Picture, frustum: impl Fn(&Layer) -> Option<Frustum>, passes: usize) -> Self {
        let empty = passes * BLOCK * PASS_BLOCKS;
        let mut plan = Self {
            groups: Vec::new(),
            numbering: Vec::new(),
            inputs: vec![0; empty],
            empty,
            order: 0..0,
            triangles: 0,
            mask: None,
        };
        let nothing = BatchBlock { records: [0, 0, u32::MAX, 1], ..BatchBlock::zeroed() };
        plan.inputs.extend_from_slice(bytemuck::bytes_of(&nothing));
        let mut order: Vec<u32> = Vec::new();
        for (number, layer) in picture.layers.iter().enumerate() {
            plan.add(number, layer, frustum(layer).as_ref(), &mut order);
        }
        plan.let_first_write(picture);
        plan.align();
        let start = plan.inputs.len();
        order.push(0);
        plan.inputs.extend_from_slice(bytemuck::cast_slice(&order));
        plan.order = start..plan.inputs.len();
        plan
    }

    /// Adds one bit per pixel of the window.
    pub fn add_mask(&mut self, bits: &[u32]) {
        self.align();
        let start = self.inputs.len();
        self.inputs.extend_from_slice(bytemuck::cast_slice(bits));
        self.mask = Some(start..self.inputs.len());
    }

    fn add(&mut self, number: usize, layer: &Layer, frustum: Option<&Frustum>, order: &mut Vec<u32>) {
        let (set, instances) = (layer.set_tables(), layer.instances());
        let batches: Vec<(RecordsAt, u32, u32)> = match layer.set {
            Set::Standing => {
                let one = |r: &Records| (RecordsAt::Buffer(Arc::clone(&r.buffer)), r.first, r.count);
                layer.tables.records.iter().map(one).collect()
            }
            Set::Moving if instances.is_empty() => Vec::new(),
            Set::Moving => {
                self.align();
                let (words, start) = (set.record_words(instances), self.inputs.len());
                self.inputs.extend_from_slice(bytemuck::cast_slice(&words));
                let count = (words.len() / RECORD_WORDS) as u32;
                vec![(RecordsAt::Inputs(start..self.inputs.len()), 0, count)]
            }
        };
        let mut visible = Visible::new(instances, &set.instances, frustum, layer.seen.as_deref());
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
        let push_first = |plan: &mut Self, local: u32| {
            let record = layer.record(first_in_set + local);
            let part = layer.tables.part_of(&record);
            plan.push_block(&BatchBlock { shifts: [shift, local, 0, 0], record, part, ..block })
        };
        let at = if count == 1 { push_first(self, 0) } else { self.push_block(&block) };
        let (mut calls, mut last) = (Vec::with_capacity(draws.len()), None);
        for Drawn { vertices, records } in draws {
            self.triangles += u64::from(vertices.end - vertices.start) / 3 * records.len() as u64;
            // All records of a call place one part. Looking it up for every vertex takes longer than uploading it
            // once.
            let known =
                if count == 1 { Some(at) } else { last.filter(|(first, _)| *first == records[0]).map(|(_, at)| at) };
            let block = known.unwrap_or_else(|| push_first(self, records[0]));
            last = Some((records[0], block));
            let single = records.len() == 1;
            let start = order.len() as u32;
            order.extend(records.iter().filter(|_| !single));
            let instances = if single { 0..1 } else { start..order.len() as u32 };
            calls.push(Call { vertices, instances, block, single });
        }
        self.groups.push(Group { layer: layer_number, page, records, calls, block: at, single: count == 1 });
    }

    fn push_block(&mut self, block: &BatchBlock) -> usize {
        self.align();
        let at = self.inputs.len();
        self.inputs.extend_from_slice(bytemuck::bytes_of(block));
        at
    }

    /// Lets the first batch also resolve pixels without a face, if its style is the backdrop's.
    fn let_first_write(&mut self, picture: &Picture) {
        if let Some(first) =
            self.groups.first().filter(|first| picture.layers[first.layer].style == picture.backdrop_style)
        {
            let flag = first.block + 3 * size_of::<u32>();
            self.inputs[flag..flag + size_of::<u32>()].copy_from_slice(bytemuck::bytes_of(&1u32));
        }
    }

    /// Returns whether pixels without a face need their own batch.
    pub fn needs_empty(&self, picture: &Picture) -> bool {
        self.groups.first().is_none_or(|first| picture.layers[first.layer].style != picture.backdrop_style)
    }

    fn align(&mut self) {
        self.inputs.resize(self.inputs.len().next_multiple_of(BLOCK), 0);
    }
}
