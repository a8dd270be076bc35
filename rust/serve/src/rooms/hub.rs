//! All rooms of a server.

use std::collections::HashMap;
use std::net::IpAddr;
use std::sync::Arc;

use parking_lot::Mutex;
use rustls::crypto::ring;

use super::limits::Limits;
use super::reason::{End, Reason};
use super::room::{JoinRequest, Room, Sender};
use super::statistics::Statistics;
use super::token::Key;
use crate::clients::{Admission, Clients, client_key};

/// Rooms of a server; a room exists while it has users.
pub struct Rooms {
    /// Limits of rooms and users.
    pub limits: Limits,
    /// Whether pages may exchange files among themselves.
    pub peers: bool,
    /// Whether users may connect by WebTransport.
    pub datagrams: bool,
    pub(crate) statistics: Arc<Statistics>,
    /// Key that signs tokens; none if users need no token.
    pub(crate) token_key: Option<Key>,
    ticket_key: Key,
    connections: Arc<Clients>,
    /// Number of existing rooms by the client that created them.
    creators: Arc<Clients>,
    state: Mutex<State>,
}

#[derive(Default)]
struct State {
    rooms: HashMap<String, Arc<Room>>,
    is_closed: bool,
}

/// A client's connection to a room, which is counted until the last clone is dropped.
#[derive(Clone, Debug)]
pub struct CountedClient {
    address: IpAddr,
    _connection: Arc<Admission>,
}

/// A user's seat in a room; dropping it removes the user.
pub struct Seat {
    rooms: Arc<Rooms>,
    name: String,
    pub room: Arc<Room>,
    pub sender: Sender,
}

impl Rooms {
    /// Creates the rooms of a server. A token admits a user; a ticket gives a reconnecting user the same number. With a
    /// key, users need a token, and tickets stay valid after a restart.
    pub fn new(limits: Limits, key: Option<Key>) -> Result<Self, String> {
        let ticket_key = key.clone().map_or_else(|| random::<32>().and_then(|secret| Key::new(&secret)), Ok)?;
        Ok(Rooms { token_key: key, ..Self::without_tokens(limits, ticket_key)? })
    }

    /// Creates rooms that need no tokens; the key signs tickets, which stay valid after a restart.
    pub fn without_tokens(limits: Limits, ticket_key: Key) -> Result<Self, String> {
        limits.check()?;
        Ok(Rooms {
            limits,
            peers: true,
            datagrams: true,
            statistics: Arc::new(Statistics::new()),
            token_key: None,
            ticket_key,
            connections: Arc::default(),
            creators: Arc::default(),
            state: Mutex::default(),
        })
    }

    /// Counts a client's connection; none if the client's limit, or `total` for all clients together, is reached.
    pub(crate) fn count_client(&self, client: IpAddr, total: usize) -> Option<CountedClient> {
        let address = client_key(client);
        let connection = Clients::admit(&self.connections, address, self.limits.sockets_per_client, total)?;
        Some(CountedClient { address, _connection: Arc::new(connection) })
    }

    /// Rejects new users and ends all connections.
    pub fn close(&self) {
        let mut state = self.state.lock();
        state.is_closed = true;
        state.rooms.values().for_each(|room| room.end(&shutdown_end()));
    }

    /// Admits a user to a room, and creates the room for its first user. `ticket` was given to the user's previous
    /// connection, or empty.
    pub(super) fn join(
        rooms: &Arc<Self>,
        name: &str,
        client: &CountedClient,
        ticket: &[u8],
        mut join_request: JoinRequest<'_>,
    ) -> Result<Seat, End> {
        let token = join_request.token;
        join_request.previous = rooms.ticket_key.check_ticket(name, token.as_ref(), ticket);
        let mut state = rooms.state.lock();
        if state.is_closed {
            return Err(shutdown_end());
        }
        let room = match state.rooms.get(name) {
            Some(room) => Arc::clone(room),
            None if state.rooms.len() >= rooms.limits.rooms => {
                let sentence = format!("expected a server with fewer than {} rooms", rooms.limits.rooms);
                return Err(End::new(Reason::Full, sentence));
            }
            None => {
                let limit = rooms.limits.rooms_per_client;
                let creator = Clients::admit(&rooms.creators, client.address, limit, usize::MAX);
                let sentence = || format!("expected a client that has created fewer than {limit} rooms");
                let creator = creator.ok_or_else(|| End::new(Reason::Full, sentence()))?;
                Arc::new(Room::new(join_request.identity as u16, Arc::clone(&rooms.statistics), creator))
            }
        };
        let ticket = |user, identity| rooms.ticket_key.ticket(name, token.as_ref(), user, identity);
        let user = room.join(&join_request, rooms.limits.users, ticket)?;
        state.rooms.insert(name.to_owned(), Arc::clone(&room));
        rooms.statistics.rooms.set(state.rooms.len() as i64);
        drop(state);
        let sender = Sender { user, outbox: join_request.outbox };
        Ok(Seat { rooms: Arc::clone(rooms), name: name.to_owned(), room, sender })
    }
}

impl Drop for Seat {
    fn drop(&mut self) {
        let mut state = self.rooms.state.lock();
        self.room.leave(&self.sender);
        if self.room.is_empty() {
            state.rooms.remove(&self.name);
            self.rooms.statistics.rooms.set(state.rooms.len() as i64);
        }
    }
}

/// End of every connection at shutdown.
pub fn shutdown_end() -> End {
    End::new(Reason::Ending, "the server is shutting down")
}

/// Cryptographically secure random bytes.
pub fn random<const COUNT: usize>() -> Result<[u8; COUNT], String> {
    let mut bytes = [0; COUNT];
    let filled = ring::default_provider().secure_random.fill(&mut bytes);
    filled.map(|()| bytes).map_err(|_| "the system gives no random bytes".into())
}
