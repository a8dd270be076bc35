//! Scheduling of waiting regions: early stages before late ones, then the client that has used the least time.

use std::collections::HashMap;
use std::hash::Hash;
use std::time::Duration;

/// A waiting work item.
pub struct Waiting<Work, Client> {
    /// Stage of the part that it makes next.
    pub stage: u8,
    /// Request number, ascending with time.
    pub number: u64,
    pub clients: Vec<Client>,
    pub work: Work,
}

/// Waiting work, and the time used by each client.
pub struct Queue<Work, Client> {
    waiting: Vec<Waiting<Work, Client>>,
    had: HashMap<Client, Duration>,
}

impl<Work, Client> Default for Queue<Work, Client> {
    fn default() -> Self {
        Queue { waiting: Vec::new(), had: HashMap::new() }
    }
}

impl<Work, Client: Copy + Eq + Hash> Queue<Work, Client> {
    pub fn push(&mut self, waiting: Waiting<Work, Client>) {
        for client in &waiting.clients {
            self.know(*client);
        }
        self.waiting.push(waiting);
    }

    /// Adds a client to the waiting work that `is_it` finds.
    pub fn join(&mut self, client: Client, is_it: impl Fn(&Work) -> bool) {
        self.know(client);
        if let Some(found) = self.waiting.iter_mut().find(|each| is_it(&each.work)) {
            found.clients.push(client);
        }
    }

    /// Removes a client from waiting work; returns the work if no client is left.
    pub fn leave(&mut self, client: Client, is_it: impl Fn(&Work) -> bool) -> Option<Work> {
        let place = self.waiting.iter().position(|each| is_it(&each.work))?;
        let clients = &mut self.waiting[place].clients;
        clients.swap_remove(clients.iter().position(|each| *each == client)?);
        if clients.is_empty() { Some(self.waiting.remove(place).work) } else { None }
    }

    /// Removes and returns the next work of at most a stage.
    pub fn take(&mut self, last_stage: u8) -> Option<Waiting<Work, Client>> {
        let place = self.order().into_iter().find(|place| self.waiting[*place].stage <= last_stage)?;
        Some(self.waiting.remove(place))
    }

    /// Charges used time in equal shares to the clients that waited for it.
    pub fn charge(&mut self, clients: &[Client], took: Duration) {
        for client in clients {
            *self.had.entry(*client).or_default() += took / u32::try_from(clients.len()).unwrap_or(u32::MAX);
        }
    }

    /// Number of waiting items before the one that `is_it` finds.
    pub fn position(&self, is_it: impl Fn(&Work) -> bool) -> Option<usize> {
        self.order().into_iter().position(|place| is_it(&self.waiting[place].work))
    }

    /// Discards the used time of clients that are gone.
    pub fn forget(&mut self, is_gone: impl Fn(&Client) -> bool) {
        self.had.retain(|client, _| !is_gone(client));
    }

    /// Starts a new client with the least time of all clients, so that absence gives no advantage.
    fn know(&mut self, client: Client) {
        let least = self.had.values().min().copied().unwrap_or_default();
        self.had.entry(client).or_insert(least);
    }

    /// Indices of waiting work in the order of service.
    fn order(&self) -> Vec<usize> {
        let had = |place: usize| self.waiting[place].clients.iter().filter_map(|client| self.had.get(client)).min();
        let mut places: Vec<usize> = (0..self.waiting.len()).collect();
        places.sort_by_key(|place| (self.waiting[*place].stage, had(*place), self.waiting[*place].number));
        places
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn queue(given: &[(u8, &'static str, &'static str)]) -> Queue<&'static str, &'static str> {
        let mut queue = Queue::default();
        for (number, (stage, client, work)) in given.iter().enumerate() {
            queue.push(Waiting { stage: *stage, number: number as u64, clients: vec![*client], work: *work });
        }
        queue
    }

    fn drain(mut queue: Queue<&'static str, &'static str>) -> Vec<&'static str> {
        std::iter::from_fn(|| queue.take(u8::MAX).map(|each| each.work)).collect()
    }

    #[test]
    fn early_stages_and_then_earlier_requests_come_first() {
        let queue = queue(&[(1, "ann", "a1"), (0, "bob", "b0"), (0, "ann", "a0")]);
        assert_eq!(drain(queue), ["b0", "a0", "a1"]);
    }

    #[test]
    fn a_client_that_floods_waits_for_itself() {
        let mut queue = queue(&[(0, "flood", "f1"), (0, "flood", "f2"), (0, "flood", "f3"), (0, "ann", "a1")]);
        let mut order = Vec::new();
        while let Some(each) = queue.take(u8::MAX) {
            queue.charge(&each.clients, Duration::from_secs(1));
            order.push(each.work);
        }
        assert_eq!(order, ["f1", "a1", "f2", "f3"]);
    }

    #[test]
    fn a_client_gains_nothing_by_coming_late() {
        let mut queue = queue(&[(0, "ann", "a1")]);
        queue.charge(&["ann"], Duration::from_secs(9));
        for (number, work) in ["n1", "n2"].into_iter().enumerate() {
            queue.push(Waiting { stage: 0, number: 10 + number as u64, clients: vec!["new"], work });
        }
        assert_eq!(queue.take(9).unwrap().work, "a1");
    }

    #[test]
    fn shared_work_is_charged_to_all_and_stays_until_the_last_leaves() {
        let mut queue = queue(&[(0, "ann", "both"), (0, "carl", "c")]);
        queue.join("bob", |work| *work == "both");
        assert_eq!(queue.leave("ann", |work| *work == "both"), None);
        assert_eq!(queue.leave("bob", |work| *work == "both"), Some("both"));
        assert_eq!(queue.leave("bob", |work| *work == "both"), None);
        queue.charge(&["ann", "bob"], Duration::from_secs(4));
        assert_eq!(queue.had["ann"], Duration::from_secs(2));
        assert_eq!(queue.waiting.len(), 1);
    }

    #[test]
    fn late_stages_can_be_left_out() {
        let mut queue = queue(&[(1, "ann", "late")]);
        assert!(queue.take(0).is_none());
        assert_eq!(queue.position(|work| *work == "late"), Some(0));
        assert_eq!(queue.take(1).unwrap().work, "late");
    }
}
