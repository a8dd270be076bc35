//! Session of a user in a room, independent of its transport.

use std::sync::Arc;
use std::time::{Instant, SystemTime};

use super::frame::{Fault, FromUser, HEADER_BYTES, VERSION};
use super::hub::{CountedClient, Rooms, Seat, random};
use super::limits::Limits;
use super::outbox::Outbox;
use super::pose::Pose;
use super::reason::{End, Reason};
use super::room::JoinRequest;

/// A user's burst of `say` and `signal` may have the queue's limit divided by this number, bytes.
const SAY_BURST_DIVISOR: usize = 4;
/// Bytes that the server adds to a forwarded payload.
const FORWARDED_HEADER_BYTES: usize = HEADER_BYTES + 2 + 1;
/// Smaller messages by `say` and `signal` count as this many bytes.
const MIN_MESSAGE_BYTES: usize = 64;

/// Connection of a user to a room. It gets a seat by its first frame.
pub struct Session {
    pub rooms: Arc<Rooms>,
    entrance: Entrance,
    /// Queue of frames for the user.
    pub outbox: Arc<Outbox>,
    seat: Option<Seat>,
    messages: Bucket,
    bytes: Bucket,
    said_bytes: Bucket,
    poses: Bucket,
    /// Limit on final poses (`stops`).
    final_poses: Bucket,
}

/// Room and token from the address that a client requested, and the client.
#[derive(Clone, Debug)]
pub struct Entrance {
    pub room: String,
    pub token: Option<String>,
    pub client: CountedClient,
}

impl Session {
    pub fn new(rooms: Arc<Rooms>, entrance: Entrance, now: Instant) -> Self {
        let limits = rooms.limits;
        let outbox = Arc::new(Outbox::new(limits.queue_bytes, limits.burst));
        let bucket = |rate| Bucket::new(rate, rate * limits.burst.as_secs_f64(), now);
        let (messages, bytes) = (bucket(limits.messages_per_second), bucket(limits.bytes_per_second));
        let said_burst = (limits.queue_bytes / SAY_BURST_DIVISOR) as f64;
        let said_bytes = Bucket::new(limits.said_bytes_per_second, said_burst, now);
        let [poses, final_poses] = [(); 2].map(|()| bucket(limits.poses_per_second));
        Session { rooms, entrance, outbox, seat: None, messages, bytes, said_bytes, poses, final_poses }
    }

    /// Whether the user is in the room.
    pub fn has_joined(&self) -> bool {
        self.seat.is_some()
    }

    /// Counts the end and gives up the seat. Transports call it before they send the reason: the user can then rejoin
    /// at once, and the others see it leave even if it does not read.
    pub fn end(self, reason: Reason) {
        self.rooms.statistics.count_close(reason);
    }

    /// Counts received bytes.
    pub fn count_bytes(&mut self, bytes: usize, now: Instant) -> Result<(), End> {
        let limit = self.rooms.limits.bytes_per_second;
        check_rate(self.bytes.take(bytes as f64, now), || format!("{limit} bytes a second"))
    }

    /// Counts a message without frames, such as a ping.
    pub fn count_message(&mut self, now: Instant) -> Result<(), End> {
        let limit = self.rooms.limits.messages_per_second;
        check_rate(self.messages.take(1.0, now), || format!("{limit} messages a second"))
    }

    /// Processes a message of frames.
    pub fn handle_message(&mut self, mut bytes: &[u8], now: Instant) -> Result<(), End> {
        self.count_message(now)?;
        while !bytes.is_empty() {
            let (frame, rest) = FromUser::read(bytes)?;
            self.handle_frame(frame, now)?;
            bytes = rest;
        }
        Ok(())
    }

    /// Processes a datagram of poses and acknowledgements. It is dropped if the user is not in the room, because
    /// datagrams can arrive before hello.
    pub fn handle_datagram(&mut self, mut bytes: &[u8], now: Instant) -> Result<(), End> {
        self.count_message(now)?;
        while self.has_joined() && !bytes.is_empty() {
            let (frame, rest) = FromUser::read(bytes)?;
            if !matches!(frame, FromUser::Pose(_) | FromUser::Ack { .. }) {
                return Err(End::new(Reason::Frame, "expected only poses and acknowledgements in datagrams"));
            }
            self.handle_frame(frame, now)?;
            bytes = rest;
        }
        Ok(())
    }

