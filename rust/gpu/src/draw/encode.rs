//! Command encoding of a frame's passes: raster layer by layer, then resolve batch by batch.

use std::num::NonZeroU64;
use std::ops::Range;

use nearfar_core::base::Result;
use wgpu::{
    BindGroup, BindingResource, BufferBinding, Color, CommandEncoder, ComputePassDescriptor, LoadOp, Operations,
    RenderPassColorAttachment, RenderPassDepthStencilAttachment, RenderPassDescriptor, StoreOp,
};

use super::inputs::{BLOCK, PASS_BLOCKS};
use super::picture::{Layer, Picture};
use super::pipelines::{Layouts, Pipelines, RasterKey, ResolveKey, views_mask};
use super::plan::{Batch, Plan, RecordsLocation};
use super::slots::{Slot, Target};
use super::style::Style;
use super::timing::Stopwatch;
use crate::device::{Device, SAMPLES};
use crate::upload::{Page, Placeholders, SceneTables};

/// Clear value of visibility targets, all bits set, which means no face.
const NO_FACE: Color = Color { r: 65535.0, g: 65535.0, b: 65535.0, a: 65535.0 };

/// A pass over a window.
#[derive(Clone, Copy, Debug)]
pub(super) struct PassKind {
    /// Index among the frame's passes.
    pub number: usize,
    pub color: bool,
    pub surface: bool,
    pub multisampled: bool,
}

/// Bind groups of a frame.
pub(super) struct FrameBindings<'a> {
    device: &'a Device,
    picture: &'a Picture,
    plan: &'a Plan,
    slot: &'a Slot,
    view: BindGroup,
    /// Bind group of both views, if a pass draws two.
    views: Option<BindGroup>,
    /// Scene tables of each batch, for raster and for resolve passes.
    raster_scenes: Vec<BindGroup>,
    resolve_scenes: Vec<BindGroup>,
    /// Scene tables of the batch without records.
    empty_scene: BindGroup,
    /// Visible faces of each view, single-sampled and multisampled.
    targets: [Vec<BindGroup>; 2],
    mask: Option<BindGroup>,
}

