//! One room: its users, and the frames that they send each other.

use std::collections::{BTreeMap, HashMap};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Instant;

use super::figures::Figures;
use super::frame::{FromServer, To};
use super::outbox::Outbox;
use super::pose::Pose;
use super::reason::{End, Reason};
use super::settle::Settling;
use super::token::Number;
use crate::clients::Entered;

/// A room with users.
pub struct Room {
    state: Mutex<State>,
    figures: Arc<Figures>,
    _begun: Entered,
}

#[derive(Default)]
struct State {
    users: BTreeMap<u16, User>,
    /// Users of each group with their outboxes.
    groups: HashMap<u16, Vec<(u16, Arc<Outbox>)>>,
    /// Last assigned number.
    last: u16,
}

struct User {
    group: u16,
    name: String,
    identity: u64,
    token: Option<Number>,
    outbox: Arc<Outbox>,
    settling: Settling,
    /// Whether its last pose was final (`stops`).
    rests: bool,
}

/// Sender of a frame: its number and its connection's outbox, which differs if the user has reconnected.
#[derive(Clone, Copy)]
pub struct By<'a> {
    /// Number of the user.
    pub user: u16,
    /// Outbox of the connection.
    pub outbox: &'a Arc<Outbox>,
}

/// Request to join a room.
pub struct Joining<'a> {
    /// Group, chosen by the user.
    pub group: u16,
    /// Name that others see.
    pub name: &'a str,
    /// Number of the user's token.
    pub token: Option<Number>,
    /// Number and identity of a reconnecting user.
    pub back: Option<(u16, u64)>,
    /// Random value that distinguishes users with the same number; a reconnecting user keeps its own.
    pub identity: u64,
    /// Queue of frames for the user.
    pub outbox: Arc<Outbox>,
}

impl By<'_> {
    fn is(&self, user: &User) -> bool {
        Arc::ptr_eq(&user.outbox, self.outbox)
    }
}

impl Room {
    /// Creates an empty room for a client; the first user gets the number after `last`.
    pub fn new(last: u16, figures: Arc<Figures>, begun: Entered) -> Self {
        Room { state: Mutex::new(State { last, ..State::default() }), figures, _begun: begun }
    }

    /// Whether the room has no users.
    pub fn is_empty(&self) -> bool {
        self.state().users.is_empty()
    }

    /// Admits a user and notifies all. `welcome` makes the ticket for a number and an identity. Returns the user's
    /// number.
    pub fn join<Ticket: AsRef<[u8]>>(
        &self,
        joining: &Joining<'_>,
        most: usize,
        welcome: impl FnOnce(u16, u64) -> Ticket,
    ) -> Result<u16, End> {
        let mut state = self.state();
        let has_token = |user: &User| joining.token.is_some() && user.token == joining.token;
        // A ticket proves that the token was not intercepted, so its owner replaces all other users of the token.
        let replaced: Vec<u16> = joining.back.map_or_else(Vec::new, |back| {
            let is_old = |(user, present): &(&u16, &User)| (**user, present.identity) == back || has_token(present);
            state.users.iter().filter(is_old).map(|(user, _)| *user).collect()
        });
        if replaced.is_empty() && state.users.values().any(has_token) {
            return Err(End::new(Reason::Token, "expected a token that no other connection uses"));
        }
        if state.users.len() - replaced.len() >= most {
            return Err(End::new(Reason::Full, format!("expected a room with fewer than {most} users")));
        }
        for user in replaced {
            let Some(outbox) = state.leave(user) else { continue };
            self.figures.users.dec();
            outbox.end(End::new(Reason::Replaced, "the user reconnected over another connection"));
        }
        let back = joining.back.filter(|(user, _)| !state.users.contains_key(user));
        let (user, identity) = back.unwrap_or_else(|| (state.unused(), joining.identity));
        state.welcome(user, joining, welcome(user, identity).as_ref());
        state.enter(user, identity, joining);
        self.figures.users.inc();
        Ok(user)
    }

    /// Removes a user, unless its number belongs to a newer connection of the same user.
    pub fn leave(&self, by: By<'_>) {
        let mut state = self.state();
        if state.has(by) {
            state.leave(by.user);
            self.figures.users.dec();
        }
    }

    /// Forwards a user's pose, with its arrival time, to the group.
    pub fn pose(&self, by: By<'_>, pose: Pose, read: Instant) {
        let mut state = self.state();
        let State { users, groups, .. } = &mut *state;
        let (from, Some(user)) = (by.user, users.get_mut(&by.user).filter(|user| by.is(user))) else { return };
        if !user.settling.send(pose.sequence) {
            self.figures.dropped.inc();
            return;
        }
        user.rests = pose.stops;
        let group = groups.get(&user.group).into_iter().flatten();
        let others = group.filter(|(other, _)| *other != from);
        let overwritten = others.filter(|(_, outbox)| outbox.add_pose(from, pose, read)).count();
        if overwritten > 0 {
            self.figures.dropped.inc_by(overwritten as u64);
        }
    }

