//! Views of orthoviews as splats: a raster in compute shaders.
//!
//! Views stay on the device as words without loss. A thread projects a splat and raises the keys of the samples that it
//! covers, by atomic integers of 64 bits where the adapter has them and else by two passes of 32 bits. Pieces of views are
//! drawn nearest first in a few batches; between them the farthest order of each tile of samples is taken, and pieces that
//! lie behind it are left out.

mod arena;
mod calls;
mod draw;
mod layout;
mod programs;
mod room;
mod uniforms;

pub use draw::draw;

use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use nearfar_core::base::Result;
use nearfar_core::orthoview::splat::{Compressed, Splats};
use rayon::prelude::*;

use crate::device::Device;
use arena::{Arena, identity};

/// Views that lie on a device.
#[derive(Default)]
struct Views(Mutex<Arena>);

impl Views {
    fn arena(&self) -> MutexGuard<'_, Arena> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Views that do not lie on the device yet, as words. No lock is held during parallel work.
    fn compressed(&self, views: &[Arc<Splats>]) -> HashMap<usize, Compressed> {
        let missing = self.arena().missing(views);
        missing.par_iter().map(|view| (identity(view), view.compressed())).collect()
    }
}

/// Brings views to a device before a picture shows them.
pub fn keep(device: &Device, views: &[Arc<Splats>]) -> Result<()> {
    device.check()?;
    let own = device.state::<Views>();
    let compressed = own.compressed(views);
    own.arena().keep(device, views, &compressed).map(|_| ())
}

/// Bytes of the views that lie on a device.
pub fn kept_bytes(device: &Device) -> u64 {
    device.state::<Views>().arena().bytes()
}
