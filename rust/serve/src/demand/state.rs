//! State of the queue: regions in progress, and complete ones in memory. Work is ordered by stage, then by the time
//! that its client has used already, then by the age of the request.

use std::collections::{HashMap, VecDeque};
use std::net::IpAddr;
use std::sync::Arc;
use std::time::Duration;

use super::region::{PartMaker, Place, Region};

/// Counters of requests since the start, and current gauges.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Statistics {
    /// Regions with waiting clients.
    pub waiting: u64,
    /// Bytes of regions on disk.
    pub cached_bytes: u64,
    /// Requests whose region was complete.
    pub found: u64,
    /// Requests that joined others waiting for the same region.
    pub shared: u64,
    /// Rejected requests.
    pub refused: u64,
    /// Completed regions.
    pub made: u64,
    /// Failed regions.
    pub failed: u64,
    /// Regions abandoned by all clients.
    pub left: u64,
}

impl Statistics {
    /// Request counters by outcome.
    pub fn outcomes(&self) -> [(&'static str, u64); 6] {
        let Statistics { found, shared, refused, made, failed, left, .. } = *self;
        [("found", found), ("shared", shared), ("refused", refused), ("made", made), ("failed", failed), ("left", left)]
    }
}

#[derive(Default)]
pub struct State {
    /// Regions in progress by place.
    pub entries: HashMap<String, Entry>,
    used_time: HashMap<IpAddr, Duration>,
    /// Complete regions that could not be written to disk, oldest first.
    pub in_memory: VecDeque<Arc<Region>>,
    /// Coarse maps of complete regions, oldest first. Manifests list only the full maps, but slow clients may still
    /// fetch the coarse ones.
    pub superseded_maps: VecDeque<Arc<Region>>,
    request_count: u64,
    pub statistics: Statistics,
}

/// A region in progress, and its waiting clients.
pub struct Entry {
    pub region: Arc<Region>,
    pub clients: Vec<IpAddr>,
    /// Request number, ascending with time.
    number: u64,
    /// Work that waits for a thread; none while a thread does it.
    work: Option<Work>,
}

/// Next part of a region to be made.
#[derive(Default)]
pub struct Work {
    pub stage: u8,
    /// Maker of the parts; none before the first one.
    pub part_maker: Option<Box<dyn PartMaker>>,
}

impl State {
    /// Adds a client to a region, which is created if it is new.
    pub fn add(&mut self, client: IpAddr, key: String, place: Place) -> Arc<Region> {
        // A new client starts with the least time of all clients, so that absence gives no advantage.
        let least = self.used_time.values().min().copied().unwrap_or_default();
        self.used_time.entry(client).or_insert(least);
        if let Some(entry) = self.entries.get_mut(&key) {
            entry.clients.push(client);
            self.statistics.shared += 1;
            return Arc::clone(&entry.region);
        }
        self.request_count += 1;
        let region = Arc::new(Region::new(place));
        let (number, work) = (self.request_count, Some(Work::default()));
        self.entries.insert(key, Entry { region: Arc::clone(&region), clients: vec![client], number, work });
        region
    }

    /// Entry of a region, unless it was abandoned or has ended.
    fn entry(&mut self, region: &Arc<Region>) -> Option<&mut Entry> {
        self.entries.get_mut(&region.place.to_string()).filter(|entry| Arc::ptr_eq(&entry.region, region))
    }

    /// Removes a client from a region; returns the entry if no client is left.
    pub fn leave(&mut self, client: IpAddr, region: &Arc<Region>) -> Option<Entry> {
        let clients = &mut self.entry(region)?.clients;
        clients.swap_remove(clients.iter().position(|each| *each == client)?);
        let mut abandoned = None;
        if clients.is_empty() {
            abandoned = self.remove(region);
            region.abandon();
            self.statistics.left += 1;
        }
        let is_present = |client: &IpAddr| self.entries.values().any(|entry| entry.clients.contains(client));
        self.used_time.retain(|client, _| is_present(client));
        abandoned
    }

    pub fn remove(&mut self, region: &Arc<Region>) -> Option<Entry> {
        self.entry(region)?;
        self.entries.remove(&region.place.to_string())
    }

    /// Takes the next work whose stage is at most `last_stage`, with its region and the clients that wait for it.
    pub fn take(&mut self, last_stage: u8) -> Option<(Arc<Region>, Vec<IpAddr>, Work)> {
        let region = self.order().into_iter().find_map(|(stage, region)| (stage <= last_stage).then_some(region))?;
        let entry = self.entry(&region)?;
        let (clients, work) = (entry.clients.clone(), entry.work.take()?);
        Some((region, clients, work))
    }

    /// Puts work on a region back into the queue; returns it if the region was abandoned.
    pub fn put_back(&mut self, region: &Arc<Region>, work: Work) -> Option<Work> {
        match self.entry(region) {
            Some(entry) => entry.work.replace(work),
            None => Some(work),
        }
    }

    /// Charges used time in equal shares to the clients that waited for it.
    pub fn charge(&mut self, clients: &[IpAddr], duration: Duration) {
        for client in clients {
            *self.used_time.entry(*client).or_default() += duration / u32::try_from(clients.len()).unwrap_or(u32::MAX);
        }
    }

    /// Number of regions ahead of a region in the queue; none if it is not queued.
    pub fn position(&self, region: &Arc<Region>) -> Option<usize> {
        self.order().iter().position(|(_, waiting)| Arc::ptr_eq(waiting, region))
    }

