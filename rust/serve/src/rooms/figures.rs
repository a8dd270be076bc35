//! Counts of rooms, for Prometheus.

use std::time::Duration;

use prometheus_client::encoding::EncodeLabelSet;
use prometheus_client::metrics::counter::Counter;
use prometheus_client::metrics::family::Family;
use prometheus_client::metrics::gauge::Gauge;
use prometheus_client::metrics::histogram::{Histogram, exponential_buckets};
use prometheus_client::registry::{Registry, Unit};

use super::reason::Reason;

/// Counts of all rooms.
pub struct Figures {
    /// Users who are there.
    pub users: Gauge,
    /// Rooms that somebody is in.
    pub rooms: Gauge,
    /// Connections of WebTransport.
    pub datagrams: Gauge,
    /// Poses that were older than one that was sent, beyond a user's rate, or overwritten by a newer one.
    pub dropped: Counter,
    forwarded: Counter,
    poses: Family<Outcome, Counter>,
    closes: Family<Closed, Counter>,
    residence: Histogram,
}

#[derive(Clone, Debug, PartialEq, Eq, Hash, EncodeLabelSet)]
struct Outcome {
    outcome: &'static str,
}

#[derive(Clone, Debug, PartialEq, Eq, Hash, EncodeLabelSet)]
struct Closed {
    reason: &'static str,
}

impl Figures {
    /// Nothing has happened yet.
    pub fn new() -> Self {
        let poses = Family::<Outcome, Counter>::default();
        let [forwarded, dropped] =
            ["forwarded", "dropped"].map(|outcome| poses.get_or_create_owned(&Outcome { outcome }));
        // From 8 microseconds to a quarter of a second, by factors of two.
        let residence = Histogram::new(exponential_buckets(8e-6, 2.0, 16));
        let closes = Family::default();
        let [users, rooms, datagrams] = [(); 3].map(|()| Gauge::default());
        Figures { users, rooms, datagrams, dropped, forwarded, poses, closes, residence }
    }

    /// Let a registry tell them.
    pub fn register(&self, registry: &mut Registry) {
        registry.register("rooms", "Rooms that somebody is in", self.rooms.clone());
        registry.register("room_users", "Users who are in rooms", self.users.clone());
        let sessions = self.datagrams.clone();
        registry.register("room_datagram_connections", "Connections whose poses come as datagrams", sessions);
        registry.register("room_poses", "Poses that came to a user or were overwritten", self.poses.clone());
        registry.register("room_closes", "Connections of rooms that ended, by reason", self.closes.clone());
        registry.register_with_unit(
            "room_residence",
            "Time from reading a pose to writing it",
            Unit::Seconds,
            self.residence.clone(),
        );
    }

    /// Poses were written that had been read so long before.
    pub fn written(&self, ages: impl ExactSizeIterator<Item = Duration>) {
        self.forwarded.inc_by(ages.len() as u64);
        ages.for_each(|age| self.residence.observe(age.as_secs_f64()));
    }

    /// A connection has ended.
    pub fn closed(&self, reason: Reason) {
        self.closes.get_or_create(&Closed { reason: reason.name() }).inc();
    }
}
