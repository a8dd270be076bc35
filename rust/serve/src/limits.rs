//! Limits of connections.

use std::time::Duration;

/// Bytes of a user's frames that are read at once.
pub const READ: usize = 1 << 12;
/// Messages, and pieces of a stream, that are read in a row; then other connections have their turn.
pub const ROW: usize = 16;

/// How long and how many connections are kept.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Connections at the same time; others wait until one ends.
    pub connections: usize,
    /// Connections of one client at the same time; more are closed at once. Programs on this machine, such as a proxy,
    /// may have all.
    pub per_client: usize,
    /// Time for a handshake, for the headers of a request, and between two requests.
    pub headers: Duration,
    /// Time in which a client takes no byte of an answer.
    pub silence: Duration,
    /// Bytes of a request's headers.
    pub header_bytes: usize,
    /// Time that answers get to end when the server does.
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