    /// Notifies all clients that their positions may have changed.
    pub fn touch_all(&self) {
        self.entries.values().for_each(|entry| entry.region.touch());
    }

    /// Stages and regions of waiting work in the order of service.
    fn order(&self) -> Vec<(u8, Arc<Region>)> {
        let used_time = |entry: &Entry| entry.clients.iter().filter_map(|client| self.used_time.get(client)).min();
        let waiting = self.entries.values().filter_map(|entry| Some((entry.work.as_ref()?.stage, entry)));
        let mut waiting: Vec<_> = waiting.collect();
        waiting.sort_by_key(|(stage, entry)| (*stage, used_time(entry), entry.number));
        waiting.into_iter().map(|(stage, entry)| (stage, Arc::clone(&entry.region))).collect()
    }
}

/// Appends a region to a list and removes the oldest ones while the list has more than `max_bytes` and more than
/// `min_count` regions.
pub fn append(regions: &mut VecDeque<Arc<Region>>, region: Arc<Region>, max_bytes: u64, min_count: usize) {
    regions.push_back(region);
    let mut bytes: u64 = regions.iter().map(|region| region.bytes()).sum();
    while bytes > max_bytes && regions.len() > min_count {
        bytes -= regions.pop_front().map_or(0, |region| region.bytes());
    }
}

#[cfg(test)]
mod tests {
    use bytes::Bytes;

    use super::*;

    const ANN: IpAddr = IpAddr::V4(std::net::Ipv4Addr::new(10, 0, 0, 1));
    const BOB: IpAddr = IpAddr::V4(std::net::Ipv4Addr::new(10, 0, 0, 2));

    /// Adds a region at x with work of a stage.
    fn add(state: &mut State, stage: u8, client: IpAddr, x: f64) -> Arc<Region> {
        let place = Place([x, 0.0, 0.0]);
        let region = state.add(client, place.to_string(), place);
        state.put_back(&region, Work { stage, part_maker: None });
        region
    }

    fn state(items: &[(u8, IpAddr, f64)]) -> State {
        let mut state = State::default();
        for (stage, client, x) in items {
            add(&mut state, *stage, *client, *x);
        }
        state
    }

    /// Takes all work, and charges `seconds` for each item; returns the x of the regions, in order.
    fn drain(mut state: State, seconds: u64) -> Vec<f64> {
        let take = || {
            let (region, clients, _) = state.take(u8::MAX)?;
            state.charge(&clients, Duration::from_secs(seconds));
            Some(region.place.0[0])
        };
        std::iter::from_fn(take).collect()
    }

    #[test]
    fn early_stages_and_then_earlier_requests_come_first() {
        assert_eq!(drain(state(&[(1, ANN, 1.0), (0, BOB, 2.0), (0, ANN, 3.0)]), 0), [2.0, 3.0, 1.0]);
    }

    #[test]
    fn a_flooding_client_delays_only_itself() {
        let state = state(&[(0, BOB, 1.0), (0, BOB, 2.0), (0, BOB, 3.0), (0, ANN, 4.0)]);
        assert_eq!(drain(state, 1), [1.0, 4.0, 2.0, 3.0]);
    }

    #[test]
    fn a_client_gains_nothing_by_coming_late() {
        let mut state = state(&[(0, ANN, 1.0)]);
        state.charge(&[ANN], Duration::from_secs(9));
        add(&mut state, 0, BOB, 2.0);
        add(&mut state, 0, BOB, 3.0);
        assert_eq!(drain(state, 0)[0], 1.0);
    }

    #[test]
    fn shared_work_is_charged_to_all_and_stays_until_the_last_leaves() {
        let mut state = State::default();
        let [both, _] = [(BOB, 1.0), (BOB, 2.0)].map(|(client, x)| add(&mut state, 0, client, x));
        assert!(Arc::ptr_eq(&both, &add(&mut state, 0, ANN, 1.0)));
        state.charge(&[ANN, BOB], Duration::from_secs(4));
        assert_eq!(state.used_time[&ANN], Duration::from_secs(2));
        assert!(state.leave(ANN, &both).is_none());
        assert!(state.leave(BOB, &both).is_some_and(|entry| entry.work.is_some()));
        assert!(state.leave(BOB, &both).is_none());
        assert_eq!((state.entries.len(), state.used_time.len()), (1, 1));
    }

    #[test]
    fn workers_for_early_stages_skip_late_ones() {
        let mut state = State::default();
        let late = add(&mut state, 1, ANN, 1.0);
        assert!(state.take(0).is_none());
        assert_eq!(state.position(&late), Some(0));
        assert!(Arc::ptr_eq(&state.take(1).unwrap().0, &late));
    }

    #[test]
    fn the_oldest_are_removed_when_the_budget_is_full() {
        let region = |bytes: usize| {
            let files = [(bytes.to_string(), Bytes::from(vec![1; bytes]))];
            Arc::new(Region::with_files(Place([0.0; 3]), files.into()))
        };
        let mut regions = VecDeque::new();
        (30..34).for_each(|bytes| append(&mut regions, region(bytes), 100, 0));
        assert!(regions.iter().map(|region| region.bytes()).eq([31, 32, 33]));
        append(&mut regions, region(101), 100, 1);
        assert_eq!(regions.len(), 1);
        append(&mut regions, region(102), 100, 0);
        assert!(regions.is_empty());
    }
}