impl<'a> FrameBindings<'a> {
    /// Creates the bind groups for a slot and its inputs.
    pub fn new(
        device: &'a Device,
        picture: &'a Picture,
        plan: &'a Plan,
        (slot, inputs): (&'a Slot, &wgpu::Buffer),
        placeholders: &'a Placeholders,
    ) -> Self {
        let layouts = device.state::<Pipelines>().layouts(device);
        let map = picture.backdrop.as_ref().map_or(&placeholders.map, |backdrop| &backdrop.texels);
        let views = slot.shape.views;
        let view = |count: u32| {
            let passes = section(inputs, &(0..count as usize * PASS_BLOCKS * BLOCK));
            let [color, range] = [&map.color.view, &map.range.view].map(BindingResource::TextureView);
            device.bind_group(&layouts.view, (0..).zip([passes, section(inputs, &(0..BLOCK)), color, range]))
        };
        let order = section(inputs, &plan.order);
        let scenes = plan.batches.iter().map(|batch| {
            let records = match &batch.records {
                RecordsLocation::Buffer(buffer) => buffer.as_entire_binding(),
                RecordsLocation::Inputs(range) => section(inputs, range),
            };
            let tables = tables(&picture.layers[batch.layer].tables, &batch.page, records);
            let raster = tables.clone().into_iter().chain([order.clone()]);
            let raster = device.bind_group(&layouts.raster_scene, (0..).zip(raster));
            (raster, device.bind_group(&layouts.resolve_scene, (0..).zip(tables)))
        });
        let (raster_scenes, resolve_scenes) = scenes.unzip();
        let records = placeholders.tables.parts.as_entire_binding();
        let empty_tables = tables(&placeholders.tables, &placeholders.page, records);
        Self {
            device,
            picture,
            plan,
            slot,
            view: view(1),
            views: (views > 1).then(|| view(views)),
            raster_scenes,
            resolve_scenes,
            empty_scene: device.bind_group(&layouts.resolve_scene, (0..).zip(empty_tables)),
            targets: targets(device, layouts, slot),
            mask: plan.mask.as_ref().map(|bits| device.bind_group(&layouts.mask, [(0, section(inputs, bits))])),
        }
    }

    /// Encodes one pass: raster, then resolve.
    pub fn encode(&self, encoder: &mut CommandEncoder, pass: PassKind) -> Result<()> {
        let samples = if pass.multisampled { SAMPLES } else { 1 };
        let target = self.slot.multisampled.as_ref().filter(|_| pass.multisampled).unwrap_or(&self.slot.single_sampled);
        let views = self.slot.shape.views as usize;
        let offset = |view: usize| ((pass.number * views + view) * PASS_BLOCKS * BLOCK) as u32;
        self.raster(encoder, target, samples, offset(0))?;
        let mut targets = self.targets[usize::from(pass.multisampled)].iter().enumerate();
        targets.try_for_each(|(view, target)| self.resolve(encoder, pass, samples, (target, offset(view))))
    }

    fn raster(&self, encoder: &mut CommandEncoder, target: &Target, samples: u32, offset: u32) -> Result<()> {
        let layers = &self.picture.layers;
        let pipelines = self.device.state::<Pipelines>();
        let mask = match &self.mask {
            Some(mask) => Some((mask, pipelines.mask(self.device, samples)?)),
            None => None,
        };
        let pipeline = |batch: &Batch, one_record| {
            let is_used = batch.calls.iter().any(|call| call.has_one_record == one_record);
            let key = self.raster_key(&layers[batch.layer], one_record, samples);
            is_used.then(|| pipelines.raster(self.device, key)).transpose()
        };
        // A layer that covers earlier ones begins a pass with a new depth buffer, for itself and for later layers, even
        // if nothing of it is visible.
        let pass_of = |batch: &Batch| layers[..=batch.layer].iter().filter(|layer| layer.covers).count();
        let mut start = 0;
        let mut is_first = true;
        while is_first || start < self.plan.batches.len() {
            let rest = &self.plan.batches[start..];
            let count = rest.iter().take_while(|batch| pass_of(batch) == pass_of(&rest[0])).count();
            let batches = &rest[..count];
            let pipelines: Vec<_> = batches
                .iter()
                .map(|batch| Ok([pipeline(batch, false)?, pipeline(batch, true)?]))
                .collect::<Result<_>>()?;
            let mut pass = encoder.begin_render_pass(&RenderPassDescriptor {
                label: Some("raster"),
                color_attachments: &[Some(RenderPassColorAttachment {
                    view: &target.faces,
                    depth_slice: None,
                    resolve_target: None,
                    ops: Operations {
                        load: if is_first { LoadOp::Clear(NO_FACE) } else { LoadOp::Load },
                        store: StoreOp::Store,
                    },
                })],
                depth_stencil_attachment: Some(RenderPassDepthStencilAttachment {
                    view: &target.depth,
                    depth_ops: Some(Operations { load: LoadOp::Clear(0.0), store: StoreOp::Discard }),
                    stencil_ops: None,
                }),
                timestamp_writes: self.slot.watch.as_ref().and_then(Stopwatch::raster),
                multiview_mask: views_mask(self.slot.shape.views),
                ..RenderPassDescriptor::default()
            });
            if let Some((mask, pipeline)) = &mask {
                pass.set_pipeline(pipeline);
                pass.set_bind_group(0, *mask, &[]);
                pass.set_bind_group(1, &self.view, &[offset, self.plan.empty_block as u32]);
                pass.draw(0..3, 0..1);
            }
            let view = self.views.as_ref().unwrap_or(&self.view);
            for ((batch, scene), pipelines) in batches.iter().zip(&self.raster_scenes[start..]).zip(&pipelines) {
                pass.set_bind_group(0, scene, &[]);
                let (mut pipeline_of, mut bound_block) = (None, None);
                for call in &batch.calls {
                    if pipeline_of != Some(call.has_one_record) {
                        let Some(pipeline) = &pipelines[usize::from(call.has_one_record)] else { continue };
                        pass.set_pipeline(pipeline);
                        pipeline_of = Some(call.has_one_record);
                    }
                    if bound_block != Some(call.block) {
                        pass.set_bind_group(1, view, &[offset, call.block as u32]);
                        bound_block = Some(call.block);
                    }
                    pass.draw(call.vertices.clone(), call.instances.clone());
                }
            }
            start += count;
            is_first = false;
        }
        Ok(())
    }

    fn resolve(
        &self,
        encoder: &mut CommandEncoder,
        kind: PassKind,
        samples: u32,
        (target, offset): (&BindGroup, u32),
    ) -> Result<()> {
        let picture = self.picture;
        let compile = |style: Style, one_record, writes_first, layer: Option<&Layer>| {
            let tables = layer.map(|layer| &layer.tables);
            let key = ResolveKey {
                style,
                mapped: writes_first && picture.backdrop.is_some(),
                limited: writes_first && picture.backdrop.is_some() && picture.limits.is_some(),
                bare: writes_first && picture.bare,
                color: kind.color,
                surface: kind.surface,
                one_record,
                textured: tables.is_some_and(|tables| tables.materials.textured),
                colored: tables.is_some_and(|tables| tables.colored),
                smooth: tables.is_some_and(|tables| tables.smooth),
                glowing: tables.is_some_and(|tables| tables.materials.glowing),
                samples,
            };
            self.device.state::<Pipelines>().resolve(self.device, key)
        };
        let needs_empty_batch = self.plan.needs_empty_batch(picture);
        let pipelines = self.plan.batches.iter().enumerate().map(|(n, batch)| {
            let layer = &picture.layers[batch.layer];
            compile(layer.style, batch.has_one_record, n == 0 && !needs_empty_batch, Some(layer))
        });
        let pipelines: Vec<_> = pipelines.collect::<Result<_>>()?;
        let empty_pipeline = compile(picture.backdrop_style, false, true, None)?;
        let mut pass = encoder.begin_compute_pass(&ComputePassDescriptor {
            label: Some("resolve"),
            timestamp_writes: self.slot.watch.as_ref().and_then(Stopwatch::resolve),
        });
        let groups = [self.slot.shape.width.div_ceil(8), self.slot.shape.height.div_ceil(8)];
        pass.set_bind_group(2, target, &[]);
        let mut dispatch = |pipeline: &wgpu::ComputePipeline, scene: &BindGroup, block: u32| {
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, scene, &[]);
            pass.set_bind_group(1, &self.view, &[offset, block]);
            pass.dispatch_workgroups(groups[0], groups[1], 1);
        };
        if needs_empty_batch {
            dispatch(&empty_pipeline, &self.empty_scene, self.plan.empty_block as u32);
        }
        for ((batch, pipeline), scene) in self.plan.batches.iter().zip(&pipelines).zip(&self.resolve_scenes) {
            dispatch(pipeline, scene, batch.block as u32);
        }
        Ok(())
    }

