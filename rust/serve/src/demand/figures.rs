//! Counts of what became of requests for regions.

/// Counts since the start, and what is there now.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Figures {
    /// Regions that are waited for.
    pub waiting: u64,
    /// Bytes of regions on disk.
    pub cached_bytes: u64,
    /// Requests whose region was complete.
    pub found: u64,
    /// Requests that wait for a region together with others.
    pub shared: u64,
    /// Requests that were not taken.
    pub refused: u64,
    /// Regions that were made.
    pub made: u64,
    /// Regions that could not be made.
    pub failed: u64,
    /// Regions that nobody waited for any more.
    pub left: u64,
}

impl Figures {
    /// Counts of requests by their outcomes.
    pub fn outcomes(&self) -> [(&'static str, u64); 6] {
        [
            ("found", self.found),
            ("shared", self.shared),
            ("refused", self.refused),
            ("made", self.made),
            ("failed", self.failed),
            ("left", self.left),
        ]
    }
}
