//! Queue of frames for a user: the newest pose of each other user, and all other frames in order.

use std::task::Waker;
use std::time::{Duration, Instant};

use bytes::BytesMut;
use futures_util::task::AtomicWaker;
use parking_lot::Mutex;

use super::frame::FromServer;
use super::pose::Pose;
use super::reason::{End, Reason};

/// Capacity in bytes that an empty queue keeps.
const EMPTY_CAPACITY: usize = 1 << 12;
/// One sender may fill the queue's limit divided by this number.
const SHARE_DIVISOR: usize = 4;

/// Queue of frames for one user, in bounded memory. Each addition wakes the task that writes to the user.
pub struct Outbox {
    pending: Mutex<Pending>,
    writer: AtomicWaker,
    /// Maximum number of bytes queued or in flight, without poses.
    max_bytes: usize,
    /// Age of the queue up to which a sender that fills its share is disconnected. If the queue is older, its user has
    /// not read for that long, and is disconnected instead.
    burst: Duration,
}

#[derive(Default)]
struct Pending {
    /// Reliable frames, in order.
    queue: Vec<u8>,
    /// Time at which the oldest queued frame of another user was added.
    since: Option<Instant>,
    /// Senders with their numbers of queued bytes.
    shares: Vec<(u16, usize)>,
    /// Bytes taken from the queue that the socket has not accepted yet.
    in_flight: usize,
    /// At most one pose per user.
    poses: Vec<QueuedPose>,
    settled: Option<Settled>,
    end: Option<End>,
}

/// Sequence number up to which the user's poses are settled.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Settled {
    sequence: u32,
    /// Whether it may be the last one, because the user has stopped.
    is_last: bool,
}

struct QueuedPose {
    user: u16,
    pose: Pose,
    arrival: Instant,
}

/// Selection of queued frames.
#[derive(Clone, Copy, PartialEq)]
pub enum Selection {
    All,
    /// Only frames that must arrive: no poses and settled numbers that later ones will replace.
    Reliable,
}

/// A datagram of poses and a settled number.
#[derive(Default)]
pub struct Datagram {
    /// Encoded frames; empty if nothing is queued.
    pub bytes: BytesMut,
    /// Users and numbers of the poses, with their arrival times.
    poses: Vec<(u16, u32, Instant)>,
    settled: Option<u32>,
}

/// Result of `Outbox::take`, for the connection to write.
#[derive(Debug, PartialEq)]
pub enum Outgoing {
    /// The queue is empty.
    Nothing,
    /// Frames were taken as one message.
    Message,
    End(End),
}

impl Outbox {
    /// Creates an empty queue with a limit in bytes, not counting poses. A sender that fills its share within the time
    /// `burst` is disconnected.
    pub fn new(max_bytes: usize, burst: Duration) -> Self {
        Outbox { pending: Mutex::default(), writer: AtomicWaker::new(), max_bytes, burst }
    }

    /// Changes the queue and wakes the writer; returns the result of `change`, or none if the connection has ended.
    fn update<T>(&self, change: impl FnOnce(&mut Pending) -> T) -> Option<T> {
        let mut pending = self.pending.lock();
        let changed = pending.end.is_none().then(|| change(&mut pending));
        drop(pending);
        self.writer.wake();
        changed
    }

    /// Queues a reliable frame. Disconnects the user if the queue exceeds its limit.
    pub fn add(&self, frame: &FromServer<'_>) {
        self.update(|pending| pending.push(frame, self.max_bytes));
    }

    /// Queues a frame from another user. An error ends the sender's connection: its share is full, and the queue is
    /// younger than `burst`. In an older queue the frame counts against the user, who does not read.
    pub fn add_from(&self, sender: u16, frame: &FromServer<'_>, now: Instant) -> Result<(), End> {
        let added = self.update(|pending| {
            let since = *pending.since.get_or_insert(now);
            let (share, max_share) = (pending.share(sender), self.max_bytes / SHARE_DIVISOR);
            *share += frame.bytes();
            if *share > max_share && now.saturating_duration_since(since) < self.burst {
                let sentence = format!("expected at most {max_share} bytes at once for one user");
                return Err(End::new(Reason::Flood, sentence));
            }
            pending.push(frame, self.max_bytes);
            Ok(())
        });
        added.unwrap_or(Ok(()))
    }

    /// Queues a pose with its arrival time, replacing an older one of the same user. Returns whether it replaced one.
    pub fn add_pose(&self, user: u16, pose: Pose, arrival: Instant) -> bool {
        let new = QueuedPose { user, pose, arrival };
        let is_replacement = self.update(|pending| {
            let Some(older) = pending.poses.iter_mut().find(|queued| queued.user == user) else {
                pending.poses.push(new);
                return false;
            };
            // A replaced pose that needs acknowledgement is settled only if the new one is acknowledged, too.
            let is_acknowledged = older.pose.is_acknowledged || new.pose.is_acknowledged;
            *older = QueuedPose { pose: Pose { is_acknowledged, ..new.pose }, ..new };
            true
        });
        is_replacement.unwrap_or_default()
    }

