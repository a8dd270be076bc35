//! One room: its users, and the frames that they send each other.

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;
use std::time::Instant;

use parking_lot::Mutex;

use super::frame::{FromServer, To};
use super::outbox::Outbox;
use super::pose::Pose;
use super::reason::{End, Reason};
use super::settle::Settlement;
use super::statistics::Statistics;
use super::token::{TICKET_BYTES, TokenNumber};
use crate::clients::Admission;

/// A room with users.
pub struct Room {
    state: Mutex<State>,
    statistics: Arc<Statistics>,
    _creator: Admission,
}

#[derive(Default)]
struct State {
    users: BTreeMap<u16, User>,
    /// Users of each group with their outboxes.
    groups: HashMap<u16, Vec<(u16, Arc<Outbox>)>>,
    last_number: u16,
}

struct User {
    group: u16,
    name: String,
    identity: u64,
    token: Option<TokenNumber>,
    outbox: Arc<Outbox>,
    settlement: Settlement,
    /// Whether its last pose was final (`stops`).
    has_stopped: bool,
}

/// Sender of a frame: its number and its connection's outbox, which differs if the user has reconnected.
#[derive(Clone)]
pub struct Sender {
    pub user: u16,
    pub outbox: Arc<Outbox>,
}

/// Request to join a room.
pub struct JoinRequest<'a> {
    /// Group, chosen by the user.
    pub group: u16,
    /// Name that others see.
    pub name: &'a str,
    /// Number of the user's token.
    pub token: Option<TokenNumber>,
    /// Number and identity of a reconnecting user.
    pub previous: Option<(u16, u64)>,
    /// Random value that distinguishes users with the same number; a reconnecting user keeps its own.
    pub identity: u64,
    /// Queue of frames for the user.
    pub outbox: Arc<Outbox>,
}

impl Sender {
    /// Whether this is the user's current connection.
    fn is_current(&self, user: &User) -> bool {
        Arc::ptr_eq(&user.outbox, &self.outbox)
    }
}

impl Room {
    /// Creates an empty room, which is counted for its creator; the first user gets the number after `last_number`.
    pub fn new(last_number: u16, statistics: Arc<Statistics>, creator: Admission) -> Self {
        Room { state: Mutex::new(State { last_number, ..State::default() }), statistics, _creator: creator }
    }

    pub fn is_empty(&self) -> bool {
        self.state.lock().users.is_empty()
    }

    /// Admits a user and notifies all. `make_ticket` makes the ticket for a number and an identity. Returns the user's
    /// number.
    pub fn join(
        &self,
        join_request: &JoinRequest<'_>,
        max_users: usize,
        make_ticket: impl FnOnce(u16, u64) -> [u8; TICKET_BYTES],
    ) -> Result<u16, End> {
        let mut state = self.state.lock();
        let has_token = |user: &User| join_request.token.is_some() && user.token == join_request.token;
        // A token may have been intercepted, but a ticket was sent only to its user. So a user with a ticket replaces
        // all other users of its token.
        let replaced: Vec<u16> = join_request.previous.map_or_else(Vec::new, |previous| {
            let is_old = |(number, user): &(&u16, &User)| (**number, user.identity) == previous || has_token(user);
            state.users.iter().filter(is_old).map(|(user, _)| *user).collect()
        });
        if replaced.is_empty() && state.users.values().any(has_token) {
            return Err(End::new(Reason::Token, "expected a token that no other connection uses"));
        }
        if state.users.len() - replaced.len() >= max_users {
            return Err(End::new(Reason::Full, format!("expected a room with fewer than {max_users} users")));
        }
        for user in replaced {
            let Some(outbox) = state.leave(user) else { continue };
            self.statistics.users.dec();
            outbox.end(End::new(Reason::Replaced, "the user reconnected over another connection"));
        }
        let previous = join_request.previous.filter(|(user, _)| !state.users.contains_key(user));
        let (user, identity) = previous.unwrap_or_else(|| (state.next_free_number(), join_request.identity));
        state.welcome(user, join_request, &make_ticket(user, identity));
        state.enter(user, identity, join_request);
        self.statistics.users.inc();
        Ok(user)
    }

    /// Removes a user, unless its number belongs to a newer connection of the same user.
    pub fn leave(&self, sender: &Sender) {
        let mut state = self.state.lock();
        if state.is_current(sender) {
            state.leave(sender.user);
            self.statistics.users.dec();
        }
    }

    /// Forwards a user's pose, with its arrival time, to the group.
    pub fn pose(&self, sender: &Sender, pose: Pose, arrival: Instant) {
        let mut state = self.state.lock();
        let State { users, groups, .. } = &mut *state;
        let Some(user) = users.get_mut(&sender.user).filter(|user| sender.is_current(user)) else { return };
        if !user.settlement.send(pose.sequence) {
            self.statistics.dropped.inc();
            return;
        }
        user.has_stopped = pose.stops;
        let group = groups.get(&user.group).into_iter().flatten();
        let others = group.filter(|(other, _)| *other != sender.user);
        let overwritten = others.filter(|(_, outbox)| outbox.add_pose(sender.user, pose, arrival)).count();
        self.statistics.dropped.inc_by(overwritten as u64);
    }

