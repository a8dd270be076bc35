//! Cancellable waiting for the device.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::thread;
use std::time::Duration;

use nearfar_core::base::{self, Error, Progress};
use wgpu::{Buffer, CommandBuffer, MapMode, PollStatus, PollType};

use super::{AdapterKind, Device};

/// Minimum polling interval.
const SHORTEST_NAP: Duration = Duration::from_micros(20);

/// Maximum polling interval.
const LONGEST_NAP: Duration = Duration::from_micros(500);

/// Submitted work; true once a poll has found it complete.
#[derive(Clone, Default)]
pub(crate) struct Submission(Arc<AtomicBool>);

impl Device {
    /// Returns whether the processor itself executes the device's work.
    pub(crate) fn is_software(&self) -> bool {
        self.report.kind == AdapterKind::Software
    }

    /// Submits commands; fails if the caller cancels. Software drivers block a submission until the previous work is
    /// complete, so this waits for it, cancellably.
    pub(crate) fn submit(&self, commands: CommandBuffer, progress: &Progress) -> base::Result<Submission> {
        if self.is_software() {
            self.look_until(progress, |status| (status == PollStatus::QueueEmpty).then_some(()))?;
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
    pub(crate) fn wait(&self, submission: &Submission, progress: &Progress) -> base::Result<()> {
        self.look_until(progress, |_| submission.0.load(Ordering::Acquire).then_some(()))
    }

    /// Waits for all submitted work and closes the device; fails if the caller cancels.
    pub(super) fn close(&self, progress: &Progress) -> base::Result<()> {
        self.alone(|| {
            let waited = self.look_until(progress, |status| (status == PollStatus::QueueEmpty).then_some(()));
            // A lost device has no work to wait for.
            if waited == Err(Error::Cancelled) {
                return waited;
            }
            self.destroy();
            Ok(())
        })
    }

    /// Polls the device, which runs pending callbacks, until `found` has a result or the caller cancels.
    ///
    /// Never uses wgpu's blocking wait, for three reasons. Mesa's software drivers ignore a timeout above zero and
    /// return when the work is complete. After a timeout, wgpu 30 compares its old state with a list that other
    /// threads change, and panics if their work ended meanwhile, on every adapter. A lock against that would block
    /// submissions during waits.
    fn look_until<R>(&self, progress: &Progress, found: impl Fn(PollStatus) -> Option<R>) -> base::Result<R> {
        let mut nap = SHORTEST_NAP;
        loop {
            self.check()?;
            let polled = self.wgpu.poll(PollType::Poll);
            let status = polled.map_err(|error| Error::Device(format!("{}: {error}", self.report.label())))?;
            self.check()?;
            progress.check()?;
            if let Some(result) = found(status) {
                return Ok(result);
            }
            thread::sleep(nap);
            // The interval is a tenth of the time so far: long waits need few polls, short ones little time.
            nap = (nap * 11 / 10).min(LONGEST_NAP);
        }
    }

    /// Calls `take` with the beginning of a buffer once the device has finished with it.
    pub(crate) fn read_buffer<R>(
        &self,
        buffer: &Buffer,
        bytes: u64,
        progress: &Progress,
        take: impl FnOnce(&[u8]) -> R,
    ) -> base::Result<R> {
        // Mapped ranges are multiples of 8 bytes.
        let room = bytes.next_multiple_of(8);
        self.open_buffer(buffer, room, MapMode::Read, progress)?;
        let view = buffer.get_mapped_range(..room);
        let taken = view.map(|view| take(&view[..bytes as usize])).map_err(|error| self.failure(&error));
        buffer.unmap();
        // The data are undefined if the device was lost meanwhile.
        self.check()?;
        taken
    }

    /// Waits until the beginning of a buffer is mapped for the processor; unmaps it on failure.
    pub(crate) fn open_buffer(
        &self,
        buffer: &Buffer,
        bytes: u64,
        mode: MapMode,
        progress: &Progress,
    ) -> base::Result<()> {
        let answer = Arc::new(AtomicU32::new(0));
        let written = Arc::clone(&answer);
        buffer.map_async(mode, ..bytes, move |result| written.store(1 + u32::from(result.is_err()), Ordering::Release));
        let answered = |_| match answer.load(Ordering::Acquire) {
            0 => None,
            1 => Some(Ok(())),
            _ => Some(Err(self.failure(&"its memory could not be read; use backend='cpu'"))),
        };
        self.look_until(progress, answered).unwrap_or_else(|error| {
            buffer.unmap();
            Err(error)
        })
    }
}
