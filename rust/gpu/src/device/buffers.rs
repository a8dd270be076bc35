//! Creation of buffers and textures, which is counted, because repeated frames must allocate nothing; and a cache of
//! pipelines, each compiled once per device.

use std::collections::HashMap;
use std::hash::Hash;
use std::sync::Mutex;
use std::sync::atomic::Ordering;

use bytemuck::NoUninit;
use nearfar_core::base::Result;
use nearfar_core::base::memory::room_for;
use wgpu::{
    BindGroup, BindGroupDescriptor, BindGroupEntry, BindGroupLayout, BindingResource, BufferDescriptor, BufferUsages,
    Texture, TextureDescriptor,
};

use super::{Device, Scope, lock};

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

/// Quantity of `Counters`.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Counter {
    Allocations,
    AllocatedBytes,
    UploadedBytes,
    Triangles,
    RasterNanoseconds,
    ResolveNanoseconds,
}

impl Device {
    /// Returns the counts so far.
    pub fn counters(&self) -> Counters {
        let [allocations, allocated_bytes, uploaded_bytes, triangles, raster, resolve] =
            [0, 1, 2, 3, 4, 5].map(|i: usize| self.counts[i].load(Ordering::Relaxed));
        Counters { allocations, allocated_bytes, uploaded_bytes, triangles, pass_nanoseconds: [raster, resolve] }
    }

    pub(crate) fn count(&self, counter: Counter, amount: u64) {
        self.counts[counter as usize].fetch_add(amount, Ordering::Relaxed);
    }

    /// Creates an empty buffer.
    pub(crate) fn buffer(&self, label: &str, bytes: u64, usage: BufferUsages) -> Result<wgpu::Buffer> {
        self.new_buffer(label, bytes, usage, false)
    }

    /// Creates an empty buffer that is mapped for writing.
    pub(crate) fn mapped_buffer(&self, label: &str, bytes: u64, usage: BufferUsages) -> Result<wgpu::Buffer> {
        self.new_buffer(label, bytes, usage, true)
    }

    /// Creates a buffer with constant contents.
    pub(crate) fn filled_buffer<T: NoUninit>(
        &self,
        label: &str,
        contents: &[T],
        usage: BufferUsages,
    ) -> Result<wgpu::Buffer> {
        let bytes: &[u8] = bytemuck::cast_slice(contents);
        let length = bytes.len() as u64;
        let buffer = self.mapped_buffer(label, length, usage)?;
        if length > 0 {
            buffer.get_mapped_range_mut(..length).map_err(|error| self.failure(error))?.copy_from_slice(bytes);
        }
        buffer.unmap();
        self.count(Counter::UploadedBytes, length);
        Ok(buffer)
    }

    pub(crate) fn texture(&self, descriptor: &TextureDescriptor<'_>, bytes: u64) -> Result<Texture> {
        self.allocate(bytes, bytes, || self.wgpu.create_texture(descriptor))
    }

    /// Creates a bind group of resources with their binding numbers.
    pub(crate) fn bind_group<'a>(
        &self,
        layout: &BindGroupLayout,
        resources: impl IntoIterator<Item = (u32, BindingResource<'a>)>,
    ) -> BindGroup {
        let entry = |(binding, resource)| BindGroupEntry { binding, resource };
        let entries: Vec<_> = resources.into_iter().map(entry).collect();
        self.wgpu.create_bind_group(&BindGroupDescriptor { label: None, layout, entries: &entries })
    }

    /// Calls a function that allocates, and counts the allocation. If the device uses system memory, first checks that
    /// there is enough: after a failed allocation some drivers close the device, and others end the process.
    fn allocate<R>(&self, bytes: u64, system_bytes: u64, create: impl FnOnce() -> R) -> Result<R> {
        if self.report.kind.uses_system_memory() {
            room_for(system_bytes)?;
        }
        let scope = Scope::open(self);
        let created = create();
        scope.close()?;
        self.count(Counter::Allocations, 1);
        self.count(Counter::AllocatedBytes, bytes);
        Ok(created)
    }

    fn new_buffer(&self, label: &str, bytes: u64, usage: BufferUsages, mapped: bool) -> Result<wgpu::Buffer> {
        // A binding must hold at least one entry of a table.
        let size = bytes.next_multiple_of(16).max(256);
        let descriptor = BufferDescriptor { label: Some(label), size, usage, mapped_at_creation: mapped };
        // A mapped buffer of OpenGL has a second copy.
        let system_bytes = if mapped { 2 * size } else { size };
        self.allocate(size, system_bytes, || self.wgpu.create_buffer(&descriptor))
    }
}

/// Cache of compiled pipelines, by their settings.
pub(crate) struct PipelineCache<K, P>(Mutex<HashMap<K, P>>);

impl<K, P> Default for PipelineCache<K, P> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<K: Eq + Hash, P: Clone> PipelineCache<K, P> {
    /// Returns the pipeline of some settings; compiles it on first use.
    pub fn get(&self, device: &Device, settings: K, compile: impl FnOnce(&K) -> P) -> Result<P> {
        let mut pipelines = lock(&self.0);
        if let Some(pipeline) = pipelines.get(&settings) {
            return Ok(pipeline.clone());
        }
        let scope = Scope::open(device);
        let pipeline = compile(&settings);
        scope.close()?;
        pipelines.insert(settings, pipeline.clone());
        Ok(pipeline)
    }
}
