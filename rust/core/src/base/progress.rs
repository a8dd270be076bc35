//! Progress and cancellation of long kernels.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use super::memory::{HEADROOM, check_headroom};
use super::{Error, Result};

/// The first 64 checks, and then every 64th, test whether `HEADROOM` remains: some kernels check once per item, and a
/// test takes 10 µs. A kernel may allocate 1 MiB per check without `room_for`, so 64 checks use at most `HEADROOM`.
const CHECKS_PER_REQUEST: u64 = 64;

/// Progress of a kernel. The kernel's threads write it; the caller reads it every 50 ms and may cancel the kernel.
#[derive(Debug, Default)]
pub struct Progress {
    done: AtomicU64,
    total: AtomicU64,
    cancelled: AtomicBool,
    /// Whether memory is limited, so that checks test for headroom.
    watches_memory: bool,
    /// Number of checks so far, if `watches_memory`.
    checks: AtomicU64,
    /// Whether a check has failed for lack of memory. Then all later checks fail as well, as after a cancellation.
    is_out_of_memory: AtomicBool,
}

impl Progress {
    /// Creates a progress with no finished units and an unknown total.
    pub fn new() -> Self {
        Self::default()
    }

    /// Creates a progress whose checks also fail when less than `HEADROOM` remains, if memory is limited.
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

    /// Returns whether memory is limited, so that checks test for headroom.
    pub fn watches_memory(&self) -> bool {
        self.watches_memory
    }

    /// Fails if the caller has cancelled or memory has run short. Then all later checks fail.
    pub fn check(&self) -> Result<()> {
        if self.cancelled.load(Ordering::Relaxed) {
            return Err(Error::Cancelled);
        }
        if self.watches_memory { self.check_memory(check_headroom) } else { Ok(()) }
    }

    fn check_memory(&self, request: impl FnOnce() -> Result<()>) -> Result<()> {
        if self.is_out_of_memory.load(Ordering::Relaxed) {
            return Err(Error::Memory { bytes: HEADROOM });
        }
        let earlier = self.checks.fetch_add(1, Ordering::Relaxed);
        if earlier >= CHECKS_PER_REQUEST && !earlier.is_multiple_of(CHECKS_PER_REQUEST) {
            return Ok(());
        }
        request().inspect_err(|_| self.is_out_of_memory.store(true, Ordering::Relaxed))
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

    #[test]
    fn few_of_many_checks_ask_for_headroom() {
        let progress = Progress::watching_memory(true);
        let mut asked = Vec::new();
        for check in 0..1000 {
            let request = || {
                asked.push(check);
                Ok(())
            };
            assert_eq!(progress.check_memory(request), Ok(()));
        }
        assert!(asked.into_iter().eq((0..64).chain((64..1000).step_by(64))));
        let refused = || Err(Error::Memory { bytes: HEADROOM });
        // Check 1024 makes the next request. After it has failed, checks fail without a request.
        (1000..1024).for_each(|_| assert_eq!(progress.check_memory(refused), Ok(())));
        assert_eq!(progress.check_memory(refused), refused());
        assert_eq!(progress.check(), refused());
    }
}
