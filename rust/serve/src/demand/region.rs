//! A region that is waited for: its parts so far, for all who wait.

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
    /// All parts are there.
    Complete,
    /// The reason why there will be no more parts.
    Failed(String),
}

/// Parts that a client has not been told of yet.
#[derive(Debug)]
pub struct News {
    /// JSON of parts, each with its newline.
    pub lines: Vec<Bytes>,
    /// How it ended; none while there is more to come.
    pub outcome: Option<Outcome>,
}

#[derive(Default)]
struct Ready {
    lines: Vec<Bytes>,
    files: HashMap<String, Bytes>,
    outcome: Option<Outcome>,
}

/// A region in the making.
pub struct Region {
    /// The centre.
    pub place: Place,
    ready: Mutex<Ready>,
    /// Counts changes.
    changes: watch::Sender<u64>,
    is_abandoned: AtomicBool,
}

impl Region {
    /// A region of which nothing is ready.
    pub fn new(place: Place) -> Self {
        Region { place, ready: Mutex::default(), changes: watch::Sender::new(0), is_abandoned: AtomicBool::new(false) }
    }

    /// Add a part.
    pub fn add(&self, part: Part) {
        let mut ready = self.ready();
        ready.lines.push(part.line);
        ready.files.extend(part.files);
        drop(ready);
        self.touch();
    }

    /// The work has ended.
    pub fn end(&self, outcome: Outcome) {
        self.ready().outcome = Some(outcome);
        self.touch();
    }

    /// Nobody waits any more.
    pub fn abandon(&self) {
        self.is_abandoned.store(true, Ordering::Release);
    }

    /// Whether somebody waits.
    pub fn is_wanted(&self) -> bool {
        !self.is_abandoned.load(Ordering::Acquire)
    }

    /// Wake those who wait, because something has changed that they tell of.
    pub fn touch(&self) {
        self.changes.send_modify(|count| *count += 1);
    }

    /// Is told of changes.
    pub fn watch(&self) -> watch::Receiver<u64> {
        self.changes.subscribe()
    }

    /// Parts after so many lines.
    pub fn since(&self, lines: usize) -> News {
        let ready = self.ready();
        News { lines: ready.lines.get(lines..).unwrap_or_default().to_vec(), outcome: ready.outcome.clone() }
    }

    /// The content of a file that is ready.
    pub fn file(&self, name: &str) -> Option<Bytes> {
        self.ready().files.get(name).cloned()
    }

    /// All files that are ready.
    pub fn files(&self) -> HashMap<String, Bytes> {
        self.ready().files.clone()
    }

    /// Bytes of all files.
    pub fn bytes(&self) -> u64 {
        self.ready().files.values().map(|data| data.len() as u64).sum()
    }

    fn ready(&self) -> MutexGuard<'_, Ready> {
        self.ready.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
