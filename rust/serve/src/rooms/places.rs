//! Numbers of connections and of created rooms per client.

use std::net::IpAddr;
use std::sync::Arc;

use super::limits::Limits;
use crate::clients::{Clients, Entered, client_key};

/// Connections and rooms by client address.
#[derive(Debug, Default)]
pub struct Places {
    sockets: Arc<Clients>,
    rooms: Arc<Clients>,
}

/// A client's connection; counted until the last clone is dropped.
#[derive(Clone, Debug)]
pub struct Place {
    client: IpAddr,
    _socket: Arc<Entered>,
}

impl Places {
    /// Counts a connection of a client; none if its limit, or the limit `all` for all clients, is reached.
    pub fn socket(&self, client: IpAddr, limits: Limits, all: usize) -> Option<Place> {
        let client = client_key(client);
        let socket = Clients::enter_among(&self.sockets, client, limits.sockets_per_client, all)?;
        Some(Place { client, _socket: Arc::new(socket) })
    }

    /// Counts a room that a client creates; none if too many rooms that it created still exist.
    pub fn room(&self, place: &Place, limits: Limits) -> Option<Entered> {
        Clients::enter(&self.rooms, place.client, limits.rooms_per_client)
    }
}
