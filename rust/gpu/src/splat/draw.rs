//! Drawing of views by a device, in bands of rows.

use std::num::NonZeroU64;
use std::ops::Range;
use std::sync::Arc;

use bytemuck::{Pod, Zeroable};
use nearfar_core::base::{Progress, Result};
use nearfar_core::orthoview::splat::{Counts, Picture, Plan, Splats};
use nearfar_core::render::Frame;
use wgpu::{BindingResource, Buffer, BufferBinding, BufferUsages};

use super::arena::{arena_of, compress_missing};
use super::calls::{Call, Kernel, Kernels, calls};
use super::layout::{Images, KEY_BYTES, Layout};
use crate::compute::memory::{PooledBuffer, Results};
use crate::compute::programs::{ROW, Work, groups};
use crate::device::{Device, lock};

/// Width and height of a tile of samples.
const TILE: u32 = 16;
/// Bytes between blocks: a multiple of every adapter's alignment.
const STRIDE: usize = 512;

/// Draws views; samples without a splat show `before` or the sky.
pub fn draw(
    device: &Device,
    views: &[Arc<Splats>],
    picture: &Picture<'_>,
    progress: &Progress,
) -> Result<(Frame, Counts)> {
    device.check()?;
    let mut plan = Plan::new(&views.iter().map(|view| &**view).collect::<Vec<&Splats>>(), picture)?;
    let layout = Layout::new(device, &plan)?;
    let compressed = compress_missing(device, views);
    let mut images = Images::new(&layout);
    progress.expect(u64::from(layout.bands().count() as u32) + 1);
    let before = plan.initial_keys();
    let bands = {
        // The arena is locked until the work is submitted, so that these views cannot be evicted. Meanwhile nothing
        // runs in rayon, where a waiting thread may draw another picture, which needs the same lock.
        let mut arena = lock(arena_of(device));
        let places = arena.show(device, views, &compressed)?;
        for (view, [page, heads, bits]) in plan.views.iter_mut().zip(&places) {
            view.place = [view.place[0], *page, *heads, *bits];
        }
        let calls = calls(&mut plan.pieces, |view| places[view as usize][0]);
        let pages = arena.buffers(device)?;
        Drawing::new(device, &plan, &layout, &calls, &pages, before.as_deref())?.submit(progress)?
    };
    let mut drawn = 0;
    for band in bands {
        band.images.read(progress, |bytes| images.add(&layout, band.pixels, bytemuck::cast_slice(bytes)))?;
        drawn += u64::from(band.tiles.read_word(progress)?);
        progress.report(1)?;
    }
    let frame = plan.frame(&images.as_found())?;
    progress.report(1)?;
    Ok((frame, plan.counts(drawn)))
}

/// Submitted work of a band.
struct Band<'a> {
    pixels: u32,
    images: Results<'a>,
    tiles: Results<'a>,
}

/// Buffers and kernels of a picture.
struct Drawing<'a, 'b> {
    device: &'a Device,
    plan: &'b Plan<'b>,
    layout: &'b Layout,
    calls: &'b [Call],
    /// Initial keys of all samples, if there is a `before`.
    before: Option<&'b [[u32; 2]]>,
    pages: [BindingResource<'b>; 4],
    kernels: Kernels,
    views: PooledBuffer<'a>,
    pieces: PooledBuffer<'a>,
    keys: PooledBuffer<'a>,
}

impl<'a, 'b> Drawing<'a, 'b> {
    fn new(
        device: &'a Device,
        plan: &'b Plan<'b>,
        layout: &'b Layout,
        calls: &'b [Call],
        pages: &[&'b Buffer],
        before: Option<&'b [[u32; 2]]>,
    ) -> Result<Self> {
        let page = |n: usize| pages.get(n).unwrap_or(&pages[0]).as_entire_binding();
        let samples = u64::from(layout.size[0]) * u64::from(layout.rows) * u64::from(layout.grid * layout.grid);
        let filled = |bytes: &[u8]| {
            let buffer = PooledBuffer::scratch(device, bytes.len() as u64)?;
            buffer.fill(bytes, &Progress::new())?;
            Ok(buffer)
        };
        Ok(Self {
            device,
            plan,
            layout,
            calls,
            before,
            pages: [0, 1, 2, 3].map(page),
            kernels: Kernels { is_parallel: plan.is_parallel(), is_long: device.uses_long_atomics() },
            views: filled(bytemuck::cast_slice(&plan.views))?,
            pieces: filled(bytemuck::cast_slice(&plan.pieces))?,
            keys: PooledBuffer::scratch(device, KEY_BYTES * samples)?,
        })
    }

    /// Submits the work of all bands.
    fn submit(&self, progress: &Progress) -> Result<Vec<Band<'a>>> {
        let tiles_of = |rows: u32| {
            [self.layout.size[0], rows].map(|length| (length * self.layout.grid).div_ceil(TILE)).iter().product::<u32>()
        };
        let mut bands: Vec<Band<'a>> = Vec::new();
        for rows in self.layout.bands() {
            let count = rows.end - rows.start;
            let pixels = self.layout.size[0] * count;
            let images = Results::new(self.device, 4 * u64::from(self.layout.outputs(pixels).1))?;
            let tiles = Results::new(self.device, 4 * u64::from(1 + tiles_of(count)))?;
            let mut work = Work::new(self.device);
            self.encode(&mut work, &rows, &images, &tiles, tiles_of(count))?;
            work.submit(progress)?;
            bands.push(Band { pixels, images, tiles });
        }
        Ok(bands)
    }

