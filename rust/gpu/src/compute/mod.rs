//! Kernels on what lies on the device: frames that were not read back, and long arrays.

mod discontinuity;
mod lookup;
mod memory;
mod morph;
mod programs;
mod similarity;
mod stream;

pub use discontinuity::discontinuity;
pub use lookup::{Filter, Map, lookup};
pub use morph::morph;
pub use similarity::{Compared, MOST_TAPS, similarity};

use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use wgpu::ComputePipeline;

/// What is kept on a device between calls.
#[derive(Default)]
pub(crate) struct Kernels {
    pipelines: Mutex<HashMap<programs::Key, Arc<ComputePipeline>>>,
    spare: Mutex<Vec<wgpu::Buffer>>,
    alone: Mutex<()>,
}

impl Kernels {
    /// Held while a kept frame is open to the processor, and while work that reads one is handed in: never both.
    pub(crate) fn alone(&self) -> MutexGuard<'_, ()> {
        self.alone.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
