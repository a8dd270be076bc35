//! A user's connection, independent of its transport.

use std::sync::Arc;
use std::time::{Instant, SystemTime};

use super::bucket::Bucket;
use super::frame::{Fault, FromUser, HEAD, VERSION};
use super::hub::{Rooms, Seat, random};
use super::limits::Limits;
use super::outbox::Outbox;
use super::places::Place;
use super::pose::Pose;
use super::reason::{End, Reason};
use super::room::Joining;

/// Divisor of the queue's limit: burst that a user may send by `say` and `signal`.
const BURST: usize = 4;
/// Header bytes of a forwarded payload.
const AROUND: usize = HEAD + 2 + 1;
/// Least size in bytes that a message counts as.
const MIN: usize = 64;

/// Connection of a user to a room; it has a seat after its first frame.
pub struct Session {
    pub rooms: Arc<Rooms>,
    entering: Entering,
    /// Queue of frames for the user.
    pub outbox: Arc<Outbox>,
    seat: Option<Seat>,
    messages: Bucket,
    bytes: Bucket,
    said: Bucket,
    poses: Bucket,
    /// Limit on final poses (`stops`).
    rests: Bucket,
}

/// Room and token of a connection, from its address.
#[derive(Clone, Debug)]
pub struct Entering {
    room: String,
    token: Option<String>,
    place: Place,
}

impl Entering {
    /// Creates it from the name of the room and the user's token.
    pub fn new(room: &str, token: Option<&str>, place: Place) -> Self {
        Entering { room: room.to_owned(), token: token.map(str::to_owned), place }
    }
}

impl Session {
    /// Creates the session of a new connection.
    pub fn new(rooms: Arc<Rooms>, entering: Entering, now: Instant) -> Self {
        let limits = rooms.limits;
        let outbox = Arc::new(Outbox::new(limits.queue_bytes, limits.burst));
        let bucket = |rate| Bucket::new(rate, rate * limits.burst.as_secs_f64(), now);
        let (messages, bytes) = (bucket(limits.messages_per_second), bucket(limits.bytes_per_second));
        let said = Bucket::new(limits.said_bytes_per_second, (limits.queue_bytes / BURST) as f64, now);
        let [poses, rests] = [(); 2].map(|()| bucket(limits.poses_per_second));
        Session { rooms, entering, outbox, seat: None, messages, bytes, said, poses, rests }
    }

    /// Whether the user is in the room.
    pub fn is_in(&self) -> bool {
        self.seat.is_some()
    }

    /// Counts the end and gives up the seat. This precedes the notification, so that the user can rejoin at once; the
    /// others are notified even if the user does not read.
    pub fn end(self, reason: Reason) {
        self.rooms.figures.closed(reason);
    }

    /// Counts received bytes.
    pub fn took(&mut self, bytes: usize, now: Instant) -> Result<(), End> {
        let sentence = || format!("expected at most {} bytes a second", self.rooms.limits.bytes_per_second);
        if self.bytes.take(bytes as f64, now) { Ok(()) } else { Err(End::new(Reason::Flood, sentence())) }
    }

    /// Counts a message without frames, such as a ping.
    pub fn count_message(&mut self, now: Instant) -> Result<(), End> {
        let sentence = || format!("expected at most {} messages a second", self.rooms.limits.messages_per_second);
        if self.messages.take(1.0, now) { Ok(()) } else { Err(End::new(Reason::Flood, sentence())) }
    }

    /// Processes a message of frames.
    pub fn message(&mut self, mut bytes: &[u8], now: Instant) -> Result<(), End> {
        self.count_message(now)?;
        while !bytes.is_empty() {
            let (frame, rest) = FromUser::read(bytes).map_err(end_of_fault)?;
            self.frame(frame, now)?;
            bytes = rest;
        }
        Ok(())
    }

    /// Processes a datagram of poses and acknowledgements. It is dropped if the user is not in the room, because
    /// datagrams can arrive before hello.
    pub fn datagram(&mut self, mut bytes: &[u8], now: Instant) -> Result<(), End> {
        self.count_message(now)?;
        while self.is_in() && !bytes.is_empty() {
            let (frame, rest) = FromUser::read(bytes).map_err(end_of_fault)?;
            if !matches!(frame, FromUser::Pose(_) | FromUser::Ack { .. }) {
                return Err(End::new(Reason::Frame, "expected poses and acknowledgements alone in datagrams"));
            }
            self.frame(frame, now)?;
            bytes = rest;
        }
        Ok(())
    }

    fn frame(&mut self, frame: FromUser<'_>, now: Instant) -> Result<(), End> {
        if let FromUser::Say { payload, .. } | FromUser::Signal { payload, .. } = frame {
            self.says(payload, now)?;
        }
        if let FromUser::Pose(pose) = &frame
            && !self.moves(pose, now)?
        {
            self.rooms.figures.dropped.inc();
            return Ok(());
        }
        let Some(seat) = &self.seat else { return self.enter(frame) };
        match frame {
            FromUser::Hello { .. } => return Err(End::new(Reason::Frame, "expected one hello")),
            FromUser::Pose(pose) => seat.room.pose(seat.sender(), pose, now),
            FromUser::Ack { user, sequence } => seat.room.acknowledge(seat.sender(), user, sequence),
            FromUser::Say { to, payload } => return seat.room.say(seat.sender(), to, payload, now),
            FromUser::Signal { user, payload } => return seat.room.signal(seat.sender(), user, payload, now),
            FromUser::Bye => return Err(End::new(Reason::Bye, "the user left")),
        }
        Ok(())
    }

    /// Whether a pose is forwarded. Each pose wakes the whole group, so poses beyond the rate are dropped, as later
    /// ones replace them. Final poses (`stops`) must arrive, so too many of them end the connection.
    fn moves(&mut self, pose: &Pose, now: Instant) -> Result<bool, End> {
        if !pose.stops {
            return Ok(self.poses.take_if(1.0, now));
        }
        let sentence = || format!("expected at most {} rests a second", self.rooms.limits.poses_per_second);
        if self.rests.take(1.0, now) { Ok(true) } else { Err(End::new(Reason::Flood, sentence())) }
    }

    /// Counts the payload bytes of `say` and `signal`, whose rate is lower because all recipients must receive them.
    fn says(&mut self, payload: &[u8], now: Instant) -> Result<(), End> {
        let sentence = || {
            let Limits { said_bytes_per_second: rate, queue_bytes, .. } = self.rooms.limits;
            format!("expected at most {rate} bytes a second of say and signal, {} at once", queue_bytes / BURST)
        };
        let bytes = (payload.len() + AROUND).max(MIN) as f64;
        if self.said.take(bytes, now) { Ok(()) } else { Err(End::new(Reason::Flood, sentence())) }
    }

    /// Processes the first frame: takes a seat in the room.
    fn enter(&mut self, first: FromUser<'_>) -> Result<(), End> {
        let FromUser::Hello { group, name, ticket } = first else {
            return Err(End::new(Reason::Frame, "expected hello first"));
        };
        let Entering { room, token, place } = &self.entering;
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
        self.seat = Some(Rooms::join(&self.rooms, room, place, ticket, joining)?);
        Ok(())
    }
}

fn end_of_fault(fault: Fault) -> End {
    match fault {
        Fault::Frame(sentence) => End::new(Reason::Frame, sentence),
        Fault::Version(version) => End::new(Reason::Version, format!("expected version {VERSION}, got {version}")),
    }
}
