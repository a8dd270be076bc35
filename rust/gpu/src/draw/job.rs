//! A frame under way: its windows are submitted ahead and read in order, so that drawing and reading overlap.

use std::collections::VecDeque;
use std::sync::Arc;

use nearfar_core::base::{Aabb, Error, Progress, Result};
use nearfar_core::camera::Camera;
use nearfar_core::render::tiles::{MAX_SAMPLES, sample_offsets};
use nearfar_core::render::{Channels, Frame, Limits};
use wgpu::CommandEncoderDescriptor;

use super::cull::Frustum;
use super::encode::{Bound, PassKind};
use super::inputs::BLOCK;
use super::layers::Layer;
use super::picture::Picture;
use super::plan::{PASS_BLOCKS, Plan};
use super::read;
use super::slots::{Shape, Slots};
use super::style::Displacement;
use super::submitted::{Submitted, open_buffers};
use super::timing::Stopwatch;
use super::view::{CHANNELS, Outputs, Sampling, eye_of, pass_of};
use super::window::Window;
use crate::device::{Counted, Device, SAMPLES, Scope, Submission};
use crate::upload::Residents;

/// Windows in flight at a time.
const WINDOWS_AHEAD: usize = 2;
/// Passes in one submission: between two, the caller may cancel. In software a pass of millions of pixels takes a second.
const PASSES_PER_SUBMISSION: usize = 8;
const PASSES_IN_SOFTWARE: usize = 1;
/// Bytes of a pixel's channels: colour, range, ids, position, normal, albedo, shading normal, coverage.
const CHANNEL_BYTES: [u64; CHANNELS] = [12, 4, 8, 12, 12, 12, 12, 4];

/// A frame that is being drawn.
pub struct Job {
    pub(super) device: Arc<Device>,
    pub(super) picture: Picture,
    pub(super) camera: Camera,
    pub(super) channels: Channels,
    samples: u32,
    waiting: VecDeque<Window>,
    pub(super) submitted: VecDeque<Submitted>,
    frame: Frame,
}

impl Job {
    /// Begins a frame; the layers' scenes are on the device already.
    pub(crate) fn begin(
        device: &Arc<Device>,
        picture: Picture,
        camera: &Camera,
        channels: Channels,
        samples: u32,
        progress: &Progress,
    ) -> Result<Self> {
        if !(1..=MAX_SAMPLES).contains(&samples) {
            return Err(Error::value("samples", format!("a whole number from 1 to {MAX_SAMPLES}"), samples));
        }
        let eye = camera.position - picture.origin;
        let reach = nearfar_core::base::REACH;
        if eye.abs().max_element() > reach {
            let expected = format!("a place within {reach:e} m of the scene's origin");
            return Err(Error::value("position", expected, format!("{:e} m", eye.abs().max_element())));
        }
        let pixels = u64::from(camera.width) * u64::from(camera.height);
        let frame = Frame::new(channels, pixels as usize)?;
        let (most, side) = window_limits(device, channels);
        progress.expect(pixels);
        let mut job = Self {
            device: Arc::clone(device),
            picture,
            camera: *camera,
            channels,
            samples,
            waiting: Window::split(camera.width, camera.height, most, side).into(),
            submitted: VecDeque::new(),
            frame,
        };
        job.submit_ahead(progress)?;
        Ok(job)
    }

    /// Waits for the frame's windows, submits those that are left, and returns the images.
    pub fn finish(mut self, progress: &Progress) -> Result<Frame> {
        while let Some(submitted) = self.submitted.pop_front() {
            self.device.wait(&submitted.submission, progress)?;
            submitted.await_opening(&self.device, progress)?;
            read::copy(&self.device, &submitted, &self.picture, self.camera.width, &mut self.frame)?;
            submitted.slot.readable().unmap();
            submitted.slot.watch.as_ref().map_or(Ok(()), |watch| watch.count(&self.device, progress))?;
            progress.report(submitted.window.pixels() as u64)?;
            self.device.state::<Slots>().give_back(submitted.slot);
            self.submit_ahead(progress)?;
        }
        Ok(self.frame)
    }

    fn submit_ahead(&mut self, progress: &Progress) -> Result<()> {
        while self.submitted.len() < WINDOWS_AHEAD {
            let Some(window) = self.waiting.pop_front() else { break };
            let submitted = self.submit(window, progress)?;
            self.submitted.push_back(submitted);
        }
        Ok(())
    }

