//! Prints the measurements as JSON.

use std::time::Instant;

use nearfar_serve::rooms::frame::HEADER_BYTES;
use serde_json::{Value, json};

use crate::options::Load;
use crate::user::{Measurements, pose};

/// Sizes of `ack` and `settled` in bytes.
const ACK: usize = HEADER_BYTES + 6;
const SETTLED: usize = HEADER_BYTES + 4;
/// Header bytes that WebSocket adds to a short message of a user, and of the server.
const FROM_USER: usize = 6;
const FROM_SERVER: usize = 2;

/// Resources used by the server's process during the measurement.
pub struct ServerUsage {
    pub cpu_seconds: f64,
    /// Resident memory per user, and of the whole process at each sample.
    pub kilobytes_per_user: f64,
    pub kilobytes: Vec<f64>,
}

/// Summarizes the measurements as JSON; times are in milliseconds. `residence` is the result of `Process::residence`.
pub fn report(load: &Load, users: &[Measurements], usage: &ServerUsage, residence: (f64, f64)) -> Value {
    let sum = |pick: fn(&Measurements) -> usize| users.iter().map(pick).sum::<usize>() as f64;
    let poses = sum(|each| each.poses);
    let (others, pose) = (load.group - 1, HEADER_BYTES + pose(0, Instant::now()).bytes());
    json!({
        "users": load.users,
        "group": load.group,
        "poses_per_second": poses / load.users as f64 / load.seconds,
        "round_trip": percentiles(users, |each| &each.round_trips),
        "way": percentiles(users, |each| &each.one_way_delays),
        "unsettled": sum(|each| each.unsettled),
        "residence": { "99": residence.1 * 1e3, "share_within_1.02": residence.0 },
        "cores": usage.cpu_seconds / load.seconds,
        "microseconds_per_pose": usage.cpu_seconds / poses * 1e6,
        "kilobytes_per_user": usage.kilobytes_per_user,
        "kilobytes": usage.kilobytes,
        "bytes_up": sum(|each| each.sent) / poses,
        "bytes_down": sum(|each| each.received) / poses,
        // The closed form assumes one frame per message.
        "closed_form_up": pose + FROM_USER + others * (ACK + FROM_USER),
        "closed_form_down": others * (pose + 2 + FROM_SERVER) + SETTLED + FROM_SERVER,
    })
}

fn percentiles(users: &[Measurements], pick: fn(&Measurements) -> &Vec<u32>) -> Value {
    let mut times: Vec<u32> = users.iter().flat_map(|each| pick(each).iter().copied()).collect();
    times.sort_unstable();
    let at = |share: f64| times.get((times.len() as f64 * share) as usize).map(|time| f64::from(*time) / 1e3);
    json!({ "median": at(0.5), "99": at(0.99), "most": at(1.0 - f64::EPSILON) })
}
