//! One room: its users, and what they send each other.

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

/// A room that somebody is in.
pub struct Room {
    state: Mutex<State>,
    figures: Arc<Figures>,
}

#[derive(Default)]
struct State {
    users: BTreeMap<u16, User>,
    /// Users of each group with what waits for them.
    groups: HashMap<u16, Vec<(u16, Arc<Outbox>)>>,
    /// The last number that was given.
    last: u16,
}

struct User {
    group: u16,
    name: String,
    identity: u64,
    token: Option<Number>,
    outbox: Arc<Outbox>,
    settling: Settling,
}

/// Who wants to join.
pub struct Joining<'a> {
    /// The group, which is of the user's choice.
    pub group: u16,
    /// The name that others are told.
    pub name: &'a str,
    /// The number of the user's token.
    pub token: Option<Number>,
    /// Number and identity of a user who comes back.
    pub back: Option<(u16, u64)>,
    /// Tells users of the same number apart, unless the user comes back.
    pub identity: u64,
    /// What waits for the user.
    pub outbox: Arc<Outbox>,
}

impl Room {
    /// An empty room; the first user's number follows this one.
    pub fn new(last: u16, figures: Arc<Figures>) -> Self {
        Room { state: Mutex::new(State { last, ..State::default() }), figures }
    }

    /// Whether nobody is there.
    pub fn is_empty(&self) -> bool {
        self.state().users.is_empty()
    }

    /// Let a user in, and tell all. `welcome` gives the ticket of a number and an identity. The user's number.
    pub fn join<Ticket: AsRef<[u8]>>(
        &self,
        joining: &Joining<'_>,
        most: usize,
        welcome: impl FnOnce(u16, u64) -> Ticket,
    ) -> Result<u16, End> {
        let mut state = self.state();
        let back = joining
            .back
            .filter(|(user, identity)| state.users.get(user).is_none_or(|present| present.identity == *identity));
        let replaced = back.map(|(user, _)| user).filter(|user| state.users.contains_key(user));
        let others = || state.users.iter().filter(|(user, _)| Some(**user) != replaced);
        if joining.token.is_some() && others().any(|(_, other)| other.token == joining.token) {
            return Err(End::new(Reason::Token, "expected a token that no other connection uses"));
        }
        if others().count() >= most {
            return Err(End::new(Reason::Full, format!("expected a room with fewer than {most} users")));
        }
        if let Some(outbox) = replaced.and_then(|user| state.leave(user)) {
            self.figures.users.dec();
            outbox.end(End::new(Reason::Replaced, "the user came back by another connection"));
        }
        let (user, identity) = back.unwrap_or_else(|| (state.unused(), joining.identity));
        state.welcome(user, joining, welcome(user, identity).as_ref());
        state.enter(user, identity, joining);
        self.figures.users.inc();
        Ok(user)
    }

    /// A user's connection has ended. The number may be that of a user who came back by another one.
    pub fn leave(&self, user: u16, outbox: &Arc<Outbox>) {
        let mut state = self.state();
        if state.users.get(&user).is_some_and(|found| Arc::ptr_eq(&found.outbox, outbox)) {
            state.leave(user);
            self.figures.users.dec();
        }
    }

    /// Forward a user's pose, which was read then, to the group.
    pub fn pose(&self, from: u16, pose: Pose, read: Instant) {
        let mut state = self.state();
        let State { users, groups, .. } = &mut *state;
        let Some(user) = users.get_mut(&from) else { return };
        if !user.settling.send(pose.sequence) {
            self.figures.dropped.inc();
            return;
        }
        let group = groups.get(&user.group).into_iter().flatten();
        let others = group.filter(|(other, _)| *other != from);
        let overwritten = others.filter(|(_, outbox)| outbox.add_pose(from, pose, read)).count();
        if overwritten > 0 {
            self.figures.dropped.inc_by(overwritten as u64);
        }
    }

    /// A user has acknowledged a pose of another one. Users who are not of its group are ignored.
    pub fn acknowledge(&self, from: u16, user: u16, sequence: u32) {
        let mut state = self.state();
        let Some(user) = state.users.get_mut(&user) else { return };
        if let Some(settled) = user.settling.acknowledge(from, sequence) {
            user.outbox.add_settled(settled);
        }
    }

    /// Tell others what a user says; all get it in the same order.
    pub fn say(&self, from: u16, to: To, payload: &[u8]) {
        let state = self.state();
        let frame = FromServer::Say { user: from, to, payload };
        match (to, state.users.get(&from)) {
            (To::Room, Some(_)) => state.tell(from, &frame),
            (To::Group, Some(user)) => {
                let group = state.groups.get(&user.group).into_iter().flatten();
                group.filter(|(other, _)| *other != from).for_each(|(_, outbox)| outbox.add(&frame));
            }
            (_, None) => {}
        }
    }

    /// Pass a signal to a user; to one who is not there, nothing.
    pub fn signal(&self, from: u16, to: u16, payload: &[u8]) {
        let state = self.state();
        if let (true, Some(user)) = (state.users.contains_key(&from), state.users.get(&to)) {
            user.outbox.add(&FromServer::Signal { user: from, payload });
        }
    }

    /// End all connections.
    pub fn end(&self, end: &End) {
        self.state().users.values().for_each(|user| user.outbox.end(end.clone()));
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl State {
    /// A number that nobody has, and that was not given for longest. Rooms have fewer users than there are numbers.
    fn unused(&mut self) -> u16 {
        loop {
            self.last = self.last.wrapping_add(1);
            if !self.users.contains_key(&self.last) {
                return self.last;
            }
        }
    }

    /// Tell a user who is about to enter of itself and of who is there.
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
        self.users.insert(user, User { group, name: name.to_owned(), identity, token, outbox, settling });
    }

    /// Let a user out, and tell others. What waits for it.
    fn leave(&mut self, user: u16) -> Option<Arc<Outbox>> {
        let gone = self.users.remove(&user)?;
        if let Some(peers) = self.groups.get_mut(&gone.group) {
            peers.retain(|(peer, _)| *peer != user);
            for (peer, outbox) in peers.iter() {
                let settled = self.users.get_mut(peer).and_then(|peer| peer.settling.leave(user));
                if let Some(sequence) = settled {
                    outbox.add_settled(sequence);
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
        self.users.iter().filter(|(user, _)| **user != but).for_each(|(_, user)| user.outbox.add(frame));
    }
}
