//! A client's wait for a region.

use std::net::IpAddr;
use std::sync::Arc;

use bytes::Bytes;
use tokio::sync::watch;

use super::cache::CompleteRegion;
use super::place::Place;
use super::region::{Outcome, Progress, Region};
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
    progress: watch::Receiver<Progress>,
    /// Number of lines received so far.
    line_count: usize,
    /// Last reported number of regions ahead in the queue.
    position: Option<usize>,
}

impl Ticket {
    pub(super) fn new(shared: Arc<Shared>, region: Arc<Region>, client: IpAddr) -> Self {
        let progress = region.watch();
        Ticket { shared, region, client, progress, line_count: 0, position: None }
    }

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
            let position = self.shared.position(&self.region);
            if self.line_count == 0 && position != self.position {
                self.position = position;
                if let Some(position) = position {
                    return Event::Before(position);
                }
            }
            if self.progress.changed().await.is_err() {
                return Event::End(Outcome::Failed("the server ends".into()));
            }
        }
    }

    /// Waits until the region is complete.
    pub async fn whole(mut self) -> Result<CompleteRegion, String> {
        loop {
            match self.event().await {
                Event::End(Outcome::Complete) => return Ok(CompleteRegion::InMemory(Arc::clone(&self.region))),
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
