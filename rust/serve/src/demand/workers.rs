//! Regions in progress, and the threads that make them.

use std::collections::{HashMap, VecDeque};
use std::net::IpAddr;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Instant;

use super::cache::Cache;
use super::figures::Figures;
use super::leftover::Leftover;
use super::maker::{Maker, Making, Part, Wanted};
use super::place::Place;
use super::queue::{Queue, Waiting};
use super::region::{Outcome, Region};

/// State shared by requests and threads.
pub struct Shared {
    maker: Box<dyn Maker>,
    pub cache: Option<Cache>,
    /// Bytes of complete regions that may stay in memory because they cannot be written to disk.
    memory: u64,
    state: Mutex<State>,
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
    pub leftover: Leftover,
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
        let entry = Entry { region: Arc::clone(&region), clients: vec![client] };
        self.entries.insert(key, entry);
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
        let left = self.queue.leave(client, |work| Arc::ptr_eq(&work.region, region));
        let here: Vec<IpAddr> = self.entries.values().flat_map(|entry| entry.clients.iter().copied()).collect();
        self.queue.forget(|client| !here.contains(client));
        left
    }

    fn touch_all(&self) {
        for entry in self.entries.values() {
            entry.region.touch();
        }
    }
}

impl Shared {
    pub fn new(maker: Box<dyn Maker>, cache: Option<Cache>, memory: u64) -> Self {
        Shared {
            maker,
            cache,
            memory,
            state: Mutex::default(),
            wake: Condvar::new(),
            is_closing: AtomicBool::new(false),
        }
    }

    /// Number of regions ahead of a queued one.
    pub fn position(&self, region: &Arc<Region>) -> Option<usize> {
        self.state().queue.position(|work| Arc::ptr_eq(&work.region, region))
    }

    /// Removes a client that no longer waits for a region.
    pub fn leave(&self, client: IpAddr, region: &Arc<Region>) {
        let mut state = self.state();
        let over = state.leave(client, region);
        state.touch_all();
        drop(state);
        // Dropped without the lock, because a maker may take time to stop.
        drop(over);
    }

    pub fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub fn is_closing(&self) -> bool {
        self.is_closing.load(Ordering::Acquire)
    }

    /// Wakes the threads, because there is work.
    pub fn wake(&self) {
        self.wake.notify_all();
    }

    /// Tells the threads to stop.
    pub fn close(&self) {
        // Under the lock, so that a thread between its check and its wait does not miss the wake-up.
        let state = self.state();
        self.is_closing.store(true, Ordering::Release);
        drop(state);
        self.wake();
    }

    /// Makes parts until the server shuts down.
    pub fn work(self: &Arc<Self>, last_stage: u8) {
        while let Some(Waiting { stage: _, number, clients, mut work }) = self.next(last_stage) {
            let started = Instant::now();
            let made = self.step(&mut work);
            let took = started.elapsed();
            let region = Arc::clone(&work.region);
            let next = match made {
                Ok(part) => {
                    let next = part.next;
                    region.add(part);
                    next
                }
                Err(reason) => {
                    self.end(&region, Outcome::Failed(reason));
                    None
                }
            };
            if next.is_none() && region.since(0).outcome.is_none() {
                self.keep(&region);
            }
            let mut state = self.state();
            state.queue.charge(&clients, took);
            let again = next.zip(state.entry(&region).map(|entry| entry.clients.clone()));
            let mut over = Some(work);
            if let Some((stage, clients)) = again
                && let Some(work) = over.take()
            {
                state.queue.push(Waiting { stage, number, clients, work });
            }
            state.touch_all();
            drop(state);
            // Dropped without the lock, because a maker may take time to stop.
            drop(over);
            self.wake();
        }
    }

    /// Waits for work; none at shutdown.
    fn next(&self, last_stage: u8) -> Option<Waiting<Work, IpAddr>> {
        let mut state = self.state();
        loop {
            if self.is_closing() {
                return None;
            }
            if let Some(found) = state.queue.take(last_stage) {
                state.touch_all();
                return Some(found);
            }
            state = self.wake.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }

    fn step(self: &Arc<Self>, work: &mut Work) -> Result<Part, String> {
        let region = Arc::clone(&work.region);
        let (shared, waited) = (Arc::clone(self), Arc::clone(&region));
        let is_wanted: Wanted = Arc::new(move || waited.is_wanted() && !shared.is_closing());
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
        let kept = self.cache.as_ref().map(|cache| cache.keep(&region.place.to_string(), &region.files()));
        if let Some(Err(error)) = &kept {
            tracing::warn!(place = %region.place, %error, "a region cannot be kept on disk");
        }
        if let (Some(Ok(())), Some(cache)) = (&kept, &self.cache) {
            let mut rest = region.files();
            rest.retain(|name, _| name.starts_with("files/") && cache.file(name).is_none());
            self.state().leftover.add(rest);
        } else {
            let mut state = self.state();
            state.in_memory.push_back(Arc::clone(region));
            let mut held: u64 = state.in_memory.iter().map(|region| region.bytes()).sum();
            while held > self.memory && state.in_memory.len() > 1 {
                held -= state.in_memory.pop_front().map_or(0, |region| region.bytes());
            }
        }
        self.end(region, Outcome::Complete);
    }

    /// Records the outcome for all waiting clients; a new request starts a new region.
    fn end(&self, region: &Arc<Region>, outcome: Outcome) {
        let mut state = self.state();
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
