//! Makers of regions, which a binding implements.

use std::sync::Arc;

use bytes::Bytes;

use super::place::Place;

/// A part of a region that is ready.
#[derive(Clone, Debug)]
pub struct Part {
    /// 0 for what comes first; what comes next of the region is of this stage or of a later one.
    pub stage: u8,
    /// The part as a line of JSON, with its newline.
    pub line: Bytes,
    /// Content of files by name; the last part has the region's manifest.
    pub files: Vec<(String, Bytes)>,
    /// Stage of the part that comes next; none after the last one.
    pub next: Option<u8>,
}

/// Makes regions of one scene.
pub trait Maker: Send + Sync {
    /// Begin to make the region of a place; nothing is made yet.
    fn begin(&self, place: Place) -> Result<Box<dyn Making>, String>;
}

/// A region in the making.
pub trait Making: Send {
    /// Make the next part. `is_wanted` is asked several times a second; the work ends with an error when it says no.
    fn next(&mut self, is_wanted: &Wanted) -> Result<Part, String>;
}

/// Tells whether somebody waits for a region.
pub type Wanted = Arc<dyn Fn() -> bool + Send + Sync>;
