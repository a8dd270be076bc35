//! Clients' requests for regions, and the threads that make them.

use std::collections::{HashMap, VecDeque};
use std::net::IpAddr;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::Instant;

use super::cache::{Cache, Kept, Whole};
use super::figures::Figures;
use super::leftover::Leftover;
use super::queue::{Queue, Waiting};
use super::region::{Outcome, Region};
use super::ticket::Ticket;
use super::{Maker, Making, Part, Place, Wanted};

/// Steps of heights, metres: eyes of many heights share regions.
const HEIGHT_STEP: f64 = 0.125;

/// How much work is taken.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Threads; the first one makes only first stages, so that a new client never waits for a late stage of others.
    pub workers: usize,
    /// Regions that are waited for, at most.
    pub regions: usize,
    /// Regions that one client may wait for.
    pub per_client: usize,
    /// Bytes of complete regions that stay in memory because the disk does not take them.
    pub memory: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Limits { workers: 2, regions: 64, per_client: 4, memory: 256 << 20 }
    }
}

/// Why a request is not taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Refusal {
    /// The client waits for as many regions as it may.
    TooManyOfClient(usize),
    /// As many regions are waited for as may be.
    TooMany(usize),
    /// The server ends.
    Closing,
}

/// How a request is served.
pub enum Answer {
    /// The region is complete.
    Whole(Whole),
    /// It is being made.
    Coming(Ticket),
}

/// Makes regions for clients.
pub struct Demand {
    shared: Arc<Shared>,
    grid: f64,
    threads: Mutex<Vec<JoinHandle<()>>>,
}

pub(super) struct Shared {
    maker: Box<dyn Maker>,
    cache: Option<Cache>,
    limits: Limits,
    state: Mutex<State>,
    wake: Condvar,
    is_closing: AtomicBool,
}

#[derive(Default)]
struct State {
    entries: HashMap<String, Entry>,
    queue: Queue<Work, IpAddr>,
    /// Complete regions that the disk did not take, oldest first.
    in_memory: VecDeque<Arc<Region>>,
    leftover: Leftover,
    requests: u64,
    figures: Figures,
}

/// A region that is waited for.
struct Entry {
    region: Arc<Region>,
    clients: Vec<IpAddr>,
}

struct Work {
    region: Arc<Region>,
    making: Option<Box<dyn Making>>,
}

impl Demand {
    /// Start the threads. Places move to a horizontal grid with a spacing in metres.
    pub fn start(maker: Box<dyn Maker>, grid: f64, cache: Option<Cache>, limits: Limits) -> std::io::Result<Self> {
        let shared = Arc::new(Shared {
            maker,
            cache,
            limits,
            state: Mutex::default(),
            wake: Condvar::new(),
            is_closing: AtomicBool::new(false),
        });
        let demand = Demand { shared, grid, threads: Mutex::default() };
        for number in 0..limits.workers.max(1) {
            let shared = Arc::clone(&demand.shared);
            let last_stage = if number == 0 && limits.workers > 1 { 0 } else { u8::MAX };
            let thread = std::thread::Builder::new().name(format!("nearfar maker {number}"));
            let started = thread.spawn(move || shared.work(last_stage))?;
            demand.threads.lock().unwrap_or_else(PoisonError::into_inner).push(started);
        }
        Ok(demand)
    }

    /// The place whose region serves a place (`nf.stream.snap`, of heights too).
    fn snapped(&self, Place([x, y, z]): Place) -> Place {
        let nearest = |value: f64, step: f64| step * (value / step).round_ties_even();
        Place([nearest(x, self.grid), nearest(y, HEIGHT_STEP), nearest(z, self.grid)])
    }

    /// Ask for the region of a place.
    pub fn ask(&self, client: IpAddr, place: Place) -> Result<Answer, Refusal> {
        let place = self.snapped(place);
        let key = place.to_string();
        let kept = self.shared.cache.as_ref().and_then(|cache| cache.find(&key));
        let limits = self.shared.limits;
        let mut state = self.shared.state();
        if let Some(manifest) = kept {
            state.figures.found += 1;
            return Ok(Answer::Whole(Whole::Manifest(manifest)));
        }
        if self.shared.is_closing() {
            return Err(Refusal::Closing);
        }
        if let Some(region) = state.in_memory.iter().find(|region| region.place == place).cloned() {
            state.figures.found += 1;
            return Ok(Answer::Whole(Whole::InMemory(region)));
        }
        let own = state.entries.values().filter(|entry| entry.clients.contains(&client)).count();
        let is_new = !state.entries.contains_key(&key);
        if is_new && own >= limits.per_client {
            state.figures.refused += 1;
            return Err(Refusal::TooManyOfClient(limits.per_client));
        }
        if is_new && state.entries.len() >= limits.regions {
            state.figures.refused += 1;
            return Err(Refusal::TooMany(limits.regions));
        }
        let region = state.add(client, key, place);
        drop(state);
        self.shared.wake.notify_all();
        Ok(Answer::Coming(Ticket::new(Arc::clone(&self.shared), region, client)))
    }

