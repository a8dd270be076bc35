//! A client's wait for a region.

use std::net::IpAddr;
use std::sync::Arc;

use bytes::Bytes;
use tokio::sync::watch;

use super::cache::Whole;
use super::place::Place;
use super::region::{Outcome, Region};
use super::workers::Shared;

/// Progress of a region.
#[derive(Debug)]
pub enum Event {
    /// Number of regions ahead in the queue.
    Before(usize),
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
    changes: watch::Receiver<u64>,
    told: usize,
    before: Option<usize>,
}

impl Ticket {
    pub(super) fn new(shared: Arc<Shared>, region: Arc<Region>, client: IpAddr) -> Self {
        let changes = region.watch();
        Ticket { shared, region, client, changes, told: 0, before: None }
    }

    /// Waits for the next event.
    pub async fn event(&mut self) -> Event {
        loop {
            // Marked as seen before reading, so that no later change is missed.
            self.changes.borrow_and_update();
            let news = self.region.since(self.told);
            if !news.lines.is_empty() {
                self.told += news.lines.len();
                return Event::Lines(news.lines);
            }
            if let Some(outcome) = news.outcome {
                return Event::End(outcome);
            }
            let before = self.shared.position(&self.region);
            if self.told == 0 && before != self.before {
                self.before = before;
                if let Some(before) = before {
                    return Event::Before(before);
                }
            }
            if self.changes.changed().await.is_err() {
                return Event::End(Outcome::Failed("the server ends".into()));
            }
        }
    }

    /// Waits until the region is complete.
    pub async fn whole(mut self) -> Result<Whole, String> {
        loop {
            match self.event().await {
                Event::End(Outcome::Complete) => return Ok(Whole::InMemory(Arc::clone(&self.region))),
                Event::End(Outcome::Failed(reason)) => return Err(reason),
                Event::Before(_) | Event::Lines(_) => {}
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
