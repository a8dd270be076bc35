//! An open device: its queue, its limits, and what was made on it.

use std::sync::atomic::AtomicU64;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use nearfar_core::base::{Error, Progress, Result};
use wgpu::{Adapter, DeviceDescriptor, DeviceLostReason, Features, Limits, PollError, PollType, SubmissionIndex};

use super::{AdapterKind, AdapterReport};
use crate::compute::Kernels;
use crate::draw::{Pipelines, Slots};
use crate::upload::Residents;

/// How long the device is waited for before the caller is asked whether to go on.
const POLL: Duration = Duration::from_millis(20);

/// A device with everything that is kept on it between frames.
pub struct Device {
    pub(crate) wgpu: wgpu::Device,
    pub(crate) queue: wgpu::Queue,
    pub(crate) report: AdapterReport,
    pub(crate) limits: Limits,
    /// Storage buffers can be read where they are, because device and processor share their memory.
    pub(crate) shares_memory: bool,
    /// Depth is written by fragments: OpenGL's own has no reversed z.
    pub(crate) writes_depth: bool,
    pub(crate) residents: Residents,
    pub(crate) pipelines: Pipelines,
    pub(crate) slots: Slots,
    pub(crate) kernels: Kernels,
    pub(super) made: [AtomicU64; 4],
    lost: Arc<Mutex<Option<String>>>,
}

impl Device {
    pub(super) fn open(adapter: &Adapter, report: AdapterReport) -> Result<Self> {
        let limits = adapter.limits();
        let descriptor = DeviceDescriptor {
            label: Some("nearfar"),
            required_features: adapter.features() & Features::MAPPABLE_PRIMARY_BUFFERS,
            required_limits: limits.clone(),
            ..DeviceDescriptor::default()
        };
        let (wgpu, queue) = pollster::block_on(adapter.request_device(&descriptor)).map_err(|error| {
            Error::Device(format!("{}: can't be opened ({error}); update its driver, or use backend='cpu'", report.label()))
        })?;
        let lost = Arc::new(Mutex::new(None));
        let told = Arc::clone(&lost);
        wgpu.set_device_lost_callback(move |reason, message| {
            let reason = match reason {
                DeviceLostReason::Destroyed => "it was closed".to_string(),
                _ => message,
            };
            *told.lock().unwrap_or_else(PoisonError::into_inner) = Some(reason);
        });
        let shared = matches!(report.kind, AdapterKind::Software | AdapterKind::Integrated);
        let (shares_memory, writes_depth) =
            (shared && wgpu.features().contains(Features::MAPPABLE_PRIMARY_BUFFERS), report.backend == "gl");
        Ok(Self {
            wgpu,
            queue,
            report,
            limits,
            shares_memory,
            writes_depth,
            residents: Residents::default(),
            pipelines: Pipelines::default(),
            slots: Slots::default(),
            kernels: Kernels::default(),
            made: Default::default(),
            lost,
        })
    }

    /// The adapter that it was opened on.
    pub fn report(&self) -> &AdapterReport {
        &self.report
    }

    /// True once it can't be used any more.
    pub fn is_lost(&self) -> bool {
        self.lost_because().is_some()
    }

    /// Closes the device as a driver's fault would, so that what follows can be tried.
    pub fn lose(&self) {
        self.wgpu.destroy();
        // The callback comes with the next poll.
        let _ = self.wgpu.poll(PollType::Poll);
        let mut lost = self.lost.lock().unwrap_or_else(PoisonError::into_inner);
        lost.get_or_insert_with(|| "it was closed".to_string());
    }

    pub(super) fn lost_because(&self) -> Option<String> {
        self.lost.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Waits for submitted work as long as the caller wants to.
    pub(crate) fn wait(&self, submission: &SubmissionIndex, progress: &Progress) -> Result<()> {
        loop {
            let wait = PollType::Wait { submission_index: Some(submission.clone()), timeout: Some(POLL) };
            match self.wgpu.poll(wait) {
                Ok(_) => return self.check(),
                Err(PollError::Timeout) => progress.check()?,
                Err(error) => return Err(Error::Device(format!("{}: {error}", self.report.label()))),
            }
            self.check()?;
        }
    }

    /// Bytes that one binding, and so one part of a scene or image, may have.
    pub(crate) fn largest_binding(&self) -> u64 {
        // A page is addressed by 32-bit numbers of words; 2³⁰ bytes are plenty and leave drivers room.
        self.report.largest_binding.min(1 << 30)
    }
}

impl std::fmt::Debug for Device {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Device({})", self.report.label())
    }
}
