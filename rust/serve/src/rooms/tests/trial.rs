//! Simulates users of a server's rooms, controlled by a script of bytes, in one thread without a network. Panics if a
//! user receives a frame that it must not get, or if the final pose of a movement is lost. For tests and fuzzing.

use std::collections::HashMap;
use std::net::IpAddr;
use std::sync::Arc;
use std::time::{Duration, Instant};

use bytes::{Buf, BytesMut};

use super::frame::{FromServer, FromUser, HEADER_BYTES, MAX_SAY_BYTES, MAX_SIGNAL_BYTES, To};
use super::outbox::{Outbox, Outgoing, Selection};
use super::pose::{self, Placement, Pose};
use super::reason::End;
use super::{Entrance, Limits, Rooms, Session};

/// Number of users, more than a room admits, and maximum number of users in a room.
const USERS: usize = 8;
const ROOM_USERS: usize = 5;
/// Maximum number of connections per client; users belong to two clients.
const CLIENT_SOCKETS: usize = 4;
/// Maximum size of a datagram in bytes: two poses.
const DATAGRAM_BYTES: usize = 2 * (HEADER_BYTES + 2 + pose::MAX_BYTES);
/// Kinds of the frames that users send in datagrams: poses and acknowledgements.
const DATAGRAM_KINDS: [u8; 2] = [2, 3];
/// Unit of time in scripts; an action lets up to 255 pass.
const STEP: Duration = Duration::from_millis(2);
/// Time after which no rate limit remembers earlier messages.
const RECOVERY: Duration = Duration::from_secs(3600);

/// Runs a script.
pub fn run(mut script: &[u8]) {
    let default = Limits::default();
    let limits =
        Limits { users: ROOM_USERS, rooms: 1, sockets_per_client: CLIENT_SOCKETS, queue_bytes: 1 << 15, ..default };
    let Ok(rooms) = Rooms::new(limits, None) else { return };
    let mut trial = Trial { rooms: Arc::new(rooms), users: Default::default(), now: Instant::now() };
    while let Ok(step) = script.try_get_u8() {
        trial.step(usize::from(step) % USERS, usize::from(step) / USERS, &mut script);
    }
    trial.settle();
    trial.users = Default::default();
    let client = trial.rooms.count_client([10, 0, 0, 1].into(), 1);
    assert!(client.is_some(), "a connection was not given back");
}

struct Trial {
    rooms: Arc<Rooms>,
    users: [User; USERS],
    now: Instant,
}

#[derive(Default)]
struct User {
    session: Option<Session>,
    known: Knowledge,
    /// Ticket of the last connection.
    ticket: Vec<u8>,
    /// Sequence number of the last pose sent, and the greatest sequence number so far.
    sequence: u32,
    max_sequence: Option<u32>,
    /// Greatest sequence number, if its pose is final, and the users who must receive it, each with its connection
    /// count.
    final_pose: Option<(u32, Vec<(usize, usize)>)>,
    /// Whether the network loses its datagrams.
    loses_datagrams: bool,
    /// Whether it has sent raw bytes of the script, which may be any frames.
    has_sent_raw: bool,
    /// Number of connections so far.
    connection_count: usize,
}

/// A user's knowledge of its room.
#[derive(Default)]
struct Knowledge {
    number: Option<u16>,
    group: u16,
    /// Groups of other users, and sequence numbers of their last poses.
    others: HashMap<u16, (u16, Option<u32>)>,
    settled: Option<u32>,
}

impl Trial {
    /// Lets a user take an action; further bytes of the script are its arguments.
    fn step(&mut self, who: usize, action: usize, script: &mut &[u8]) {
        let mut byte = || script.try_get_u8().unwrap_or_default();
        match action {
            0 | 1 => self.connect(who),
            2 | 3 => self.hello(who, u16::from(byte() % 2), usize::from(byte())),
            4..=10 => self.pose(who, byte().cast_signed(), byte()),
            11..=14 => self.acknowledge(who, usize::from(byte()) % USERS, byte()),
            15 => {
                let (to, payload) = ([To::Group, To::Room][who % 2], &vec![0; 16 * usize::from(byte())][..]);
                self.send(who, &[FromUser::Say { to, payload: truncate(payload, MAX_SAY_BYTES) }]);
            }
            16 => {
                let user = self.number(usize::from(byte()) % USERS);
                let payload = &vec![0; 64 * usize::from(byte())][..];
                self.send(who, &[FromUser::Signal { user, payload: truncate(payload, MAX_SIGNAL_BYTES) }]);
            }
            17 => self.send(who, &[FromUser::Bye]),
            18 => {
                let length = usize::from(byte());
                let (raw, rest) = script.split_at(length.min(script.len()));
                *script = rest;
                self.users[who].has_sent_raw = true;
                self.deliver(who, raw, raw.first().is_some_and(|kind| DATAGRAM_KINDS.contains(kind)));
            }
            19 | 20 => self.now += STEP * u32::from(byte()),
            // Simulates a broken connection.
            21 => self.users[who].session = None,
            22 if byte() == 0 => self.rooms.close(),
            23 | 24 => self.users[who].loses_datagrams = !self.users[who].loses_datagrams,
            _ => self.receive(who),
        }
    }

