//! How many sockets clients have, and how many rooms they have begun.

use std::net::IpAddr;
use std::sync::Arc;

use super::limits::Limits;
use crate::clients::{Clients, Entered, counted};

/// Sockets and rooms by the addresses of clients.
#[derive(Debug, Default)]
pub struct Places {
    sockets: Arc<Clients>,
    rooms: Arc<Clients>,
}

/// A client's socket; it counts until the last copy is dropped.
#[derive(Clone, Debug)]
pub struct Place {
    client: IpAddr,
    _socket: Arc<Entered>,
}

impl Places {
    /// A socket of a client; none if it has as many as it may, or all have.
    pub fn socket(&self, client: IpAddr, limits: Limits, all: usize) -> Option<Place> {
        let client = counted(client);
        let socket = Clients::enter_among(&self.sockets, client, limits.sockets_per_client, all)?;
        Some(Place { client, _socket: Arc::new(socket) })
    }

    /// A room that a client begins; none if it has begun as many as it may of those that are there.
    pub fn room(&self, place: &Place, limits: Limits) -> Option<Entered> {
        Clients::enter(&self.rooms, place.client, limits.rooms_per_client)
    }
}
