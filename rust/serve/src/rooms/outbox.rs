//! Queue of frames for a user: the newest pose of each other user, and all other frames in order.

use std::sync::{Mutex, MutexGuard, PoisonError};
use std::task::Waker;
use std::time::{Duration, Instant};

use bytes::BytesMut;
use futures_util::task::AtomicWaker;

use super::frame::FromServer;
use super::pose::Pose;
use super::reason::{End, Reason};

/// Capacity in bytes that an empty queue keeps.
const KEPT: usize = 1 << 12;
/// Divisor of the queue's limit: share that one sender may fill.
const SHARE: usize = 4;

/// Queue of frames for one user, in bounded memory. Additions wake the user's writer, which takes all of it.
pub struct Outbox {
    pending: Mutex<Pending>,
    writer: AtomicWaker,
    /// Greatest number of bytes queued or in flight, without poses.
    most: usize,
    /// Time during which a full share is the sender's fault; later it is that of the user who does not read.
    burst: Duration,
}

#[derive(Default)]
struct Pending {
    /// Reliable frames, in order.
    queue: Vec<u8>,
    /// Time at which the first frame of a sender was queued.
    since: Option<Instant>,
    /// Queued bytes of each sender.
    shares: Vec<(u16, usize)>,
    /// Bytes taken from the queue that the socket has not accepted yet.
    on_way: usize,
    /// At most one pose per user.
    poses: Vec<Waiting>,
    settled: Option<Settled>,
    end: Option<End>,
}

/// Number up to which poses are settled.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Settled {
    sequence: u32,
    /// Whether no later number may follow.
    is_last: bool,
}

struct Waiting {
    user: u16,
    pose: Pose,
    read: Instant,
}

/// Selection of queued frames.
#[derive(Clone, Copy, PartialEq)]
pub enum Part {
    /// All frames.
    All,
    /// Reliable frames only, without poses and settled numbers that later ones will replace.
    Lasting,
}

/// Poses and a settled number that fit into a datagram.
#[derive(Default)]
pub struct Passing {
    /// Encoded frames; empty if nothing is queued.
    pub bytes: BytesMut,
    /// Users and numbers of the poses, with their arrival times.
    poses: Vec<(u16, u32, Instant)>,
    settled: Option<u32>,
}

/// Result of `Outbox::take`.
#[derive(Debug, PartialEq)]
pub enum Taken {
    /// The queue is empty.
    Nothing,
    /// Frames were taken as one message.
    Message,
    /// The connection ends.
    End(End),
}

impl Outbox {
    /// Creates an empty queue with a limit in bytes, not counting poses. A sender that fills its share within the time
    /// of a burst is disconnected.
    pub fn new(most: usize, burst: Duration) -> Self {
        Outbox { pending: Mutex::default(), writer: AtomicWaker::new(), most, burst }
    }

    /// Queues a reliable frame. Disconnects the user if the queue exceeds its limit.
    pub fn add(&self, frame: &FromServer<'_>) {
        let mut pending = self.pending();
        self.put(&mut pending, frame);
        drop(pending);
        self.writer.wake();
    }

    /// Queues a frame from another user at a time. An error if the sender's share is full and the queue is younger than
    /// a burst; later the user counts as one who does not read.
    pub fn add_from(&self, sender: u16, frame: &FromServer<'_>, now: Instant) -> Result<(), End> {
        let mut pending = self.pending();
        if pending.end.is_some() {
            return Ok(());
        }
        let since = *pending.since.get_or_insert(now);
        let share = pending.share(sender);
        *share += frame.bytes();
        if *share > self.most / SHARE && now.saturating_duration_since(since) < self.burst {
            let sentence = format!("expected at most {} bytes at once for one user", self.most / SHARE);
            return Err(End::new(Reason::Flood, sentence));
        }
        self.put(&mut pending, frame);
        drop(pending);
        self.writer.wake();
        Ok(())
    }

    fn put(&self, pending: &mut Pending, frame: &FromServer<'_>) {
        if pending.end.is_some() {
            return;
        }
        if pending.queue.len() + pending.on_way + frame.bytes() > self.most {
            let sentence = format!("expected a client that reads before {} bytes are queued", self.most);
            pending.finish(End::new(Reason::Slow, sentence));
        } else {
            frame.write(&mut pending.queue);
        }
    }

    /// Queues a pose with its arrival time, replacing an older one of the same user. Returns whether it replaced one.
    pub fn add_pose(&self, user: u16, pose: Pose, read: Instant) -> bool {
        let mut pending = self.pending();
        if pending.end.is_some() {
            return false;
        }
        let new = Waiting { user, pose, read };
        let older = pending.poses.iter_mut().find(|waiting| waiting.user == user);
        let is_overwritten = older.is_some();
        match older {
            // A replaced pose that needs acknowledgement is settled only if the new one is acknowledged, too.
            Some(older) => {
                let is_acknowledged = older.pose.is_acknowledged || new.pose.is_acknowledged;
                *older = Waiting { pose: Pose { is_acknowledged, ..new.pose }, ..new };
            }
            None => pending.poses.push(new),
        }
        drop(pending);
        self.writer.wake();
        is_overwritten
    }