    fn connect(&mut self, who: usize) {
        self.users[who].session = None;
        let client: IpAddr = [10, 0, 0, 1 + (who % 2) as u8].into();
        let Some(client) = self.rooms.count_client(client, USERS) else { return };
        let entrance = Entrance { room: "hall".to_owned(), token: None, client };
        let session = Session::new(Arc::clone(&self.rooms), entrance, self.now);
        let user = &mut self.users[who];
        (user.session, user.known, user.max_sequence, user.final_pose) =
            (Some(session), Knowledge::default(), None, None);
        (user.has_sent_raw, user.connection_count) = (false, user.connection_count + 1);
    }

    fn hello(&mut self, who: usize, group: u16, choice: usize) {
        let ticket = if choice.is_multiple_of(2) { Vec::new() } else { self.users[choice / 2 % USERS].ticket.clone() };
        if self.users[who].known.number.is_none() {
            self.users[who].known.group = group;
        }
        self.send(who, &[FromUser::Hello { group, name: &"name"[..choice % 5], ticket: &ticket }]);
    }

    fn pose(&mut self, who: usize, step: i8, flags: u8) {
        let user = &mut self.users[who];
        user.sequence = user.sequence.wrapping_add_signed(i32::from(step));
        let is_newest = Some(user.sequence) > user.max_sequence;
        user.max_sequence = user.max_sequence.max(Some(user.sequence));
        let head = Placement { position: [0.0; 3], rotation: [0, 0, 0, 32767] };
        let (is_acknowledged, stops, hands, pointer) = (flags & 1 == 0, flags & 2 != 0, [None; 2], None);
        // Clocks of users need not agree or be monotonic.
        let (sequence, clock) = (user.sequence, u64::from(flags).wrapping_mul(0x0101_0101_0101_0101));
        let pose = Pose { sequence, clock, is_acknowledged, stops, head, hands, pointer };
        self.send(who, &[FromUser::Pose(pose)]);
        if is_newest {
            let to = self.others(who).map(|other| (other, self.users[other].connection_count)).collect();
            self.users[who].final_pose = (stops && self.is_in(who)).then_some((pose.sequence, to));
        }
    }

    /// Whether a user is in the room and has sent no raw bytes.
    fn is_in(&self, who: usize) -> bool {
        let is_open = |open: &Session| open.has_joined() && open.outbox.end_reason().is_none();
        !self.users[who].has_sent_raw && self.users[who].session.as_ref().is_some_and(is_open)
    }

    /// Other users of a user's group who are in the room.
    fn others(&self, who: usize) -> impl Iterator<Item = usize> {
        let group = |who: usize| self.users[who].known.group;
        (0..USERS).filter(move |&other| other != who && self.is_in(other) && group(other) == group(who))
    }

    /// Lets all users receive and acknowledge all queued frames, without loss. Checks that the final pose of each user
    /// has reached all who were present, and is settled unless others have joined since.
    fn settle(&mut self) {
        self.now += RECOVERY;
        self.users.iter_mut().for_each(|user| user.loses_datagrams = false);
        for who in 0..USERS {
            self.receive(who);
            let known: Vec<_> = self.users[who].known.others.iter().map(|(user, (_, last))| (*user, *last)).collect();
            for (user, last) in known {
                last.into_iter().for_each(|sequence| self.send(who, &[FromUser::Ack { user, sequence }]));
            }
        }
        (0..USERS).for_each(|who| self.receive(who));
        let has_raw_senders = self.users.iter().any(|user| user.has_sent_raw && user.session.is_some());
        for who in (0..USERS).filter(|who| self.is_in(*who)) {
            let User { final_pose: Some((sequence, to)), known, .. } = &self.users[who] else { continue };
            let others: Vec<_> = self.others(who).map(|other| (other, self.users[other].connection_count)).collect();
            for (other, _) in others.iter().filter(|other| to.contains(other)) {
                let last = self.users[*other].known.others.get(&self.number(who)).and_then(|(_, last)| *last);
                assert_eq!(last, Some(*sequence), "the last pose of a movement is lost");
            }
            if !has_raw_senders && !others.is_empty() && others.iter().all(|other| to.contains(other)) {
                assert_eq!(known.settled, Some(*sequence), "the last pose of a movement is not settled");
            }
        }
    }

    fn acknowledge(&mut self, who: usize, other: usize, choice: u8) {
        let user = self.number(other);
        let known = self.users[who].known.others.get(&user).and_then(|(_, sequence)| *sequence);
        let sequence = if choice < 200 { known.unwrap_or_default() } else { u32::from(choice) };
        self.send(who, &[FromUser::Ack { user, sequence }]);
    }

    fn number(&self, who: usize) -> u16 {
        self.users[who].known.number.unwrap_or(who as u16)
    }

