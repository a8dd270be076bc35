//! A region in progress: its parts so far, shared by all waiting clients.

use std::collections::HashMap;

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

/// State of a region in progress.
#[derive(Default)]
pub struct Progress {
    /// JSON lines of parts, each with its newline.
    pub lines: Vec<Bytes>,
    files: HashMap<String, Bytes>,
    /// Outcome; none while more parts follow.
    pub outcome: Option<Outcome>,
    is_abandoned: bool,
}

/// A region in progress.
pub struct Region {
    /// Centre.
    pub place: Place,
    progress: watch::Sender<Progress>,
}

impl Region {
    /// Creates a region without parts.
    pub fn new(place: Place) -> Self {
        Region { place, progress: watch::Sender::default() }
    }

    /// Adds a part.
    pub fn add(&self, part: Part) {
        self.progress.send_modify(|progress| {
            progress.lines.push(part.line);
            progress.files.extend(part.files);
        });
    }

    /// Records the outcome.
    pub fn end(&self, outcome: Outcome) {
        self.progress.send_modify(|progress| progress.outcome = Some(outcome));
    }

    /// Marks the region as abandoned by all clients.
    pub fn abandon(&self) {
        self.progress.send_modify(|progress| progress.is_abandoned = true);
    }

    /// Whether a client still waits.
    pub fn is_wanted(&self) -> bool {
        !self.progress.borrow().is_abandoned
    }

    /// Notifies waiting clients that the region's position in the queue may have changed.
    pub fn touch(&self) {
        self.progress.send_modify(|_| {});
    }

    /// Subscribes to changes.
    pub fn watch(&self) -> watch::Receiver<Progress> {
        self.progress.subscribe()
    }

    /// Content of a finished file.
    pub fn file(&self, name: &str) -> Option<Bytes> {
        self.progress.borrow().files.get(name).cloned()
    }

    /// All finished files.
    pub fn files(&self) -> HashMap<String, Bytes> {
        self.progress.borrow().files.clone()
    }

    /// Total size of all files, bytes.
    pub fn bytes(&self) -> u64 {
        self.progress.borrow().files.values().map(|data| data.len() as u64).sum()
    }
}
