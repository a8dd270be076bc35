//! Pool of buffers for kernels, and copies to and from the processor.

use std::ops::Deref;
use std::sync::Mutex;

use bytemuck::Pod;
use nearfar_core::base::{Progress, Result};
use rayon::prelude::*;
use wgpu::{Buffer, BufferUsages, CommandEncoder, MapMode};

use crate::device::{Counter, Device, lock};

/// Maximum number and total bytes of buffers in the pool.
const MAX_POOL_BUFFERS: usize = 24;
const MAX_POOL_BYTES: u64 = 1 << 28;
/// Bytes that one thread copies at a time.
const COPY_BYTES: usize = 1 << 20;

/// Unused buffers of a device.
#[derive(Default)]
struct BufferPool(Mutex<Vec<Buffer>>);

/// A buffer that returns to the pool when dropped, even while the device still uses it: its next use comes later in the
/// queue.
pub(crate) struct PooledBuffer<'a> {
    device: &'a Device,
    buffer: Buffer,
    usage: BufferUsages,
    bytes: u64,
}

impl<'a> PooledBuffer<'a> {
    /// Creates a buffer that only kernels use.
    pub fn scratch(device: &'a Device, bytes: u64) -> Result<Self> {
        Self::new(device, "scratch", bytes, BufferUsages::STORAGE | BufferUsages::COPY_DST)
    }

    /// Creates a buffer that the processor fills.
    pub fn input(device: &'a Device, bytes: u64) -> Result<Self> {
        let transfer = if device.shares_memory { BufferUsages::MAP_WRITE } else { BufferUsages::COPY_DST };
        Self::new(device, "input", bytes, BufferUsages::STORAGE | transfer)
    }

    fn new(device: &'a Device, label: &str, bytes: u64, usage: BufferUsages) -> Result<Self> {
        let bytes = bytes.next_multiple_of(16).max(256);
        let fits = |buffer: &Buffer| buffer.usage() == usage && (bytes..=2 * bytes).contains(&buffer.size());
        let take = |pool: &mut Vec<Buffer>| pool.iter().position(fits).map(|index| pool.remove(index));
        let unused = take(&mut lock(&device.state::<BufferPool>().0));
        let buffer = unused.map_or_else(|| device.buffer(label, bytes, usage), Ok)?;
        Ok(Self { device, buffer, usage, bytes })
    }

    /// Writes to the beginning of the buffer.
    pub fn fill(&self, bytes: &[u8], progress: &Progress) -> Result<()> {
        let length = bytes.len() as u64;
        self.device.count(Counter::UploadedBytes, length);
        if !self.usage.contains(BufferUsages::MAP_WRITE) {
            self.device.with_queue(|queue| queue.write_buffer(self, 0, bytes));
            return Ok(());
        }
        let mapped_bytes = length.next_multiple_of(8);
        self.device.map_buffer(self, mapped_bytes, MapMode::Write, progress)?;
        let view = self.get_mapped_range_mut(..mapped_bytes);
        let filled = view.map(|mut view| view.slice(..bytes.len()).copy_from_slice(bytes));
        self.unmap();
        filled.map_err(|error| self.device.failure(error))
    }

    /// Returns a binding of the requested size.
    pub fn binding(&self) -> wgpu::BindingResource<'_> {
        let size = std::num::NonZeroU64::new(self.bytes);
        wgpu::BindingResource::Buffer(wgpu::BufferBinding { buffer: self, offset: 0, size })
    }
}

impl Deref for PooledBuffer<'_> {
    type Target = Buffer;

    fn deref(&self) -> &Buffer {
        &self.buffer
    }
}

impl Drop for PooledBuffer<'_> {
    fn drop(&mut self) {
        let mut pool = lock(&self.device.state::<BufferPool>().0);
        pool.push(self.buffer.clone());
        while pool.len() > MAX_POOL_BUFFERS || pool.iter().map(Buffer::size).sum::<u64>() > MAX_POOL_BYTES {
            pool.remove(0);
        }
    }
}

/// Results of a kernel, readable by the processor.
pub(crate) struct Results<'a> {
    pub on_device: PooledBuffer<'a>,
    staging: Option<PooledBuffer<'a>>,
    bytes: u64,
}

impl<'a> Results<'a> {
    pub fn new(device: &'a Device, bytes: u64) -> Result<Self> {
        let mut usage = BufferUsages::STORAGE | BufferUsages::COPY_SRC | BufferUsages::COPY_DST;
        if device.shares_memory {
            usage |= BufferUsages::MAP_READ;
        }
        let read = BufferUsages::MAP_READ | BufferUsages::COPY_DST;
        let staging = || PooledBuffer::new(device, "read-back", bytes, read);
        Ok(Self {
            on_device: PooledBuffer::new(device, "results", bytes, usage)?,
            staging: (!device.shares_memory).then(staging).transpose()?,
            bytes,
        })
    }

    /// Encodes the copy that the processor reads; to be called after the kernel is encoded.
    pub fn encode_copy(&self, encoder: &mut CommandEncoder) {
        if let Some(staging) = &self.staging {
            encoder.copy_buffer_to_buffer(&self.on_device, 0, staging, 0, self.bytes.next_multiple_of(4));
        }
    }

    /// Waits for the results and calls `take` with them.
    pub fn read<R>(&self, progress: &Progress, take: impl FnOnce(&[u8]) -> R) -> Result<R> {
        let buffer = self.staging.as_ref().unwrap_or(&self.on_device);
        self.on_device.device.read_buffer(buffer, self.bytes, progress, take)
    }

    /// Waits for the results and returns the first `count` of them.
    pub fn read_values<T: Pod + Send + Sync>(&self, count: usize, progress: &Progress) -> Result<Vec<T>> {
        let mut values = vec![T::zeroed(); count];
        self.read(progress, |bytes| parallel_copy(bytemuck::cast_slice_mut(&mut values), bytes))?;
        Ok(values)
    }

    /// Waits for the results and returns the first word.
    pub fn read_word(&self, progress: &Progress) -> Result<u32> {
        self.read(progress, |bytes| bytes.first_chunk().copied().map_or(0, u32::from_ne_bytes))
    }
}

/// Copies with all threads.
pub(crate) fn parallel_copy(to: &mut [u8], from: &[u8]) {
    to.par_chunks_mut(COPY_BYTES).zip(from.par_chunks(COPY_BYTES)).for_each(|(to, from)| to.copy_from_slice(from));
}
