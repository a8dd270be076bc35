//! A user's connection, by whatever way its messages come and go.

use std::sync::Arc;
use std::time::{Instant, SystemTime};

use super::bucket::Bucket;
use super::frame::{Fault, FromUser, VERSION};
use super::hub::{Rooms, Seat, random};
use super::outbox::Outbox;
use super::reason::{End, Reason};
use super::room::Joining;

/// A connection to a room: without a place in it until the first frame has come.
pub struct Session {
    pub rooms: Arc<Rooms>,
    entering: Entering,
    /// What waits for the user.
    pub outbox: Arc<Outbox>,
    seat: Option<Seat>,
    messages: Bucket,
    bytes: Bucket,
}

/// Where a connection leads, as its address says.
#[derive(Clone, Debug, PartialEq)]
pub struct Entering {
    /// The room's name.
    pub room: String,
    /// The user's token.
    pub token: Option<String>,
}

impl Session {
    /// A connection that begins now.
    pub fn new(rooms: Arc<Rooms>, entering: Entering, now: Instant) -> Self {
        let limits = rooms.limits;
        let outbox = Arc::new(Outbox::new(limits.queue_bytes));
        let bucket = |rate| Bucket::new(rate, limits.burst, now);
        let (messages, bytes) = (bucket(limits.messages_per_second), bucket(limits.bytes_per_second));
        Session { rooms, entering, outbox, seat: None, messages, bytes }
    }

    /// Whether the user is in the room.
    pub fn is_in(&self) -> bool {
        self.seat.is_some()
    }

    /// So many bytes have come.
    pub fn took(&mut self, bytes: usize, now: Instant) -> Result<(), End> {
        let sentence = || format!("expected at most {} bytes a second", self.rooms.limits.bytes_per_second);
        if self.bytes.take(bytes as f64, now) { Ok(()) } else { Err(End::new(Reason::Flood, sentence())) }
    }

    /// A message without frames, such as a ping, has come.
    pub fn counted(&mut self, now: Instant) -> Result<(), End> {
        let sentence = || format!("expected at most {} messages a second", self.rooms.limits.messages_per_second);
        if self.messages.take(1.0, now) { Ok(()) } else { Err(End::new(Reason::Flood, sentence())) }
    }

    /// A message of frames has come.
    pub fn message(&mut self, mut bytes: &[u8], now: Instant) -> Result<(), End> {
        self.counted(now)?;
        while !bytes.is_empty() {
            let (frame, rest) = FromUser::read(bytes).map_err(told)?;
            self.frame(frame, now)?;
            bytes = rest;
        }
        Ok(())
    }

    fn frame(&mut self, frame: FromUser<'_>, now: Instant) -> Result<(), End> {
        let Some(seat) = &self.seat else { return self.enter(frame) };
        match frame {
            FromUser::Hello { .. } => return Err(End::new(Reason::Frame, "expected one hello")),
            FromUser::Pose(pose) => seat.room.pose(seat.user, pose, now),
            FromUser::Ack { user, sequence } => seat.room.acknowledge(seat.user, user, sequence),
            FromUser::Say { to, payload } => seat.room.say(seat.user, to, payload),
            FromUser::Signal { user, payload } => seat.room.signal(seat.user, user, payload),
            FromUser::Bye => return Err(End::new(Reason::Bye, "the user left")),
        }
        Ok(())
    }

    /// The first frame takes a place in the room.
    fn enter(&mut self, first: FromUser<'_>) -> Result<(), End> {
        let FromUser::Hello { group, name, ticket } = first else {
            return Err(End::new(Reason::Frame, "expected hello first"));
        };
        let Entering { room, token } = &self.entering;
        let token = match &self.rooms.entry {
            None => None,
            Some(key) => {
                let token = token.as_deref().unwrap_or_default();
                let since =
                    SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).map_or(u64::MAX, |at| at.as_secs());
                Some(key.check(room, since, token).map_err(|sentence| End::new(Reason::Token, sentence))?)
            }
        };
        let identity = u64::from_le_bytes(random().map_err(|sentence| End::new(Reason::Full, sentence))?);
        let outbox = Arc::clone(&self.outbox);
        let joining = Joining { group, name, token, back: None, identity, outbox };
        self.seat = Some(Rooms::join(&self.rooms, room, ticket, joining)?);
        Ok(())
    }
}

fn told(fault: Fault) -> End {
    match fault {
        Fault::Frame(sentence) => End::new(Reason::Frame, sentence),
        Fault::Version(version) => End::new(Reason::Version, format!("expected version {VERSION}, got {version}")),
    }
}
