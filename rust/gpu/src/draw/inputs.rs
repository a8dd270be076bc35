//! Shader inputs of a frame. Only bytes that differ from the last frame's are uploaded.

use std::ops::Range;

use nearfar_core::base::Result;
use wgpu::{Buffer, BufferUsages, CommandEncoder, MapMode};

use crate::device::{Counter, Device};

/// Alignment of uniform blocks, bytes.
pub(super) const BLOCK: usize = 256;
/// Number of blocks per pass.
pub(super) const PASS_BLOCKS: usize = 3;

/// Shader inputs of a frame: uniform blocks, records of moving instances and the order of records.
#[derive(Default)]
pub(super) struct ShaderInputs {
    /// Device buffer, and the mapped staging buffer for changes.
    buffers: Option<(Buffer, Buffer)>,
    on_device: Vec<u8>,
}

impl ShaderInputs {
    /// Uploads the bytes that differ from the last frame's; returns the buffer on the device.
    pub fn upload(&mut self, device: &Device, encoder: &mut CommandEncoder, bytes: Vec<u8>) -> Result<Buffer> {
        let size = (bytes.len() as u64).next_multiple_of(BLOCK as u64).next_power_of_two();
        let (buffer, staging) = match &self.buffers {
            Some(buffers) if buffers.0.size() >= size => buffers,
            _ => {
                self.on_device.clear();
                let usage = BufferUsages::UNIFORM | BufferUsages::STORAGE | BufferUsages::COPY_DST;
                let buffer = device.buffer("inputs", size, usage)?;
                let staging =
                    device.mapped_buffer("changes", size, BufferUsages::MAP_WRITE | BufferUsages::COPY_SRC)?;
                self.buffers.insert((buffer, staging))
            }
        };
        let changed = changes(&self.on_device, &bytes);
        if !changed.is_empty() {
            let view = staging.get_mapped_range_mut(..bytes.len().next_multiple_of(8) as u64);
            let mut view = view.map_err(|error| device.failure(error))?;
            for range in &changed {
                view.slice(range.clone()).copy_from_slice(&bytes[range.clone()]);
            }
        }
        staging.unmap();
        for range in changed {
            let (start, length) = (range.start as u64, range.len() as u64);
            encoder.copy_buffer_to_buffer(staging, start, buffer, start, length);
            device.count(Counter::UploadedBytes, length);
        }
        self.on_device = bytes;
        Ok(buffer.clone())
    }

    /// Requests to map the staging buffer again after the device has finished; a later poll of the device calls
    /// `report`.
    pub fn map_again(&self, report: impl FnOnce(bool) + Send + 'static) {
        match &self.buffers {
            Some((_, staging)) => staging.map_async(MapMode::Write, .., move |result| report(result.is_ok())),
            None => report(true),
        }
    }
}

/// Returns the ranges in which `bytes` differs from `before`, in pieces of 16 bytes.
fn changes(before: &[u8], bytes: &[u8]) -> Vec<Range<usize>> {
    const PIECE_BYTES: usize = 16;
    let mut runs: Vec<Range<usize>> = Vec::new();
    for start in (0..bytes.len()).step_by(PIECE_BYTES) {
        let end = (start + PIECE_BYTES).min(bytes.len());
        if before.get(start..end) == Some(&bytes[start..end]) {
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
    fn only_changed_data_is_uploaded() {
        let before = vec![0u8; 100];
        assert_eq!(changes(&before, &before), []);
        assert_eq!(changes(&[], &before).first(), Some(&(0..100)));
        let mut bytes = before.clone();
        [17, 40, 99].into_iter().for_each(|i: usize| bytes[i] = 1);
        assert_eq!(changes(&before, &bytes), [16..48, 96..100]);
    }
}
