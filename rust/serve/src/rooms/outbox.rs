//! All that waits for a user: the newest pose of each other user, and all else in order.

use std::sync::{Mutex, MutexGuard, PoisonError};
use std::task::Waker;
use std::time::{Duration, Instant};

use bytes::BytesMut;
use futures_util::task::AtomicWaker;

use super::frame::FromServer;
use super::pose::Pose;
use super::reason::{End, Reason};

/// Bytes of memory that an empty queue keeps.
const KEPT: usize = 1 << 12;
/// Part of a queue that one sender may fill.
const SHARE: usize = 4;

/// All that waits for one user, in bounded memory. Whoever writes to the user is woken and takes all of it.
pub struct Outbox {
    pending: Mutex<Pending>,
    writer: AtomicWaker,
    /// Most bytes of frames that wait or are on their way, without poses.
    most: usize,
    /// Time for which the sender answers for a full share; after it, the user who does not read does.
    burst: Duration,
}

#[derive(Default)]
struct Pending {
    /// Frames that must arrive, in order.
    queue: Vec<u8>,
    /// When the first of them was added that came of a sender.
    since: Option<Instant>,
    /// Bytes of each sender in the queue.
    shares: Vec<(u16, usize)>,
    /// Bytes of such frames that were taken and that the user's socket has not taken yet.
    on_way: usize,
    /// At most one pose of each user.
    poses: Vec<Waiting>,
    settled: Option<Settled>,
    end: Option<End>,
}

/// The number up to which poses are settled.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Settled {
    sequence: u32,
    /// No later one may follow.
    is_last: bool,
}

struct Waiting {
    user: u16,
    pose: Pose,
    read: Instant,
}

/// Which of what waits is taken.
#[derive(Clone, Copy, PartialEq)]
pub enum Part {
    /// All of it.
    All,
    /// All that must arrive, without poses and settled numbers that a later one will replace.
    Lasting,
}

/// Poses and a settled number as a datagram that may be sent.
#[derive(Default)]
pub struct Passing {
    /// Its frames; none if nothing waits.
    pub bytes: BytesMut,
    /// Users and numbers of the poses, and when they were read.
    poses: Vec<(u16, u32, Instant)>,
    settled: Option<u32>,
}

/// The outcome of a writer's look at what waits.
#[derive(Debug, PartialEq)]
pub enum Taken {
    /// There is nothing.
    Nothing,
    /// Frames, which are one message.
    Message,
    /// The connection ends.
    End(End),
}

impl Outbox {
    /// An empty one that takes so many bytes of frames besides poses. Who fills its share of them faster than in the
    /// time of a burst sends too much.
    pub fn new(most: usize, burst: Duration) -> Self {
        Outbox { pending: Mutex::default(), writer: AtomicWaker::new(), most, burst }
    }

    /// Add a frame that must arrive. Who lets too many bytes wait is ended.
    pub fn add(&self, frame: &FromServer<'_>) {
        let mut pending = self.pending();
        self.put(&mut pending, frame);
        drop(pending);
        self.writer.wake();
    }

    /// Add a frame that came of another user then. An error if the sender's share is full and what waits has not waited
    /// long: later it is the user who does not read.
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
            let sentence = format!("expected a user who reads before {} bytes wait for it", self.most);
            pending.finish(End::new(Reason::Slow, sentence));
        } else {
            frame.write(&mut pending.queue);
        }
    }

    /// Add a pose, which was read then, in the place of an older one of the same user. Whether there was one.
    pub fn add_pose(&self, user: u16, pose: Pose, read: Instant) -> bool {
        let mut pending = self.pending();
        if pending.end.is_some() {
            return false;
        }
        let new = Waiting { user, pose, read };
        let older = pending.poses.iter_mut().find(|waiting| waiting.user == user);
        let is_overwritten = older.is_some();
        match older {
            // A wish for acknowledgement is settled by a later pose alone if that pose is acknowledged, too.
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

    /// Add that poses are settled up to a number; `is_last` if no later one may follow.
    pub fn add_settled(&self, sequence: u32, is_last: bool) {
        let mut pending = self.pending();
        if pending.end.is_none() {
            pending.settled = pending.settled.max(Some(Settled { sequence, is_last }));
        }
        drop(pending);
        self.writer.wake();
    }

    /// Forget the pose of a user who has left.
    pub fn forget(&self, user: u16) {
        self.pending().poses.retain(|waiting| waiting.user != user);
    }

    /// End the connection, and forget all that waits. The first reason counts.
    pub fn end(&self, end: End) {
        let mut pending = self.pending();
        if pending.end.is_none() {
            pending.finish(end);
        }
        drop(pending);
        self.writer.wake();
    }

    /// The end, if it has come.
    pub fn ended(&self) -> Option<End> {
        self.pending().end.clone()
    }

    /// Wake this when something is added.
    pub fn register(&self, writer: &Waker) {
        self.writer.register(writer);
    }

    /// Take what waits, or a part of it, as one message: frames in order, then poses, whose times of reading come with them.
    /// All that was taken before has been written.
    pub fn take(&self, part: Part, message: &mut BytesMut, read: &mut Vec<Instant>) -> Taken {
        let mut pending = self.pending();
        if let Some(end) = &pending.end {
            return Taken::End(end.clone());
        }
        pending.on_way = pending.queue.len();
        message.extend_from_slice(&pending.queue);
        // A burst's memory is given back.
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

    /// As many poses and settled numbers, those that last apart, as so many bytes can hold. They wait until they are sent.
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

    /// A datagram was sent: what is in it waits no longer, but newer poses do. When its poses were read.
    pub fn sent(&self, passing: &Passing) -> impl ExactSizeIterator<Item = Instant> {
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
