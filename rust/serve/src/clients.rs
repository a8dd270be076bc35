//! Limits on connections, in total and per client address.

use std::collections::HashMap;
use std::net::{IpAddr, Ipv6Addr};
use std::sync::Arc;
use std::time::Duration;

use parking_lot::Mutex;
use tokio::sync::{AcquireError, OwnedSemaphorePermit, Semaphore};

/// Prefix length in bits by which IPv6 clients are told apart: a client usually has all addresses of a /64 network.
const NETWORK_BITS: u32 = 64;
/// Maximum number of pending connections, whose session has not started, in total and per client.
pub const MAX_PENDING: usize = 64;
const MAX_PENDING_PER_CLIENT: usize = 16;
/// Maximum number of pending connections with an unvalidated address, in total and per address. They are counted
/// apart, because forged packets must not exhaust the limit of the address that they claim.
const MAX_UNVALIDATED: usize = 16;
const MAX_UNVALIDATED_PER_CLIENT: usize = 1;

/// Number of connections, or of other resources, by client address.
#[derive(Debug, Default)]
pub struct Clients(Mutex<HashMap<IpAddr, usize>>);

/// A counted connection of a client; dropping it decrements the count.
#[derive(Debug)]
pub struct Admission {
    clients: Arc<Clients>,
    client: IpAddr,
}

/// Address under which a client is counted.
pub fn client_key(address: IpAddr) -> IpAddr {
    match address.to_canonical() {
        IpAddr::V6(v6) if !v6.is_loopback() => Ipv6Addr::from_bits(v6.to_bits() >> NETWORK_BITS << NETWORK_BITS).into(),
        address => address,
    }
}

impl Clients {
    /// Counts a connection of a client; none if the client, or all clients together, have reached their limit. Local
    /// clients have no limit of their own.
    pub fn admit(clients: &Arc<Self>, client: IpAddr, per_client: usize, total: usize) -> Option<Admission> {
        let mut counts = clients.0.lock();
        if counts.values().sum::<usize>() >= total {
            return None;
        }
        let count = counts.entry(client).or_default();
        if *count >= per_client && !client.is_loopback() {
            return None;
        }
        *count += 1;
        Some(Admission { clients: Arc::clone(clients), client })
    }
}

impl Drop for Admission {
    fn drop(&mut self) {
        let mut counts = self.clients.0.lock();
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
    free_slots: Arc<Semaphore>,
    total: usize,
    clients: Arc<Clients>,
    per_client: usize,
}

/// A connection that counts towards both limits.
pub type Entry = (Admission, OwnedSemaphorePermit);

impl Gate {
    /// Creates a gate for `total` connections, `per_client` of them for each client.
    pub fn new(total: usize, per_client: usize) -> Self {
        Gate { free_slots: Arc::new(Semaphore::new(total)), total, clients: Arc::default(), per_client }
    }

    /// Waits for a free connection slot.
    pub async fn wait(&self) -> Result<OwnedSemaphorePermit, AcquireError> {
        Arc::clone(&self.free_slots).acquire_owned().await
    }

    /// Waits until all connections have ended.
    pub async fn wait_until_empty(&self) {
        let _all = self.free_slots.acquire_many(u32::try_from(self.total).unwrap_or(u32::MAX)).await;
    }

    /// Takes a slot for a client's connection, if one is free.
    pub fn enter(&self, client: IpAddr) -> Option<Entry> {
        self.enter_with(client, self.take_slot()?)
    }

    /// Like `enter`, with a slot from `wait`.
    pub fn enter_with(&self, client: IpAddr, slot: OwnedSemaphorePermit) -> Option<Entry> {
        Some((Clients::admit(&self.clients, client_key(client), self.per_client, usize::MAX)?, slot))
    }

    fn take_slot(&self) -> Option<OwnedSemaphorePermit> {
        Arc::clone(&self.free_slots).try_acquire_owned().ok()
    }
}

/// Limits on QUIC connections before their session starts.
pub struct PendingGate {
    gate: Gate,
    unvalidated: Arc<Clients>,
}

/// Result of a request for admission.
pub enum PendingEntry {
    Admitted(Entry),
    /// Admission is possible once the client has validated its address.
    Unvalidated,
    Full,
}

impl PendingGate {
    pub fn new() -> Self {
        PendingGate { gate: Gate::new(MAX_PENDING, MAX_PENDING_PER_CLIENT), unvalidated: Arc::default() }
    }

