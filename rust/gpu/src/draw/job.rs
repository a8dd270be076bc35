//! A frame in progress: its windows are submitted ahead and read in order, so that drawing and reading overlap.

use std::collections::VecDeque;
use std::sync::Arc;

use nearfar_core::base::{Aabb, Error, MAX_COORDINATE, Progress, Result};
use nearfar_core::camera::Camera;
use nearfar_core::render::tiles::{MAX_SAMPLES, sample_offsets};
use nearfar_core::render::{Channels, Frame, Limits};
use wgpu::CommandEncoderDescriptor;

use super::cull::Frustum;
use super::encode::{FrameBindings, PassKind};
use super::inputs::{BLOCK, PASS_BLOCKS};
use super::picture::{Layer, Picture};
use super::plan::Plan;
use super::read;
use super::slots::{Shape, Slots, Submitted, map_buffers};
use super::style::Displacement;
use super::timing::Stopwatch;
use super::view::{Sampling, eye_of, pass_block};
use super::window::{Window, bytes_per_pixel, output_layouts, window_limits};
use crate::device::{Counter, Device, SAMPLES, Scope, Submission};
use crate::upload::Residents;

/// Maximum number of windows in flight.
const MAX_WINDOWS_IN_FLIGHT: usize = 2;
/// Passes per submission; cancellation is checked between submissions. In software a pass of millions of pixels takes
/// a second.
const PASSES_PER_SUBMISSION: usize = 8;
const PASSES_IN_SOFTWARE: usize = 1;

/// Frames being drawn: one, or two at once.
pub struct Job {
    pub(super) device: Arc<Device>,
    pub(super) picture: Picture,
    /// A camera for each frame, all of one size.
    pub(super) cameras: Vec<Camera>,
    pub(super) channels: Channels,
    samples: u32,
    waiting: VecDeque<Window>,
    pub(super) submitted: VecDeque<Submitted>,
    frames: Vec<Frame>,
}

impl Job {
    /// Begins a frame for each camera; two only if `draws_both` allows it. The layers' scenes must be on the device.
    pub(crate) fn begin(
        device: &Arc<Device>,
        picture: Picture,
        cameras: &[Camera],
        channels: Channels,
        samples: u32,
        progress: &Progress,
    ) -> Result<Self> {
        if !(1..=MAX_SAMPLES).contains(&samples) {
            return Err(Error::value("samples", format!("a whole number from 1 to {MAX_SAMPLES}"), samples));
        }
        for camera in cameras {
            let distance = (camera.position - picture.origin).abs().max_element();
            if distance > MAX_COORDINATE {
                let expected = format!("a place within {MAX_COORDINATE:e} m of the scene's origin");
                return Err(Error::value("position", expected, format!("{distance:e} m")));
            }
        }
        let Camera { width, height, .. } = cameras[0];
        let pixels = u64::from(width) * u64::from(height);
        let frames = cameras.iter().map(|_| Frame::new(channels, pixels as usize)).collect::<Result<_>>()?;
        let (max_pixels, max_side) = window_limits(device, channels);
        progress.expect(pixels * cameras.len() as u64);
        let mut job = Self {
            device: Arc::clone(device),
            picture,
            cameras: cameras.to_vec(),
            channels,
            samples,
            waiting: Window::split(width, height, max_pixels, max_side).into(),
            submitted: VecDeque::new(),
            frames,
        };
        job.submit_ahead(progress)?;
        Ok(job)
    }

    /// Waits for the frames' windows, submits remaining ones, and returns the images of each frame.
    pub fn finish(mut self, progress: &Progress) -> Result<Vec<Frame>> {
        while let Some(submitted) = self.submitted.pop_front() {
            self.device.wait(&submitted.submission, progress)?;
            submitted.await_mapping(&self.device, progress)?;
            read::copy(&self.device, &submitted, &self.picture, self.cameras[0].width, &mut self.frames)?;
            submitted.slot.readable().unmap();
            submitted.slot.watch.as_ref().map_or(Ok(()), |watch| watch.count(&self.device, progress))?;
            progress.report((self.frames.len() * submitted.window.pixels()) as u64)?;
            self.device.state::<Slots>().give_back(submitted.slot);
            self.submit_ahead(progress)?;
        }
        Ok(self.frames)
    }

    /// Returns the number of frames.
    pub fn frame_count(&self) -> usize {
        self.frames.len()
    }

    fn submit_ahead(&mut self, progress: &Progress) -> Result<()> {
        while self.submitted.len() < MAX_WINDOWS_IN_FLIGHT {
            let Some(window) = self.waiting.pop_front() else { break };
            let submitted = self.submit(window, progress)?;
            self.submitted.push_back(submitted);
        }
        Ok(())
    }

