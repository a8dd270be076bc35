//! Command encoding of a frame's passes: raster layer by layer, then resolve batch by batch.

use nearfar_core::base::Result;
use wgpu::{
    BindGroup, BindGroupDescriptor, BindGroupEntry, BindingResource, BufferBinding, Color, CommandEncoder,
    ComputePassDescriptor, LoadOp, Operations, RenderPassColorAttachment, RenderPassDepthStencilAttachment,
    RenderPassDescriptor, StoreOp,
};

use super::inputs::{BLOCK, PASS_BLOCKS};
use super::layers::Layer;
use super::picture::Picture;
use super::pipelines::{Layouts, Pipelines, RasterKey, ResolveKey, views_mask};
use super::plan::{Group, Plan, RecordsAt};
use super::slots::{Slot, Target};
use super::style::Style;
use super::timing::Stopwatch;
use crate::device::{Device, SAMPLES};
use crate::upload::{Page, Placeholders, SceneTables};

/// Clear colour of visible faces: four halves of ones, for no face.
const NOTHING: Color = Color { r: 65535.0, g: 65535.0, b: 65535.0, a: 65535.0 };

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
pub(super) struct Bound<'a> {
    device: &'a Device,
    picture: &'a Picture,
    plan: &'a Plan,
    slot: &'a Slot,
    view: BindGroup,
    /// Bind group of both views, if a pass draws two.
    views: Option<BindGroup>,
    raster: Vec<BindGroup>,
    resolve: Vec<BindGroup>,
    /// Bind group and block of the batch without records.
    empty: (BindGroup, u32),
    /// Visible instances of each view, single-sampled and multisampled.
    targets: [Vec<BindGroup>; 2],
    /// Bit mask of the drawn pixels.
    mask: Option<BindGroup>,
}

impl<'a> Bound<'a> {
    /// Creates the bind groups; `None` before the slot has inputs.
    pub fn new(
        device: &'a Device,
        picture: &'a Picture,
        plan: &'a Plan,
        slot: &'a Slot,
        placeholders: &'a Placeholders,
    ) -> Option<Self> {
        let layouts = device.state::<Pipelines>().layouts(device);
        let inputs = slot.inputs.buffer()?;
        let map = picture.backdrop.as_ref().map_or(&placeholders.map, |backdrop| &backdrop.texels);
        let views = slot.shape.views;
        let view = |count: u32| {
            let passes = section(inputs, 0, u64::from(count) * (PASS_BLOCKS * BLOCK) as u64);
            let maps = [&map.color.view, &map.range.view].map(BindingResource::TextureView);
            let [color, range] = maps;
            group(device, &layouts.view, &[passes, section(inputs, 0, BLOCK as u64), color, range])
        };
        let order = section(inputs, plan.order.start as u64, plan.order.len().next_multiple_of(4) as u64);
        let raster = |g: &Group| {
            let mut entries = scene(picture, inputs, g);
            entries.push(order.clone());
            group(device, &layouts.raster_scene, &entries)
        };
        let records = placeholders.tables.parts.as_entire_binding();
        let empty_scene =
            group(device, &layouts.resolve_scene, &tables(&placeholders.tables, &placeholders.page, records));
        Some(Self {
            device,
            picture,
            plan,
            slot,
            view: view(1),
            views: (views > 1).then(|| view(views)),
            raster: plan.groups.iter().map(raster).collect(),
            resolve: plan
                .groups
                .iter()
                .map(|g| group(device, &layouts.resolve_scene, &scene(picture, inputs, g)))
                .collect(),
            empty: (empty_scene, plan.empty as u32),
            targets: targets(device, layouts, slot),
            mask: plan
                .mask
                .as_ref()
                .map(|bits| group(device, &layouts.mask, &[section(inputs, bits.start as u64, bits.len() as u64)])),
        })
    }

    /// Encodes one pass: raster, then resolve.
    pub fn encode(&self, encoder: &mut CommandEncoder, pass: PassKind) -> Result<()> {
        let samples = if pass.multisampled { SAMPLES } else { 1 };
        let target = self.slot.multisampled.as_ref().filter(|_| pass.multisampled).unwrap_or(&self.slot.single);
        let views = self.slot.shape.views as usize;
        let offset = |view: usize| ((pass.number * views + view) * PASS_BLOCKS * BLOCK) as u32;
        self.raster(encoder, target, samples, offset(0))?;
        let targets = &self.targets[usize::from(pass.multisampled)];
        targets
            .iter()
            .enumerate()
            .try_for_each(|(view, target)| self.resolve(encoder, pass, samples, (target, offset(view))))
    }

