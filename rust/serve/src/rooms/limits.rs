//! How much rooms and their users may have.

use std::time::Duration;

use super::frame::{HEAD, NAME};
use super::token::TICKET;

/// Most bytes of `welcome`.
const WELCOME: usize = HEAD + 2 + 2 + 1 + TICKET;
/// Most bytes of `joined`.
const JOINED: usize = HEAD + 2 + 2 + 1 + NAME;

/// Limits of a server's rooms and of each user.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Rooms at the same time.
    pub rooms: usize,
    /// Users of a room at the same time.
    pub users: usize,
    /// Sockets of one client at the same time. Programs on this machine, such as a proxy, may have all.
    pub sockets_per_client: usize,
    /// Rooms at the same time that one client has begun. Programs on this machine may begin all.
    pub rooms_per_client: usize,
    /// Bytes of a message that a user sends.
    pub message_bytes: usize,
    /// Bytes that wait for a user, besides the poses; who lets more wait is closed.
    pub queue_bytes: usize,
    /// Messages that a user sends in a second.
    pub messages_per_second: f64,
    /// Bytes that a user sends in a second, counted where they come in: with the heads of messages.
    pub bytes_per_second: f64,
    /// Bytes a second that a user says and signals to others.
    pub said_bytes_per_second: f64,
    /// Poses a second that are passed on; those beyond are dropped. As many may say besides that none follows.
    pub poses_per_second: f64,
    /// So much time's worth of messages, of bytes and of poses may come at once; who sends more is closed.
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

impl Limits {
    /// Whether the limits fit together; a sentence if they do not.
    pub fn check(&self) -> Result<(), String> {
        let most = usize::from(u16::MAX) - 1;
        if !(1..=most).contains(&self.users) {
            return Err(format!("users: expected 1 to {most}, got {}", self.users));
        }
        // A user who joins is told of itself and of all others at once.
        let first = WELCOME + JOINED * self.users;
        if self.queue_bytes < first {
            let (users, got) = (self.users, self.queue_bytes);
            return Err(format!("queue_bytes: expected {first} or more for {users} users, got {got}"));
        }
        let times = [self.burst, self.hello, self.ping, self.silence, self.linger];
        for (name, time) in ["burst", "hello", "ping", "silence", "linger"].into_iter().zip(times) {
            if time.is_zero() {
                return Err(format!("{name}: expected more than no time"));
            }
        }
        if self.ping >= self.silence {
            return Err(format!("ping: expected less than the silence of {:?}, got {:?}", self.silence, self.ping));
        }
        let Limits { messages_per_second, bytes_per_second, said_bytes_per_second, poses_per_second, .. } = *self;
        let rates = [messages_per_second, bytes_per_second, said_bytes_per_second, poses_per_second];
        let names = ["messages_per_second", "bytes_per_second", "said_bytes_per_second", "poses_per_second"];
        for (name, rate) in names.into_iter().zip(rates) {
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