    /// Queues the number up to which poses are settled; `is_last` if no later one may follow.
    pub fn add_settled(&self, sequence: u32, is_last: bool) {
        let mut pending = self.pending();
        if pending.end.is_none() {
            pending.settled = pending.settled.max(Some(Settled { sequence, is_last }));
        }
        drop(pending);
        self.writer.wake();
    }

    /// Removes the pose of a user who has left.
    pub fn forget(&self, user: u16) {
        self.pending().poses.retain(|waiting| waiting.user != user);
    }

    /// Ends the connection and discards the queue. The first reason is kept.
    pub fn end(&self, end: End) {
        let mut pending = self.pending();
        if pending.end.is_none() {
            pending.finish(end);
        }
        drop(pending);
        self.writer.wake();
    }

    /// End of the connection, if any.
    pub fn ended(&self) -> Option<End> {
        self.pending().end.clone()
    }

    /// Registers the task to wake when something is added.
    pub fn register(&self, writer: &Waker) {
        self.writer.register(writer);
    }

    /// Takes queued frames as one message: reliable frames in order, then poses; appends the poses' arrival times to
    /// `read`. All frames taken before have been written.
    pub fn take(&self, part: Part, message: &mut BytesMut, read: &mut Vec<Instant>) -> Taken {
        let mut pending = self.pending();
        if let Some(end) = &pending.end {
            return Taken::End(end.clone());
        }
        pending.on_way = pending.queue.len();
        message.extend_from_slice(&pending.queue);
        // The memory of a burst is released.
        if pending.queue.capacity() > KEPT {
            pending.queue = Vec::new();
        }
        pending.queue.clear();
        pending.shares.clear();
        pending.since = None;
        pending.poses.retain(|waiting| {
            let is_taken = part == Part::All || waiting.pose.stops;
            if is_taken {
                FromServer::Pose { user: waiting.user, pose: waiting.pose }.write(message);
                read.push(waiting.read);
            }
            !is_taken
        });
        if let Some(Settled { sequence, .. }) = pending.settled.take_if(|told| part == Part::All || told.is_last) {
            FromServer::Settled { sequence }.write(message);
        }
        if message.is_empty() { Taken::Nothing } else { Taken::Message }
    }

    /// Composes a datagram of at most `most` bytes from replaceable frames, which stay queued until `sent`.
    pub fn passing(&self, most: usize) -> Passing {
        let (pending, mut passing) = (self.pending(), Passing::default());
        let fits = |passing: &Passing, frame: &FromServer<'_>| passing.bytes.len() + frame.bytes() <= most;
        if let Some(Settled { sequence, is_last: false }) = pending.settled {
            let frame = FromServer::Settled { sequence };
            if fits(&passing, &frame) {
                frame.write(&mut passing.bytes);
                passing.settled = Some(sequence);
            }
        }
        for waiting in pending.poses.iter().filter(|waiting| !waiting.pose.stops) {
            let frame = FromServer::Pose { user: waiting.user, pose: waiting.pose };
            if !fits(&passing, &frame) {
                break;
            }
            frame.write(&mut passing.bytes);
            passing.poses.push((waiting.user, waiting.pose.sequence, waiting.read));
        }
        passing
    }

    /// Removes the frames of a sent datagram, but not newer ones; returns the arrival times of its poses.
    pub fn confirm_sent(&self, passing: &Passing) -> impl ExactSizeIterator<Item = Instant> {
        let mut pending = self.pending();
        let is_sent = |waiting: &Waiting| {
            passing.poses.iter().any(|(user, sequence, _)| (*user, *sequence) == (waiting.user, waiting.pose.sequence))
        };
        pending.poses.retain(|waiting| !is_sent(waiting));
        pending.settled.take_if(|told| Some(told.sequence) == passing.settled && !told.is_last);
        drop(pending);
        passing.poses.iter().map(|(.., read)| *read)
    }

    fn pending(&self) -> MutexGuard<'_, Pending> {
        self.pending.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Pending {
    fn share(&mut self, sender: u16) -> &mut usize {
        let at = self.shares.iter().position(|(user, _)| *user == sender).unwrap_or(self.shares.len());
        if at == self.shares.len() {
            self.shares.push((sender, 0));
        }
        &mut self.shares[at].1
    }

    fn finish(&mut self, end: End) {
        *self = Pending { end: Some(end), ..Pending::default() };
    }
}