    fn handle_frame(&mut self, frame: FromUser<'_>, now: Instant) -> Result<(), End> {
        match &frame {
            FromUser::Say { payload, .. } | FromUser::Signal { payload, .. } => self.count_payload(payload, now)?,
            FromUser::Pose(pose) if !self.accepts_pose(pose, now)? => {
                self.rooms.statistics.dropped.inc();
                return Ok(());
            }
            _ => {}
        }
        let Some(Seat { room, sender, .. }) = &self.seat else { return self.enter(frame) };
        match frame {
            FromUser::Hello { .. } => return Err(End::new(Reason::Frame, "expected one hello")),
            FromUser::Pose(pose) => room.pose(sender, pose, now),
            FromUser::Ack { user, sequence } => room.acknowledge(sender, user, sequence),
            FromUser::Say { to, payload } => return room.say(sender, to, payload, now),
            FromUser::Signal { user, payload } => return room.signal(sender, user, payload, now),
            FromUser::Bye => return Err(End::by_user()),
        }
        Ok(())
    }

    /// Whether a pose is within the rate. Each pose wakes the whole group, so others are dropped; later ones replace
    /// them. Final poses (`stops`) must arrive, so too many of them end the connection.
    fn accepts_pose(&mut self, pose: &Pose, now: Instant) -> Result<bool, End> {
        if !pose.stops {
            return Ok(self.poses.take_if(1.0, now));
        }
        let limit = self.rooms.limits.poses_per_second;
        check_rate(self.final_poses.take(1.0, now), || format!("{limit} final poses a second")).map(|()| true)
    }

    /// Counts the payload bytes of `say` and `signal`. Their rate limit is lower than the limit of all bytes,
    /// because all recipients must receive them.
    fn count_payload(&mut self, payload: &[u8], now: Instant) -> Result<(), End> {
        let Limits { said_bytes_per_second: limit, queue_bytes, .. } = self.rooms.limits;
        let bytes = (payload.len() + FORWARDED_HEADER_BYTES).max(MIN_MESSAGE_BYTES) as f64;
        check_rate(self.said_bytes.take(bytes, now), || {
            format!("{limit} bytes a second of say and signal, {} at once", queue_bytes / SAY_BURST_DIVISOR)
        })
    }

    /// Processes the first frame: takes a seat in the room.
    fn enter(&mut self, first: FromUser<'_>) -> Result<(), End> {
        let FromUser::Hello { group, name, ticket } = first else {
            return Err(End::new(Reason::Frame, "expected hello first"));
        };
        let Entrance { room, token, client } = &self.entrance;
        let check_token = |key: &super::Key| {
            let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).map_or(u64::MAX, |age| age.as_secs());
            key.check(room, now, token.as_deref().unwrap_or_default())
        };
        let token = self.rooms.token_key.as_ref().map(check_token).transpose();
        let token = token.map_err(|sentence| End::new(Reason::Token, sentence))?;
        let identity = u64::from_le_bytes(random().map_err(|sentence| End::new(Reason::Full, sentence))?);
        let join_request =
            JoinRequest { group, name, token, previous: None, identity, outbox: Arc::clone(&self.outbox) };
        self.seat = Some(Rooms::join(&self.rooms, room, client, ticket, join_request)?);
        Ok(())
    }
}

/// Ends the connection if a rate is not within its limit, which the reason names.
fn check_rate(is_within: bool, limit: impl FnOnce() -> String) -> Result<(), End> {
    if is_within { Ok(()) } else { Err(End::new(Reason::Flood, format!("expected at most {}", limit()))) }
}

impl From<Fault> for End {
    fn from(fault: Fault) -> Self {
        match fault {
            Fault::Frame(sentence) => End::new(Reason::Frame, sentence),
            Fault::Version(version) => End::new(Reason::Version, format!("expected version {VERSION}, got {version}")),
        }
    }
}

/// Rate limit by the token bucket algorithm: a balance that refills over time up to a capacity.
pub struct Bucket {
    rate: f64,
    capacity: f64,
    balance: f64,
    last_refill: Instant,
}

impl Bucket {
    /// Creates a full bucket that refills by `rate` per second.
    pub fn new(rate: f64, capacity: f64, now: Instant) -> Self {
        Bucket { rate, capacity, balance: capacity, last_refill: now }
    }

    /// Takes an amount, even if the balance becomes negative; returns whether it did not.
    pub fn take(&mut self, amount: f64, now: Instant) -> bool {
        self.refill(now);
        self.balance -= amount;
        self.balance >= 0.0
    }

    /// Takes an amount if the balance suffices; returns whether it did.
    fn take_if(&mut self, amount: f64, now: Instant) -> bool {
        self.refill(now);
        let has_amount = self.balance >= amount;
        self.balance -= if has_amount { amount } else { 0.0 };
        has_amount
    }

    fn refill(&mut self, now: Instant) {
        let refilled = self.balance + self.rate * now.saturating_duration_since(self.last_refill).as_secs_f64();
        self.last_refill = self.last_refill.max(now);
        self.balance = refilled.min(self.capacity);
    }
}
