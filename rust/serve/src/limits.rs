//! Limits on connections.

use std::time::Duration;

/// Bytes of a user's frames that are read at once.
pub const READ_BYTES: usize = 1 << 12;
/// Consecutive messages, or pieces of a stream, before other connections get their turn.
pub const MAX_CONSECUTIVE: usize = 16;

/// Limits on the duration and number of connections.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Greatest number of connections; further ones wait until one ends.
    pub connections: usize,
    /// Greatest number of connections per client; further ones are closed at once. Local programs, such as a proxy, are
    /// exempt.
    pub per_client: usize,
    /// Timeout for a handshake, for the headers of a request, and between two requests.
    pub headers: Duration,
    /// Timeout for a client that reads nothing of a response.
    pub silence: Duration,
    /// Greatest size of a request's headers, bytes.
    pub header_bytes: usize,
    /// Time for open responses to finish at shutdown.
    pub grace: Duration,
}

impl Default for Limits {
    fn default() -> Self {
        let seconds = Duration::from_secs;
        Limits {
            connections: 1024,
            per_client: 256,
            headers: seconds(30),
            silence: seconds(60),
            header_bytes: 1 << 15,
            grace: seconds(3),
        }
    }
}
