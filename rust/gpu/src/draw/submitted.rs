//! A window of a frame that the device is processing.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use nearfar_core::base::{Progress, Result};
use wgpu::MapMode;

use super::plan::Numbering;
use super::slots::Slot;
use super::view::Outputs;
use super::window::Window;
use crate::device::{Device, Submission};

/// A window that the device is processing.
pub(super) struct Submitted {
    pub window: Window,
    pub slot: Slot,
    /// Output layout of each view.
    pub outputs: Vec<Outputs>,
    pub numbering: Vec<Numbering>,
    pub submission: Submission,
    /// Number of buffers mapped again, and of failed mappings.
    pub opened: Arc<[AtomicU32; 2]>,
}

impl Submitted {
    /// Waits until the output is mapped for reading and the inputs are mapped again.
    pub fn await_opening(&self, device: &Device, progress: &Progress) -> Result<()> {
        loop {
            let [opened, failed] = [0, 1].map(|i: usize| self.opened[i].load(Ordering::Acquire));
            if failed > 0 {
                return Err(device.failure(&"its memory could not be read; use backend='cpu'"));
            }
            if opened == 2 {
                return Ok(());
            }
            device.wait(&self.submission, progress)?;
            progress.check()?;
        }
    }
}

/// Requests to map the output and the inputs; counts the results.
pub(super) fn open_buffers(slot: &Slot, bytes: u64) -> Arc<[AtomicU32; 2]> {
    let opened: Arc<[AtomicU32; 2]> = Arc::default();
    let count = |opened: &Arc<[AtomicU32; 2]>| {
        let opened = Arc::clone(opened);
        move |ok: bool| {
            opened[usize::from(!ok)].fetch_add(1, Ordering::Release);
        }
    };
    let read = count(&opened);
    slot.readable().map_async(MapMode::Read, ..bytes.next_multiple_of(8), move |result| read(result.is_ok()));
    slot.inputs.reopen(count(&opened));
    opened
}
