//! Clients by their addresses, and how many connections each has.

use std::collections::HashMap;
use std::net::{IpAddr, Ipv6Addr};
use std::sync::{Arc, Mutex, PoisonError};

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
