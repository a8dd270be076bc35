//! Clients' requests for regions.

use std::net::IpAddr;
use std::sync::Arc;
use std::thread::JoinHandle;

use parking_lot::Mutex;

use super::cache::{Cache, CompleteRegion, RegionFile};
use super::maker::Maker;
use super::place::Place;
use super::region::Outcome;
use super::ticket::Ticket;
use super::workers::{Figures, Shared};

/// Height step of region centres, metres: users of slightly different eye heights share regions.
const HEIGHT_STEP: f64 = 0.125;

/// Limits on the work.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Number of threads; the first one makes only first stages, so that new clients never wait for others' late
    /// stages.
    pub workers: usize,
    /// Greatest number of regions in progress.
    pub regions: usize,
    /// Greatest number of regions in progress per client.
    pub per_client: usize,
    /// Bytes of complete regions that may stay in memory because they cannot be written to disk.
    pub memory: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Limits { workers: 2, regions: 64, per_client: 4, memory: 256 << 20 }
    }
}

/// Reason for rejecting a request.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Refusal {
    /// The client waits for its greatest number of regions.
    TooManyOfClient(usize),
    /// The server has its greatest number of regions in progress.
    TooMany(usize),
    /// The server is shutting down.
    Closing,
}

/// Response to a request.
pub enum Answer {
    /// The region is complete.
    Complete(CompleteRegion),
    /// The region is in progress.
    InProgress(Ticket),
}

/// Makes regions on request.
pub struct Demand {
    shared: Arc<Shared>,
    grid: f64,
    limits: Limits,
    threads: Mutex<Vec<JoinHandle<()>>>,
}

impl Demand {
    /// Starts the threads. Centres are snapped to a horizontal grid with a spacing in metres.
    pub fn start(maker: Box<dyn Maker>, grid: f64, cache: Option<Cache>, limits: Limits) -> std::io::Result<Self> {
        let shared = Arc::new(Shared::new(maker, cache, limits.memory));
        let demand = Demand { shared, grid, limits, threads: Mutex::default() };
        for number in 0..limits.workers.max(1) {
            let shared = Arc::clone(&demand.shared);
            let last_stage = if number == 0 && limits.workers > 1 { 0 } else { u8::MAX };
            let thread = std::thread::Builder::new().name(format!("nearfar maker {number}"));
            let started = thread.spawn(move || shared.work(last_stage))?;
            demand.threads.lock().push(started);
        }
        Ok(demand)
    }

    /// Snaps a place to the region's centre, as `nf.stream.snap` does, and its height to steps.
    fn snapped(&self, Place([x, y, z]): Place) -> Place {
        let nearest = |value: f64, step: f64| step * (value / step).round_ties_even();
        Place([nearest(x, self.grid), nearest(y, HEIGHT_STEP), nearest(z, self.grid)])
    }

    /// Requests the region of a place.
    pub fn ask(&self, client: IpAddr, place: Place) -> Result<Answer, Refusal> {
        let place = self.snapped(place);
        let key = place.to_string();
        let cached = self.shared.cache.as_ref().and_then(|cache| cache.find(&key));
        let limits = self.limits;
        let mut state = self.shared.state.lock();
        if let Some(manifest) = cached {
            state.figures.found += 1;
            return Ok(Answer::Complete(CompleteRegion::Manifest(manifest)));
        }
        if self.shared.is_closing() {
            return Err(Refusal::Closing);
        }
        if let Some(region) = state.in_memory.iter().find(|region| region.place == place).cloned() {
            state.figures.found += 1;
            return Ok(Answer::Complete(CompleteRegion::InMemory(region)));
        }
        if !state.entries.contains_key(&key) {
            let of_client = state.entries.values().filter(|entry| entry.clients.contains(&client)).count();
            let refusal = if of_client >= limits.per_client {
                Some(Refusal::TooManyOfClient(limits.per_client))
            } else {
                (state.entries.len() >= limits.regions).then_some(Refusal::TooMany(limits.regions))
            };
            if let Some(refusal) = refusal {
                state.figures.refused += 1;
                return Err(refusal);
            }
        }
        let region = state.add(client, key, place);
        drop(state);
        self.shared.wake();
        Ok(Answer::InProgress(Ticket::new(Arc::clone(&self.shared), region, client)))
    }

    /// Content of a file of a region that is in progress or complete.
    pub fn file(&self, name: &str) -> Option<RegionFile> {
        let state = self.shared.state.lock();
        let mut in_memory = state.entries.values().map(|entry| &entry.region).chain(&state.in_memory);
        let found = in_memory.find_map(|region| region.file(name)).or_else(|| state.unlisted.file(name));
        drop(state);
        found.map(RegionFile::Content).or_else(|| self.shared.cache.as_ref()?.file(name))
    }

    /// Tileset of a region on disk, found by its manifest.
    pub fn tileset(&self, manifest: &[u8]) -> Option<RegionFile> {
        self.shared.cache.as_ref()?.tileset(manifest)
    }

    /// Request counters by outcome, and current gauges.
    pub fn figures(&self) -> Figures {
        let cached_bytes = self.shared.cache.as_ref().map_or(0, Cache::bytes);
        let state = self.shared.state.lock();
        Figures { waiting: state.entries.len() as u64, cached_bytes, ..state.figures }
    }

    /// Rejects further requests, cancels the work and waits until it has stopped.
    pub fn close(&self) {
        self.shared.close();
        let threads = std::mem::take(&mut *self.threads.lock());
        for thread in threads {
            // Panics of a maker are caught in the thread.
            let _ = thread.join();
        }
        if let Some(cache) = &self.shared.cache {
            cache.close();
        }
        for entry in self.shared.state.lock().entries.values() {
            entry.region.end(Outcome::Failed("the server ends".into()));
        }
    }
}

impl Drop for Demand {
    fn drop(&mut self) {
        self.close();
    }
}

#[cfg(test)]
mod tests;
