//! Registry of this machine's adapters and of one open device per adapter and process.

use std::process;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use nearfar_core::base::{Error, Progress, Result};
use wgpu::{Adapter, Backends, Instance, InstanceDescriptor};

use super::{AdapterKind, AdapterReport, Device};

#[derive(Default)]
struct Registry {
    native: Option<Vec<Found>>,
    gl: Option<Vec<Found>>,
}

struct Found {
    adapter: Adapter,
    report: AdapterReport,
    device: Option<Arc<Device>>,
}

/// The registry, and the process that it belongs to. A forked child has none of the drivers' threads and connections,
/// and Mesa's OpenGL waits for them for ever: there, adapters are refused before taking a lock that may have been
/// held.
static KNOWN: OnceLock<(u32, Mutex<Registry>)> = OnceLock::new();

/// Returns all adapters, best first, with the reason if one cannot be used.
pub fn adapters() -> Result<Vec<AdapterReport>> {
    with_registry(|registry| {
        let mut reports: Vec<AdapterReport> = registry.find_all().map(|found| found.report.clone()).collect();
        reports.sort_by_key(AdapterReport::rank);
        reports
    })
}

/// Returns whether there is a usable hardware adapter. OpenGL is searched last, because that takes longest.
pub fn is_hardware(wanted: Option<&str>) -> Result<bool> {
    let is_one = |found: &Found| found.is_usable(wanted) && found.report.kind != AdapterKind::Software;
    with_registry(|registry| registry.native().iter().any(is_one) || registry.gl().iter().any(is_one))
}

/// Returns the device on the best `wanted` adapter, opened on first use and again after a loss.
pub fn device(wanted: Option<&str>) -> Result<Arc<Device>> {
    with_registry(|registry| {
        // A native software adapter is preferred to OpenGL's, and hardware behind OpenGL to both.
        let decided = registry.native().iter().any(|f| f.is_usable(wanted) && f.report.kind != AdapterKind::Software);
        if !decided {
            registry.gl();
        }
        let best =
            registry.found_so_far().filter(|found| found.is_usable(wanted)).min_by_key(|found| found.report.rank());
        let Some(found) = best else { return Err(Error::Device(absence(registry, wanted))) };
        if let Some(device) = found.device.as_ref().filter(|device| !device.is_lost()) {
            return Ok(device.clone());
        }
        let device = Arc::new(Device::open(&found.adapter, found.report.clone())?);
        found.device = Some(device.clone());
        Ok(device)
    })?
}

/// Waits for the work of all devices and closes them. Mesa's drivers crash at process exit while they work.
pub fn close(progress: &Progress) -> Result<()> {
    let Some((owner, registry)) = KNOWN.get() else { return Ok(()) };
    if *owner != process::id() {
        return Ok(());
    }
    let mut registry = registry.lock().unwrap_or_else(PoisonError::into_inner);
    registry.found_so_far().filter_map(|found| found.device.take()).try_for_each(|device| device.close(progress))
}

fn with_registry<R>(use_it: impl FnOnce(&mut Registry) -> R) -> Result<R> {
    let (owner, registry) = KNOWN.get_or_init(|| (process::id(), Mutex::default()));
    if *owner != process::id() {
        return Err(Error::Device(FORKED.to_string()));
    }
    Ok(use_it(&mut registry.lock().unwrap_or_else(PoisonError::into_inner)))
}

/// Message for forked children.
pub(super) const FORKED: &str = "graphics drivers do not survive a fork, and this process was forked from one that had loaded them; \
    start it by multiprocessing's 'spawn' or 'forkserver', or use backend='cpu'";

impl Registry {
    fn native(&mut self) -> &mut Vec<Found> {
        self.native.get_or_insert_with(|| find(Backends::PRIMARY))
    }

    fn gl(&mut self) -> &mut Vec<Found> {
        self.gl.get_or_insert_with(|| find(Backends::GL))
    }

    fn find_all(&mut self) -> impl Iterator<Item = &mut Found> {
        self.native();
        self.gl();
        self.found_so_far()
    }

    fn found_so_far(&mut self) -> impl Iterator<Item = &mut Found> {
        self.native.iter_mut().chain(&mut self.gl).flatten()
    }
}

impl Found {
    fn is_usable(&self, wanted: Option<&str>) -> bool {
        self.report.refused.is_empty() && wanted.is_none_or(|wanted| self.report.answers_to(wanted))
    }
}

fn find(backends: Backends) -> Vec<Found> {
    let mut descriptor = InstanceDescriptor::new_without_display_handle();
    descriptor.backends = backends;
    let instance = Instance::new(descriptor);
    let adapters = pollster::block_on(instance.enumerate_adapters(backends));
    let found = |adapter: Adapter| Found { report: AdapterReport::new(&adapter), adapter, device: None };
    adapters.into_iter().map(found).collect()
}

/// Returns the message for the case that no adapter is usable: the reason, and what to install.
fn absence(registry: &mut Registry, wanted: Option<&str>) -> String {
    let seen: Vec<String> = registry
        .find_all()
        .map(|found| match &found.report.refused[..] {
            "" => found.report.label(),
            refused => format!("{} ({refused})", found.report.label()),
        })
        .collect();
    if let (Some(name), false) = (wanted, seen.is_empty()) {
        let seen = seen.join(", ");
        return format!(
            "no graphics adapter '{name}' can be used, found {seen}; select by interface or a part of a name"
        );
    }
    let what = wanted.map_or("no graphics adapter".to_string(), |name| format!("no graphics adapter '{name}'"));
    let seen = if seen.is_empty() { "found none".to_string() } else { format!("found {}", seen.join(", ")) };
    format!("{what} can be used, {seen}; {INSTALL}")
}

const INSTALL: &str = if cfg!(target_os = "macos") {
    "Metal comes with macOS"
} else if cfg!(windows) {
    "install the graphics card's driver"
} else {
    "install a Vulkan driver, such as mesa-vulkan-drivers and libvulkan1 (Debian, Ubuntu) or mesa-vulkan-drivers and \
     vulkan-loader (Fedora), which has one in software too"
};
