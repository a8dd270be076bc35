//! A region in progress: its parts so far, shared by all waiting clients.

use std::collections::HashMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use bytes::Bytes;
use tokio::sync::watch;

use super::maker::Part;
use super::place::Place;

/// How the work on a region ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// All parts are ready.
    Complete,
    /// No more parts follow, for this reason.
    Failed(String),
}

/// Parts that a client has not received yet.
#[derive(Debug)]
pub struct News {
    /// JSON lines of parts, each with its newline.
    pub lines: Vec<Bytes>,
    /// Outcome; none while more parts follow.
    pub outcome: Option<Outcome>,
}

#[derive(Default)]
struct Ready {
    lines: Vec<Bytes>,
    files: HashMap<String, Bytes>,
    outcome: Option<Outcome>,
}

/// A region in progress.
pub struct Region {
    /// Centre.
    pub place: Place,
    ready: Mutex<Ready>,
    /// Change counter.
    changes: watch::Sender<u64>,
    is_abandoned: AtomicBool,
}

impl Region {
    /// Creates a region without parts.
    pub fn new(place: Place) -> Self {
        Region { place, ready: Mutex::default(), changes: watch::Sender::new(0), is_abandoned: AtomicBool::new(false) }
    }

    /// Adds a part.
    pub fn add(&self, part: Part) {
        let mut ready = self.ready();
        ready.lines.push(part.line);
        ready.files.extend(part.files);
        drop(ready);
        self.touch();
    }

    /// Records the outcome.
    pub fn end(&self, outcome: Outcome) {
        self.ready().outcome = Some(outcome);
        self.touch();
    }

    /// Marks the region as abandoned by all clients.
    pub fn abandon(&self) {
        self.is_abandoned.store(true, Ordering::Release);
    }

    /// Whether a client still waits.
    pub fn is_wanted(&self) -> bool {
        !self.is_abandoned.load(Ordering::Acquire)
    }

    /// Notifies waiting clients of a change.
    pub fn touch(&self) {
        self.changes.send_modify(|count| *count += 1);
    }

    /// Subscribes to changes.
    pub fn watch(&self) -> watch::Receiver<u64> {
        self.changes.subscribe()
    }

    /// Parts after the first `lines` ones.
    pub fn since(&self, lines: usize) -> News {
        let ready = self.ready();
        News { lines: ready.lines.get(lines..).unwrap_or_default().to_vec(), outcome: ready.outcome.clone() }
    }

    /// Content of a finished file.
    pub fn file(&self, name: &str) -> Option<Bytes> {
        self.ready().files.get(name).cloned()
    }

    /// All finished files.
    pub fn files(&self) -> HashMap<String, Bytes> {
        self.ready().files.clone()
    }

    /// Total size of all files, bytes.
    pub fn bytes(&self) -> u64 {
        self.ready().files.values().map(|data| data.len() as u64).sum()
    }

    fn ready(&self) -> MutexGuard<'_, Ready> {
        self.ready.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
