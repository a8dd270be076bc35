//! Views kept on a device between pictures.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use nearfar_core::base::{Progress, Result};
use nearfar_core::orthoview::splat::Splats;
use rayon::prelude::*;

use super::arena::{Arena, Words, identity};
use crate::compute::programs::Work;
use crate::device::Device;

/// Views on a device.
#[derive(Default)]
pub(super) struct Views(Mutex<Arena>);

impl Views {
    /// Locks and returns the views.
    pub fn arena(&self) -> MutexGuard<'_, Arena> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Packs the views that are not yet on the device into words. No lock is held during parallel work.
    pub fn compressed(&self, views: &[Arc<Splats>]) -> Words {
        let missing = self.arena().missing(views);
        missing.par_iter().map(|view| (identity(view), view.compressed())).collect()
    }
}

/// Uploads views to a device before a picture shows them.
pub fn keep(device: &Device, views: &[Arc<Splats>], progress: &Progress) -> Result<()> {
    device.check()?;
    let own = device.state::<Views>();
    let compressed = own.compressed(views);
    own.arena().keep(device, views, &compressed)?;
    // Until a submission, copies of the words stay in the processor's memory.
    Work::new(device).submit(progress).map(|_| ())
}

/// Returns the bytes of the views on a device.
pub fn kept_bytes(device: &Device) -> u64 {
    device.state::<Views>().arena().bytes()
}
