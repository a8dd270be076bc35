//! Regions: traits for making them, which the binding implements, and the parts made so far, which all waiting clients
//! share.

use std::collections::HashMap;
use std::fmt;
use std::str::FromStr;
use std::sync::Arc;

use bytes::Bytes;
use tokio::sync::watch;

/// A finished part of a region.
#[derive(Clone, Debug)]
pub struct Part {
    /// Stage of the part, from 0; later parts of the region have this stage or a later one.
    pub stage: u8,
    /// Announcement of the part: a line of JSON with its newline.
    pub line: Bytes,
    /// Content of files by name; the last part has the region's manifest.
    pub files: Vec<(String, Bytes)>,
    /// Stage of the next part; none after the last part.
    pub next: Option<u8>,
}

/// Makes regions of one scene.
pub trait Maker: Send + Sync {
    /// Begins the region of a place without computing anything yet.
    fn begin(&self, place: Place) -> Result<Box<dyn PartMaker>, String>;
}

/// Makes the parts of a region, one after the other.
pub trait PartMaker: Send {
    /// Makes the next part. Calls `is_wanted` several times a second and ends with an error once it returns false.
    fn next(&mut self, is_wanted: &Wanted) -> Result<Part, String>;
}

/// Tells whether a client still waits for a region.
pub type Wanted = Arc<dyn Fn() -> bool + Send + Sync>;

/// Result of the work on a region.
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

/// A region in memory, in progress or complete.
pub struct Region {
    /// Centre.
    pub place: Place,
    progress: watch::Sender<Progress>,
}

/// A complete region.
#[derive(Clone)]
pub enum CompleteRegion {
    /// Region that is not on disk.
    InMemory(Arc<Region>),
    /// Manifest of a region on disk.
    Manifest(Bytes),
}

impl Region {
    /// Creates a region without parts.
    pub fn new(place: Place) -> Self {
        Self::with_files(place, HashMap::new())
    }

    /// Creates a region with some files.
    pub fn with_files(place: Place, files: HashMap<String, Bytes>) -> Self {
        Region { place, progress: watch::Sender::new(Progress { files, ..Progress::default() }) }
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

    /// Marks the region as abandoned: no client waits for it any more.
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

/// Maximum coordinate, metres, as for scenes.
const MAX_METRES: f64 = 1e12;
/// Maximum length of a coordinate's text.
const MAX_CHARS: usize = 40;

/// A world position, metres. URLs and the cache name it by its text, three numbers separated by commas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place(pub [f64; 3]);

impl fmt::Display for Place {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = self.0.map(|value| if value == 0.0 { 0.0 } else { value });
        write!(out, "{x},{y},{z}")
    }
}

impl FromStr for Place {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let error = || format!("expected three numbers with commas between them, got {:?}", shortened(text));
        let mut values = text.split(',').map(|part| coordinate(part).ok_or_else(error));
        let mut next = || values.next().unwrap_or_else(|| Err(error()));
        let place = Place([next()?, next()?, next()?]);
        match values.next() {
            None => Ok(place),
            Some(_) => Err(error()),
        }
    }
}

/// Parses a finite number of plain characters; rejects "inf", "nan" and numbers out of range.
fn coordinate(text: &str) -> Option<f64> {
    let is_plain =
        text.len() <= MAX_CHARS && text.bytes().all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte));
    let value: f64 = if is_plain { text.parse().ok()? } else { return None };
    (value.abs() <= MAX_METRES).then_some(value)
}

fn shortened(text: &str) -> String {
    text.chars().take(MAX_CHARS).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_and_numbers_are_each_others_inverse() {
        for (text, same) in [("4,1.7,-2", "4,1.7,-2"), ("-0,0,1e3", "0,0,1000"), ("0.1,2.50,-3E-2", "0.1,2.5,-0.03")] {
            let place: Place = text.parse().unwrap();
            assert_eq!(place.to_string(), same);
            assert_eq!(same.parse::<Place>().unwrap().to_string(), same);
        }
    }

    #[test]
    fn other_texts_are_refused() {
        for text in [
            "",
            "1,2",
            "1,2,3,4",
            "1,2,",
            "nan,0,0",
            "inf,0,0",
            "1e999,0,0",
            "1,2,3e13",
            "../1,2,3",
            "1, 2,3",
            "１,2,3",
        ] {
            let reason = text.parse::<Place>().unwrap_err();
            assert!(reason.starts_with("expected three numbers"), "{text}: {reason}");
        }
        assert!("9".repeat(1000).parse::<Place>().unwrap_err().len() < 120);
    }
}
