//! A frame that stays on the device: kernels read it there, and it is copied to the processor on request.

use std::sync::atomic::Ordering;
use std::sync::{Arc, Mutex, MutexGuard};

use glam::DVec3;
use nearfar_core::base::{Error, Progress, Result};
use nearfar_core::camera::Camera;
use nearfar_core::render::{Channels, Frame};
use wgpu::PollType;

use super::job::Job;
use super::picture::Picture;
use super::read;
use super::slots::{Slots, Submitted};
use super::window::window_limits;
use crate::device::{Device, lock};

/// Images of a frame on the device. Its slot is reused after the frame is dropped.
pub struct DeviceFrame {
    device: Arc<Device>,
    picture: Picture,
    camera: Camera,
    channels: Channels,
    submitted: Option<Submitted>,
}

/// Lock of a device's frames.
#[derive(Default)]
struct FrameLock(Mutex<()>);

/// Location of a channel in a buffer.
pub(crate) struct Section<'a> {
    pub buffer: &'a wgpu::Buffer,
    /// First word of the channel.
    pub first: u32,
}

impl Job {
    /// Keeps the frame on the device, without waiting for it: kernels that read it come later in the queue.
    pub fn keep(mut self, progress: &Progress) -> Result<DeviceFrame> {
        let [camera] = self.cameras[..] else {
            return Err(Error::value("frame", "one picture", "two that are drawn at once"));
        };
        self.device.check_whole(&camera, self.channels)?;
        let Some(submitted) = self.submitted.pop_front() else {
            return Err(self.device.failure("a frame without a window"));
        };
        // `submit` has requested to map the output for reading, but kernels cannot use a mapped buffer.
        submitted.slot.readable().unmap();
        progress.report(submitted.window.pixels() as u64)?;
        let Self { device, picture, channels, .. } = self;
        Ok(DeviceFrame { device, picture, camera, channels, submitted: Some(submitted) })
    }
}

impl Device {
    /// Fails for a frame that is too large to stay on the device, because it would be drawn in several windows.
    pub fn check_whole(&self, camera: &Camera, channels: Channels) -> Result<()> {
        let (max_pixels, max_side) = window_limits(self, channels);
        let Camera { width, height, .. } = *camera;
        if width.max(height) <= max_side && u64::from(width) * u64::from(height) <= max_pixels {
            return Ok(());
        }
        let label = self.report().label();
        let expected =
            format!("at most {max_pixels} pixels in these channels and {max_side} each way, which {label} can hold");
        Err(Error::value("camera", expected, format!("{width} × {height}")))
    }
}

impl DeviceFrame {
    /// Returns the device that holds the frame.
    pub fn device(&self) -> &Arc<Device> {
        &self.device
    }

    /// Returns the frame's camera.
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// Returns the world position that points are relative to.
    pub fn origin(&self) -> DVec3 {
        self.picture.origin
    }

    /// Copies the frame's images to the processor.
    pub fn read(&self, progress: &Progress) -> Result<Frame> {
        let submitted = self.submitted()?;
        let pixels = submitted.window.pixels();
        progress.expect(pixels as u64);
        let mut frame = Frame::new(self.channels, pixels)?;
        let words = self.words(submitted, progress)?;
        read::fill(&words, submitted, &submitted.outputs[0], &self.picture, self.camera.width, &mut frame);
        progress.report(pixels as u64)?;
        Ok(frame)
    }

    /// Locks the frames of the device. A frame must not be mapped while work that reads it is submitted, so both hold
    /// this lock.
    pub(crate) fn lock(&self) -> MutexGuard<'_, ()> {
        lock(&self.device.state::<FrameLock>().0)
    }

    /// Copies the output's words on this thread alone: a thread that waits inside rayon may run another task, which
    /// may need the same lock.
    fn words(&self, submitted: &Submitted, progress: &Progress) -> Result<Vec<u32>> {
        let _lock = self.lock();
        let slot = &submitted.slot;
        self.device.read_buffer(slot.readable(), slot.shape.output_bytes, progress, bytemuck::pod_collect_to_vec)
    }

    /// Returns the linear colour, three words per pixel.
    pub(crate) fn color(&self) -> Result<Section<'_>> {
        self.section(0, "color")
    }

    /// Returns the points relative to the origin, three words per pixel.
    pub(crate) fn position(&self) -> Result<Section<'_>> {
        self.section(3, "position")
    }

    fn section(&self, channel: usize, name: &str) -> Result<Section<'_>> {
        let submitted = self.submitted()?;
        match submitted.outputs[0][channel] {
            u32::MAX => Err(Error::value("frame", format!("one with {name}"), "one without")),
            first => Ok(Section { buffer: &submitted.slot.output, first }),
        }
    }

    fn submitted(&self) -> Result<&Submitted> {
        self.device.check()?;
        self.submitted.as_ref().ok_or_else(|| self.device.failure("a frame without a slot"))
    }
}

impl Drop for DeviceFrame {
    fn drop(&mut self) {
        let Some(submitted) = self.submitted.take() else { return };
        // Mapping callbacks run during a poll.
        let polled = self.device.wgpu.poll(PollType::Poll);
        let [mapped, failed] = [0, 1].map(|i: usize| submitted.mapped[i].load(Ordering::Acquire));
        // Two mappings were requested. The mapping of the output was cancelled, perhaps too late; the mapping of the
        // inputs must succeed before the next frame uses the slot.
        if polled.is_ok() && !self.device.is_lost() && mapped > 0 && mapped + failed == 2 {
            self.device.state::<Slots>().give_back(submitted.slot);
        }
    }
}