    fn submit(&self, window: Window, progress: &Progress) -> Result<Submitted> {
        let (device, picture) = (&*self.device, &self.picture);
        let outputs = output_layouts(self.channels, &window, self.cameras.len());
        let passes = self.passes();
        let multisampled = passes.iter().any(|(pass, _)| pass.multisampled);
        let views = self.cameras.len();
        let bytes = views as u64 * bytes_per_pixel(self.channels) * window.pixels() as u64;
        let Window { width, height, .. } = window;
        let shape = Shape { width, height, views: views as u32, multisampled, output_bytes: bytes };
        let mut plan = Plan::new(picture, |layer| self.frustum(layer, &window), passes.len() * views);
        if let Some(mask) = &picture.mask {
            plan.add_mask(&mask.bits(&window, self.cameras[0].width));
        }
        let farthest = self.farthest();
        for (pass, sampling) in &passes {
            for (view, (camera, outputs)) in self.cameras.iter().zip(&outputs).enumerate() {
                let block = pass_block(picture, camera, &window, sampling, outputs, farthest);
                let start = (pass.number * views + view) * PASS_BLOCKS * BLOCK;
                plan.inputs[start..start + size_of_val(&block)].copy_from_slice(bytemuck::bytes_of(&block));
            }
        }
        device.count(Counter::Triangles, plan.triangles * passes.len() as u64);
        let mut slot = device.state::<Slots>().take(device, shape)?;
        slot.watch.iter().for_each(Stopwatch::restart);
        let placeholders = device.state::<Residents>().placeholders(device)?;
        let scope = Scope::open(device);
        let encoder = || device.wgpu.create_command_encoder(&CommandEncoderDescriptor { label: Some("frame") });
        let mut commands = encoder();
        let inputs = slot.inputs.upload(device, &mut commands, std::mem::take(&mut plan.inputs))?;
        let bindings = FrameBindings::new(device, picture, &plan, (&slot, &inputs), &placeholders);
        let mut in_flight: Option<Submission> = None;
        let passes_per_submission = if device.is_software() { PASSES_IN_SOFTWARE } else { PASSES_PER_SUBMISSION };
        for (n, chunk) in passes.chunks(passes_per_submission).enumerate() {
            if n > 0 {
                let full = std::mem::replace(&mut commands, encoder());
                if let Some(previous) = in_flight.replace(device.submit(full.finish(), progress)?) {
                    device.wait(&previous, progress)?;
                }
            }
            for (pass, _) in chunk {
                bindings.encode(&mut commands, *pass)?;
            }
        }
        drop(bindings);
        if let Some(staging) = &slot.staging {
            commands.copy_buffer_to_buffer(&slot.output, 0, staging, 0, bytes.next_multiple_of(4));
        }
        if let Some(watch) = &slot.watch {
            watch.stop(&mut commands);
        }
        let submission = device.submit(commands.finish(), progress)?;
        let mapped = map_buffers(&slot, bytes);
        scope.close()?;
        Ok(Submitted { window, slot, outputs, numbering: plan.numbering, submission, mapped })
    }

    /// Returns the passes of a window. Colour and the other channels share a pass if one sample serves both.
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
        // Limits discard fragments of whole pixels, so multisampling would leave jagged edges there.
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

    /// Returns the frustum for the visible points of a layer; `None` if its displacement is unbounded.
    fn frustum(&self, layer: &Layer, window: &Window) -> Option<Frustum> {
        let limits = self.picture.limits.unwrap_or(Limits::NONE);
        let displacement = layer.displacement?;
        let frustum_of = |camera: &Camera| {
            let eye = eye_of(camera, &self.picture);
            let frustum = Frustum::new(camera, window, eye, &limits, &displacement);
            match &self.picture.mask {
                Some(mask) if displacement == Displacement::NONE => {
                    frustum.with_mask(mask, Camera { position: eye, ..*camera })
                }
                _ => frustum,
            }
        };
        self.cameras.iter().map(frustum_of).reduce(Frustum::union)
    }

    /// Returns the depth of the farthest point along parallel rays.
    fn farthest(&self) -> f64 {
        let [camera] = &self.cameras[..] else { return 1.0 };
        if !camera.is_parallel() {
            return 1.0;
        }
        let eye = eye_of(camera, &self.picture);
        let bounds =
            self.picture.layers.iter().flat_map(|layer| layer.scene.instances()).map(|instance| instance.bounds);
        let distance = |b: Aabb| (b.min.as_dvec3() - eye).abs().max((b.max.as_dvec3() - eye).abs()).length();
        bounds.filter(|bounds| !bounds.is_empty()).map(distance).fold(1.0, f64::max) * 1.01
    }
}
