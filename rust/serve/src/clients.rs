//! Counts of connections per client address, and limits on them.

use std::collections::HashMap;
use std::net::{IpAddr, Ipv6Addr};
use std::sync::{Arc, Mutex, PoisonError};

use tokio::sync::{AcquireError, OwnedSemaphorePermit, Semaphore};

/// Number of connections, or of other resources, by client address.
#[derive(Debug, Default)]
pub struct Clients(Mutex<HashMap<IpAddr, usize>>);

/// A counted connection of a client; uncounted on drop.
#[derive(Debug)]
pub struct Entered {
    clients: Arc<Clients>,
    client: IpAddr,
}

/// Prefix length that identifies an IPv6 client: whoever has one address of a network has all of its addresses.
const NETWORK: u32 = 64;

/// Address under which a client is counted.
pub fn client_key(address: IpAddr) -> IpAddr {
    match address.to_canonical() {
        IpAddr::V6(own) if !own.is_loopback() => Ipv6Addr::from_bits(own.to_bits() >> NETWORK << NETWORK).into(),
        other => other,
    }
}

impl Clients {
    /// Counts a connection of a client; none if the client has reached its limit.
    pub fn enter(clients: &Arc<Self>, client: IpAddr, most: usize) -> Option<Entered> {
        Self::enter_among(clients, client, most, usize::MAX)
    }

    /// Like `enter`, with a limit for all clients together.
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

/// Limits on the number of connections, in total and per client.
#[derive(Clone)]
pub struct Gate {
    open: Arc<Semaphore>,
    all: usize,
    clients: Arc<Clients>,
    per_client: usize,
}

/// A connection's share of both limits.
pub type Entry = (Entered, OwnedSemaphorePermit);

impl Gate {
    /// Creates a gate for `all` connections, `per_client` of them for each client.
    pub fn new(all: usize, per_client: usize) -> Self {
        Gate { open: Arc::new(Semaphore::new(all)), all, clients: Arc::default(), per_client }
    }

    /// Waits for a free connection slot.
    pub async fn wait(&self) -> Result<OwnedSemaphorePermit, AcquireError> {
        Arc::clone(&self.open).acquire_owned().await
    }

    /// Waits until all connections have ended.
    pub async fn empty(&self) {
        let _all = self.open.acquire_many(u32::try_from(self.all).unwrap_or(u32::MAX)).await;
    }

    /// Takes a slot for a client's connection, if one is free.
    pub fn enter(&self, client: IpAddr) -> Option<Entry> {
        let place = Arc::clone(&self.open).try_acquire_owned().ok()?;
        self.enter_at(client, place)
    }

    /// Like `enter`, with a slot from `wait`.
    pub fn enter_at(&self, client: IpAddr, place: OwnedSemaphorePermit) -> Option<Entry> {
        Some((Clients::enter(&self.clients, client_key(client), self.per_client)?, place))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_of_one_network_are_one_client() {
        let of = |text: &str| client_key(text.parse().expect("an address"));
        assert_eq!(of("2001:db8::1:2:3:4"), of("2001:db8::9"));
        assert_ne!(of("2001:db8::1"), of("2001:db8:0:1::1"));
        assert_ne!(of("10.0.0.1"), of("10.0.0.2"));
        assert_eq!(of("::ffff:10.0.0.1"), of("10.0.0.1"));
        assert!(of("::1").is_loopback());
    }

    #[test]
    fn connections_of_a_client_are_limited() {
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
