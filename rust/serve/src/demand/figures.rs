//! Counters of requests for regions.

/// Counters since the start, and current gauges.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Figures {
    /// Regions with waiting clients.
    pub waiting: u64,
    /// Bytes of regions on disk.
    pub cached_bytes: u64,
    /// Requests whose region was complete.
    pub found: u64,
    /// Requests that joined others waiting for the same region.
    pub shared: u64,
    /// Rejected requests.
    pub refused: u64,
    /// Completed regions.
    pub made: u64,
    /// Failed regions.
    pub failed: u64,
    /// Regions abandoned by all clients.
    pub left: u64,
}

impl Figures {
    /// Request counters by outcome.
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
