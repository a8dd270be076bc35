//! Regions in progress, and the threads that make them.

use std::collections::{HashMap, VecDeque};
use std::net::IpAddr;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use parking_lot::{Condvar, Mutex};

use super::cache::Cache;
use super::maker::{Maker, Making, Part, Wanted};
use super::place::Place;
use super::queue::{Queue, Waiting};
use super::region::{Outcome, Region};
use super::unlisted::Unlisted;

/// Counters of requests since the start, and current gauges.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Figures {
    /// Regions with waiting clients.
    pub waiting: u64,
    /// Bytes of regions on disk.
    pub cached_bytes: u64,
    /// Requests whose region was complete.
    pub found: u64,
    /// Requests that joined others waiting for the same region.
    pub shared: u64,
    /// Rejected requests.
    pub refused: u64,
    /// Completed regions.
    pub made: u64,
    /// Failed regions.
    pub failed: u64,
    /// Regions abandoned by all clients.
    pub left: u64,
}

impl Figures {
    /// Request counters by outcome.
    pub fn outcomes(&self) -> [(&'static str, u64); 6] {
        let Figures { found, shared, refused, made, failed, left, .. } = *self;
        [("found", found), ("shared", shared), ("refused", refused), ("made", made), ("failed", failed), ("left", left)]
    }
}

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

/// Regions in progress, and complete ones in memory.
#[derive(Default)]
pub struct State {
    /// Regions in progress by place.
    pub entries: HashMap<String, Entry>,
    queue: Queue<Work, IpAddr>,
    /// Complete regions that could not be written to disk, oldest first.
    pub in_memory: VecDeque<Arc<Region>>,
    pub unlisted: Unlisted,
    requests: u64,
    pub figures: Figures,
}

/// A region in progress, and its waiting clients.
pub struct Entry {
    pub region: Arc<Region>,
    pub clients: Vec<IpAddr>,
}

struct Work {
    region: Arc<Region>,
    making: Option<Box<dyn Making>>,
}

impl State {
    /// Adds a client to a region, which is queued if it is new.
    pub fn add(&mut self, client: IpAddr, key: String, place: Place) -> Arc<Region> {
        if let Some(entry) = self.entries.get_mut(&key) {
            entry.clients.push(client);
            self.figures.shared += 1;
            let region = Arc::clone(&entry.region);
            self.queue.join(client, |work| Arc::ptr_eq(&work.region, &region));
            return region;
        }
        self.requests += 1;
        let region = Arc::new(Region::new(place));
        self.entries.insert(key, Entry { region: Arc::clone(&region), clients: vec![client] });
        let work = Work { region: Arc::clone(&region), making: None };
        self.queue.push(Waiting { stage: 0, number: self.requests, clients: vec![client], work });
        region
    }

    /// Entry of a region, unless it was abandoned.
    fn entry(&self, region: &Arc<Region>) -> Option<&Entry> {
        self.entries.get(&region.place.to_string()).filter(|entry| Arc::ptr_eq(&entry.region, region))
    }

    /// Removes a client from a region; returns the queued work if no client is left.
    fn leave(&mut self, client: IpAddr, region: &Arc<Region>) -> Option<Work> {
        let key = region.place.to_string();
        let entry = self.entries.get_mut(&key).filter(|entry| Arc::ptr_eq(&entry.region, region))?;
        entry.clients.swap_remove(entry.clients.iter().position(|each| *each == client)?);
        if entry.clients.is_empty() {
            region.abandon();
            self.entries.remove(&key);
            self.figures.left += 1;
        }
        let abandoned = self.queue.leave(client, |work| Arc::ptr_eq(&work.region, region));
        let present: Vec<IpAddr> = self.entries.values().flat_map(|entry| entry.clients.iter().copied()).collect();
        self.queue.forget(|client| !present.contains(client));
        abandoned
    }

    fn touch_all(&self) {
        for entry in self.entries.values() {
            entry.region.touch();
        }
    }
}

impl Shared {
    pub fn new(maker: Box<dyn Maker>, cache: Option<Cache>, memory: u64) -> Self {
        let (state, wake, is_closing) = (Mutex::default(), Condvar::new(), AtomicBool::new(false));
        Shared { maker, cache, memory, state, wake, is_closing }
    }

