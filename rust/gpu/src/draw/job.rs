//! A frame under way: its windows are submitted ahead and read in order, so that drawing and reading overlap.

use std::collections::VecDeque;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use nearfar_core::base::{Aabb, Error, Progress, Result};
use nearfar_core::camera::Camera;
use nearfar_core::render::tiles::{MAX_SAMPLES, sample_offsets};
use nearfar_core::render::{Channels, Frame};
use wgpu::{CommandEncoderDescriptor, MapMode, SubmissionIndex};

use super::bindings::{Numbering, PASS_BLOCKS, Plan};
use super::encode::{Bound, PassKind};
use super::slots::{BLOCK, SAMPLES, Shape, Slot};
use super::view::{Outputs, Sampling, Window, eye_of, pass_of};
use super::{Frustum, Kind, Picture, read};
use crate::device::{Device, Scope, Written};

/// Windows in flight at a time.
const AHEAD: usize = 2;
/// Passes in one submission: between two, the caller is asked whether to go on.
const PASSES: usize = 8;
/// Bytes of a pixel's channels: colour, range, ids, position, normal.
const BYTES: [u64; 5] = [12, 4, 8, 12, 12];

/// A frame that is being drawn.
pub struct Job {
    pub(super) device: Arc<Device>,
    pub(super) picture: Picture,
    pub(super) camera: Camera,
    pub(super) channels: Channels,
    samples: u32,
    pub(super) shape: (u64, u32),
    pub(super) waiting: VecDeque<Window>,
    pub(super) submitted: VecDeque<Submitted>,
    frame: Frame,
}

/// A window that the device works on.
pub(super) struct Submitted {
    pub window: Window,
    pub slot: Slot,
    pub outputs: Outputs,
    pub numbering: Vec<Numbering>,
    submission: SubmissionIndex,
    /// Buffers that are open again, and those that could not be opened.
    pub opened: Arc<[AtomicU32; 2]>,
}

