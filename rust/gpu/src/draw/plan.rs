//! Batches of a frame: the draw calls of each, and their shader inputs.

use std::ops::Range;
use std::sync::Arc;

use bytemuck::{NoUninit, Pod, Zeroable};

use super::cull::{DrawCall, Frustum, calls_within, visible_calls};
use super::inputs::{BLOCK, PASS_BLOCKS};
use super::picture::{Layer, Picture, Set};
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
pub(super) enum RecordsLocation {
    /// In their own buffer.
    Buffer(Arc<wgpu::Buffer>),
    /// Among the frame's inputs.
    Inputs(Range<usize>),
}

/// Triangles of one page, placed by records of one layer that fit into one binding.
pub(super) struct Batch {
    pub layer: usize,
    pub page: Arc<Page>,
    pub records: RecordsLocation,
    pub calls: Vec<Call>,
    /// Offset of its uniform block in the inputs.
    pub block: usize,
    /// Whether it has only one record, so that shaders need not look it up.
    pub has_one_record: bool,
}

/// A draw call.
pub(super) struct Call {
    pub vertices: Range<u32>,
    /// Range in the order of records; unused if the call has one record, which is then in the block.
    pub instances: Range<u32>,
    /// Offset in the inputs of a uniform block with the call's part and first record.
    pub block: usize,
    /// Whether the call has only one record.
    pub has_one_record: bool,
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
    pub batches: Vec<Batch>,
    pub numbering: Vec<Numbering>,
    /// Bytes of the shader inputs; blocks of passes come first.
    pub inputs: Vec<u8>,
    /// Offset of the block for the batch without records, which resolves pixels without a face.
    pub empty_block: usize,
    /// Order of records, among the inputs.
    pub order: Range<usize>,
    pub triangles: u64,
    /// Bit mask of the window's pixels, among the inputs, if not all are drawn.
    pub mask: Option<Range<usize>>,
}

impl Plan {
    /// Plans the visible part of the layers; the inputs begin with space for the blocks of `passes` passes.
    pub fn new(picture: &Picture, frustum: impl Fn(&Layer) -> Option<Frustum>, passes: usize) -> Self {
        let empty_block = passes * BLOCK * PASS_BLOCKS;
        let mut plan = Self {
            batches: Vec::new(),
            numbering: Vec::new(),
            inputs: vec![0; empty_block],
            empty_block,
            order: 0..0,
            triangles: 0,
            mask: None,
        };
        plan.push(&[BatchBlock { records: [0, 0, u32::MAX, 1], ..BatchBlock::zeroed() }]);
        let mut order: Vec<u32> = Vec::new();
        for (number, layer) in picture.layers.iter().enumerate() {
            plan.add_layer(number, layer, frustum(layer).as_ref(), &mut order);
        }
        if !plan.needs_empty_batch(picture) {
            let writes_first = plan.batches[0].block + 3 * size_of::<u32>();
            plan.inputs[writes_first..writes_first + size_of::<u32>()].copy_from_slice(&1u32.to_ne_bytes());
        }
        order.push(0);
        plan.order = plan.push(&order);
        plan
    }

    /// Adds one bit per pixel of the window.
    pub fn add_mask(&mut self, bits: &[u32]) {
        self.mask = Some(self.push(bits));
    }

    fn add_layer(&mut self, number: usize, layer: &Layer, frustum: Option<&Frustum>, order: &mut Vec<u32>) {
        let (set, instances) = (layer.set_tables(), layer.instances());
        let locations: Vec<(RecordsLocation, u32, u32)> = match layer.set {
            Set::Static => {
                let location = |r: &Records| (RecordsLocation::Buffer(Arc::clone(&r.buffer)), r.first, r.count);
                layer.tables.records.iter().map(location).collect()
            }
            Set::Moving if instances.is_empty() => Vec::new(),
            Set::Moving => {
                let words = set.record_words(instances);
                vec![(RecordsLocation::Inputs(self.push(&words)), 0, (words.len() / RECORD_WORDS) as u32)]
            }
        };
        let calls = visible_calls(instances, &set.instances, frustum, layer.may_show.as_deref());
        for (records, first_in_set, count) in locations {
            let first = self.numbering.last().map_or(0, |last| last.first + last.count);
            let numbering = Numbering { layer: number, first, count, first_in_set };
            for (page, calls) in calls_within(&calls, &(first_in_set..first_in_set + count)) {
                self.add_batch(layer, &numbering, (page, records.clone()), calls, order);
            }
            self.numbering.push(numbering);
        }
    }

    fn add_batch(
        &mut self,
        layer: &Layer,
        numbering: &Numbering,
        (page, records): (Arc<Page>, RecordsLocation),
        draw_calls: Vec<DrawCall>,
        order: &mut Vec<u32>,
    ) {
        let shift = layer.tables.materials.texels.shift;
        let block = BatchBlock {
            records: [numbering.first, numbering.count, page.number as u32, 0],
            shifts: [shift, 0, 0, 0],
            ..BatchBlock::zeroed()
        };
        let has_one_record = numbering.count == 1;
        let push_block = |plan: &mut Self, first_record: u32| {
            let record = layer.set_tables().record(layer.instances(), (numbering.first_in_set + first_record) as usize);
            let part = layer.tables.part_of(&record);
            plan.push(&[BatchBlock { shifts: [shift, first_record, 0, 0], record, part, ..block }]).start
        };
        let batch_block = if has_one_record { push_block(self, 0) } else { self.push(&[block]).start };
        let (mut calls, mut last) = (Vec::with_capacity(draw_calls.len()), None);
        for DrawCall { vertices, records } in draw_calls {
            self.triangles += u64::from(vertices.end - vertices.start) / 3 * records.len() as u64;
            // All records of a call place one part, which is uploaded once: looking it up for every vertex takes
            // longer.
            let block = match last {
                _ if has_one_record => batch_block,
                Some((first_record, block)) if first_record == records[0] => block,
                _ => push_block(self, records[0]),
            };
            last = Some((records[0], block));
            let has_one_record = records.len() == 1;
            let start = order.len() as u32;
            order.extend(records.iter().filter(|_| !has_one_record));
            let instances = if has_one_record { 0..1 } else { start..order.len() as u32 };
            calls.push(Call { vertices, instances, block, has_one_record });
        }
        self.batches.push(Batch { layer: numbering.layer, page, records, calls, block: batch_block, has_one_record });
    }

    /// Returns whether pixels without a face need their own batch. They do not if the first batch has the backdrop's
    /// style, because it then resolves them, too.
    pub fn needs_empty_batch(&self, picture: &Picture) -> bool {
        self.batches.first().is_none_or(|first| picture.layers[first.layer].style != picture.backdrop_style)
    }

    /// Adds values to the inputs at the next multiple of the block size; returns their range.
    fn push<T: NoUninit>(&mut self, values: &[T]) -> Range<usize> {
        let start = self.inputs.len().next_multiple_of(BLOCK);
        self.inputs.resize(start, 0);
        self.inputs.extend_from_slice(bytemuck::cast_slice(values));
        start..self.inputs.len()
    }
}
