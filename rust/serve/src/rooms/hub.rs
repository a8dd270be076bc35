//! All rooms of a server.

use std::collections::HashMap;
use std::net::IpAddr;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use prometheus_client::registry::Registry;
use rustls::crypto::ring;

use super::figures::Figures;
use super::limits::Limits;
use super::outbox::Outbox;
use super::places::{Place, Places};
use super::reason::{End, Reason};
use super::room::{By, Joining, Room};
use super::token::Key;

/// Rooms of a server; a room exists while it has users.
pub struct Rooms {
    /// Limits of rooms and users.
    pub limits: Limits,
    /// Whether pages may exchange files among themselves.
    pub(super) peers: bool,
    /// Whether users may connect by WebTransport.
    datagrams: bool,
    pub(super) figures: Arc<Figures>,
    /// Key that signs tokens; none if users need no token.
    pub(super) entry: Option<Key>,
    /// Key that signs tickets.
    back: Key,
    places: Places,
    state: Mutex<State>,
}

#[derive(Default)]
struct State {
    rooms: HashMap<String, Arc<Room>>,
    is_closed: bool,
}

/// A user's seat in a room; given up on drop.
pub struct Seat {
    rooms: Arc<Rooms>,
    name: String,
    /// The room.
    pub room: Arc<Room>,
    user: u16,
    outbox: Arc<Outbox>,
}

impl Rooms {
    /// Creates the rooms of a server. With a key, users need a token, and tickets stay valid after a restart.
    pub fn new(limits: Limits, key: Option<Key>) -> Result<Self, String> {
        let back = match &key {
            Some(key) => key.clone(),
            None => Key::new(&random::<32>()?)?,
        };
        Self::new_with_keys(limits, key, back)
    }

    /// Creates rooms without tokens; the key signs tickets, which stay valid after a restart.
    pub fn open(limits: Limits, key: Key) -> Result<Self, String> {
        Self::new_with_keys(limits, None, key)
    }

    fn new_with_keys(limits: Limits, entry: Option<Key>, back: Key) -> Result<Self, String> {
        limits.check()?;
        let (figures, places) = (Arc::new(Figures::new()), Places::default());
        Ok(Rooms { limits, peers: true, datagrams: true, figures, entry, back, places, state: Mutex::default() })
    }

    /// Lets pages load files from the server only.
    pub fn without_peers(self) -> Self {
        Rooms { peers: false, ..self }
    }

    /// Lets users connect by WebSocket only.
    pub fn without_datagrams(self) -> Self {
        Rooms { datagrams: false, ..self }
    }

    /// Whether users may connect by WebTransport.
    pub(crate) fn takes_datagrams(&self) -> bool {
        self.datagrams
    }

    /// Whether users need a token.
    pub(crate) fn needs_token(&self) -> bool {
        self.entry.is_some()
    }

    /// Counts a client's connection; none if its limit, or the limit `all` for all clients, is reached.
    pub(crate) fn place(&self, client: IpAddr, all: usize) -> Option<Place> {
        self.places.socket(client, self.limits, all)
    }

    /// Rejects new users and ends all connections.
    pub fn close(&self) {
        let mut state = self.state();
        state.is_closed = true;
        state.rooms.values().for_each(|room| room.end(&ending()));
    }

    /// Registers the metrics.
    pub(crate) fn register(&self, registry: &mut Registry) {
        self.figures.register(registry);
    }

    /// Admits a user to a room, which its first user creates. `ticket` is that of the previous connection, or empty.
    pub(super) fn join(
        rooms: &Arc<Self>,
        name: &str,
        place: &Place,
        ticket: &[u8],
        mut joining: Joining<'_>,
    ) -> Result<Seat, End> {
        let token = joining.token;
        joining.back = rooms.back.back_to(name, token.as_ref(), ticket);
        let outbox = Arc::clone(&joining.outbox);
        let mut state = rooms.state();
        if state.is_closed {
            return Err(ending());
        }
        let room = match state.rooms.get(name) {
            Some(room) => Arc::clone(room),
            None if state.rooms.len() >= rooms.limits.rooms => {
                let sentence = format!("expected a server with fewer than {} rooms", rooms.limits.rooms);
                return Err(End::new(Reason::Full, sentence));
            }
            None => {
                let most = rooms.limits.rooms_per_client;
                let sentence = || format!("expected a client that has begun fewer than {most} rooms");
                let begun = rooms.places.room(place, rooms.limits);
                let begun = begun.ok_or_else(|| End::new(Reason::Full, sentence()))?;
                Arc::new(Room::new(joining.identity as u16, Arc::clone(&rooms.figures), begun))
            }
        };
        let ticket = |user, identity| rooms.back.ticket(name, token.as_ref(), user, identity);
        let user = room.join(&joining, rooms.limits.users, ticket)?;
        state.rooms.insert(name.to_owned(), Arc::clone(&room));
        rooms.figures.rooms.set(state.rooms.len() as i64);
        drop(state);
        Ok(Seat { rooms: Arc::clone(rooms), name: name.to_owned(), room, user, outbox })
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Seat {
    /// Identity of the sender.
    pub fn sender(&self) -> By<'_> {
        By { user: self.user, outbox: &self.outbox }
    }
}

impl Drop for Seat {
    fn drop(&mut self) {
        let mut state = self.rooms.state();
        self.room.leave(self.sender());
        if self.room.is_empty() {
            state.rooms.remove(&self.name);
            self.rooms.figures.rooms.set(state.rooms.len() as i64);
        }
    }
}

/// End of every connection at shutdown.
pub fn ending() -> End {
    End::new(Reason::Ending, "the server ends")
}

/// Cryptographically secure random bytes.
pub fn random<const COUNT: usize>() -> Result<[u8; COUNT], String> {
    let mut bytes = [0; COUNT];
    let filled = ring::default_provider().secure_random.fill(&mut bytes);
    filled.map(|()| bytes).map_err(|error| format!("the system gives no random bytes: {error:?}"))
}