    fn raster(&self, encoder: &mut CommandEncoder, target: &Target, samples: u32, offset: u32) -> Result<()> {
        let layers = &self.picture.layers;
        let pipelines = self.device.state::<Pipelines>();
        let hiding = self.mask.as_ref().map(|_| pipelines.mask(self.device, samples)).transpose()?;
        let mut start = 0;
        let mut first = true;
        while first || start < self.plan.groups.len() {
            let groups = &self.plan.groups[start..];
            // A layer that covers earlier ones begins a pass with a new depth buffer, for itself and for later layers,
            // even if nothing of it is visible.
            let section = |n: usize| layers[..=groups[n].layer].iter().filter(|layer| layer.covers).count();
            let same = |n: usize| section(n) == section(0);
            let count = (0..groups.len()).take_while(|&n| same(n)).count();
            let pipeline = |g: &Group, single| {
                let used = g.calls.iter().any(|call| call.single == single);
                let (layer, views) = (&layers[g.layer], self.slot.shape.views);
                let key = raster_key(self.device, self.picture, layer, single, samples, views);
                used.then(|| self.device.state::<Pipelines>().raster(self.device, key)).transpose()
            };
            let pipelines: Vec<_> =
                groups[..count].iter().map(|g| Ok([pipeline(g, false)?, pipeline(g, true)?])).collect::<Result<_>>()?;
            let mut pass = encoder.begin_render_pass(&RenderPassDescriptor {
                label: Some("raster"),
                color_attachments: &[Some(RenderPassColorAttachment {
                    view: &target.visible,
                    depth_slice: None,
                    resolve_target: None,
                    ops: Operations {
                        load: if first { LoadOp::Clear(NOTHING) } else { LoadOp::Load },
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
            if let (Some(mask), Some(pipeline)) = (&self.mask, &hiding) {
                pass.set_pipeline(pipeline);
                pass.set_bind_group(0, mask, &[]);
                pass.set_bind_group(1, &self.view, &[offset, self.empty.1]);
                pass.draw(0..3, 0..1);
            }
            let view = self.views.as_ref().unwrap_or(&self.view);
            for (n, (group, pipelines)) in groups[..count].iter().zip(&pipelines).enumerate() {
                pass.set_bind_group(0, &self.raster[start + n], &[]);
                let (mut drawn_by, mut bound) = (None, None);
                for call in &group.calls {
                    if drawn_by != Some(call.single) {
                        let Some(pipeline) = &pipelines[usize::from(call.single)] else { continue };
                        pass.set_pipeline(pipeline);
                        drawn_by = Some(call.single);
                    }
                    if bound != Some(call.block) {
                        pass.set_bind_group(1, view, &[offset, call.block as u32]);
                        bound = Some(call.block);
                    }
                    pass.draw(call.vertices.clone(), call.instances.clone());
                }
            }
            start += count;
            first = false;
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
        let key = |style: Style, single, first, layer: Option<&Layer>| ResolveKey {
            style,
            mapped: first && self.picture.backdrop.is_some(),
            limited: first && self.picture.backdrop.is_some() && self.picture.limits.is_some(),
            bare: first && self.picture.bare,
            color: kind.color,
            surface: kind.surface,
            single,
            textured: layer.is_some_and(|layer| layer.tables.materials.textured),
            colored: layer.is_some_and(|layer| layer.tables.colored),
            smooth: layer.is_some_and(|layer| layer.tables.smooth),
            glowing: layer.is_some_and(|layer| layer.tables.materials.glowing),
            samples,
        };
        let layers = &self.picture.layers;
        let resolve = |group: &Group| {
            let layer = &layers[group.layer];
            let first = std::ptr::eq(group, &self.plan.groups[0]) && !self.plan.needs_empty(self.picture);
            self.device.state::<Pipelines>().resolve(self.device, key(layer.style, group.single, first, Some(layer)))
        };
        let pipelines: Vec<_> = self.plan.groups.iter().map(resolve).collect::<Result<_>>()?;
        let missed = self
            .device
            .state::<Pipelines>()
            .resolve(self.device, key(self.picture.backdrop_style, false, true, None))?;
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
        if self.plan.needs_empty(self.picture) {
            dispatch(&missed, &self.empty.0, self.empty.1);
        }
        for ((group, pipeline), scene) in self.plan.groups.iter().zip(&pipelines).zip(&self.resolve) {
            dispatch(pipeline, scene, group.block as u32);
        }
        Ok(())
    }
}

fn raster_key(device: &Device, picture: &Picture, layer: &Layer, single: bool, samples: u32, views: u32) -> RasterKey {
    let (cutout, clipped) = (layer.scene.has_cutouts(), picture.clips(device, layer));
    let limited = picture.limits.is_some() && !clipped;
    RasterKey { style: layer.style, cut: layer.cut, cutout, limited, clipped, single, samples, views }
}

fn targets(device: &Device, layouts: &Layouts, slot: &Slot) -> [Vec<BindGroup>; 2] {
    let views = |layout: usize, target: &Target| {
        let bound = |view| {
            let entries = [BindingResource::TextureView(view), slot.output.as_entire_binding()];
            group(device, &layouts.target[layout], &entries)
        };
        target.views.iter().map(bound).collect()
    };
    [views(0, &slot.single), slot.multisampled.as_ref().map_or_else(Vec::new, |several| views(1, several))]
}

fn scene<'a>(picture: &'a Picture, inputs: &'a wgpu::Buffer, group: &'a Group) -> Vec<BindingResource<'a>> {
    let records = match &group.records {
        RecordsAt::Buffer(buffer) => buffer.as_entire_binding(),
        RecordsAt::Inputs(range) => section(inputs, range.start as u64, range.len() as u64),
    };
    tables(&picture.layers[group.layer].tables, &group.page, records)
}

fn tables<'a>(tables: &'a SceneTables, page: &'a Page, records: BindingResource<'a>) -> Vec<BindingResource<'a>> {
    vec![
        page.buffer.as_entire_binding(),
        records,
        tables.parts.as_entire_binding(),
        tables.materials.materials.as_entire_binding(),
        tables.materials.textures.as_entire_binding(),
        BindingResource::TextureView(&tables.materials.texels.view),
    ]
}

fn section(buffer: &wgpu::Buffer, offset: u64, size: u64) -> BindingResource<'_> {
    BindingResource::Buffer(BufferBinding { buffer, offset, size: std::num::NonZeroU64::new(size) })
}

fn group(device: &Device, layout: &wgpu::BindGroupLayout, resources: &[BindingResource<'_>]) -> BindGroup {
    let entries: Vec<_> = resources
        .iter()
        .enumerate()
        .map(|(binding, resource)| BindGroupEntry { binding: binding as u32, resource: resource.clone() })
        .collect();
    device.wgpu.create_bind_group(&BindGroupDescriptor { label: None, layout, entries: &entries })
}
