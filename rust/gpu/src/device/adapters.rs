//! Adapters: capabilities and order of preference.

use wgpu::{Adapter, DeviceType, DownlevelFlags, TextureFormat, TextureUsages};

/// Kind of processor that an adapter drives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum AdapterKind {
    /// A card with dedicated memory.
    Discrete,
    /// A GPU that shares the processor's memory.
    Integrated,
    /// A share of another machine's GPU.
    Virtual,
    /// Not reported by the driver.
    Unknown,
    /// The processor itself: lavapipe, llvmpipe, WARP.
    Software,
}

impl AdapterKind {
    /// Returns the name shown to users.
    pub fn name(self) -> &'static str {
        match self {
            Self::Discrete => "discrete",
            Self::Integrated => "integrated",
            Self::Virtual => "virtual",
            Self::Unknown => "unknown",
            Self::Software => "software",
        }
    }

    /// Returns whether the adapter shares the system's memory.
    pub(super) fn uses_system_memory(self) -> bool {
        matches!(self, Self::Software | Self::Integrated)
    }
}

/// Description of an adapter.
#[derive(Clone, Debug)]
pub struct AdapterReport {
    /// Name from the driver.
    pub name: String,
    /// Graphics interface: "vulkan", "metal", "dx12" or "gl".
    pub backend: &'static str,
    /// Kind of processor that it drives.
    pub kind: AdapterKind,
    /// Driver and version.
    pub driver: String,
    /// Reason why it cannot be used; empty if usable.
    pub refusal_reason: String,
    /// Maximum size of a binding, bytes: larger scenes and images are drawn in parts.
    pub largest_binding: u64,
    /// Maximum width of a picture, pixels: larger ones are drawn in parts.
    pub largest_image: u32,
}

/// Format of visibility targets: the numbers of an instance record and of a face, each split into two 16-bit integers.
/// Usable adapters can render to it.
pub(crate) const VISIBILITY_FORMAT: TextureFormat = TextureFormat::Rgba16Uint;
/// Samples per pixel of multisampled targets.
pub(crate) const SAMPLES: u32 = 4;
/// Number of storage buffers that a pass binds.
const STORAGE_BUFFERS: u32 = 8;

impl AdapterReport {
    pub(super) fn new(adapter: &Adapter) -> Self {
        let (info, limits) = (adapter.get_info(), adapter.limits());
        let kind = match info.device_type {
            DeviceType::DiscreteGpu => AdapterKind::Discrete,
            DeviceType::IntegratedGpu => AdapterKind::Integrated,
            DeviceType::VirtualGpu => AdapterKind::Virtual,
            DeviceType::Cpu => AdapterKind::Software,
            DeviceType::Other => AdapterKind::Unknown,
        };
        Self {
            name: info.name,
            backend: info.backend.to_str(),
            kind,
            driver: [info.driver, info.driver_info].join(" ").trim().to_string(),
            refusal_reason: missing_features(adapter).unwrap_or_default(),
            largest_binding: limits.max_storage_buffer_binding_size.min(limits.max_buffer_size),
            largest_image: limits.max_texture_dimension_2d,
        }
    }

    /// Returns name and interface, as shown in messages and accepted from users.
    pub fn label(&self) -> String {
        format!("{} ({})", self.name, self.backend)
    }

    /// Returns whether a text is its interface or a part of its label.
    pub fn matches(&self, text: &str) -> bool {
        let text = text.to_lowercase();
        self.backend == text || self.label().to_lowercase().contains(&text)
    }

    /// Returns the sort key; the adapter with the smallest key is preferred.
    pub(super) fn rank(&self) -> (bool, AdapterKind, usize) {
        let order = ["metal", "vulkan", "dx12", "gl"];
        let backend = order.iter().position(|&name| name == self.backend).unwrap_or(order.len());
        (!self.refusal_reason.is_empty(), self.kind, backend)
    }
}

/// Returns what an adapter lacks, as a sentence; `None` if it is usable.
fn missing_features(adapter: &Adapter) -> Option<String> {
    let required = DownlevelFlags::COMPUTE_SHADERS | DownlevelFlags::VERTEX_STORAGE | DownlevelFlags::FRAGMENT_STORAGE;
    let missing = required - adapter.get_downlevel_capabilities().flags;
    if !missing.is_empty() {
        let names: Vec<_> = missing.iter_names().map(|(name, _)| name).collect();
        return Some(format!("it lacks {}", names.join(", ")));
    }
    let count = adapter.limits().max_storage_buffers_per_shader_stage;
    if count < STORAGE_BUFFERS {
        return Some(format!("it binds {count} storage buffers, {STORAGE_BUFFERS} are needed"));
    }
    let required = TextureUsages::RENDER_ATTACHMENT | TextureUsages::TEXTURE_BINDING;
    let allowed = adapter.get_texture_format_features(VISIBILITY_FORMAT).allowed_usages;
    (!allowed.contains(required)).then(|| "it cannot render to textures of four 16-bit integers".to_string())
}