    fn encode(
        &self,
        work: &mut Work<'a>,
        rows: &Range<u32>,
        images: &Results<'_>,
        tiles: &Results<'_>,
        tile_count: u32,
    ) -> Result<()> {
        let (grid, row_count) = (self.layout.grid, rows.end - rows.start);
        let pixels = self.layout.size[0] * row_count;
        let ([colors, others, middles], _) = self.layout.outputs(pixels);
        let mut block = DrawBlock::new(self.plan);
        block.size = [self.layout.size[0] * grid, row_count * grid, rows.start * grid, grid];
        block.outputs = [colors, others, middles, 0];
        let passes = if self.kernels.is_long { 0..1 } else { 0..2u32 };
        let blocks = passes.flat_map(|pass| self.calls.iter().map(move |call| block.with_work(&call.pieces, pass)));
        let blocks: Vec<DrawBlock> = blocks.chain([block]).collect();
        let draw_count = blocks.len() - 1;
        let uniforms = Uniforms::new(self.device, &blocks)?;
        let bytes = KEY_BYTES * u64::from(pixels) * u64::from(grid * grid);
        match self.before {
            Some(keys) => {
                let [first, after] = [rows.start, rows.end].map(|row| (row * grid) as usize * block.size[0] as usize);
                self.keys.fill(bytemuck::cast_slice(&keys[first..after]), &Progress::new())?;
            }
            None => work.encoder.clear_buffer(&self.keys, 0, Some(bytes)),
        }
        work.encoder.clear_buffer(&tiles.on_device, 0, Some(4 * u64::from(1 + tile_count)));
        for (number, call) in (0..draw_count).zip(self.calls.iter().cycle()) {
            if call.begins_batch && (number > 0 || self.before.is_some()) {
                let resources =
                    [(0, uniforms.binding(number)), (7, tiles.on_device.binding()), (8, self.keys.binding())];
                self.kernels.run(work, Kernel::Tiles, &resources, groups_of_one(tile_count))?;
            }
            let resources = [
                (0, uniforms.binding(number)),
                (1, self.views.binding()),
                (2, self.pages[call.page as usize].clone()),
                (6, self.pieces.binding()),
                (7, tiles.on_device.binding()),
                (8, self.keys.binding()),
            ];
            self.kernels.run(work, Kernel::Draw, &resources, groups_of_one(call.pieces.end - call.pieces.start))?;
        }
        let mut resources = vec![(0, uniforms.binding(draw_count)), (1, self.views.binding())];
        resources.extend((2..).zip(self.pages.iter().cloned()));
        resources.extend([(6, images.on_device.binding()), (8, self.keys.binding())]);
        self.kernels.run(work, Kernel::Resolve, &resources, groups(pixels))?;
        images.encode_copy(&mut work.encoder);
        tiles.encode_copy(&mut work.encoder);
        Ok(())
    }
}

/// Returns the workgroups of a kernel with one item per workgroup.
fn groups_of_one(count: u32) -> [u32; 2] {
    [count.clamp(1, ROW), count.div_ceil(ROW).max(1)]
}

/// The uniform block `Draw` of `splat.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct DrawBlock {
    size: [u32; 4],
    work: [u32; 4],
    outputs: [u32; 4],
    limits: [u32; 4],
    start: [[f32; 4]; 3],
    direction: [[f32; 4]; 3],
    segment: [f32; 4],
    planes: [[f32; 4]; 8],
}

impl DrawBlock {
    /// Creates the block of a picture, without size, work and outputs.
    fn new(plan: &Plan<'_>) -> Self {
        let (picture, half_spaces) = (plan.picture(), plan.planes());
        let mut planes = [[0.0; 4]; 8];
        planes[..half_spaces.len()].copy_from_slice(&half_spaces);
        let limits = [
            half_spaces.len() as u32,
            u32::from(!picture.limits.is_none()),
            u32::from(picture.pixels.bare),
            u32::from(picture.before.is_some()),
        ];
        let segment = picture.limits.segment;
        Self {
            size: [0; 4],
            work: [0, 0, 0, plan.views.len() as u32],
            outputs: [0; 4],
            limits,
            start: plan.rays.start,
            direction: plan.rays.direction,
            segment: [segment.t_min, segment.t_max.min(f32::MAX), 0.0, 0.0],
            planes,
        }
    }

    /// Returns the block for a pass over some pieces.
    fn with_work(mut self, pieces: &Range<u32>, pass: u32) -> Self {
        [self.work[0], self.work[1], self.work[2]] = [pieces.start, pieces.end - pieces.start, pass];
        self
    }
}

/// Uniform blocks in one buffer.
struct Uniforms(Buffer);

impl Uniforms {
    fn new(device: &Device, blocks: &[DrawBlock]) -> Result<Self> {
        let mut bytes = vec![0u8; blocks.len() * STRIDE];
        for (slot, block) in bytes.chunks_exact_mut(STRIDE).zip(blocks) {
            slot[..size_of_val(block)].copy_from_slice(bytemuck::bytes_of(block));
        }
        device.filled_buffer("splats", &bytes, BufferUsages::UNIFORM).map(Self)
    }

    fn binding(&self, number: usize) -> BindingResource<'_> {
        let size = NonZeroU64::new(size_of::<DrawBlock>() as u64);
        BindingResource::Buffer(BufferBinding { buffer: &self.0, offset: (number * STRIDE) as u64, size })
    }
}
