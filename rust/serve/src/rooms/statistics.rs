//! Metrics of rooms, for Prometheus.

use std::time::Instant;

use prometheus_client::metrics::counter::Counter;
use prometheus_client::metrics::family::Family;
use prometheus_client::metrics::gauge::Gauge;
use prometheus_client::metrics::histogram::{Histogram, exponential_buckets};
use prometheus_client::registry::{Registry, Unit};

use super::reason::Reason;

/// Counters by the value of a label.
type LabelledCounters = Family<[(&'static str, &'static str); 1], Counter>;

/// Metrics of all rooms.
pub struct Statistics {
    /// Number of users in rooms.
    pub users: Gauge,
    /// Number of rooms with users.
    pub rooms: Gauge,
    /// Number of WebTransport connections.
    pub datagrams: Gauge,
    /// Poses that arrived out of order, exceeded a user's rate, or were replaced by a newer one.
    pub dropped: Counter,
    forwarded: Counter,
    poses: LabelledCounters,
    closes: LabelledCounters,
    residence: Histogram,
}

impl Statistics {
    pub fn new() -> Self {
        let (poses, closes) = (LabelledCounters::default(), LabelledCounters::default());
        let [forwarded, dropped] =
            ["forwarded", "dropped"].map(|outcome| poses.get_or_create_owned(&[("outcome", outcome)]));
        // 16 buckets from 8 µs to 0.25 s, by factors of two.
        let residence = Histogram::new(exponential_buckets(8e-6, 2.0, 16));
        let [users, rooms, datagrams] = [(); 3].map(|()| Gauge::default());
        Statistics { users, rooms, datagrams, dropped, forwarded, poses, closes, residence }
    }

    pub fn register(&self, registry: &mut Registry) {
        registry.register("rooms", "Rooms with users", self.rooms.clone());
        registry.register("room_users", "Users who are in rooms", self.users.clone());
        let sessions = self.datagrams.clone();
        registry.register("room_datagram_connections", "Connections that send poses as datagrams", sessions);
        registry.register("room_poses", "Poses delivered to a user or overwritten", self.poses.clone());
        registry.register("room_closes", "Closed connections of rooms, by reason", self.closes.clone());
        let (help, residence) = ("Time from reading a pose to writing it", self.residence.clone());
        registry.register_with_unit("room_residence", help, Unit::Seconds, residence);
    }

    /// Counts poses that have just been written; `arrivals` are the times at which they were read.
    pub fn count_forwarded(&self, arrivals: impl ExactSizeIterator<Item = Instant>) {
        let now = Instant::now();
        self.forwarded.inc_by(arrivals.len() as u64);
        arrivals.for_each(|arrival| self.residence.observe(now.saturating_duration_since(arrival).as_secs_f64()));
    }

    pub fn count_close(&self, reason: Reason) {
        self.closes.get_or_create(&[("reason", reason.name())]).inc();
    }
}