    /// Processes an acknowledgement of another user's pose; it is ignored if the sender is not in that user's group.
    pub fn acknowledge(&self, sender: &Sender, user: u16, sequence: u32) {
        let mut state = self.state.lock();
        if state.is_current(sender)
            && let Some(user) = state.users.get_mut(&user)
            && let Some(settled) = user.settlement.acknowledge(sender.user, sequence)
        {
            user.outbox.add_settled(settled, user.has_stopped);
        }
    }

    /// Sends a message to others, who all receive messages in the same order. An error if the sender exceeds its share
    /// of a queue.
    pub fn say(&self, sender: &Sender, to: To, payload: &[u8], now: Instant) -> Result<(), End> {
        let state = self.state.lock();
        let Some(user) = state.users.get(&sender.user).filter(|user| sender.is_current(user)) else { return Ok(()) };
        let frame = FromServer::Say { user: sender.user, to, payload };
        let send = |outbox: &Outbox| outbox.add_from(sender.user, &frame, now);
        match to {
            To::Room => state.others(sender.user).try_for_each(|other| send(&other.outbox)),
            To::Group => {
                let group = state.groups.get(&user.group).into_iter().flatten();
                group.filter(|(other, _)| *other != sender.user).try_for_each(|(_, outbox)| send(outbox))
            }
        }
    }

    /// Sends a signal to a user, if present. An error if the sender exceeds its share of the queue.
    pub fn signal(&self, sender: &Sender, to: u16, payload: &[u8], now: Instant) -> Result<(), End> {
        let state = self.state.lock();
        let Some(recipient) = state.users.get(&to).filter(|_| state.is_current(sender)) else { return Ok(()) };
        recipient.outbox.add_from(sender.user, &FromServer::Signal { user: sender.user, payload }, now)
    }

    /// Ends all connections.
    pub fn end(&self, end: &End) {
        self.state.lock().users.values().for_each(|user| user.outbox.end(end.clone()));
    }
}

impl State {
    /// Finds the next free number in cyclic order. Rooms have fewer users than there are numbers.
    fn next_free_number(&mut self) -> u16 {
        loop {
            self.last_number = self.last_number.wrapping_add(1);
            if !self.users.contains_key(&self.last_number) {
                return self.last_number;
            }
        }
    }

    /// Queues `welcome` and a `joined` frame of each present user for a new user.
    fn welcome(&self, user: u16, join_request: &JoinRequest<'_>, ticket: &[u8]) {
        join_request.outbox.add(&FromServer::Welcome { user, others: self.users.len() as u16, ticket });
        for (number, other) in &self.users {
            join_request.outbox.add(&FromServer::Joined { user: *number, group: other.group, name: &other.name });
        }
    }

    fn enter(&mut self, user: u16, identity: u64, join_request: &JoinRequest<'_>) {
        let &JoinRequest { group, name, token, .. } = join_request;
        self.notify_others(user, &FromServer::Joined { user, group, name });
        let peers = self.groups.entry(group).or_default();
        let settlement = Settlement::new(peers.iter().map(|(peer, _)| *peer));
        for (peer, _) in peers.iter() {
            if let Some(peer) = self.users.get_mut(peer) {
                peer.settlement.join(user);
            }
        }
        let (name, outbox) = (name.to_owned(), Arc::clone(&join_request.outbox));
        peers.push((user, Arc::clone(&outbox)));
        self.users.insert(user, User { group, name, identity, token, outbox, settlement, has_stopped: false });
    }

    /// Removes a user and notifies the others. Returns its outbox.
    fn leave(&mut self, user: u16) -> Option<Arc<Outbox>> {
        let removed = self.users.remove(&user)?;
        if let Some(peers) = self.groups.get_mut(&removed.group) {
            peers.retain(|(peer, _)| *peer != user);
            for (peer, outbox) in peers.iter() {
                let Some(peer) = self.users.get_mut(peer) else { continue };
                if let Some(sequence) = peer.settlement.leave(user) {
                    outbox.add_settled(sequence, peer.has_stopped);
                }
            }
            if peers.is_empty() {
                self.groups.remove(&removed.group);
            }
        }
        self.users.values().for_each(|other| other.outbox.forget(user));
        self.notify_others(user, &FromServer::Left { user });
        Some(removed.outbox)
    }

    fn notify_others(&self, user: u16, frame: &FromServer<'_>) {
        self.others(user).for_each(|other| other.outbox.add(frame));
    }

    fn others(&self, user: u16) -> impl Iterator<Item = &User> {
        self.users.iter().filter(move |(other, _)| **other != user).map(|(_, other)| other)
    }

    fn is_current(&self, sender: &Sender) -> bool {
        self.users.get(&sender.user).is_some_and(|user| sender.is_current(user))
    }
}