    /// The content of a file of a region that is being made or complete.
    pub fn file(&self, name: &str) -> Option<Kept> {
        let state = self.shared.state();
        let in_memory = state.entries.values().map(|entry| &entry.region).chain(&state.in_memory);
        let found = in_memory.filter_map(|region| region.file(name)).next().or_else(|| state.leftover.file(name));
        drop(state);
        found.map(Kept::Content).or_else(|| self.shared.cache.as_ref()?.file(name))
    }

    /// The tileset of a region on disk, by its manifest.
    pub fn tileset(&self, manifest: &[u8]) -> Option<Kept> {
        self.shared.cache.as_ref()?.tileset(manifest)
    }

    /// Regions that are waited for.
    pub fn waiting(&self) -> usize {
        self.shared.state().entries.len()
    }

    /// Counts of what became of requests, and what is there.
    pub fn figures(&self) -> Figures {
        let mut figures = self.shared.state().figures;
        figures.waiting = self.waiting() as u64;
        figures.cached_bytes = self.shared.cache.as_ref().map_or(0, Cache::bytes);
        figures
    }

    /// Take no more requests, stop the work and wait until it has stopped.
    pub fn close(&self) {
        // With the lock: a thread that has looked and not yet waits would never hear of it.
        let state = self.shared.state();
        self.shared.is_closing.store(true, Ordering::Release);
        drop(state);
        self.shared.wake.notify_all();
        let threads = std::mem::take(&mut *self.threads.lock().unwrap_or_else(PoisonError::into_inner));
        for thread in threads {
            // A maker's panic is caught where it happens.
            let _ = thread.join();
        }
        if let Some(cache) = &self.shared.cache {
            cache.close();
        }
        for entry in self.shared.state().entries.values() {
            entry.region.end(Outcome::Failed("the server ends".into()));
        }
    }
}

impl Drop for Demand {
    fn drop(&mut self) {
        self.close();
    }
}

impl State {
    /// Note that a client waits for a region, which begins to be made if it was not.
    fn add(&mut self, client: IpAddr, key: String, place: Place) -> Arc<Region> {
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

    /// The entry of a region, unless nobody waits for it any more.
    fn entry(&self, region: &Arc<Region>) -> Option<&Entry> {
        self.entries.get(&region.place.to_string()).filter(|entry| Arc::ptr_eq(&entry.region, region))
    }

    /// Note that a client waits no more; what was to be done for it alone.
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
    /// Number of regions that are worked on before one that waits.
    pub(super) fn before(&self, region: &Arc<Region>) -> Option<usize> {
        self.state().queue.before(|work| Arc::ptr_eq(&work.region, region))
    }

    /// A client waits no more for a region.
    pub(super) fn leave(&self, client: IpAddr, region: &Arc<Region>) {
        let mut state = self.state();
        let over = state.leave(client, region);
        state.touch_all();
        drop(state);
        // A maker may take its time to end.
        drop(over);
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn is_closing(&self) -> bool {
        self.is_closing.load(Ordering::Acquire)
    }

    /// Make part after part until the server ends.
    fn work(self: &Arc<Self>, last_stage: u8) {
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
            // A maker may take its time to end.
            drop(over);
            self.wake.notify_all();
        }
    }

    /// Wait for work; none when the server ends.
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
        let (part, making) = made.unwrap_or_else(|_| Err("an internal error, which the log tells of".into()))?;
        work.making = Some(making);
        Ok(part)
    }

    /// Keep a complete region on the disk, or in memory if that does not take it, and tell that it is complete.
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
            while held > self.limits.memory && state.in_memory.len() > 1 {
                held -= state.in_memory.pop_front().map_or(0, |region| region.bytes());
            }
        }
        self.end(region, Outcome::Complete);
    }

    /// Tell those who wait how it ended; who asks now is not one of them.
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

#[cfg(test)]
mod tests;
