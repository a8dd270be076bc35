//! Parts of images ("windows") that the device is drawing, and a pool of slots: the targets and buffers of one such
//! part. A frame takes a slot of its shape and returns it, so repeated frames allocate nothing.

use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, Mutex};

use nearfar_core::base::{Progress, Result};
use wgpu::{
    BufferUsages, Extent3d, MapMode, TextureDescriptor, TextureDimension, TextureFormat, TextureUsages, TextureView,
    TextureViewDescriptor, TextureViewDimension,
};

use super::inputs::ShaderInputs;
use super::pipelines::DEPTH;
use super::plan::Numbering;
use super::timing::Stopwatch;
use super::window::{Outputs, Window};
use crate::device::{Device, SAMPLES, Submission, UNREADABLE, VISIBILITY_FORMAT, lock};

/// Maximum number and bytes of idle slots; one slot is kept whatever its size.
const MAX_IDLE_SLOTS: usize = 6;
const MAX_IDLE_BYTES: u64 = 1 << 29;

#[derive(Default)]
pub(crate) struct Slots(Mutex<Vec<Slot>>);

/// Size of a slot's targets and output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Shape {
    pub width: u32,
    pub height: u32,
    /// Number of views drawn at once.
    pub views: u32,
    /// Whether there is an additional multisampled target.
    pub multisampled: bool,
    /// Size of the output buffer.
    pub output_bytes: u64,
}

impl Shape {
    /// Returns the bytes of a slot of this shape, without inputs.
    fn total_bytes(&self) -> u64 {
        let samples = 1 + u64::from(self.multisampled) * u64::from(SAMPLES);
        2 * self.output_bytes + 12 * samples * u64::from(self.views) * u64::from(self.width) * u64::from(self.height)
    }
}

/// Target of a raster pass.
pub(super) struct Target {
    /// Instance record and face that each pixel shows, for all views.
    pub faces: TextureView,
    pub depth: TextureView,
    /// Layer of `faces` for each camera view.
    pub faces_by_view: Vec<TextureView>,
}

/// Targets and buffers of one window that the device draws.
pub(super) struct Slot {
    pub shape: Shape,
    pub single_sampled: Target,
    pub multisampled: Option<Target>,
    pub output: wgpu::Buffer,
    /// Staging copy for the CPU; `None` if the CPU can read the output itself.
    pub staging: Option<wgpu::Buffer>,
    pub inputs: ShaderInputs,
    /// Timer of the passes, if the device has a clock.
    pub watch: Option<Stopwatch>,
}

impl Slots {
    /// Takes a slot of a shape, creating one if none is idle.
    pub(super) fn take(&self, device: &Device, shape: Shape) -> Result<Slot> {
        let take =
            |slots: &mut Vec<Slot>| slots.iter().rposition(|slot| slot.shape == shape).map(|index| slots.remove(index));
        let idle = take(&mut lock(&self.0));
        idle.map_or_else(|| Slot::new(device, shape), Ok)
    }

    /// Returns a slot to the pool, after its frame is read and its inputs are mapped again.
    pub(super) fn give_back(&self, slot: Slot) {
        let mut slots = lock(&self.0);
        slots.push(slot);
        let bytes = |slots: &[Slot]| slots.iter().map(|slot| slot.shape.total_bytes()).sum::<u64>();
        while slots.len() > MAX_IDLE_SLOTS || slots.len() > 1 && bytes(&slots) > MAX_IDLE_BYTES {
            slots.remove(0);
        }
    }
}

impl Slot {
    fn new(device: &Device, shape: Shape) -> Result<Self> {
        let mut usage = BufferUsages::STORAGE | BufferUsages::COPY_SRC;
        if device.shares_memory {
            usage |= BufferUsages::MAP_READ;
        }
        let read = BufferUsages::MAP_READ | BufferUsages::COPY_DST;
        let staging = || device.buffer("read-back", shape.output_bytes, read);
        Ok(Self {
            shape,
            single_sampled: Target::new(device, shape, 1)?,
            multisampled: shape.multisampled.then(|| Target::new(device, shape, SAMPLES)).transpose()?,
            output: device.buffer("output", shape.output_bytes, usage)?,
            staging: (!device.shares_memory).then(staging).transpose()?,
            inputs: ShaderInputs::default(),
            watch: Stopwatch::new(device)?,
        })
    }

    /// Returns the buffer that the CPU reads.
    pub fn readable(&self) -> &wgpu::Buffer {
        self.staging.as_ref().unwrap_or(&self.output)
    }
}

impl Target {
    fn new(device: &Device, shape: Shape, samples: u32) -> Result<Self> {
        let target = TextureUsages::RENDER_ATTACHMENT;
        let texture = |label, format: TextureFormat, usage, bytes: u64| {
            let size = Extent3d { width: shape.width, height: shape.height, depth_or_array_layers: shape.views };
            device.texture(
                &TextureDescriptor {
                    label: Some(label),
                    size,
                    mip_level_count: 1,
                    sample_count: samples,
                    dimension: TextureDimension::D2,
                    format,
                    usage,
                    view_formats: &[],
                },
                bytes * u64::from(samples * shape.views) * u64::from(shape.width) * u64::from(shape.height),
            )
        };
        let faces = texture("faces", VISIBILITY_FORMAT, target | TextureUsages::TEXTURE_BINDING, 8)?;
        let depth = texture("depth", DEPTH, target, 4)?;
        let layer = |base_array_layer| {
            faces.create_view(&TextureViewDescriptor {
                dimension: Some(TextureViewDimension::D2),
                base_array_layer,
                array_layer_count: Some(1),
                ..TextureViewDescriptor::default()
            })
        };
        Ok(Self {
            faces_by_view: (0..shape.views).map(layer).collect(),
            faces: faces.create_view(&TextureViewDescriptor::default()),
            depth: depth.create_view(&TextureViewDescriptor::default()),
        })
    }
}

/// A window that the device is processing.
pub(super) struct Submitted {
    pub window: Window,
    pub slot: Slot,
    /// Output layout of each view.
    pub outputs: Vec<Outputs>,
    pub numbering: Vec<Numbering>,
    pub submission: Submission,
    /// Numbers of successful and failed mappings: one of the output, and one of the inputs.
    pub mapped: Arc<[AtomicU32; 2]>,
}

impl Submitted {
    /// Waits until the output is mapped for reading and the inputs are mapped again.
    pub fn await_mapping(&self, device: &Device, progress: &Progress) -> Result<()> {
        loop {
            let [mapped, failed] = [0, 1].map(|i: usize| self.mapped[i].load(Ordering::Acquire));
            if failed > 0 {
                return Err(device.failure(UNREADABLE));
            }
            if mapped == 2 {
                return Ok(());
            }
            device.wait(&self.submission, progress)?;
            progress.check()?;
        }
    }
}

/// Starts to map the output for reading and the inputs for writing. Returns the counters of successful and failed
/// mappings.
pub(super) fn map_buffers(slot: &Slot, bytes: u64) -> Arc<[AtomicU32; 2]> {
    let mapped: Arc<[AtomicU32; 2]> = Arc::default();
    let count = |mapped: &Arc<[AtomicU32; 2]>| {
        let mapped = Arc::clone(mapped);
        move |ok: bool| {
            mapped[usize::from(!ok)].fetch_add(1, Ordering::Release);
        }
    };
    let read = count(&mapped);
    slot.readable().map_async(MapMode::Read, ..bytes.next_multiple_of(8), move |result| read(result.is_ok()));
    slot.inputs.map_again(count(&mapped));
    mapped
}
