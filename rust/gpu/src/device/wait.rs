//! Cancellable waiting for the device.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};
use std::thread;
use std::time::Duration;

use nearfar_core::base::{Error, Progress, Result};
use wgpu::{Buffer, CommandBuffer, MapMode, PollStatus, PollType};

use super::{AdapterKind, Device};

/// Minimum polling interval.
const MIN_POLL_INTERVAL: Duration = Duration::from_micros(20);
/// Maximum polling interval.
const MAX_POLL_INTERVAL: Duration = Duration::from_micros(500);

/// Message for buffers that could not be mapped.
pub(crate) const UNREADABLE: &str = "its memory could not be read; use backend='cpu'";

/// Submitted work. The flag is true once a poll has found the work complete.
#[derive(Clone, Default)]
pub(crate) struct Submission(Arc<AtomicBool>);

impl Device {
    /// Returns whether the processor itself executes the device's work.
    pub(crate) fn is_software(&self) -> bool {
        self.report.kind == AdapterKind::Software
    }

    /// Submits commands; fails if the caller cancels. Software drivers block a submission until the previous work is
    /// complete, so this waits for it, cancellably.
    pub(crate) fn submit(&self, commands: CommandBuffer, progress: &Progress) -> Result<Submission> {
        if self.is_software() {
            self.wait_for_all(progress)?;
        }
        let submission = Submission::default();
        let done = Arc::clone(&submission.0);
        self.with_queue(|queue| {
            queue.submit([commands]);
            queue.on_submitted_work_done(move || done.store(true, Ordering::Release));
        });
        Ok(submission)
    }

    /// Waits for submitted work; fails if the caller cancels.
    pub(crate) fn wait(&self, submission: &Submission, progress: &Progress) -> Result<()> {
        self.poll_until(progress, |_| submission.0.load(Ordering::Acquire).then_some(()))
    }

    fn wait_for_all(&self, progress: &Progress) -> Result<()> {
        self.poll_until(progress, |status| (status == PollStatus::QueueEmpty).then_some(()))
    }

    /// Waits for all submitted work and closes the device; fails if the caller cancels.
    pub(super) fn close(&self, progress: &Progress) -> Result<()> {
        self.with_exclusive_queue(|| {
            // A lost device has no work to wait for.
            if self.wait_for_all(progress) == Err(Error::Cancelled) {
                return Err(Error::Cancelled);
            }
            self.destroy();
            Ok(())
        })
    }

    /// Polls the device, which runs pending callbacks, until `result_of` has a result or the caller cancels.
    ///
    /// Never uses wgpu's blocking wait, for three reasons. Mesa's software drivers ignore a timeout above zero and
    /// return when the work is complete. After a timeout, wgpu 30 compares its old state with a list that other
    /// threads change, and panics if their work ended meanwhile, on every adapter. A lock against that would block
    /// submissions during waits.
    fn poll_until<R>(&self, progress: &Progress, result_of: impl Fn(PollStatus) -> Option<R>) -> Result<R> {
        let mut interval = MIN_POLL_INTERVAL;
        loop {
            self.check()?;
            let status = self.wgpu.poll(PollType::Poll).map_err(|error| self.error(error))?;
            self.check()?;
            progress.check()?;
            if let Some(result) = result_of(status) {
                return Ok(result);
            }
            thread::sleep(interval);
            // Growing by a tenth, the interval stays about a tenth of the time waited so far.
            interval = (interval * 11 / 10).min(MAX_POLL_INTERVAL);
        }
    }

    /// Calls `take` with the beginning of a buffer once the device has finished with it.
    pub(crate) fn read_buffer<R>(
        &self,
        buffer: &Buffer,
        bytes: u64,
        progress: &Progress,
        take: impl FnOnce(&[u8]) -> R,
    ) -> Result<R> {
        // Mapped ranges are multiples of 8 bytes.
        let mapped_bytes = bytes.next_multiple_of(8);
        self.map_buffer(buffer, mapped_bytes, MapMode::Read, progress)?;
        let view = buffer.get_mapped_range(..mapped_bytes);
        let result = view.map(|view| take(&view[..bytes as usize])).map_err(|error| self.failure(error));
        buffer.unmap();
        // The data are undefined if the device was lost meanwhile.
        self.check()?;
        result
    }

    /// Waits until the beginning of a buffer is mapped for the processor; unmaps it on failure.
    pub(crate) fn map_buffer(&self, buffer: &Buffer, bytes: u64, mode: MapMode, progress: &Progress) -> Result<()> {
        let mapping = Arc::new(OnceLock::new());
        let stored = Arc::clone(&mapping);
        buffer.map_async(mode, ..bytes, move |result| {
            let _ = stored.set(result.is_ok());
        });
        let result_of = |_| match mapping.get()? {
            true => Some(Ok(())),
            false => Some(Err(self.failure(UNREADABLE))),
        };
        self.poll_until(progress, result_of).unwrap_or_else(|error| {
            buffer.unmap();
            Err(error)
        })
    }
}