impl Job {
    /// Begins a frame: what is missing on the device must be there already.
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
        let per_pixel: u64 = wanted(channels).iter().zip(BYTES).map(|(&wanted, bytes)| u64::from(wanted) * bytes).sum();
        let most = (device.largest_binding() / per_pixel.max(1)).max(1);
        let side = device.limits.max_texture_dimension_2d;
        progress.expect(pixels);
        let mut job = Self {
            device: Arc::clone(device),
            picture,
            camera: *camera,
            channels,
            samples,
            shape: (per_pixel, side),
            waiting: Window::split(camera.width, camera.height, most, side).into(),
            submitted: VecDeque::new(),
            frame,
        };
        job.submit_ahead(progress)?;
        Ok(job)
    }

    /// Waits for the frame's windows, submits those that are left, and returns the images.
    pub fn finish(mut self, progress: &Progress) -> Result<Frame> {
        while let Some(done) = self.submitted.pop_front() {
            self.device.wait(&done.submission, progress)?;
            done.await_opening(&self.device, progress)?;
            read::copy(&self.device, &done, &self.picture, self.camera.width, &mut self.frame)?;
            done.slot.readable().unmap();
            progress.report(done.window.pixels() as u64)?;
            self.device.slots.give_back(done.slot);
            self.submit_ahead(progress)?;
        }
        Ok(self.frame)
    }

    fn submit_ahead(&mut self, progress: &Progress) -> Result<()> {
        while self.submitted.len() < AHEAD {
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
        let bytes = self.shape.0 * window.pixels() as u64;
        let shape = Shape { width: window.width, height: window.height, multisampled, bytes };
        let mut plan = Plan::new(picture, |kind| self.frustum(kind, &window), passes.len());
        let farthest = self.farthest();
        for (pass, sampling) in &passes {
            let told = pass_of(picture, &self.camera, &window, sampling, &outputs, farthest);
            let at = pass.number * PASS_BLOCKS * BLOCK;
            plan.told[at..at + size_of_val(&told)].copy_from_slice(bytemuck::bytes_of(&told));
        }
        device.count(Written::Triangles, plan.triangles * passes.len() as u64);
        let mut slot = device.slots.take(device, shape)?;
        let nothing = device.residents.nothing(device)?;
        let scope = Scope::open(device);
        let encoder = || device.wgpu.create_command_encoder(&CommandEncoderDescriptor { label: Some("frame") });
        let mut commands = encoder();
        slot.told.tell(device, &mut commands, std::mem::take(&mut plan.told))?;
        let Some(bound) = Bound::new(device, picture, &plan, &slot, &nothing) else {
            return Err(device.failure(&"a slot without buffers"));
        };
        let mut last: Option<SubmissionIndex> = None;
        for (n, chunk) in passes.chunks(PASSES).enumerate() {
            if n > 0 {
                let submission = device.queue.submit([std::mem::replace(&mut commands, encoder()).finish()]);
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
        let submission = device.queue.submit([commands.finish()]);
        let opened = open_buffers(&slot, bytes);
        scope.close()?;
        Ok(Submitted { window, slot, outputs, numbering: plan.numbering, submission, opened })
    }

    /// Passes of a window: colour and the other channels at once where one sample serves both.
    fn passes(&self) -> Vec<(PassKind, Sampling)> {
        let (color, surface) = (self.channels.color, self.channels.any_surface());
        let pass = |number, color, surface, multisampled| PassKind { number, color, surface, multisampled };
        if !color || self.samples == 1 {
            return vec![(pass(0, color, surface, false), Sampling::CENTER)];
        }
        let mut passes = Vec::new();
        if surface {
            passes.push((pass(0, false, true, false), Sampling::CENTER));
        }
        if self.samples == SAMPLES && self.device.multisamples && self.picture.multisampled {
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

    /// What of a kind of points may be seen; none where that can't be told by boxes.
    fn frustum(&self, kind: Kind, window: &Window) -> Option<Frustum> {
        let eye = eye_of(&self.camera, &self.picture);
        let offset = self.camera.position - self.picture.origin - self.picture.center;
        match kind {
            Kind::AsItIs => Some(Frustum::new(&self.camera, window, eye, 0.0)),
            Kind::FromCenter | Kind::FromCenterOnCylinder => {
                Some(Frustum::new(&self.camera, window, eye - offset, 0.0))
            }
            // Points move by the user's offset at most, where directions are not opposed.
            Kind::Blend if offset.length() < self.picture.radii[0] => {
                Some(Frustum::new(&self.camera, window, eye, 2.0 * offset.length()))
            }
            Kind::Blend | Kind::Cylinder => None,
        }
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

impl Submitted {
    /// Waits until the output can be read and the way in is open again.
    fn await_opening(&self, device: &Device, progress: &Progress) -> Result<()> {
        loop {
            let [opened, failed] = [0, 1].map(|i: usize| self.opened[i].load(Ordering::Acquire));
            if failed > 0 {
                return Err(device.failure(&"its memory could not be read; use backend='cpu'"));
            }
            if opened == 2 {
                return Ok(());
            }
            device.wait(&self.submission, progress)?;
            progress.check()?;
        }
    }
}

/// Asks for the output and the way in; what comes of it is counted.
fn open_buffers(slot: &Slot, bytes: u64) -> Arc<[AtomicU32; 2]> {
    let opened: Arc<[AtomicU32; 2]> = Arc::default();
    let count = |opened: &Arc<[AtomicU32; 2]>| {
        let opened = Arc::clone(opened);
        move |ok: bool| {
            opened[usize::from(!ok)].fetch_add(1, Ordering::Release);
        }
    };
    let read = count(&opened);
    slot.readable().map_async(MapMode::Read, ..bytes.next_multiple_of(8), move |result| read(result.is_ok()));
    slot.told.open_again(count(&opened));
    opened
}

/// Which channels are written: colour, range, ids, position, normal.
fn wanted(channels: Channels) -> [bool; 5] {
    [channels.color, channels.range, channels.object_id || channels.face_id, channels.position, channels.normal]
}

/// First word of each channel of a window.
fn layout(channels: Channels, window: &Window) -> Outputs {
    let mut at = 0;
    let mut outputs = [u32::MAX; 5];
    for ((slot, wanted), bytes) in outputs.iter_mut().zip(wanted(channels)).zip(BYTES) {
        if wanted {
            *slot = at;
            at += (bytes / 4) as u32 * window.pixels() as u32;
        }
    }
    outputs
}