    /// Number of regions ahead of a queued one.
    pub fn position(&self, region: &Arc<Region>) -> Option<usize> {
        self.state.lock().queue.position(|work| Arc::ptr_eq(&work.region, region))
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

    /// Makes parts until the server shuts down.
    pub fn work(self: &Arc<Self>, last_stage: u8) {
        while let Some(Waiting { stage: _, number, clients, mut work }) = self.next(last_stage) {
            let started = Instant::now();
            let made = self.step(&mut work);
            let duration = started.elapsed();
            let region = Arc::clone(&work.region);
            let next_stage = match made {
                Ok(part) => {
                    let next_stage = part.next;
                    region.add(part);
                    if next_stage.is_none() {
                        self.keep(&region);
                    }
                    next_stage
                }
                Err(reason) => {
                    self.end(&region, Outcome::Failed(reason));
                    None
                }
            };
            let mut state = self.state.lock();
            state.queue.charge(&clients, duration);
            let next = next_stage.zip(state.entry(&region).map(|entry| entry.clients.clone()));
            let finished = match next {
                Some((stage, clients)) => {
                    state.queue.push(Waiting { stage, number, clients, work });
                    None
                }
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
    fn next(&self, last_stage: u8) -> Option<Waiting<Work, IpAddr>> {
        let mut state = self.state.lock();
        while !self.is_closing() {
            if let Some(waiting) = state.queue.take(last_stage) {
                state.touch_all();
                return Some(waiting);
            }
            self.wake.wait(&mut state);
        }
        None
    }

    fn step(self: &Arc<Self>, work: &mut Work) -> Result<Part, String> {
        let region = Arc::clone(&work.region);
        let (shared, wanted) = (Arc::clone(self), Arc::clone(&region));
        let is_wanted: Wanted = Arc::new(move || wanted.is_wanted() && !shared.is_closing());
        let made = catch_unwind(AssertUnwindSafe(|| -> Result<_, String> {
            let mut making = match work.making.take() {
                Some(making) => making,
                None => self.maker.begin(region.place)?,
            };
            let part = making.next(&is_wanted)?;
            Ok((part, making))
        }));
        let (part, making) = made.unwrap_or_else(|_| Err("an internal error; see the server's log".into()))?;
        work.making = Some(making);
        Ok(part)
    }

    /// Stores a complete region on disk, or in memory if that fails, and records that it is complete.
    fn keep(&self, region: &Arc<Region>) {
        let key = region.place.to_string();
        let stored = self.cache.as_ref().map(|cache| cache.keep(&key, &region.files()).map(|()| cache)).transpose();
        if let Err(error) = &stored {
            tracing::warn!(place = %region.place, %error, "a region cannot be kept on disk");
        }
        if let Ok(Some(cache)) = stored {
            let mut unlisted = region.files();
            unlisted.retain(|name, _| name.starts_with("files/") && cache.file(name).is_none());
            self.state.lock().unlisted.add(unlisted);
        } else {
            let mut state = self.state.lock();
            state.in_memory.push_back(Arc::clone(region));
            let mut total: u64 = state.in_memory.iter().map(|region| region.bytes()).sum();
            while total > self.memory && state.in_memory.len() > 1 {
                total -= state.in_memory.pop_front().map_or(0, |region| region.bytes());
            }
        }
        self.end(region, Outcome::Complete);
    }

    /// Records the outcome for all waiting clients; a new request starts a new region.
    fn end(&self, region: &Arc<Region>, outcome: Outcome) {
        let mut state = self.state.lock();
        if state.entry(region).is_some() {
            state.entries.remove(&region.place.to_string());
            match &outcome {
                Outcome::Complete => state.figures.made += 1,
                Outcome::Failed(reason) => {
                    state.figures.failed += 1;
                    tracing::warn!(place = %region.place, %reason, "a region cannot be made");
                }
            }
        }
        drop(state);
        region.end(outcome);
    }
}
