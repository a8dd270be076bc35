//! How much rooms and their users may have.

use std::time::Duration;

/// Limits of a server's rooms and of each user.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Rooms at the same time.
    pub rooms: usize,
    /// Users of a room at the same time.
    pub users: usize,
    /// Bytes of a message that a user sends.
    pub message_bytes: usize,
    /// Bytes that wait for a user, besides the poses; who lets more wait is closed.
    pub queue_bytes: usize,
    /// Messages that a user sends in a second; who sends more for longer than the burst is closed.
    pub messages_per_second: f64,
    /// Bytes that a user sends in a second, counted where they come in: with the heads of messages.
    pub bytes_per_second: f64,
    /// Bytes a second that a user says and signals to others.
    pub said_bytes_per_second: f64,
    /// So much time's worth of messages and of bytes may come at once.
    pub burst: Duration,
    /// Time from the beginning of a connection until its user is in the room.
    pub hello: Duration,
    /// Time without a byte from a user after which it is sent a ping, and again each time that it has passed.
    pub ping: Duration,
    /// Time without a byte from a user, pongs included, after which it is gone.
    pub silence: Duration,
    /// Time that a connection which the server ends gets to read the reason.
    pub linger: Duration,
}

impl Default for Limits {
    fn default() -> Self {
        let seconds = Duration::from_secs;
        Limits {
            rooms: 64,
            users: 256,
            message_bytes: 1 << 15,
            queue_bytes: 1 << 17,
            messages_per_second: 5000.0,
            bytes_per_second: 131_072.0,
            said_bytes_per_second: 32_768.0,
            burst: seconds(2),
            hello: seconds(10),
            ping: seconds(10),
            silence: seconds(30),
            linger: seconds(2),
        }
    }
}
