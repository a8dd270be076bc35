//! An open device: its queue, limits and state.

use std::process;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError, RwLock};

use nearfar_core::base::{Error, Result};
use wgpu::{Adapter, DeviceDescriptor, DeviceLostReason, Features, Limits, PollType};

use super::adapters::{AdapterKind, AdapterReport, SAMPLES, VISIBLE};
use super::extensions::Extensions;

/// Features needed for 64-bit atomics.
const LONG_ATOMICS: Features = Features::SHADER_INT64.union(Features::SHADER_INT64_ATOMIC_MIN_MAX);

/// A device with the state kept on it between frames.
pub struct Device {
    pub(crate) wgpu: wgpu::Device,
    queue: wgpu::Queue,
    /// Shared by users of the queue, exclusive while the device is closed: wgpu 30 locks its parts in one order when
    /// it writes and in another when it destroys them, which deadlocks.
    closing: RwLock<()>,
    pub(crate) report: AdapterReport,
    pub(crate) limits: Limits,
    /// Whether storage buffers can be read in place, because device and processor share memory.
    pub(crate) shares_memory: bool,
    /// Whether fragments write depth: OpenGL has no reversed z.
    pub(crate) writes_depth: bool,
    /// Whether multisampled integer targets work. Mesa's OpenGL reports them and reads other values than it drew.
    pub(crate) multisamples: bool,
    extensions: Extensions,
    /// Whether triangles can be clipped at planes.
    pub(crate) clips: bool,
    /// Whether storage buffers have 64-bit atomics, and whether kernels may use them.
    has_long_atomics: bool,
    allows_long_atomics: AtomicBool,
    /// Whether one pass can draw two views, and whether it may.
    two_views: bool,
    allows_two_views: AtomicBool,
    /// Whether passes can read the device's clock.
    pub(crate) has_clock: bool,
    pub(crate) nanoseconds_per_tick: f32,
    pub(super) made: [AtomicU64; 6],
    /// Process that opened it; a forked child has no driver threads.
    pub(super) process: u32,
    lost: Arc<Mutex<Option<String>>>,
}

impl Device {
    pub(super) fn open(adapter: &Adapter, report: AdapterReport) -> Result<Self> {
        let limits = adapter.limits();
        // wgpu 30 implements none of these for all of OpenGL's adapters that report them.
        let native = Features::TIMESTAMP_QUERY | Features::CLIP_DISTANCES | Features::MULTIVIEW | LONG_ATOMICS;
        let native = if report.backend == "gl" { Features::empty() } else { native };
        let descriptor = DeviceDescriptor {
            label: Some("nearfar"),
            required_features: adapter.features() & (Features::MAPPABLE_PRIMARY_BUFFERS | native),
            required_limits: limits.clone(),
            ..DeviceDescriptor::default()
        };
        let (wgpu, queue) = pollster::block_on(adapter.request_device(&descriptor)).map_err(|error| {
            Error::Device(format!(
                "{}: can't be opened ({error}); update its driver, or use backend='cpu'",
                report.label()
            ))
        })?;
        let lost = Arc::new(Mutex::new(None));
        let reason_of_loss = Arc::clone(&lost);
        wgpu.set_device_lost_callback(move |reason, message| {
            let reason = match reason {
                DeviceLostReason::Destroyed => "it was closed".to_string(),
                _ => message,
            };
            *reason_of_loss.lock().unwrap_or_else(PoisonError::into_inner) = Some(reason);
        });
        // Uncaught errors would end the process. After such an error the device's state is unknown.
        let reason_of_loss = Arc::clone(&lost);
        wgpu.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            reason_of_loss.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert_with(|| error.to_string());
        }));
        let software = matches!(report.kind, AdapterKind::Software);
        let shared = matches!(report.kind, AdapterKind::Software | AdapterKind::Integrated);
        let (shares_memory, writes_depth) =
            (shared && wgpu.features().contains(Features::MAPPABLE_PRIMARY_BUFFERS), report.backend == "gl");
        let flags = adapter.get_texture_format_features(VISIBLE).flags;
        let multisamples = report.backend != "gl" && flags.sample_count_supported(SAMPLES);
        let clips = wgpu.features().contains(Features::CLIP_DISTANCES);
        let two_views = wgpu.features().contains(Features::MULTIVIEW) && limits.max_multiview_view_count >= 2;
        let has_long_atomics = wgpu.features().contains(LONG_ATOMICS);
        let (has_clock, nanoseconds_per_tick) =
            (wgpu.features().contains(Features::TIMESTAMP_QUERY), queue.get_timestamp_period());
        Ok(Self {
            wgpu,
            queue,
            closing: RwLock::new(()),
            report,
            limits,
            shares_memory,
            writes_depth,
            multisamples,
            extensions: Extensions::default(),
            clips,
            has_long_atomics,
            allows_long_atomics: AtomicBool::new(true),
            two_views,
            // In software, Mesa 22.3 draws triangles that cross an edge of a picture into the first view only.
            allows_two_views: AtomicBool::new(!software),
            has_clock,
            nanoseconds_per_tick,
            made: Default::default(),
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
        self.two_views && self.allows_two_views.load(Ordering::Relaxed)
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
    pub(crate) fn with_queue<R>(&self, job: impl FnOnce(&wgpu::Queue) -> R) -> R {
        let _shared = self.closing.read().unwrap_or_else(PoisonError::into_inner);
        job(&self.queue)
    }

    /// Returns whether the device is unusable.
    pub fn is_lost(&self) -> bool {
        self.lost_because().is_some()
    }

    /// Closes the device as a driver failure would, to test recovery.
    pub fn lose(&self) {
        self.alone(|| self.destroy());
    }

    /// Calls a function with exclusive use of the queue.
    pub(super) fn alone<R>(&self, job: impl FnOnce() -> R) -> R {
        let _alone = self.closing.write().unwrap_or_else(PoisonError::into_inner);
        job()
    }

    /// Closes the device; requires exclusive use of the queue.
    pub(super) fn destroy(&self) {
        // Set before the device is destroyed: another thread that reads a frame checks it afterwards.
        self.lost.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert_with(|| "it was closed".to_string());
        self.wgpu.destroy();
        // The callback runs in the next poll.
        let _ = self.wgpu.poll(PollType::Poll);
    }

    pub(super) fn lost_because(&self) -> Option<String> {
        self.lost.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Returns the maximum size of a binding, and so of a part of a scene or image, bytes.
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
