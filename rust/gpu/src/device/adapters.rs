//! Adapters: which can be used, and in which order they are taken.

use wgpu::{Adapter, Backend, DeviceType, DownlevelFlags, TextureFormat, TextureUsages};

/// The kind of processor that executes an adapter's work.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum AdapterKind {
    /// A card with memory of its own.
    Discrete,
    /// A GPU that shares the processor's memory.
    Integrated,
    /// A share of another machine's GPU.
    Virtual,
    /// The driver doesn't say.
    Unknown,
    /// The processor itself: lavapipe, llvmpipe, WARP.
    Software,
}

impl AdapterKind {
    /// The name that users read.
    pub fn name(self) -> &'static str {
        match self {
            Self::Discrete => "discrete",
            Self::Integrated => "integrated",
            Self::Virtual => "virtual",
            Self::Unknown => "unknown",
            Self::Software => "software",
        }
    }
}

/// An adapter that was found.
#[derive(Clone, Debug)]
pub struct AdapterReport {
    /// The driver's name for it.
    pub name: String,
    /// "vulkan", "metal", "dx12" or "gl".
    pub backend: &'static str,
    /// The kind of processor that executes its work.
    pub kind: AdapterKind,
    /// Driver and version.
    pub driver: String,
    /// Why it can't be used; empty where it can.
    pub refused: String,
    /// Bytes that one binding may have: larger scenes and images are drawn in parts.
    pub largest_binding: u64,
    /// Pixels across that one picture may have: larger ones are drawn in parts.
    pub largest_image: u32,
}

/// Format of targets that hold the visible faces: a record and a face in four halves. Every adapter in use draws it.
pub(crate) const VISIBLE: TextureFormat = TextureFormat::Rgba16Uint;
/// Samples of a pixel of targets that have several.
pub(crate) const SAMPLES: u32 = 4;
/// Storage buffers that a pass binds.
const STORAGE_BUFFERS: u32 = 8;

impl AdapterReport {
    pub(super) fn of(adapter: &Adapter) -> Self {
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
            backend: backend_name(info.backend),
            kind,
            driver: [info.driver, info.driver_info].join(" ").trim().to_string(),
            refused: refusal(adapter).unwrap_or_default(),
            largest_binding: limits.max_storage_buffer_binding_size.min(limits.max_buffer_size),
            largest_image: limits.max_texture_dimension_2d,
        }
    }

    /// Name and back end, by which messages and users name it.
    pub fn label(&self) -> String {
        format!("{} ({})", self.name, self.backend)
    }

    /// True where the text is its back end or a part of its name.
    pub fn answers_to(&self, wanted: &str) -> bool {
        let wanted = wanted.to_lowercase();
        self.backend == wanted || self.label().to_lowercase().contains(&wanted)
    }

    /// Sort key: the adapter with the least one is taken first.
    pub(super) fn rank(&self) -> (bool, AdapterKind, usize) {
        let order = ["metal", "vulkan", "dx12", "gl"];
        let backend = order.iter().position(|&name| name == self.backend).unwrap_or(order.len());
        (!self.refused.is_empty(), self.kind, backend)
    }
}

fn backend_name(backend: Backend) -> &'static str {
    match backend {
        Backend::Vulkan => "vulkan",
        Backend::Metal => "metal",
        Backend::Dx12 => "dx12",
        Backend::Gl => "gl",
        _ => "other",
    }
}

/// Features that an adapter lacks, as a sentence; none where it has all.
fn refusal(adapter: &Adapter) -> Option<String> {
    let needed = DownlevelFlags::COMPUTE_SHADERS | DownlevelFlags::VERTEX_STORAGE | DownlevelFlags::FRAGMENT_STORAGE;
    let missing = needed - adapter.get_downlevel_capabilities().flags;
    if !missing.is_empty() {
        return Some(format!("it lacks {missing:?}"));
    }
    let limits = adapter.limits();
    if limits.max_storage_buffers_per_shader_stage < STORAGE_BUFFERS {
        let count = limits.max_storage_buffers_per_shader_stage;
        return Some(format!("it binds {count} storage buffers, {STORAGE_BUFFERS} are needed"));
    }
    let usages = adapter.get_texture_format_features(VISIBLE).allowed_usages;
    let wanted = TextureUsages::RENDER_ATTACHMENT | TextureUsages::TEXTURE_BINDING;
    (!usages.contains(wanted)).then(|| "it draws no 64-bit integers".to_string())
}
