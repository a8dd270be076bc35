//! Limits on rooms and their users.

use std::time::Duration;

use super::frame::{HEADER_BYTES, MAX_NAME_BYTES};
use super::token::TICKET_BYTES;

/// Maximum size of `welcome`, bytes.
const WELCOME_BYTES: usize = HEADER_BYTES + 2 + 2 + 1 + TICKET_BYTES;
/// Maximum size of `joined`, bytes.
const JOINED_BYTES: usize = HEADER_BYTES + 2 + 2 + 1 + MAX_NAME_BYTES;

/// Limits of a server's rooms and of each user.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Maximum number of rooms.
    pub rooms: usize,
    /// Maximum number of users in a room.
    pub users: usize,
    /// Maximum number of connections per client. Local programs, such as a proxy, are exempt.
    pub sockets_per_client: usize,
    /// Maximum number of existing rooms that one client has created. Local programs are exempt.
    pub rooms_per_client: usize,
    /// Maximum size of a user's message, bytes.
    pub message_bytes: usize,
    /// Maximum size of a user's queue in bytes, without poses; a user whose queue exceeds it is disconnected.
    pub queue_bytes: usize,
    /// Messages per second that a user may send.
    pub messages_per_second: f64,
    /// Bytes per second that a user may send, counted on arrival, with message headers.
    pub bytes_per_second: f64,
    /// Bytes per second that a user may send by `say` and `signal`.
    pub said_bytes_per_second: f64,
    /// Poses per second that are forwarded; others are dropped. The same limit applies separately to final poses
    /// (`stops`).
    pub poses_per_second: f64,
    /// Maximum burst, as the time in which the rate limits allow as much. Users whose messages or bytes exceed it are
    /// disconnected.
    pub burst: Duration,
    /// Timeout from the start of a connection until the user has joined.
    pub hello: Duration,
    /// Time without a byte from a user before a ping is sent, and between further pings.
    pub ping: Duration,
    /// Time without a byte from a user, pongs included, before it is disconnected.
    pub silence: Duration,
    /// Time for a disconnected user to read the reason.
    pub linger: Duration,
}

impl Limits {
    /// Checks that the limits are consistent; the error names the limit that is not.
    pub fn check(&self) -> Result<(), String> {
        let max_users = usize::from(u16::MAX) - 1;
        if !(1..=max_users).contains(&self.users) {
            return Err(format!("users: expected 1 to {max_users}, got {}", self.users));
        }
        // A new user receives `welcome` and a `joined` frame for each other user at once.
        let min_bytes = WELCOME_BYTES + JOINED_BYTES * self.users;
        if self.queue_bytes < min_bytes {
            let (users, got) = (self.users, self.queue_bytes);
            return Err(format!("queue_bytes: expected {min_bytes} or more for {users} users, got {got}"));
        }
        let Limits { burst, hello, ping, silence, linger, .. } = *self;
        let times = [("burst", burst), ("hello", hello), ("ping", ping), ("silence", silence), ("linger", linger)];
        if let Some((name, _)) = times.into_iter().find(|(_, time)| time.is_zero()) {
            return Err(format!("{name}: expected a duration above 0"));
        }
        if ping >= silence {
            let [ping, silence] = [ping, silence].map(|time| time.as_secs_f64());
            return Err(format!("ping: expected less than the silence of {silence} s, got {ping} s"));
        }
        for (name, rate) in [
            ("messages_per_second", self.messages_per_second),
            ("bytes_per_second", self.bytes_per_second),
            ("said_bytes_per_second", self.said_bytes_per_second),
            ("poses_per_second", self.poses_per_second),
        ] {
            if !(rate.is_finite() && rate > 0.0) {
                return Err(format!("{name}: expected a number greater than 0, got {rate}"));
            }
        }
        Ok(())
    }
}

impl Default for Limits {
    fn default() -> Self {
        let seconds = Duration::from_secs;
        Limits {
            rooms: 64,
            users: 256,
            sockets_per_client: 128,
            rooms_per_client: 16,
            message_bytes: 1 << 15,
            queue_bytes: 1 << 17,
            messages_per_second: 5000.0,
            bytes_per_second: 131_072.0,
            said_bytes_per_second: 32_768.0,
            poses_per_second: 144.0,
            burst: seconds(2),
            hello: seconds(10),
            ping: seconds(10),
            silence: seconds(30),
            linger: seconds(2),
        }
    }
}