    /// Queues the number up to which poses are settled; `is_last` if it may be the last one.
    pub fn add_settled(&self, sequence: u32, is_last: bool) {
        self.update(|pending| pending.settled = pending.settled.max(Some(Settled { sequence, is_last })));
    }

    /// Removes the pose of a user who has left.
    pub fn forget(&self, user: u16) {
        self.pending.lock().poses.retain(|queued| queued.user != user);
    }

    /// Ends the connection and discards the queue. The first reason is kept.
    pub fn end(&self, end: End) {
        self.update(|pending| pending.finish(end));
    }

    /// Reason why the connection ends, if it does.
    pub fn end_reason(&self) -> Option<End> {
        self.pending.lock().end.clone()
    }

    /// Registers the task to wake after each change.
    pub fn register(&self, writer: &Waker) {
        self.writer.register(writer);
    }

    /// Takes queued frames as one message: those that must arrive, in order, then poses. Appends the poses' arrival
    /// times to `arrivals`. The caller must have written all frames that it took before.
    pub fn take(&self, selection: Selection, message: &mut BytesMut, arrivals: &mut Vec<Instant>) -> Outgoing {
        let mut pending = self.pending.lock();
        if let Some(end) = &pending.end {
            return Outgoing::End(end.clone());
        }
        pending.in_flight = pending.queue.len();
        message.extend_from_slice(&pending.queue);
        // Release memory that a burst has allocated.
        if pending.queue.capacity() > EMPTY_CAPACITY {
            pending.queue = Vec::new();
        }
        pending.queue.clear();
        pending.shares.clear();
        pending.since = None;
        for queued in pending.poses.extract_if(.., |queued| selection == Selection::All || queued.pose.stops) {
            FromServer::Pose { user: queued.user, pose: queued.pose }.write(message);
            arrivals.push(queued.arrival);
        }
        if let Some(Settled { sequence, .. }) =
            pending.settled.take_if(|settled| selection == Selection::All || settled.is_last)
        {
            FromServer::Settled { sequence }.write(message);
        }
        if message.is_empty() { Outgoing::Nothing } else { Outgoing::Message }
    }

    /// Composes a datagram of at most `max_bytes` from replaceable frames, which stay queued until `confirm_sent`.
    pub fn datagram(&self, max_bytes: usize) -> Datagram {
        let (pending, mut datagram) = (self.pending.lock(), Datagram::default());
        let fits = |datagram: &Datagram, frame: &FromServer<'_>| datagram.bytes.len() + frame.bytes() <= max_bytes;
        if let Some(Settled { sequence, is_last: false }) = pending.settled {
            let frame = FromServer::Settled { sequence };
            if fits(&datagram, &frame) {
                frame.write(&mut datagram.bytes);
                datagram.settled = Some(sequence);
            }
        }
        for queued in pending.poses.iter().filter(|queued| !queued.pose.stops) {
            let frame = FromServer::Pose { user: queued.user, pose: queued.pose };
            if !fits(&datagram, &frame) {
                break;
            }
            frame.write(&mut datagram.bytes);
            datagram.poses.push((queued.user, queued.pose.sequence, queued.arrival));
        }
        datagram
    }

    /// Removes the frames of a sent datagram, but not newer ones; returns the arrival times of its poses.
    pub fn confirm_sent(&self, datagram: &Datagram) -> impl ExactSizeIterator<Item = Instant> {
        let mut pending = self.pending.lock();
        let is_sent = |queued: &QueuedPose| {
            datagram.poses.iter().any(|(user, sequence, _)| (*user, *sequence) == (queued.user, queued.pose.sequence))
        };
        pending.poses.retain(|queued| !is_sent(queued));
        pending.settled.take_if(|settled| Some(settled.sequence) == datagram.settled && !settled.is_last);
        drop(pending);
        datagram.poses.iter().map(|(.., arrival)| *arrival)
    }
}

impl Pending {
    fn push(&mut self, frame: &FromServer<'_>, max_bytes: usize) {
        if self.queue.len() + self.in_flight + frame.bytes() > max_bytes {
            let sentence = format!("expected a client that reads before {max_bytes} bytes are queued");
            self.finish(End::new(Reason::Slow, sentence));
        } else {
            frame.write(&mut self.queue);
        }
    }

    fn share(&mut self, sender: u16) -> &mut usize {
        let index = self.shares.iter().position(|(user, _)| *user == sender).unwrap_or_else(|| {
            self.shares.push((sender, 0));
            self.shares.len() - 1
        });
        &mut self.shares[index].1
    }

    fn finish(&mut self, end: End) {
        *self = Pending { end: Some(end), ..Pending::default() };
    }
}
