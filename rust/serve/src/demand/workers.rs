//! Threads that make regions.

use std::net::IpAddr;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use parking_lot::{Condvar, Mutex};

use super::cache::Cache;
use super::region::{Maker, Outcome, Part, Region, Wanted};
use super::state::{State, Work, append};

/// Maximum total size in bytes of superseded maps, a few dozen regions' worth.
const MAX_SUPERSEDED_BYTES: u64 = 32 << 20;

/// State shared by requests and threads.
pub struct Shared {
    maker: Box<dyn Maker>,
    pub cache: Option<Cache>,
    /// Bytes of complete regions that may stay in memory because they cannot be written to disk.
    memory: u64,
    pub state: Mutex<State>,
    wake: Condvar,
    is_closing: AtomicBool,
}

impl Shared {
    pub fn new(maker: Box<dyn Maker>, cache: Option<Cache>, memory: u64) -> Self {
        let (state, wake, is_closing) = (Mutex::default(), Condvar::new(), AtomicBool::new(false));
        Shared { maker, cache, memory, state, wake, is_closing }
    }

    /// Removes a client that no longer waits for a region.
    pub fn leave(&self, client: IpAddr, region: &Arc<Region>) {
        let mut state = self.state.lock();
        let abandoned = state.leave(client, region);
        state.touch_all();
        drop(state);
        // Dropped without the lock, because a maker may take time to stop.
        drop(abandoned);
    }

    pub fn is_closing(&self) -> bool {
        self.is_closing.load(Ordering::Acquire)
    }

    pub fn wake(&self) {
        self.wake.notify_all();
    }

    pub fn close(&self) {
        // Under the lock, so that a thread between its check and its wait does not miss the wake-up.
        let state = self.state.lock();
        self.is_closing.store(true, Ordering::Release);
        drop(state);
        self.wake();
    }

    /// Makes parts of stages up to `last_stage` until the server shuts down.
    pub fn work(self: &Arc<Self>, last_stage: u8) {
        while let Some((region, clients, mut work)) = self.wait_for_work(last_stage) {
            let started = Instant::now();
            let part = self.make_part(&region, &mut work);
            let duration = started.elapsed();
            let next_stage = match part {
                Ok(part) => {
                    let next_stage = part.next;
                    region.add(part);
                    if next_stage.is_none() {
                        self.store(&region);
                    }
                    next_stage
                }
                Err(reason) => {
                    self.end(&region, Outcome::Failed(reason));
                    None
                }
            };
            let mut state = self.state.lock();
            state.charge(&clients, duration);
            let finished = match next_stage {
                Some(stage) => state.put_back(&region, Work { stage, ..work }),
                None => Some(work),
            };
            state.touch_all();
            drop(state);
            // Dropped without the lock, because a maker may take time to stop.
            drop(finished);
            self.wake();
        }
    }

    /// Waits for work; none at shutdown.
    fn wait_for_work(&self, last_stage: u8) -> Option<(Arc<Region>, Vec<IpAddr>, Work)> {
        let mut state = self.state.lock();
        while !self.is_closing() {
            if let Some(taken) = state.take(last_stage) {
                state.touch_all();
                return Some(taken);
            }
            self.wake.wait(&mut state);
        }
        None
    }

    fn make_part(self: &Arc<Self>, region: &Arc<Region>, work: &mut Work) -> Result<Part, String> {
        let (shared, wanted) = (Arc::clone(self), Arc::clone(region));
        let is_wanted: Wanted = Arc::new(move || wanted.is_wanted() && !shared.is_closing());
        let result = catch_unwind(AssertUnwindSafe(|| -> Result<_, String> {
            let mut part_maker = match work.part_maker.take() {
                Some(part_maker) => part_maker,
                None => self.maker.begin(region.place)?,
            };
            let part = part_maker.next(&is_wanted)?;
            Ok((part, part_maker))
        }));
        let (part, part_maker) = result.unwrap_or_else(|_| Err("an internal error; see the server's log".into()))?;
        work.part_maker = Some(part_maker);
        Ok(part)
    }

    /// Stores a complete region on disk, or in memory if that fails, and records that it is complete.
    fn store(&self, region: &Arc<Region>) {
        let (key, mut files) = (region.place.to_string(), region.files());
        let stored = self.cache.as_ref().map(|cache| cache.store(&key, &files).map(|()| cache)).transpose();
        if let Err(error) = &stored {
            tracing::warn!(place = %region.place, %error, "a region cannot be stored on disk");
        }
        if let Ok(Some(cache)) = stored {
            files.retain(|name, _| name.starts_with("files/") && cache.file(name).is_none());
            let superseded = Arc::new(Region::with_files(region.place, files));
            append(&mut self.state.lock().superseded_maps, superseded, MAX_SUPERSEDED_BYTES, 0);
        } else {
            append(&mut self.state.lock().in_memory, Arc::clone(region), self.memory, 1);
        }
        self.end(region, Outcome::Complete);
    }

    /// Records the outcome for all waiting clients; a new request starts a new region.
    fn end(&self, region: &Arc<Region>, outcome: Outcome) {
        let mut state = self.state.lock();
        if state.remove(region).is_some() {
            match &outcome {
                Outcome::Complete => state.statistics.made += 1,
                Outcome::Failed(reason) => {
                    state.statistics.failed += 1;
                    tracing::warn!(place = %region.place, %reason, "a region cannot be made");
                }
            }
        }
        drop(state);
        region.end(outcome);
    }
}
