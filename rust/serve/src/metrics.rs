//! Metrics of the server, for Prometheus.

use std::fmt;
use std::sync::Arc;
use std::time::Duration;

use prometheus_client::collector::Collector;
use prometheus_client::encoding::{DescriptorEncoder, EncodeMetric, text};
use prometheus_client::metrics::MetricType;
use prometheus_client::metrics::counter::{ConstCounter, Counter};
use prometheus_client::metrics::family::Family;
use prometheus_client::metrics::gauge::{ConstGauge, Gauge};
use prometheus_client::metrics::histogram::{Histogram, exponential_buckets};
use prometheus_client::registry::{Registry, Unit};

use crate::demand::{Demand, Statistics};
use crate::rooms::Rooms;
use crate::site::Sites;

/// Media type of the metrics as text.
pub const MEDIA: &str = "application/openmetrics-text; version=1.0.0; charset=utf-8";

/// Metrics since the server started.
pub struct Metrics {
    registry: Registry,
    answers: Family<[(&'static str, u16); 1], Counter>,
    seconds: Histogram,
    sent: Counter,
    /// Number of open connections.
    pub connections: Gauge,
    lost: Family<[(&'static str, &'static str); 1], Counter>,
    expiry: Gauge,
}

impl Metrics {
    /// Creates the metrics of a server with sites and rooms.
    pub fn new(sites: &Sites, rooms: Option<&Rooms>) -> Self {
        let mut registry = Registry::with_prefix("nearfar");
        // 17 buckets from 1 ms to 65 s, by factors of two.
        let seconds = Histogram::new(exponential_buckets(0.001, 2.0, 17));
        let (answers, lost, sent) = (Family::default(), Family::default(), Counter::default());
        let [connections, expiry] = [(); 2].map(|()| Gauge::default());
        registry.register("answers", "Completed responses, by status code", answers.clone());
        let help = "Time from a request to the end of its response";
        registry.register_with_unit("answer", help, Unit::Seconds, seconds.clone());
        registry.register_with_unit("sent", "Bytes of responses, without headers", Unit::Bytes, sent.clone());
        registry.register("connections", "Open connections", connections.clone());
        registry.register("connections_lost", "Connections closed by the server, by reason", lost.clone());
        let help = "Expiry of the certificate, in seconds since 1970; 0 without one";
        registry.register("certificate_end", help, expiry.clone());
        let demands = sites.iter().filter_map(|(name, site)| Some((name.clone(), site.demand.clone()?)));
        registry.register_collector(Box::new(Demands(demands.collect())));
        if let Some(rooms) = rooms {
            rooms.statistics.register(&mut registry);
        }
        Metrics { registry, answers, seconds, sent, connections, lost, expiry }
    }

    /// Counts a finished response.
    pub fn count_response(&self, code: u16, duration: Duration, sent: u64) {
        self.answers.get_or_create(&[("code", code)]).inc();
        self.seconds.observe(duration.as_secs_f64());
        self.sent.inc_by(sent);
    }

    /// Counts a connection that the server ended.
    pub fn count_lost(&self, reason: &'static str) {
        self.lost.get_or_create(&[("reason", reason)]).inc();
    }

    /// Sets the expiry time of the certificate.
    pub fn set_expiry(&self, unix_seconds: i64) {
        self.expiry.set(unix_seconds);
    }

    pub fn text(&self) -> String {
        let mut text = String::new();
        // Writing to memory cannot fail.
        let _ = text::encode(&mut text, &self.registry);
        text
    }
}

/// Collects the counts of regions on demand, by site name.
struct Demands(Vec<(String, Arc<Demand>)>);

impl fmt::Debug for Demands {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_list().entries(self.0.iter().map(|(name, _)| name)).finish()
    }
}

impl Collector for Demands {
    fn encode(&self, mut encoder: DescriptorEncoder<'_>) -> fmt::Result {
        let all: Vec<_> = self.0.iter().map(|(name, demand)| (name.as_str(), demand.statistics())).collect();
        let mut encode_gauge = |name, help, unit, value: fn(&Statistics) -> u64| -> fmt::Result {
            let mut gauges = encoder.encode_descriptor(name, help, unit, MetricType::Gauge)?;
            for (site, statistics) in &all {
                ConstGauge::new(value(statistics) as i64).encode(gauges.encode_family(&[("site", *site)])?)?;
            }
            Ok(())
        };
        encode_gauge("regions_waiting", "Regions that clients wait for", None, |statistics| statistics.waiting)?;
        encode_gauge("cache", "Regions on disk", Some(&Unit::Bytes), |statistics| statistics.cached_bytes)?;
        let help = "Requests for regions, by outcome";
        let mut ended = encoder.encode_descriptor("regions", help, None, MetricType::Counter)?;
        for (site, statistics) in &all {
            for (outcome, count) in statistics.outcomes() {
                let labels = [("site", *site), ("outcome", outcome)];
                ConstCounter::new(count).encode(ended.encode_family(&labels)?)?;
            }
        }
        Ok(())
    }
}
