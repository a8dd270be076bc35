//! How many connections each client has.

use std::collections::HashMap;
use std::net::IpAddr;
use std::sync::{Arc, Mutex, PoisonError};

/// Connections by the addresses of clients.
#[derive(Default)]
pub struct Clients(Mutex<HashMap<IpAddr, usize>>);

/// A connection of a client.
pub struct Entered {
    clients: Arc<Clients>,
    client: IpAddr,
}

impl Clients {
    /// Count a connection of a client; none if it has as many as it may.
    pub fn enter(clients: &Arc<Self>, client: IpAddr, most: usize) -> Option<Entered> {
        let mut counts = clients.0.lock().unwrap_or_else(PoisonError::into_inner);
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
    fn a_client_has_so_many_connections_and_no_more() {
        let clients = Arc::new(Clients::default());
        let enter = |client: [u8; 4]| Clients::enter(&clients, client.into(), 2);
        let (first, _second, other) = (enter([10, 0, 0, 1]), enter([10, 0, 0, 1]), enter([10, 0, 0, 2]));
        assert!(first.is_some() && other.is_some() && enter([10, 0, 0, 1]).is_none());
        drop(first);
        assert!(enter([10, 0, 0, 1]).is_some());
        let own: Vec<_> = (0..5).map(|_| enter([127, 0, 0, 1])).collect();
        assert!(own.iter().all(Option::is_some));
    }
}
