//! Buffers and textures, with counters of allocations and uploads: a steady frame allocates nothing.

use std::sync::atomic::Ordering;

use nearfar_core::base::Result;
use nearfar_core::base::memory::room_for;
use wgpu::{BufferDescriptor, BufferUsages, Texture, TextureDescriptor};

use super::{AdapterKind, Device, Scope};

/// Allocations and transfers since the device was opened.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Number of buffers and textures.
    pub allocations: u64,
    /// Bytes of buffers and textures.
    pub allocated_bytes: u64,
    /// Bytes uploaded to the device.
    pub uploaded_bytes: u64,
    /// Triangles in draw calls, after culling.
    pub triangles: u64,
    /// Nanoseconds of raster and of resolve passes, by the device's clock; 0 without one.
    pub pass_nanoseconds: [u64; 2],
}

/// Quantity of a counter.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Counted {
    /// Buffers and textures.
    Allocations,
    /// Their bytes.
    AllocatedBytes,
    /// Bytes sent.
    UploadedBytes,
    /// Triangles drawn.
    Triangles,
    /// Nanoseconds of raster passes.
    RasterNanoseconds,
    /// Nanoseconds of resolve passes.
    ResolveNanoseconds,
}

impl Device {
    /// Returns the counts so far.
    pub fn counters(&self) -> Counters {
        let [allocations, allocated_bytes, uploaded_bytes, triangles, raster, resolve] =
            [0, 1, 2, 3, 4, 5].map(|i: usize| self.made[i].load(Ordering::Relaxed));
        Counters { allocations, allocated_bytes, uploaded_bytes, triangles, pass_nanoseconds: [raster, resolve] }
    }

    pub(crate) fn count(&self, what: Counted, amount: u64) {
        self.made[what as usize].fetch_add(amount, Ordering::Relaxed);
    }

    /// Creates an empty buffer.
    pub(crate) fn buffer(&self, label: &str, bytes: u64, usage: BufferUsages) -> Result<wgpu::Buffer> {
        self.new_buffer(label, bytes, usage, false)
    }

    /// Creates an empty buffer that is mapped for writing.
    pub(crate) fn mapped_buffer(&self, label: &str, bytes: u64, usage: BufferUsages) -> Result<wgpu::Buffer> {
        self.new_buffer(label, bytes, usage, true)
    }

    /// Creates a constant buffer of words.
    pub(crate) fn filled_buffer(&self, label: &str, words: &[u32], usage: BufferUsages) -> Result<wgpu::Buffer> {
        let bytes: &[u8] = bytemuck::cast_slice(words);
        let buffer = self.mapped_buffer(label, bytes.len() as u64, usage)?;
        if !bytes.is_empty() {
            self.write_mapped(&buffer, bytes)?;
        }
        buffer.unmap();
        self.count(Counted::UploadedBytes, bytes.len() as u64);
        Ok(buffer)
    }

    /// Writes to the beginning of a mapped buffer.
    pub(crate) fn write_mapped(&self, buffer: &wgpu::Buffer, bytes: &[u8]) -> Result<()> {
        let mut view = buffer.get_mapped_range_mut(..bytes.len() as u64).map_err(|error| self.failure(&error))?;
        view.copy_from_slice(bytes);
        Ok(())
    }

    pub(crate) fn failure(&self, error: &impl ToString) -> nearfar_core::base::Error {
        match self.check() {
            Err(lost) => lost,
            Ok(()) => nearfar_core::base::Error::Device(format!("{}: {}", self.report.label(), error.to_string())),
        }
    }

    pub(crate) fn texture(&self, descriptor: &TextureDescriptor<'_>, bytes: u64) -> Result<Texture> {
        self.ask_for(bytes)?;
        let scope = Scope::open(self);
        let texture = self.wgpu.create_texture(descriptor);
        scope.close()?;
        self.count(Counted::Allocations, 1);
        self.count(Counted::AllocatedBytes, bytes);
        Ok(texture)
    }

    /// Checks that the system has memory if the device uses system memory: after a failed allocation some drivers
    /// close the device, and others end the process.
    fn ask_for(&self, bytes: u64) -> Result<()> {
        match self.report.kind {
            AdapterKind::Software | AdapterKind::Integrated => room_for(bytes),
            _ => Ok(()),
        }
    }

    fn new_buffer(&self, label: &str, bytes: u64, usage: BufferUsages, mapped: bool) -> Result<wgpu::Buffer> {
        // A binding must hold at least one entry of a table.
        let size = bytes.next_multiple_of(16).max(256);
        // Mapped buffers of OpenGL are copies.
        self.ask_for(if mapped { 2 * size } else { size })?;
        let scope = Scope::open(self);
        let descriptor = BufferDescriptor { label: Some(label), size, usage, mapped_at_creation: mapped };
        let buffer = self.wgpu.create_buffer(&descriptor);
        scope.close()?;
        self.count(Counted::Allocations, 1);
        self.count(Counted::AllocatedBytes, size);
        Ok(buffer)
    }
}
