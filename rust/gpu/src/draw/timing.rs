//! Timing of a frame's passes by the device's clock, if passes can read one.

use std::sync::atomic::{AtomicU32, Ordering};

use nearfar_core::base::{Progress, Result};
use wgpu::{
    Buffer, BufferUsages, CommandEncoder, ComputePassTimestampWrites, QuerySet, QuerySetDescriptor, QueryType,
    RenderPassTimestampWrites,
};

use crate::device::{Counter, Device, Scope};

/// Maximum number of timed passes of each kind; further ones are assumed to take the mean time. The queries of both
/// kinds fill a query set.
const MAX_PASSES: u32 = 1024;
/// Bytes of the times of a kind: start and end of each pass.
const BYTES_PER_KIND: u64 = 2 * MAX_PASSES as u64 * size_of::<u64>() as u64;

/// Timer of the passes of one window.
pub(super) struct Stopwatch {
    queries: QuerySet,
    resolved: Buffer,
    readable: Buffer,
    /// Number of raster and of resolve passes so far.
    counts: [AtomicU32; 2],
}

impl Stopwatch {
    /// Creates a timer; `None` if passes cannot read a clock.
    pub fn new(device: &Device) -> Result<Option<Self>> {
        if !device.has_clock() {
            return Ok(None);
        }
        let scope = Scope::open(device);
        let descriptor = QuerySetDescriptor { label: Some("times"), ty: QueryType::Timestamp, count: 4 * MAX_PASSES };
        let queries = device.wgpu.create_query_set(&descriptor);
        scope.close()?;
        let buffer = |label, usage| device.buffer(label, 2 * BYTES_PER_KIND, usage);
        Ok(Some(Self {
            queries,
            resolved: buffer("times", BufferUsages::QUERY_RESOLVE | BufferUsages::COPY_SRC)?,
            readable: buffer("times to read", BufferUsages::MAP_READ | BufferUsages::COPY_DST)?,
            counts: Default::default(),
        }))
    }

    /// Discards the passes of an earlier frame, which may not have been read.
    pub fn restart(&self) {
        self.counts.iter().for_each(|count| count.store(0, Ordering::Relaxed));
    }

    /// Times the next raster pass.
    pub fn raster(&self) -> Option<RenderPassTimestampWrites<'_>> {
        let (query_set, beginning_of_pass_write_index, end_of_pass_write_index) = self.next(0)?;
        Some(RenderPassTimestampWrites { query_set, beginning_of_pass_write_index, end_of_pass_write_index })
    }

    /// Times the next resolve pass.
    pub fn resolve(&self) -> Option<ComputePassTimestampWrites<'_>> {
        let (query_set, beginning_of_pass_write_index, end_of_pass_write_index) = self.next(1)?;
        Some(ComputePassTimestampWrites { query_set, beginning_of_pass_write_index, end_of_pass_write_index })
    }

    /// Returns the query set, and first and last query of the next pass of a kind; `None` if the set is full.
    fn next(&self, kind: u32) -> Option<(&QuerySet, Option<u32>, Option<u32>)> {
        let number = self.counts[kind as usize].fetch_add(1, Ordering::Relaxed);
        let first = 2 * (kind * MAX_PASSES + number);
        (number < MAX_PASSES).then_some((&self.queries, Some(first), Some(first + 1)))
    }

    /// Copies the times to a readable buffer, after the last pass.
    pub fn stop(&self, commands: &mut CommandEncoder) {
        for kind in 0..2 {
            let timed = self.timed_count(kind);
            if timed > 0 {
                let (first, offset) = (2 * kind as u32 * MAX_PASSES, kind as u64 * BYTES_PER_KIND);
                commands.resolve_query_set(&self.queries, first..first + 2 * timed, &self.resolved, offset);
            }
        }
        commands.copy_buffer_to_buffer(&self.resolved, 0, &self.readable, 0, 2 * BYTES_PER_KIND);
    }

    fn timed_count(&self, kind: usize) -> u32 {
        self.counts[kind].load(Ordering::Relaxed).min(MAX_PASSES)
    }

    /// Adds the times of a completed window to the device's counters.
    pub fn count(&self, device: &Device, progress: &Progress) -> Result<()> {
        let ticks: Vec<u64> =
            device.read_buffer(&self.readable, 2 * BYTES_PER_KIND, progress, bytemuck::pod_collect_to_vec)?;
        for (kind, counted) in [Counter::RasterNanoseconds, Counter::ResolveNanoseconds].into_iter().enumerate() {
            let timed = self.timed_count(kind);
            let passes = self.counts[kind].load(Ordering::Relaxed);
            let start = kind * 2 * MAX_PASSES as usize;
            let sum: u64 =
                ticks[start..start + 2 * timed as usize].chunks(2).map(|pair| pair[1].saturating_sub(pair[0])).sum();
            let all = sum as f64 * f64::from(passes) / f64::from(timed.max(1));
            device.count(counted, (all * f64::from(device.nanoseconds_per_tick)) as u64);
        }
        Ok(())
    }
}
