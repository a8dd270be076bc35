//! Waiting for the device until the caller cancels.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::Duration;

use nearfar_core::base::{Error, Progress, Result};
use wgpu::{Buffer, MapMode, PollError, PollType, SubmissionIndex};

use super::Device;

/// Time between two checks whether the caller has cancelled.
const POLL_INTERVAL: Duration = Duration::from_millis(20);

impl Device {
    /// Waits for submitted work, or until the caller cancels.
    pub(crate) fn wait(&self, submission: &SubmissionIndex, progress: &Progress) -> Result<()> {
        self.check()?;
        loop {
            let wait = PollType::Wait { submission_index: Some(submission.clone()), timeout: Some(POLL_INTERVAL) };
            match self.wgpu.poll(wait) {
                // Some drivers return only when all work is complete.
                Ok(_) => return self.check().and_then(|()| progress.check()),
                Err(PollError::Timeout) => progress.check()?,
                Err(error) => return Err(Error::Device(format!("{}: {error}", self.report.label()))),
            }
            self.check()?;
        }
    }

    /// Waits for all submitted work, or until the caller cancels, and closes the device.
    pub(super) fn close(&self, progress: &Progress) -> Result<()> {
        let wait = || PollType::Wait { submission_index: None, timeout: Some(POLL_INTERVAL) };
        self.alone(|| {
            while matches!(self.wgpu.poll(wait()), Err(PollError::Timeout)) {
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
    ) -> Result<R> {
        // Mapped ranges are of whole pairs of words.
        let room = bytes.next_multiple_of(8);
        self.open_buffer(buffer, room, MapMode::Read, progress)?;
        let view = buffer.get_mapped_range(..room);
        let taken = view.map(|view| take(&view[..bytes as usize])).map_err(|error| self.failure(&error));
        buffer.unmap();
        taken
    }

    /// Waits until the beginning of a buffer is mapped for the processor; on failure it is unmapped.
    pub(crate) fn open_buffer(&self, buffer: &Buffer, bytes: u64, mode: MapMode, progress: &Progress) -> Result<()> {
        let answer = Arc::new(AtomicU32::new(0));
        let written = Arc::clone(&answer);
        buffer.map_async(mode, ..bytes, move |result| written.store(1 + u32::from(result.is_err()), Ordering::Release));
        let answered = || match answer.load(Ordering::Acquire) {
            0 => None,
            1 => Some(Ok(())),
            _ => Some(Err(self.failure(&"its memory could not be read; use backend='cpu'"))),
        };
        loop {
            let wait = PollType::Wait { submission_index: None, timeout: Some(POLL_INTERVAL) };
            let polled = match self.wgpu.poll(wait) {
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
