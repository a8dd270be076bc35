//! Requests of clients for regions, and tickets with which clients wait for them.

use std::net::IpAddr;
use std::sync::Arc;
use std::thread::JoinHandle;

use bytes::Bytes;
use parking_lot::Mutex;
use tokio::sync::watch;

use super::cache::Cache;
use super::region::{CompleteRegion, Maker, Outcome, Place, Progress, Region};
use super::state::Statistics;
use super::workers::Shared;
use crate::file::Content;

/// Height step of region centres, metres: users of slightly different eye heights share regions.
const HEIGHT_STEP: f64 = 0.125;

/// Limits on the work.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Number of threads; the first one makes only first stages, so that new clients never wait for others' late
    /// stages.
    pub workers: usize,
    /// Maximum number of regions in progress.
    pub regions: usize,
    /// Maximum number of regions in progress per client.
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
    /// The client already waits for as many regions as one client may.
    TooManyOfClient(usize),
    /// The server already has as many regions in progress as it may.
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
            let handle = thread.spawn(move || shared.work(last_stage))?;
            demand.threads.lock().push(handle);
        }
        Ok(demand)
    }

    /// Snaps a place to the grid of centres, as `nf.stream.snap` does, and its height to steps.
    fn snap(&self, Place([x, y, z]): Place) -> Place {
        let nearest = |value: f64, step: f64| step * (value / step).round_ties_even();
        Place([nearest(x, self.grid), nearest(y, HEIGHT_STEP), nearest(z, self.grid)])
    }

    /// Requests the region of a place.
    pub fn request(&self, client: IpAddr, place: Place) -> Result<Answer, Refusal> {
        let place = self.snap(place);
        let key = place.to_string();
        let cached = self.shared.cache.as_ref().and_then(|cache| cache.find(&key));
        let limits = self.limits;
        let mut state = self.shared.state.lock();
        if let Some(manifest) = cached {
            state.statistics.found += 1;
            return Ok(Answer::Complete(CompleteRegion::Manifest(manifest)));
        }
        if self.shared.is_closing() {
            return Err(Refusal::Closing);
        }
        if let Some(region) = state.in_memory.iter().find(|region| region.place == place).cloned() {
            state.statistics.found += 1;
            return Ok(Answer::Complete(CompleteRegion::InMemory(region)));
        }
        if !state.entries.contains_key(&key) {
            let client_regions = state.entries.values().filter(|entry| entry.clients.contains(&client)).count();
            let refusal = if client_regions >= limits.per_client {
                Some(Refusal::TooManyOfClient(limits.per_client))
            } else {
                (state.entries.len() >= limits.regions).then_some(Refusal::TooMany(limits.regions))
            };
            if let Some(refusal) = refusal {
                state.statistics.refused += 1;
                return Err(refusal);
            }
        }
        let region = state.add(client, key, place);
        drop(state);
        self.shared.wake();
        let (shared, progress) = (Arc::clone(&self.shared), region.watch());
        Ok(Answer::InProgress(Ticket { shared, region, client, progress, line_count: 0, position: None }))
    }

    /// Content of a file of a region that is in progress or complete, or of a coarse map that a full one has
    /// superseded.
    pub fn file(&self, name: &str) -> Option<Content> {
        let state = self.shared.state.lock();
        let in_progress = state.entries.values().map(|entry| &entry.region);
        let mut in_memory = in_progress.chain(&state.in_memory).chain(&state.superseded_maps);
        let data = in_memory.find_map(|region| region.file(name));
        drop(state);
        data.map(Content::Bytes).or_else(|| self.shared.cache.as_ref()?.file(name))
    }

    /// Tileset of a region on disk, found by its manifest.
    pub fn tileset(&self, manifest: &[u8]) -> Option<Content> {
        self.shared.cache.as_ref()?.tileset(manifest)
    }

    /// Request counters by outcome, and current gauges.
    pub fn statistics(&self) -> Statistics {
        let cached_bytes = self.shared.cache.as_ref().map_or(0, Cache::bytes);
        let state = self.shared.state.lock();
        Statistics { waiting: state.entries.len() as u64, cached_bytes, ..state.statistics }
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
            entry.region.end(Outcome::Failed("the server is shutting down".into()));
        }
    }
}

impl Drop for Demand {
    fn drop(&mut self) {
        self.close();
    }
}

/// Progress of a region.
#[derive(Debug)]
pub enum Event {
    /// Number of regions ahead in the queue.
    Waiting(usize),
    /// JSON lines of finished parts.
    Lines(Vec<Bytes>),
    /// The last event.
    End(Outcome),
}

/// A client's interest in a region; given up on drop.
pub struct Ticket {
    shared: Arc<Shared>,
    region: Arc<Region>,
    client: IpAddr,
    progress: watch::Receiver<Progress>,
    /// Number of lines received so far.
    line_count: usize,
    /// Last reported number of regions ahead in the queue.
    position: Option<usize>,
}

impl Ticket {
    /// Waits for the next event.
    pub async fn event(&mut self) -> Event {
        loop {
            let (lines, outcome) = {
                let progress = self.progress.borrow_and_update();
                (progress.lines[self.line_count..].to_vec(), progress.outcome.clone())
            };
            if !lines.is_empty() {
                self.line_count += lines.len();
                return Event::Lines(lines);
            }
            if let Some(outcome) = outcome {
                return Event::End(outcome);
            }
            let position = self.shared.state.lock().position(&self.region);
            if self.line_count == 0 && position != self.position {
                self.position = position;
                if let Some(position) = position {
                    return Event::Waiting(position);
                }
            }
            if self.progress.changed().await.is_err() {
                return Event::End(Outcome::Failed("the server is shutting down".into()));
            }
        }
    }

    /// Waits until the region is complete.
    pub async fn wait(mut self) -> Result<CompleteRegion, String> {
        loop {
            match self.event().await {
                Event::End(Outcome::Complete) => return Ok(CompleteRegion::InMemory(Arc::clone(&self.region))),
                Event::End(Outcome::Failed(reason)) => return Err(reason),
                Event::Waiting(_) | Event::Lines(_) => {}
            }
        }
    }

    /// Centre of the region.
    pub fn place(&self) -> Place {
        self.region.place
    }
}

impl Drop for Ticket {
    fn drop(&mut self) {
        self.shared.leave(self.client, &self.region);
    }
}

#[cfg(test)]
mod tests;
