//! Targets and buffers of frames in flight. A frame takes a slot that fits and gives it back, so that steady work makes
//! nothing anew.

use std::sync::{Mutex, PoisonError};

use nearfar_core::base::Result;
use wgpu::{
    BufferUsages, Extent3d, MapMode, TextureDescriptor, TextureDimension, TextureFormat, TextureUsages, TextureView,
    TextureViewDescriptor,
};

use super::pipelines::{DEPTH, VISIBLE};
use crate::device::{Device, Written};

/// Slots that wait for frames of their size, and bytes of them: the last one waits however large it is.
const KEPT: usize = 6;
const KEPT_BYTES: u64 = 1 << 29;
/// Bytes that what shaders are told is compared by, and that its sections begin at multiples of.
pub(super) const BLOCK: usize = 256;

/// Slots that no frame uses.
#[derive(Default)]
pub(crate) struct Slots(Mutex<Vec<Slot>>);

/// What a slot is made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Shape {
    pub width: u32,
    pub height: u32,
    /// A target of several samples is there besides.
    pub multisampled: bool,
    /// Bytes of the output.
    pub bytes: u64,
}

impl Shape {
    /// Bytes of all that a slot of this shape holds, but for what shaders are told.
    fn total_bytes(&self) -> u64 {
        let samples = 1 + if self.multisampled { u64::from(SAMPLES) } else { 0 };
        2 * self.bytes + 12 * samples * u64::from(self.width) * u64::from(self.height)
    }
}

/// Target of a raster pass.
pub(super) struct Target {
    pub visible: TextureView,
    pub depth: TextureView,
}

/// One frame's own memory on the device.
pub(super) struct Slot {
    pub shape: Shape,
    pub single: Target,
    pub multisampled: Option<Target>,
    pub output: wgpu::Buffer,
    /// Where the output is read; none where it can be read itself.
    pub staging: Option<wgpu::Buffer>,
    /// What shaders are told.
    pub told: Told,
}

/// Samples of a target that has several.
pub(crate) const SAMPLES: u32 = 4;

impl Slots {
    /// A slot of a shape, made where none is left.
    pub(super) fn take(&self, device: &Device, shape: Shape) -> Result<Slot> {
        let mut slots = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        match slots.iter().rposition(|slot| slot.shape == shape) {
            Some(found) => Ok(slots.remove(found)),
            None => {
                drop(slots);
                Slot::new(device, shape)
            }
        }
    }

    /// Gives back a slot whose frame is read and whose buffers are as they were.
    pub(super) fn give_back(&self, slot: Slot) {
        let mut slots = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        slots.push(slot);
        let bytes = |slots: &[Slot]| slots.iter().map(|slot| slot.shape.total_bytes()).sum::<u64>();
        while slots.len() > KEPT || slots.len() > 1 && bytes(&slots) > KEPT_BYTES {
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
        let staging = |()| device.buffer("read-back", shape.bytes, read);
        Ok(Self {
            shape,
            single: Target::new(device, shape, 1)?,
            multisampled: shape.multisampled.then(|| Target::new(device, shape, SAMPLES)).transpose()?,
            output: device.buffer("output", shape.bytes, usage)?,
            staging: (!device.shares_memory).then_some(()).map(staging).transpose()?,
            told: Told::default(),
        })
    }

    /// The buffer that is read.
    pub fn readable(&self) -> &wgpu::Buffer {
        self.staging.as_ref().unwrap_or(&self.output)
    }
}

impl Target {
    fn new(device: &Device, shape: Shape, samples: u32) -> Result<Self> {
        let view = |label, format: TextureFormat, usage, bytes: u64| {
            let size = Extent3d { width: shape.width, height: shape.height, depth_or_array_layers: 1 };
            let texture = device.texture(
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
                bytes * u64::from(samples) * u64::from(shape.width) * u64::from(shape.height),
            )?;
            Ok(texture.create_view(&TextureViewDescriptor::default()))
        };
        let target = TextureUsages::RENDER_ATTACHMENT;
        Ok(Self {
            visible: view("visible", VISIBLE, target | TextureUsages::TEXTURE_BINDING, 8)?,
            depth: view("depth", DEPTH, target, 4)?,
        })
    }
}

/// What shaders are told for a frame, and what is known on the device already.
#[derive(Default)]
pub(super) struct Told {
    /// On the device, and the mapped buffer that changes pass through.
    buffers: Option<(wgpu::Buffer, wgpu::Buffer)>,
    known: Vec<u8>,
}

impl Told {
    /// Sends what differs from the last frame's.
    pub fn tell(&mut self, device: &Device, encoder: &mut wgpu::CommandEncoder, words: Vec<u8>) -> Result<()> {
        let size = (words.len() as u64).next_multiple_of(BLOCK as u64).next_power_of_two();
        if self.buffers.as_ref().is_none_or(|(buffer, _)| buffer.size() < size) {
            let usage = BufferUsages::UNIFORM | BufferUsages::STORAGE | BufferUsages::COPY_DST;
            let buffer = device.buffer("told", size, usage)?;
            let pass = device.mapped_buffer("changes", size, BufferUsages::MAP_WRITE | BufferUsages::COPY_SRC)?;
            self.buffers = Some((buffer, pass));
            self.known.clear();
        }
        let Some((buffer, pass)) = &self.buffers else { return Ok(()) };
        let changed = changes(&self.known, &words);
        if !changed.is_empty() {
            let view = pass.get_mapped_range_mut(..words.len().next_multiple_of(8) as u64);
            let mut view = view.map_err(|error| device.failure(&error))?;
            for range in &changed {
                view.slice(range.clone()).copy_from_slice(&words[range.clone()]);
            }
        }
        pass.unmap();
        for range in changed {
            let (start, length) = (range.start as u64, range.len() as u64);
            encoder.copy_buffer_to_buffer(pass, start, buffer, start, length);
            device.count(Written::UploadedBytes, length);
        }
        self.known = words;
        Ok(())
    }

    /// The buffer on the device.
    pub fn buffer(&self) -> Option<&wgpu::Buffer> {
        self.buffers.as_ref().map(|(buffer, _)| buffer)
    }

    /// Asks for the way in to be open again once the device is done; the answer comes with the device's next poll.
    pub fn open_again(&self, done: impl FnOnce(bool) + Send + 'static) {
        match &self.buffers {
            Some((_, pass)) => pass.map_async(MapMode::Write, .., move |result| done(result.is_ok())),
            None => done(true),
        }
    }
}

/// Runs of blocks that differ.
fn changes(known: &[u8], words: &[u8]) -> Vec<std::ops::Range<usize>> {
    const PIECE: usize = 16;
    let mut runs: Vec<std::ops::Range<usize>> = Vec::new();
    for start in (0..words.len()).step_by(PIECE) {
        let end = (start + PIECE).min(words.len());
        if known.get(start..end) == Some(&words[start..end]) {
            continue;
        }
        match runs.last_mut() {
            Some(run) if run.end == start => run.end = end,
            _ => runs.push(start..end),
        }
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::changes;

    #[test]
    fn only_what_changed_is_sent() {
        let known = vec![0u8; 100];
        assert_eq!(changes(&known, &known), []);
        assert_eq!(changes(&[], &known).first(), Some(&(0..100)));
        let mut words = known.clone();
        words[17] = 1;
        words[40] = 1;
        words[99] = 1;
        assert_eq!(changes(&known, &words), [16..48, 96..100]);
    }
}