    /// Admits a connection if the limit for validated, or for unvalidated, addresses allows it.
    pub fn enter(&self, client: IpAddr, is_validated: bool) -> PendingEntry {
        if is_validated {
            return self.gate.enter(client).map_or(PendingEntry::Full, PendingEntry::Admitted);
        }
        let client = client_key(client);
        match Clients::admit(&self.unvalidated, client, MAX_UNVALIDATED_PER_CLIENT, MAX_UNVALIDATED) {
            Some(admission) => match self.gate.take_slot() {
                Some(slot) => PendingEntry::Admitted((admission, slot)),
                None => PendingEntry::Full,
            },
            None => PendingEntry::Unvalidated,
        }
    }
}

/// Bytes of a user's messages that are read at once.
pub const READ_BYTES: usize = 1 << 12;
/// Consecutive messages, or pieces of a stream, before other connections get their turn.
pub const MAX_CONSECUTIVE: usize = 16;

/// Limits on the duration and number of connections.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Maximum number of connections; further ones wait until one ends.
    pub connections: usize,
    /// Maximum number of connections per client; further ones are closed at once. Local programs, such as a proxy, are
    /// exempt.
    pub per_client: usize,
    /// Timeout for a handshake, for the headers of a request, and between two requests.
    pub headers: Duration,
    /// Timeout for a client that reads nothing of a response.
    pub silence: Duration,
    /// Maximum size of a request's headers, bytes.
    pub header_bytes: usize,
    /// Time for open responses to finish at shutdown.
    pub grace: Duration,
}

impl Default for Limits {
    fn default() -> Self {
        let seconds = Duration::from_secs;
        Limits {
            connections: 1024,
            per_client: 256,
            headers: seconds(30),
            silence: seconds(60),
            header_bytes: 1 << 15,
            grace: seconds(3),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const VICTIM: IpAddr = IpAddr::V4(std::net::Ipv4Addr::new(10, 0, 0, 1));

    #[test]
    fn addresses_of_one_network_are_one_client() {
        let key = |text: &str| client_key(text.parse().expect("an address"));
        assert_eq!(key("2001:db8::1:2:3:4"), key("2001:db8::9"));
        assert_ne!(key("2001:db8::1"), key("2001:db8:0:1::1"));
        assert_ne!(key("10.0.0.1"), key("10.0.0.2"));
        assert_eq!(key("::ffff:10.0.0.1"), key("10.0.0.1"));
        assert!(key("::1").is_loopback());
    }

    #[test]
    fn connections_of_a_client_are_limited() {
        let clients = Arc::new(Clients::default());
        let admit = |client: [u8; 4], total| Clients::admit(&clients, client.into(), 2, total);
        let [first, _second, _other] = [1, 1, 2].map(|last| admit([10, 0, 0, last], 9).expect("a free slot"));
        assert!(admit([10, 0, 0, 1], 9).is_none());
        drop(first);
        assert!(admit([10, 0, 0, 1], 9).is_some());
        let local: Vec<_> = (0..5).filter_map(|_| admit([127, 0, 0, 1], 9)).collect();
        assert_eq!(local.len(), 5);
        assert!(admit([127, 0, 0, 1], 7).is_none(), "seven are counted");
        assert!(admit([127, 0, 0, 1], 8).is_some());
    }

    fn admitted(entry: PendingEntry) -> Option<Entry> {
        if let PendingEntry::Admitted(entry) = entry { Some(entry) } else { None }
    }

    #[test]
    fn forged_packets_use_no_slot_of_their_claimed_address() {
        let gate = PendingGate::new();
        let forged = admitted(gate.enter(VICTIM, false)).expect("the first one needs no proof");
        assert!((0..100).all(|_| matches!(gate.enter(VICTIM, false), PendingEntry::Unvalidated)));
        let own: Vec<_> = (0..MAX_PENDING_PER_CLIENT).filter_map(|_| admitted(gate.enter(VICTIM, true))).collect();
        assert_eq!(own.len(), MAX_PENDING_PER_CLIENT);
        assert!(matches!(gate.enter(VICTIM, true), PendingEntry::Full));
        drop(forged);
        assert!(admitted(gate.enter(VICTIM, false)).is_some());
    }

    #[test]
    fn forged_packets_of_many_addresses_leave_places_to_others() {
        let gate = PendingGate::new();
        let enter = |last| admitted(gate.enter([10, 0, 1, last].into(), false));
        let forged: Vec<_> = (0..200).filter_map(enter).collect();
        assert_eq!(forged.len(), MAX_UNVALIDATED);
        assert!(admitted(gate.enter(VICTIM, true)).is_some());
    }
}
