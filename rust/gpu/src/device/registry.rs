//! Registry of this machine's adapters and of one open device per adapter and process.

use std::process;
use std::sync::{Arc, Mutex, OnceLock};

use nearfar_core::base::{Error, Progress, Result};
use wgpu::{Adapter, Backends, Instance, InstanceDescriptor};

use super::{AdapterKind, AdapterReport, Device, lock};

#[derive(Default)]
struct Registry {
    native: Option<Vec<Entry>>,
    gl: Option<Vec<Entry>>,
}

/// An adapter, and the device that is open on it.
struct Entry {
    adapter: Adapter,
    report: AdapterReport,
    device: Option<Arc<Device>>,
}

/// The registry, and the process that it belongs to. In a forked child, which has none of the drivers' threads and
/// connections, Mesa's OpenGL would wait for them for ever. So a child refuses all adapters, before it takes a lock
/// that its parent may have held during the fork.
static REGISTRY: OnceLock<(u32, Mutex<Registry>)> = OnceLock::new();

/// Returns all adapters, best first; unusable ones have a reason.
pub fn adapters() -> Result<Vec<AdapterReport>> {
    with_registry(|registry| {
        let mut reports: Vec<AdapterReport> = registry.find_all().map(|entry| entry.report.clone()).collect();
        reports.sort_by_key(AdapterReport::rank);
        reports
    })
}

/// Returns whether there is a usable hardware adapter. OpenGL is searched last, because that takes longest.
pub fn is_hardware(wanted: Option<&str>) -> Result<bool> {
    let is_usable = |entry: &Entry| entry.is_usable_hardware(wanted);
    with_registry(|registry| registry.native().iter().any(is_usable) || registry.gl().iter().any(is_usable))
}

/// Returns the device on the best `wanted` adapter, opened on first use and again after a loss.
pub fn device(wanted: Option<&str>) -> Result<Arc<Device>> {
    with_registry(|registry| {
        // Order of preference: native hardware, hardware through OpenGL, native software, software through OpenGL.
        if !registry.native().iter().any(|entry| entry.is_usable_hardware(wanted)) {
            registry.gl();
        }
        let usable = registry.entries().filter(|entry| entry.is_usable(wanted));
        let Some(entry) = usable.min_by_key(|entry| entry.report.rank()) else {
            return Err(Error::Device(no_adapter_message(registry, wanted)));
        };
        if let Some(device) = entry.device.as_ref().filter(|device| !device.is_lost()) {
            return Ok(device.clone());
        }
        let device = Arc::new(Device::open(&entry.adapter, entry.report.clone())?);
        entry.device = Some(device.clone());
        Ok(device)
    })?
}

/// Waits for the work of all devices and closes them. Mesa's drivers crash at process exit while they work.
pub fn close(progress: &Progress) -> Result<()> {
    match REGISTRY.get() {
        Some((owner, registry)) if *owner == process::id() => {
            let mut registry = lock(registry);
            registry.entries().filter_map(|entry| entry.device.take()).try_for_each(|device| device.close(progress))
        }
        _ => Ok(()),
    }
}

fn with_registry<R>(function: impl FnOnce(&mut Registry) -> R) -> Result<R> {
    let (owner, registry) = REGISTRY.get_or_init(|| (process::id(), Mutex::default()));
    if *owner != process::id() {
        return Err(Error::Device(FORKED.to_string()));
    }
    Ok(function(&mut lock(registry)))
}

/// Message for forked children.
pub(super) const FORKED: &str = "graphics drivers do not survive a fork, and this process was forked from one that had loaded them; \
    start it by multiprocessing's 'spawn' or 'forkserver', or use backend='cpu'";

impl Registry {
    fn native(&mut self) -> &mut Vec<Entry> {
        self.native.get_or_insert_with(|| find_adapters(Backends::PRIMARY))
    }

    fn gl(&mut self) -> &mut Vec<Entry> {
        self.gl.get_or_insert_with(|| find_adapters(Backends::GL))
    }

    fn find_all(&mut self) -> impl Iterator<Item = &mut Entry> {
        self.native();
        self.gl();
        self.entries()
    }

    /// Returns the adapters found so far.
    fn entries(&mut self) -> impl Iterator<Item = &mut Entry> {
        self.native.iter_mut().chain(&mut self.gl).flatten()
    }
}

impl Entry {
    fn is_usable(&self, wanted: Option<&str>) -> bool {
        self.report.refusal_reason.is_empty() && wanted.is_none_or(|wanted| self.report.matches(wanted))
    }

    fn is_usable_hardware(&self, wanted: Option<&str>) -> bool {
        self.is_usable(wanted) && self.report.kind != AdapterKind::Software
    }
}

fn find_adapters(backends: Backends) -> Vec<Entry> {
    let mut descriptor = InstanceDescriptor::new_without_display_handle();
    descriptor.backends = backends;
    let instance = Instance::new(descriptor);
    let adapters = pollster::block_on(instance.enumerate_adapters(backends));
    let entry = |adapter: Adapter| Entry { report: AdapterReport::new(&adapter), adapter, device: None };
    adapters.into_iter().map(entry).collect()
}

/// Returns the message when no adapter is usable: the reason, and what to install.
fn no_adapter_message(registry: &mut Registry, wanted: Option<&str>) -> String {
    let describe = |entry: &mut Entry| match &entry.report.refusal_reason[..] {
        "" => entry.report.label(),
        refused => format!("{} ({refused})", entry.report.label()),
    };
    let adapters = registry.find_all().map(describe).collect::<Vec<_>>().join(", ");
    let name = wanted.map_or(String::new(), |name| format!(" '{name}'"));
    let (found, remedy) = match &adapters[..] {
        "" => ("none", INSTALL),
        found if wanted.is_some() => (found, "select by interface or a part of a name"),
        found => (found, INSTALL),
    };
    format!("no graphics adapter{name} can be used, found {found}; {remedy}")
}

const INSTALL: &str = if cfg!(target_os = "macos") {
    "Metal comes with macOS"
} else if cfg!(windows) {
    "install the graphics card's driver"
} else {
    "install a Vulkan driver, such as mesa-vulkan-drivers and libvulkan1 (Debian, Ubuntu) or mesa-vulkan-drivers and \
     vulkan-loader (Fedora), which include a software driver"
};

/// Makes a forked process exit without the exit handlers that its parent's drivers registered. Mesa's handlers wait for
/// driver threads, which the child does not have, so it would hang or crash after its work is done.
pub fn end_without_drivers() {
    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    gnu::register_exit();
}

#[cfg(all(target_os = "linux", target_env = "gnu"))]
mod gnu {
    use std::ffi::{c_int, c_void};
    use std::ptr;

    unsafe extern "C" {
        fn on_exit(function: extern "C" fn(c_int, *mut c_void), argument: *mut c_void) -> c_int;
        fn fflush(stream: *mut c_void) -> c_int;
        fn _exit(status: c_int) -> !;
    }

    extern "C" fn flush_and_exit(status: c_int, _: *mut c_void) {
        // SAFETY: flushes all of C's streams, as `exit` does after its handlers, and does not return.
        unsafe {
            fflush(ptr::null_mut());
            _exit(status)
        }
    }

    pub fn register_exit() {
        // Handlers run in reverse order of registration, so this one precedes the inherited ones.
        // SAFETY: the function exists until the process ends, and does not read its argument.
        unsafe { on_exit(flush_and_exit, ptr::null_mut()) };
    }
}
