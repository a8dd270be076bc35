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
    used_time: HashMap<Client, Duration>,
}

impl<Work, Client> Default for Queue<Work, Client> {
    fn default() -> Self {
        Queue { waiting: Vec::new(), used_time: HashMap::new() }
    }
}

impl<Work, Client: Copy + Eq + Hash> Queue<Work, Client> {
    pub fn push(&mut self, waiting: Waiting<Work, Client>) {
        for client in &waiting.clients {
            self.register(*client);
        }
        self.waiting.push(waiting);
    }

    /// Adds a client to the waiting work that `is_match` finds.
    pub fn join(&mut self, client: Client, is_match: impl Fn(&Work) -> bool) {
        self.register(client);
        if let Some(waiting) = self.waiting.iter_mut().find(|waiting| is_match(&waiting.work)) {
            waiting.clients.push(client);
        }
    }

    /// Removes a client from waiting work; returns the work if no client is left.
    pub fn leave(&mut self, client: Client, is_match: impl Fn(&Work) -> bool) -> Option<Work> {
        let index = self.waiting.iter().position(|waiting| is_match(&waiting.work))?;
        let clients = &mut self.waiting[index].clients;
        clients.swap_remove(clients.iter().position(|each| *each == client)?);
        if clients.is_empty() { Some(self.waiting.remove(index).work) } else { None }
    }

    /// Removes and returns the next work of at most a stage.
    pub fn take(&mut self, last_stage: u8) -> Option<Waiting<Work, Client>> {
        let index = self.order().into_iter().find(|index| self.waiting[*index].stage <= last_stage)?;
        Some(self.waiting.remove(index))
    }

    /// Charges used time in equal shares to the clients that waited for it.
    pub fn charge(&mut self, clients: &[Client], duration: Duration) {
        for client in clients {
            *self.used_time.entry(*client).or_default() += duration / u32::try_from(clients.len()).unwrap_or(u32::MAX);
        }
    }

    /// Number of waiting items before the one that `is_match` finds.
    pub fn position(&self, is_match: impl Fn(&Work) -> bool) -> Option<usize> {
        self.order().into_iter().position(|index| is_match(&self.waiting[index].work))
    }

    /// Discards the used time of clients that are gone.
    pub fn forget(&mut self, is_gone: impl Fn(&Client) -> bool) {
        self.used_time.retain(|client, _| !is_gone(client));
    }

    /// Starts a new client with the least time of all clients, so that absence gives no advantage.
    fn register(&mut self, client: Client) {
        let least = self.used_time.values().min().copied().unwrap_or_default();
        self.used_time.entry(client).or_insert(least);
    }

    /// Indices of waiting work in the order of service.
    fn order(&self) -> Vec<usize> {
        let used_time =
            |index: usize| self.waiting[index].clients.iter().filter_map(|client| self.used_time.get(client)).min();
        let mut indices: Vec<usize> = (0..self.waiting.len()).collect();
        indices.sort_by_key(|index| (self.waiting[*index].stage, used_time(*index), self.waiting[*index].number));
        indices
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn queue(items: &[(u8, &'static str, &'static str)]) -> Queue<&'static str, &'static str> {
        let mut queue = Queue::default();
        for (number, (stage, client, work)) in items.iter().enumerate() {
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
        assert_eq!(queue.used_time["ann"], Duration::from_secs(2));
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
