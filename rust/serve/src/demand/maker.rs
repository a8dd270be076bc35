//! Traits for making regions, implemented by the binding.

use std::sync::Arc;

use bytes::Bytes;

use super::place::Place;

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
    fn begin(&self, place: Place) -> Result<Box<dyn Making>, String>;
}

/// A region in progress.
pub trait Making: Send {
    /// Makes the next part. Calls `is_wanted` several times a second and ends with an error once it returns false.
    fn next(&mut self, is_wanted: &Wanted) -> Result<Part, String>;
}

/// Tells whether a client still waits for a region.
pub type Wanted = Arc<dyn Fn() -> bool + Send + Sync>;
