//! Places of connections that have no session yet.

use std::net::IpAddr;
use std::sync::Arc;

use tokio::sync::{OwnedSemaphorePermit, Semaphore};

use crate::clients::{Clients, Entered, counted};

/// Connections that have no session yet, of all clients and of one.
pub const GREETINGS: usize = 64;
const PER_CLIENT: usize = 16;
/// So many of them may be of clients that have not shown that their address is theirs, and so many of one address:
/// whoever forges packets takes no more from the one whose address they bear.
const UNPROVEN: usize = 16;
const UNPROVEN_PER_CLIENT: usize = 1;

/// All such places, and who has them.
pub struct Greeters {
    open: Arc<Semaphore>,
    proven: Arc<Clients>,
    unproven: Arc<Clients>,
}

/// A connection's place until it has a session.
pub type Greeter = (Entered, OwnedSemaphorePermit);

/// The answer to a connection that asks for a place.
pub enum Found {
    Place(Greeter),
    /// There is one once the client has shown that its address is its own.
    Unproven,
    Full,
}

impl Greeters {
    /// All places are free.
    pub fn new() -> Self {
        let [proven, unproven] = Default::default();
        Greeters { open: Arc::new(Semaphore::new(GREETINGS)), proven, unproven }
    }

    /// Find a place for a client, which has shown or not that its address is its own.
    pub fn find(&self, client: IpAddr, is_proven: bool) -> Found {
        let client = counted(client);
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
    fn forged_packets_take_no_place_of_whose_address_they_bear() {
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
