//! An open device: its queue, limits and state.

use std::process;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError, RwLock};

use nearfar_core::base::{Error, Result};
use wgpu::{Adapter, DeviceDescriptor, DeviceLostReason, Features, Limits, PollType};

use super::adapters::{AdapterKind, AdapterReport, SAMPLES, VISIBILITY_FORMAT};
use super::extensions::{Extensions, lock};

/// Features needed for 64-bit atomics.
const LONG_ATOMICS: Features = Features::SHADER_INT64.union(Features::SHADER_INT64_ATOMIC_MIN_MAX);

/// A device with the state kept on it between frames.
pub struct Device {
    pub(crate) wgpu: wgpu::Device,
    queue: wgpu::Queue,
    /// Held shared by users of the queue, and exclusively while the device is closed. wgpu 30 takes its own locks in
    /// one order for writing and in another for destruction, which would deadlock.
    closing: RwLock<()>,
    pub(crate) report: AdapterReport,
    pub(crate) limits: Limits,
    /// Whether storage buffers can be read in place, because device and processor share memory.
    pub(crate) shares_memory: bool,
    /// Whether fragments write depth: OpenGL has no reversed z.
    pub(crate) writes_depth: bool,
    /// Whether multisampled integer targets work. Mesa's OpenGL reports support, but returns wrong values.
    pub(crate) multisamples: bool,
    extensions: Extensions,
    /// Whether triangles can be clipped at planes.
    pub(crate) clips: bool,
    /// Whether storage buffers have 64-bit atomics, and whether kernels may use them.
    has_long_atomics: bool,
    allows_long_atomics: AtomicBool,
    /// Whether one pass can draw two views, and whether it may.
    has_two_views: bool,
    allows_two_views: AtomicBool,
    /// Whether passes can read the device's clock.
    has_clock: bool,
    pub(crate) nanoseconds_per_tick: f32,
    /// Counts by `Counter`.
    pub(super) counts: [AtomicU64; 6],
    /// Process that opened the device; its driver threads do not exist in a forked child.
    pub(super) process: u32,
    /// Reason of the loss, once the device is lost.
    lost: Arc<Mutex<Option<String>>>,
}