    fn send(&mut self, who: usize, frames: &[FromUser<'_>]) {
        let mut message = Vec::new();
        frames.iter().for_each(|frame| frame.write(&mut message));
        let is_datagram = |frame: &FromUser<'_>| match frame {
            FromUser::Pose(pose) => !pose.stops,
            other => matches!(other, FromUser::Ack { .. }),
        };
        self.deliver(who, &message, frames.iter().all(is_datagram));
    }

    /// Delivers a user's bytes to the server: as a datagram if `is_datagram` and the user has datagrams.
    fn deliver(&mut self, who: usize, message: &[u8], is_datagram: bool) {
        let user = &mut self.users[who];
        let is_datagram = is_datagram && has_datagrams(who);
        let Some(session) = &mut user.session else { return };
        if is_datagram && user.loses_datagrams {
            return;
        }
        let result = session.count_bytes(message.len(), self.now).and_then(|()| match is_datagram {
            true => session.handle_datagram(message, self.now),
            false => session.handle_message(message, self.now),
        });
        if let Err(End { sentence, .. }) = result {
            assert!(!sentence.is_empty(), "an end without a reason");
            user.session = None;
        }
    }

    /// Receives all queued frames of a user.
    fn receive(&mut self, who: usize) {
        let (mut message, mut read) = (BytesMut::new(), Vec::new());
        let User { session, known, ticket, max_sequence, loses_datagrams, .. } = &mut self.users[who];
        let Some(open) = session else { return };
        let part = if has_datagrams(who) { Selection::Reliable } else { Selection::All };
        if let Outgoing::End(_) = open.outbox.take(part, &mut message, &mut read) {
            *session = None;
            return;
        }
        if has_datagrams(who) {
            take_datagrams(&open.outbox, *loses_datagrams, &mut message);
        }
        let bound =
            open.rooms.limits.queue_bytes + ROOM_USERS * (HEADER_BYTES + 2 + pose::MAX_BYTES) + HEADER_BYTES + 4;
        assert!(message.len() <= bound, "{} bytes waited", message.len());
        let mut rest = &message[..];
        while !rest.is_empty() {
            let (frame, remaining) = FromServer::read(rest).expect("a frame of the server");
            known.check(frame, *max_sequence, ticket);
            rest = remaining;
        }
    }
}

impl Knowledge {
    /// Checks a frame; `max_sequence` is the greatest number of the user's own poses.
    fn check(&mut self, frame: FromServer<'_>, max_sequence: Option<u32>, ticket: &mut Vec<u8>) {
        assert_eq!(self.number.is_none(), matches!(frame, FromServer::Welcome { .. }), "one welcome, first");
        let group = |user: &u16| self.others.get(user).map(|(group, _)| *group);
        match frame {
            FromServer::Welcome { user, others, ticket: own } => {
                assert!(usize::from(others) < ROOM_USERS, "more users than a room takes");
                (self.number, *ticket) = (Some(user), own.to_vec());
            }
            FromServer::Joined { user, group, .. } => {
                assert_ne!(self.number, Some(user), "a user joined itself");
                assert!(self.others.insert(user, (group, None)).is_none(), "a user joined twice");
                assert!(self.others.len() < ROOM_USERS, "more users than a room takes");
            }
            FromServer::Left { user } => assert!(self.others.remove(&user).is_some(), "an absent user left"),
            FromServer::Pose { user, pose } => {
                let (group, last) = self.others.get_mut(&user).expect("a pose of a present user");
                assert_eq!(*group, self.group, "a pose of another group");
                assert!(last.replace(pose.sequence) < Some(pose.sequence), "an old pose");
            }
            FromServer::Say { user, to: To::Group, .. } => assert_eq!(group(&user), Some(self.group)),
            FromServer::Say { user, .. } | FromServer::Signal { user, .. } => {
                assert!(self.number == Some(user) || group(&user).is_some(), "a message of an absent user");
            }
            FromServer::Settled { sequence } => {
                assert!(Some(sequence) <= max_sequence, "a pose that was not sent is settled");
                assert!(self.settled.replace(sequence) < Some(sequence), "settled again");
            }
            FromServer::Refused { .. } => panic!("a refusal is queued like other frames"),
        }
    }
}

/// Whether a user has datagrams, as every second one does.
fn has_datagrams(who: usize) -> bool {
    who % 2 == 1
}

/// Takes all queued datagrams; appends them to the reliable frames unless they are lost.
fn take_datagrams(outbox: &Outbox, loses_datagrams: bool, message: &mut BytesMut) {
    loop {
        let datagram = outbox.datagram(DATAGRAM_BYTES);
        assert!(datagram.bytes.len() <= DATAGRAM_BYTES, "too large a datagram");
        if datagram.bytes.is_empty() {
            return;
        }
        if !loses_datagrams {
            message.extend_from_slice(&datagram.bytes);
        }
        let _ = outbox.confirm_sent(&datagram).len();
    }
}

fn truncate(bytes: &[u8], max_bytes: usize) -> &[u8] {
    &bytes[..bytes.len().min(max_bytes)]
}
