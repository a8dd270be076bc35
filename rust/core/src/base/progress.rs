//! Progress and cancellation of long kernels.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use super::memory::{HEADROOM, check_headroom};
use super::{Error, Result};

/// Progress of a kernel. The kernel's threads write it; the caller reads it every 50 ms and may cancel the kernel.
#[derive(Debug, Default)]
pub struct Progress {
    done: AtomicU64,
    total: AtomicU64,
    cancelled: AtomicBool,
    /// Whether memory is limited, so that each check asks for headroom.
    watches_memory: bool,
    /// Whether a check has failed for lack of memory. All later ones fail as well, as after a cancellation.
    ran_short: AtomicBool,
}

impl Progress {
    /// Creates a progress with no finished units and an unknown total.
    pub fn new() -> Self {
        Self::default()
    }

    /// Returns the progress of a kernel whose checks also fail when memory runs short, if it is limited.
    pub fn watching_memory(is_limited: bool) -> Self {
        Self { watches_memory: is_limited, ..Self::default() }
    }

    /// Adds units of work to the total.
    pub fn expect(&self, units: u64) {
        self.total.fetch_add(units, Ordering::Relaxed);
    }

    /// Counts finished units; fails as `check` does.
    pub fn report(&self, units: u64) -> Result<()> {
        self.done.fetch_add(units, Ordering::Relaxed);
        self.check()
    }

    /// Fails if the caller has cancelled, or if watched memory runs short. Then all later checks fail.
    pub fn check(&self) -> Result<()> {
        if self.cancelled.load(Ordering::Relaxed) {
            return Err(Error::Cancelled);
        }
        if self.watches_memory { self.check_memory() } else { Ok(()) }
    }

    fn check_memory(&self) -> Result<()> {
        if self.ran_short.load(Ordering::Relaxed) {
            return Err(Error::Memory { bytes: HEADROOM });
        }
        check_headroom().inspect_err(|_| self.ran_short.store(true, Ordering::Relaxed))
    }

    /// Asks the kernel to stop; its next report fails.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// Returns finished units and total units.
    pub fn state(&self) -> (u64, u64) {
        (self.done.load(Ordering::Relaxed), self.total.load(Ordering::Relaxed))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reports_add_up_until_cancelled() {
        let progress = Progress::new();
        progress.expect(3);
        assert_eq!(progress.report(2), Ok(()));
        progress.cancel();
        assert_eq!(progress.report(1), Err(Error::Cancelled));
        assert_eq!(progress.state(), (3, 3));
    }
}
