//! Clients by their addresses, and places for their connections.

use std::collections::HashMap;
use std::net::{IpAddr, Ipv6Addr};
use std::sync::{Arc, Mutex, PoisonError};

use tokio::sync::{AcquireError, OwnedSemaphorePermit, Semaphore};

/// Connections by the addresses of clients, or all else that clients have so many of.
#[derive(Debug, Default)]
pub struct Clients(Mutex<HashMap<IpAddr, usize>>);

/// A connection of a client.
#[derive(Debug)]
pub struct Entered {
    clients: Arc<Clients>,
    client: IpAddr,
}

/// Bits of an IPv6 address that tell clients apart: who has one address of a network has all others of it.
const NETWORK: u32 = 64;

/// The address by which a client is counted.
pub fn counted(address: IpAddr) -> IpAddr {
    match address.to_canonical() {
        IpAddr::V6(own) if !own.is_loopback() => Ipv6Addr::from_bits(own.to_bits() >> NETWORK << NETWORK).into(),
        other => other,
    }
}

impl Clients {
    /// Count a connection of a client; none if it has as many as it may.
    pub fn enter(clients: &Arc<Self>, client: IpAddr, most: usize) -> Option<Entered> {
        Self::enter_among(clients, client, most, usize::MAX)
    }

    /// The same; none also if all clients have as many as they may.
    pub fn enter_among(clients: &Arc<Self>, client: IpAddr, most: usize, all: usize) -> Option<Entered> {
        let mut counts = clients.0.lock().unwrap_or_else(PoisonError::into_inner);
        if counts.values().sum::<usize>() >= all {
            return None;
        }
        let count = counts.entry(client).or_default();
        if *count >= most && !client.is_loopback() {
            return None;
        }
        *count += 1;
        Some(Entered { clients: Arc::clone(clients), client })
    }
}

impl Drop for Entered {
    fn drop(&mut self) {
        let mut counts = self.clients.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(count) = counts.get_mut(&self.client) {
            *count -= 1;
            if *count == 0 {
                counts.remove(&self.client);
            }
        }
    }
}

/// Places among the connections, of all clients and of each.
#[derive(Clone)]
pub struct Gate {
    open: Arc<Semaphore>,
    all: usize,
    clients: Arc<Clients>,
    per_client: usize,
}

/// A connection's place among the connections.
pub type Entry = (Entered, OwnedSemaphorePermit);

impl Gate {
    /// Places for all clients and for each, all of them free.
    pub fn new(all: usize, per_client: usize) -> Self {
        Gate { open: Arc::new(Semaphore::new(all)), all, clients: Arc::default(), per_client }
    }

    /// Wait for a place.
    pub async fn wait(&self) -> Result<OwnedSemaphorePermit, AcquireError> {
        Arc::clone(&self.open).acquire_owned().await
    }

    /// Wait until nobody has a place.
    pub async fn empty(&self) {
        let _all = self.open.acquire_many(u32::try_from(self.all).unwrap_or(u32::MAX)).await;
    }

    /// A place for a client's connection, if there is one now.
    pub fn enter(&self, client: IpAddr) -> Option<Entry> {
        let place = Arc::clone(&self.open).try_acquire_owned().ok()?;
        self.enter_at(client, place)
    }

    /// The same for a place that was waited for.
    pub fn enter_at(&self, client: IpAddr, place: OwnedSemaphorePermit) -> Option<Entry> {
        Some((Clients::enter(&self.clients, counted(client), self.per_client)?, place))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_of_one_network_are_one_client() {
        let of = |text: &str| counted(text.parse().expect("an address"));
        assert_eq!(of("2001:db8::1:2:3:4"), of("2001:db8::9"));
        assert_ne!(of("2001:db8::1"), of("2001:db8:0:1::1"));
        assert_ne!(of("10.0.0.1"), of("10.0.0.2"));
        assert_eq!(of("::ffff:10.0.0.1"), of("10.0.0.1"));
        assert!(of("::1").is_loopback());
    }

    #[test]
    fn a_client_has_so_many_connections_and_no_more() {
        let clients = Arc::new(Clients::default());
        let enter = |client: [u8; 4]| Clients::enter(&clients, client.into(), 2);
        let (first, _second, other) = (enter([10, 0, 0, 1]), enter([10, 0, 0, 1]), enter([10, 0, 0, 2]));
        assert!(first.is_some() && other.is_some() && enter([10, 0, 0, 1]).is_none());
        drop(first);
        assert!(enter([10, 0, 0, 1]).is_some());
        let own: Vec<_> = (0..5).map(|_| enter([127, 0, 0, 1])).collect();
        assert!(own.iter().all(Option::is_some));
        assert!(Clients::enter_among(&clients, [127, 0, 0, 1].into(), 2, 7).is_none(), "seven are there");
        assert!(Clients::enter_among(&clients, [127, 0, 0, 1].into(), 2, 8).is_some());
    }
}
