//! Waiting for the device until the caller cancels.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use std::thread;
use std::time::Duration;

use nearfar_core::base::{self, Error, Progress};
use wgpu::{Buffer, CommandBuffer, MapMode, PollError, PollStatus, PollType, SubmissionIndex};

use super::{AdapterKind, Device};

/// Time between two checks whether the caller has cancelled.
const POLL_INTERVAL: Duration = Duration::from_millis(20);

/// Time between two looks at a device in software.
const NAP: Duration = Duration::from_micros(500);

impl Device {
    /// Whether the processor itself executes the device's work.
    pub(crate) fn is_software(&self) -> bool {
        self.report.kind == AdapterKind::Software
    }

    /// Waits for submitted work, or for a while.
    fn wait_a_while(&self, submission: Option<SubmissionIndex>) -> Result<PollStatus, PollError> {
        // Mesa's drivers in software return when the work is complete, however short the time that they are given.
        let timeout = if self.is_software() { Duration::ZERO } else { POLL_INTERVAL };
        let found = self.wgpu.poll(PollType::Wait { submission_index: submission, timeout: Some(timeout) });
        if self.is_software() && matches!(found, Err(PollError::Timeout)) {
            thread::sleep(NAP);
        }
        found
    }

    /// Submits commands, or fails if the caller cancels. Drivers in software hold whoever submits before their last work
    /// is complete, so that is waited for here.
    pub(crate) fn submit(&self, commands: CommandBuffer, progress: &Progress) -> base::Result<SubmissionIndex> {
        while self.is_software() {
            self.check()?;
            // Waiting for the latest submission would panic while another thread submits.
            match self.wgpu.poll(PollType::Poll) {
                Ok(PollStatus::QueueEmpty) => break,
                Ok(_) => thread::sleep(NAP),
                Err(error) => return Err(Error::Device(format!("{}: {error}", self.report.label()))),
            }
            progress.check()?;
        }
        Ok(self.with_queue(|queue| queue.submit([commands])))
    }

    /// Waits for submitted work, or until the caller cancels.
    pub(crate) fn wait(&self, submission: &SubmissionIndex, progress: &Progress) -> base::Result<()> {
        self.check()?;
        loop {
            match self.wait_a_while(Some(submission.clone())) {
                Ok(_) => return self.check().and_then(|()| progress.check()),
                Err(PollError::Timeout) => progress.check()?,
                Err(error) => return Err(Error::Device(format!("{}: {error}", self.report.label()))),
            }
            self.check()?;
        }
    }

    /// Waits for all submitted work, or until the caller cancels, and closes the device.
    pub(super) fn close(&self, progress: &Progress) -> base::Result<()> {
        self.alone(|| {
            while matches!(self.wait_a_while(None), Err(PollError::Timeout)) {
                progress.check()?;
            }
            self.destroy();
            Ok(())
        })
    }

    /// Calls `take` with the beginning of a buffer once the device has finished with it.
    pub(crate) fn read_buffer<R>(
        &self,
        buffer: &Buffer,
        bytes: u64,
        progress: &Progress,
        take: impl FnOnce(&[u8]) -> R,
    ) -> base::Result<R> {
        // Mapped ranges are of whole pairs of words.
        let room = bytes.next_multiple_of(8);
        self.open_buffer(buffer, room, MapMode::Read, progress)?;
        let view = buffer.get_mapped_range(..room);
        let taken = view.map(|view| take(&view[..bytes as usize])).map_err(|error| self.failure(&error));
        buffer.unmap();
        taken
    }

    /// Waits until the beginning of a buffer is mapped for the processor; on failure it is unmapped.
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
        let answered = || match answer.load(Ordering::Acquire) {
            0 => None,
            1 => Some(Ok(())),
            _ => Some(Err(self.failure(&"its memory could not be read; use backend='cpu'"))),
        };
        loop {
            let polled = match self.wait_a_while(None) {
                Ok(_) | Err(PollError::Timeout) => self.check().and_then(|()| progress.check()),
                Err(error) => Err(Error::Device(format!("{}: {error}", self.report.label()))),
            };
            match (answered(), polled) {
                (Some(answer), _) => return answer,
                (None, Ok(())) => {}
                (None, Err(error)) => {
                    buffer.unmap();
                    return Err(error);
                }
            }
        }
    }
}
