//! A window of a frame that the device works on.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use nearfar_core::base::{Progress, Result};
use wgpu::MapMode;

use super::plan::Numbering;
use super::slots::Slot;
use super::view::Outputs;
use super::window::Window;
use crate::device::{Device, Submission};

/// A window that the device works on.
pub(super) struct Submitted {
    pub window: Window,
    pub slot: Slot,
    /// Of each view.
    pub outputs: Vec<Outputs>,
    pub numbering: Vec<Numbering>,
    pub submission: Submission,
    /// Buffers that are open again, and those that could not be opened.
    pub opened: Arc<[AtomicU32; 2]>,
}

impl Submitted {
    /// Waits until the output can be read and the inputs are open again.
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

/// Asks for the output and the inputs to be open to the processor; the answers are counted.
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