    fn submit(&self, window: Window, progress: &Progress) -> Result<Submitted> {
        let (device, picture) = (&*self.device, &self.picture);
        let outputs = layout(self.channels, &window);
        let passes = self.passes();
        let multisampled = passes.iter().any(|(pass, _)| pass.multisampled);
        let bytes = bytes_per_pixel(self.channels) * window.pixels() as u64;
        let shape = Shape { width: window.width, height: window.height, multisampled, bytes };
        let mut plan = Plan::new(picture, |layer| self.frustum(layer, &window), passes.len());
        if let Some(mask) = &picture.mask {
            plan.add_mask(&mask.bits(&window, self.camera.width));
        }
        let farthest = self.farthest();
        for (pass, sampling) in &passes {
            let block = pass_of(picture, &self.camera, &window, sampling, &outputs, farthest);
            let at = pass.number * PASS_BLOCKS * BLOCK;
            plan.inputs[at..at + size_of_val(&block)].copy_from_slice(bytemuck::bytes_of(&block));
        }
        device.count(Counted::Triangles, plan.triangles * passes.len() as u64);
        let mut slot = device.state::<Slots>().take(device, shape)?;
        slot.watch.iter().for_each(Stopwatch::restart);
        let placeholders = device.state::<Residents>().placeholders(device)?;
        let scope = Scope::open(device);
        let encoder = || device.wgpu.create_command_encoder(&CommandEncoderDescriptor { label: Some("frame") });
        let mut commands = encoder();
        slot.inputs.send(device, &mut commands, std::mem::take(&mut plan.inputs))?;
        let Some(bound) = Bound::new(device, picture, &plan, &slot, &placeholders) else {
            return Err(device.failure(&"a slot without buffers"));
        };
        let mut last: Option<Submission> = None;
        let at_once = if device.is_software() { PASSES_IN_SOFTWARE } else { PASSES_PER_SUBMISSION };
        for (n, chunk) in passes.chunks(at_once).enumerate() {
            if n > 0 {
                let full = std::mem::replace(&mut commands, encoder());
                let submission = device.submit(full.finish(), progress)?;
                if let Some(before) = last.replace(submission) {
                    device.wait(&before, progress)?;
                }
            }
            for (pass, _) in chunk {
                bound.encode(&mut commands, *pass)?;
            }
        }
        drop(bound);
        if let Some(staging) = &slot.staging {
            commands.copy_buffer_to_buffer(&slot.output, 0, staging, 0, bytes.next_multiple_of(4));
        }
        if let Some(watch) = &slot.watch {
            watch.stop(&mut commands);
        }
        let submission = device.submit(commands.finish(), progress)?;
        let opened = open_buffers(&slot, bytes);
        scope.close()?;
        Ok(Submitted { window, slot, outputs, numbering: plan.numbering, submission, opened })
    }

    /// Passes of a window: colour and the other channels at once where one sample serves both.
    fn passes(&self) -> Vec<(PassKind, Sampling)> {
        let (color, surface) = (self.channels.any_sampled(), self.channels.any_surface());
        let pass = |number, color, surface, multisampled| PassKind { number, color, surface, multisampled };
        if !color || self.samples == 1 {
            return vec![(pass(0, color, surface, false), Sampling::CENTER)];
        }
        let mut passes = Vec::new();
        if surface {
            passes.push((pass(0, false, true, false), Sampling::CENTER));
        }
        // Fragments are discarded at limits for a whole pixel, which multisampling would leave jagged.
        let is_smooth = |layer| self.picture.limits.is_none() || self.picture.clips(&self.device, layer);
        let smooth = self.picture.multisampled && self.picture.layers.iter().all(is_smooth);
        if self.samples == SAMPLES && self.device.multisamples && smooth {
            passes.push((pass(passes.len(), true, false, true), Sampling::CENTER));
            return passes;
        }
        let (scale, weight) = (1.0 / f64::from(self.samples).sqrt(), 1.0 / self.samples as f32);
        for (n, offset) in sample_offsets(self.samples).into_iter().enumerate() {
            let sampling = Sampling { offset, scale, weight, adds: n > 0 };
            passes.push((pass(passes.len(), true, false, false), sampling));
        }
        passes
    }

    /// Half-spaces that visible points of a layer lie in; none where its displacement has no bound.
    fn frustum(&self, layer: &Layer, window: &Window) -> Option<Frustum> {
        let eye = eye_of(&self.camera, &self.picture);
        let limits = self.picture.limits.unwrap_or(Limits::NONE);
        layer.displacement.map(|moved| {
            let frustum = Frustum::new(&self.camera, window, eye, &limits, &moved);
            match &self.picture.mask {
                Some(mask) if moved == Displacement::NONE => {
                    frustum.masked(mask, Camera { position: eye, ..self.camera })
                }
                _ => frustum,
            }
        })
    }

    /// Depth of the farthest point along parallel rays.
    fn farthest(&self) -> f64 {
        let eye = eye_of(&self.camera, &self.picture);
        if !self.camera.is_parallel() {
            return 1.0;
        }
        let bounds =
            self.picture.layers.iter().flat_map(|layer| layer.scene.instances()).map(|instance| instance.bounds);
        let far = |b: Aabb| (b.min.as_dvec3() - eye).abs().max((b.max.as_dvec3() - eye).abs()).length();
        bounds.filter(|bounds| !bounds.is_empty()).map(far).fold(1.0, f64::max) * 1.01
    }
}

/// Flags of the wanted channels, in the order of `CHANNEL_BYTES`.
fn wanted(channels: Channels) -> [bool; CHANNELS] {
    let Channels { color, coverage, range, object_id, face_id, position, normal, albedo, shading_normal } = channels;
    [color, range, object_id || face_id, position, normal, albedo, shading_normal, coverage]
}

fn bytes_per_pixel(channels: Channels) -> u64 {
    wanted(channels).iter().zip(CHANNEL_BYTES).map(|(&wanted, bytes)| u64::from(wanted) * bytes).sum()
}

/// The most pixels that a window may have, and the most across and down.
pub(super) fn window_limits(device: &Device, channels: Channels) -> (u64, u32) {
    let most = device.largest_binding() / bytes_per_pixel(channels).max(1);
    (most.max(1), device.limits.max_texture_dimension_2d)
}

/// First word of each channel of a window.
fn layout(channels: Channels, window: &Window) -> Outputs {
    let mut at = 0;
    let mut outputs = [u32::MAX; CHANNELS];
    for ((slot, wanted), bytes) in outputs.iter_mut().zip(wanted(channels)).zip(CHANNEL_BYTES) {
        if wanted {
            *slot = at;
            at += (bytes / 4) as u32 * window.pixels() as u32;
        }
    }
    outputs
}