    /// Processes an acknowledgement of another user's pose. Users outside that user's group are ignored.
    pub fn acknowledge(&self, by: By<'_>, user: u16, sequence: u32) {
        let mut state = self.state();
        if !state.has(by) {
            return;
        }
        let Some(user) = state.users.get_mut(&user) else { return };
        if let Some(settled) = user.settling.acknowledge(by.user, sequence) {
            user.outbox.add_settled(settled, user.rests);
        }
    }

    /// Sends a message to others, in the same order for all. An error if the sender exceeds its share.
    pub fn say(&self, by: By<'_>, to: To, payload: &[u8], now: Instant) -> Result<(), End> {
        let state = self.state();
        let Some(user) = state.users.get(&by.user).filter(|user| by.is(user)) else { return Ok(()) };
        let frame = FromServer::Say { user: by.user, to, payload };
        let tell = |outbox: &Outbox| outbox.add_from(by.user, &frame, now);
        match to {
            To::Room => state.others(by.user).try_for_each(|other| tell(&other.outbox)),
            To::Group => {
                let mut group = state.groups.get(&user.group).into_iter().flatten();
                group.try_for_each(|(other, outbox)| if *other == by.user { Ok(()) } else { tell(outbox) })
            }
        }
    }

    /// Sends a signal to a user, if present. An error if the sender exceeds its share.
    pub fn signal(&self, by: By<'_>, to: u16, payload: &[u8], now: Instant) -> Result<(), End> {
        let state = self.state();
        let to = state.users.get(&to).filter(|_| state.has(by));
        to.map_or(Ok(()), |to| to.outbox.add_from(by.user, &FromServer::Signal { user: by.user, payload }, now))
    }

    /// Ends all connections.
    pub fn end(&self, end: &End) {
        self.state().users.values().for_each(|user| user.outbox.end(end.clone()));
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl State {
    /// Finds the next free number in cyclic order. Rooms have fewer users than there are numbers.
    fn unused(&mut self) -> u16 {
        loop {
            self.last = self.last.wrapping_add(1);
            if !self.users.contains_key(&self.last) {
                return self.last;
            }
        }
    }

    /// Queues `welcome` and a `joined` frame of each present user for a new user.
    fn welcome(&self, user: u16, joining: &Joining<'_>, ticket: &[u8]) {
        joining.outbox.add(&FromServer::Welcome { user, others: self.users.len() as u16, ticket });
        for (other, found) in &self.users {
            joining.outbox.add(&FromServer::Joined { user: *other, group: found.group, name: &found.name });
        }
    }

    fn enter(&mut self, user: u16, identity: u64, joining: &Joining<'_>) {
        let &Joining { group, name, token, .. } = joining;
        self.tell(user, &FromServer::Joined { user, group, name });
        let peers = self.groups.entry(group).or_default();
        let settling = Settling::new(peers.iter().map(|(peer, _)| *peer));
        for (peer, _) in peers.iter() {
            if let Some(peer) = self.users.get_mut(peer) {
                peer.settling.join(user);
            }
        }
        peers.push((user, Arc::clone(&joining.outbox)));
        let outbox = Arc::clone(&joining.outbox);
        let name = name.to_owned();
        self.users.insert(user, User { group, name, identity, token, outbox, settling, rests: false });
    }

    /// Removes a user and notifies the others. Returns its outbox.
    fn leave(&mut self, user: u16) -> Option<Arc<Outbox>> {
        let gone = self.users.remove(&user)?;
        if let Some(peers) = self.groups.get_mut(&gone.group) {
            peers.retain(|(peer, _)| *peer != user);
            for (peer, outbox) in peers.iter() {
                let Some(peer) = self.users.get_mut(peer) else { continue };
                if let Some(sequence) = peer.settling.leave(user) {
                    outbox.add_settled(sequence, peer.rests);
                }
            }
            if peers.is_empty() {
                self.groups.remove(&gone.group);
            }
        }
        self.users.values().for_each(|other| other.outbox.forget(user));
        self.tell(user, &FromServer::Left { user });
        Some(gone.outbox)
    }

    fn tell(&self, but: u16, frame: &FromServer<'_>) {
        self.others(but).for_each(|user| user.outbox.add(frame));
    }

    fn others(&self, but: u16) -> impl Iterator<Item = &User> {
        self.users.iter().filter(move |(user, _)| **user != but).map(|(_, user)| user)
    }

    fn has(&self, by: By<'_>) -> bool {
        self.users.get(&by.user).is_some_and(|user| by.is(user))
    }
}