impl Device {
    pub(super) fn open(adapter: &Adapter, report: AdapterReport) -> Result<Self> {
        let limits = adapter.limits();
        // Some adapters of OpenGL report these features although wgpu 30 does not implement them there.
        let optional = Features::TIMESTAMP_QUERY | Features::CLIP_DISTANCES | Features::MULTIVIEW | LONG_ATOMICS;
        let is_gl = report.backend == "gl";
        let optional = if is_gl { Features::empty() } else { optional };
        let descriptor = DeviceDescriptor {
            label: Some("nearfar"),
            required_features: adapter.features() & (Features::MAPPABLE_PRIMARY_BUFFERS | optional),
            required_limits: limits.clone(),
            ..DeviceDescriptor::default()
        };
        let (wgpu, queue) = pollster::block_on(adapter.request_device(&descriptor)).map_err(|error| {
            let label = report.label();
            Error::Device(format!("{label}: can't be opened ({error}); update its driver, or use backend='cpu'"))
        })?;
        let lost = Arc::new(Mutex::new(None));
        let loss_reason = Arc::clone(&lost);
        wgpu.set_device_lost_callback(move |reason, message| {
            let reason = match reason {
                DeviceLostReason::Destroyed => "it was closed".to_string(),
                _ => message,
            };
            *lock(&loss_reason) = Some(reason);
        });
        // Uncaught errors would end the process. After such an error the device's state is unknown.
        let loss_reason = Arc::clone(&lost);
        wgpu.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            lock(&loss_reason).get_or_insert_with(|| error.to_string());
        }));
        let features = wgpu.features();
        let flags = adapter.get_texture_format_features(VISIBILITY_FORMAT).flags;
        Ok(Self {
            nanoseconds_per_tick: queue.get_timestamp_period(),
            wgpu,
            queue,
            closing: RwLock::new(()),
            shares_memory: report.kind.uses_system_memory() && features.contains(Features::MAPPABLE_PRIMARY_BUFFERS),
            writes_depth: is_gl,
            multisamples: !is_gl && flags.sample_count_supported(SAMPLES),
            extensions: Extensions::default(),
            clips: features.contains(Features::CLIP_DISTANCES),
            has_long_atomics: features.contains(LONG_ATOMICS),
            allows_long_atomics: AtomicBool::new(true),
            has_two_views: features.contains(Features::MULTIVIEW) && limits.max_multiview_view_count >= 2,
            // In software, Mesa 22.3 draws triangles that cross an edge of a picture into the first view only.
            allows_two_views: AtomicBool::new(report.kind != AdapterKind::Software),
            has_clock: features.contains(Features::TIMESTAMP_QUERY),
            report,
            limits,
            counts: Default::default(),
            process: process::id(),
            lost,
        })
    }

    /// Returns whether passes are timed.
    pub fn has_clock(&self) -> bool {
        self.has_clock
    }

    /// Returns whether kernels use 64-bit atomics.
    pub fn uses_long_atomics(&self) -> bool {
        self.has_long_atomics && self.allows_long_atomics.load(Ordering::Relaxed)
    }

    /// Sets whether kernels may use 64-bit atomics; returns the previous setting.
    pub fn allow_long_atomics(&self, allowed: bool) -> bool {
        self.allows_long_atomics.swap(allowed, Ordering::Relaxed)
    }

    /// Returns whether one pass draws two views.
    pub(crate) fn draws_two_views(&self) -> bool {
        self.has_two_views && self.allows_two_views.load(Ordering::Relaxed)
    }

    /// Sets whether one pass may draw two views, whatever the adapter's kind; returns the previous setting. Software
    /// tests only draw triangles that cross no edge of a picture.
    pub fn allow_two_views(&self, allowed: bool) -> bool {
        self.allows_two_views.swap(allowed, Ordering::Relaxed)
    }

    /// Returns the report of its adapter.
    pub fn report(&self) -> &AdapterReport {
        &self.report
    }

    /// Returns a module's state on the device, created on first use.
    pub(crate) fn state<T: Default + Send + Sync + 'static>(&self) -> &T {
        self.extensions.get()
    }

    /// Calls a function with the queue; the device cannot be closed meanwhile.
    pub(crate) fn with_queue<R>(&self, function: impl FnOnce(&wgpu::Queue) -> R) -> R {
        let _shared = self.closing.read().unwrap_or_else(PoisonError::into_inner);
        function(&self.queue)
    }

    /// Returns whether the device is unusable.
    pub fn is_lost(&self) -> bool {
        self.loss_reason().is_some()
    }

    /// Closes the device as a driver failure would, to test recovery.
    pub fn lose(&self) {
        self.with_exclusive_queue(|| self.destroy());
    }

    /// Calls a function with exclusive use of the queue.
    pub(super) fn with_exclusive_queue<R>(&self, function: impl FnOnce() -> R) -> R {
        let _exclusive = self.closing.write().unwrap_or_else(PoisonError::into_inner);
        function()
    }

    /// Closes the device; requires exclusive use of the queue.
    pub(super) fn destroy(&self) {
        // Set before the device is destroyed, because another thread may read a frame, and checks for a loss
        // afterwards.
        lock(&self.lost).get_or_insert_with(|| "it was closed".to_string());
        self.wgpu.destroy();
        // The callback runs in the next poll.
        let _ = self.wgpu.poll(PollType::Poll);
    }

    pub(super) fn loss_reason(&self) -> Option<String> {
        lock(&self.lost).clone()
    }

    /// Returns the maximum size of a binding, which limits the parts of scenes and images, bytes.
    pub(crate) fn largest_binding(&self) -> u64 {
        // Pages are addressed by 32-bit word numbers; 2³⁰ bytes suffice and leave a reserve for drivers.
        self.report.largest_binding.min(1 << 30)
    }
}

impl std::fmt::Debug for Device {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Device({})", self.report.label())
    }
}