    fn raster_key(&self, layer: &Layer, one_record: bool, samples: u32) -> RasterKey {
        let (cutout, clipped) = (layer.scene.has_cutouts(), self.picture.clips(self.device, layer));
        let limited = self.picture.limits.is_some() && !clipped;
        let views = self.slot.shape.views;
        RasterKey { style: layer.style, cut: layer.cut, cutout, limited, clipped, one_record, samples, views }
    }
}

fn targets(device: &Device, layouts: &Layouts, slot: &Slot) -> [Vec<BindGroup>; 2] {
    let views = |layout: usize, target: &Target| {
        let bind_group = |view| {
            let resources = [BindingResource::TextureView(view), slot.output.as_entire_binding()];
            device.bind_group(&layouts.target[layout], (0..).zip(resources))
        };
        target.faces_by_view.iter().map(bind_group).collect()
    };
    let multisampled = slot.multisampled.as_ref().map_or_else(Vec::new, |target| views(1, target));
    [views(0, &slot.single_sampled), multisampled]
}

fn tables<'a>(tables: &'a SceneTables, page: &'a Page, records: BindingResource<'a>) -> [BindingResource<'a>; 6] {
    [
        page.buffer.as_entire_binding(),
        records,
        tables.parts.as_entire_binding(),
        tables.materials.materials.as_entire_binding(),
        tables.materials.textures.as_entire_binding(),
        BindingResource::TextureView(&tables.materials.texels.view),
    ]
}

fn section<'a>(buffer: &'a wgpu::Buffer, bytes: &Range<usize>) -> BindingResource<'a> {
    let size = NonZeroU64::new(bytes.len() as u64);
    BindingResource::Buffer(BufferBinding { buffer, offset: bytes.start as u64, size })
}
