//! Limits on connections before their session starts.

use std::net::IpAddr;
use std::sync::Arc;

use tokio::sync::{OwnedSemaphorePermit, Semaphore};

use crate::clients::{Clients, Entered, client_key};

/// Greatest number of connections without a session, in total and per client.
pub const GREETINGS: usize = 64;
const PER_CLIENT: usize = 16;
/// Greatest number of these from clients with unvalidated addresses, in total and per address: forged packets
/// must not exhaust the limit of the address that they claim.
const UNPROVEN: usize = 16;
const UNPROVEN_PER_CLIENT: usize = 1;

/// Counts of connections without a session.
pub struct Greeters {
    open: Arc<Semaphore>,
    proven: Arc<Clients>,
    unproven: Arc<Clients>,
}

/// A counted connection without a session.
pub type Greeter = (Entered, OwnedSemaphorePermit);

/// Result of a request for admission.
pub enum Found {
    Place(Greeter),
    /// Admission is possible once the client has validated its address.
    Unproven,
    Full,
}

impl Greeters {
    /// Creates the counters.
    pub fn new() -> Self {
        let [proven, unproven] = Default::default();
        Greeters { open: Arc::new(Semaphore::new(GREETINGS)), proven, unproven }
    }

    /// Admits a client, whose address may be validated or not.
    pub fn find(&self, client: IpAddr, is_proven: bool) -> Found {
        let client = client_key(client);
        let entered = if is_proven {
            Clients::enter(&self.proven, client, PER_CLIENT)
        } else {
            Clients::enter_among(&self.unproven, client, UNPROVEN_PER_CLIENT, UNPROVEN)
        };
        match entered {
            None if !is_proven => Found::Unproven,
            entered => entered.zip(Arc::clone(&self.open).try_acquire_owned().ok()).map_or(Found::Full, Found::Place),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const VICTIM: [u8; 4] = [10, 0, 0, 1];

    fn place(found: Found) -> Option<Greeter> {
        if let Found::Place(greeter) = found { Some(greeter) } else { None }
    }

    #[test]
    fn forged_packets_use_no_slot_of_their_claimed_address() {
        let greeters = Greeters::new();
        let find = |is_proven| greeters.find(VICTIM.into(), is_proven);
        let forged = place(find(false)).expect("the first one needs no proof");
        assert!((0..100).all(|_| matches!(find(false), Found::Unproven)));
        let own: Vec<_> = (0..PER_CLIENT).filter_map(|_| place(find(true))).collect();
        assert_eq!(own.len(), PER_CLIENT);
        assert!(matches!(find(true), Found::Full));
        drop(forged);
        assert!(place(find(false)).is_some());
    }

    #[test]
    fn forged_packets_of_many_addresses_leave_places_to_others() {
        let greeters = Greeters::new();
        let forged: Vec<_> = (0..200).filter_map(|last| place(greeters.find([10, 0, 1, last].into(), false))).collect();
        assert_eq!(forged.len(), UNPROVEN);
        assert!(place(greeters.find(VICTIM.into(), true)).is_some());
    }
}
