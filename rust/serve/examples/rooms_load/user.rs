//! A user who sends poses and acknowledges those of others.

use std::time::{Duration, Instant};

use nearfar_serve::rooms::frame::{FromServer, FromUser};
use nearfar_serve::rooms::pose::{Placement, PointerOrigin, Pose};
use tokio::time::{Instant as Tick, MissedTickBehavior, interval_at};

use crate::connection::UserConnection;
use crate::options::{Failure, Load};
use crate::server::ServerAddress;

/// Warm-up time that is not measured.
pub const WARM_UP: Duration = Duration::from_secs(1);

/// Measurements of one user: times in microseconds, and bytes of messages with their headers.
#[derive(Default)]
pub struct Measurements {
    pub round_trips: Vec<u32>,
    pub one_way_delays: Vec<u32>,
    /// Sent poses that some user of the group has not acknowledged.
    pub unsettled: usize,
    pub poses: usize,
    pub sent: usize,
    pub received: usize,
}

/// Sends poses and acknowledges those of others until the time is over, rejoining if the load asks for it.
pub async fn play(
    load: &Load,
    number: usize,
    server: &ServerAddress,
    epoch: Instant,
    mut connection: UserConnection,
) -> Result<Measurements, Failure> {
    let started = Tick::now();
    let end = started + WARM_UP + Duration::from_secs_f64(load.seconds);
    let (measured_from, measurements) = (started + WARM_UP, Measurements::default());
    let mut user = UserState { measured_from, epoch, measurements, times: Vec::new(), settled: 0 };
    // Departures are spread evenly over the stay.
    let mut stay = load.stay.mul_f64((number + 1) as f64 / load.users as f64);
    loop {
        let until = Tick::now().checked_add(stay).map_or(end, |leaves| leaves.min(end));
        user.run(load, number, until, &mut connection).await?;
        if until == end {
            return Ok(user.measurements);
        }
        connection.leave().await?;
        (connection, stay) = (UserConnection::join(load, number, server).await?, load.stay);
    }
}

/// State of a user; `run` is one stay in the room.
struct UserState {
    /// Start of the measurement.
    measured_from: Tick,
    epoch: Instant,
    measurements: Measurements,
    /// Send time of each pose of this stay.
    times: Vec<Tick>,
    /// Number of settled poses of this stay.
    settled: usize,
}

impl UserState {
    async fn run(
        &mut self,
        load: &Load,
        number: usize,
        until: Tick,
        connection: &mut UserConnection,
    ) -> Result<(), Failure> {
        let phase = Duration::from_secs_f64(number as f64 * 0.618_034 % 1.0 / load.hertz);
        let mut ticks = interval_at(Tick::now() + phase, Duration::from_secs_f64(1.0 / load.hertz));
        ticks.set_missed_tick_behavior(MissedTickBehavior::Skip);
        (self.times, self.settled) = (Vec::new(), 0);
        let mut before = None;
        loop {
            if before.is_none() && Tick::now() >= self.measured_from {
                before = Some(connection.bytes());
            }
            tokio::select! {
                () = tokio::time::sleep_until(until) => break,
                _ = ticks.tick() => {
                    let pose = pose(self.times.len() as u32, self.epoch);
                    self.times.push(Tick::now());
                    connection.send(&[FromUser::Pose(pose)]).await?;
                    self.measurements.poses += usize::from(Tick::now() >= self.measured_from);
                }
                message = connection.receive() => {
                    let message = message?;
                    self.handle_message(&message, connection).await?;
                }
            }
        }
        let (after, before) = (connection.bytes(), before.unwrap_or_else(|| connection.bytes()));
        self.measurements.sent += after.0 - before.0;
        self.measurements.received += after.1 - before.1;
        self.measurements.unsettled += self.times.len() - self.settled;
        Ok(())
    }

    /// Reads the frames of a message and acknowledges its poses.
    async fn handle_message(&mut self, mut message: &[u8], connection: &mut UserConnection) -> Result<(), Failure> {
        let (now, mut acknowledged) = (Tick::now(), Vec::new());
        while !message.is_empty() {
            let (frame, rest) = FromServer::read(message).map_err(|fault| format!("{fault:?}"))?;
            match frame {
                FromServer::Pose { user, pose } => {
                    let delay = (self.epoch.elapsed().as_micros() as u64).saturating_sub(pose.clock);
                    self.measurements.one_way_delays.extend((now >= self.measured_from).then_some(delay as u32));
                    acknowledged.push(FromUser::Ack { user, sequence: pose.sequence });
                }
                // Datagrams can overtake each other.
                FromServer::Settled { sequence } if sequence as usize >= self.settled => {
                    let last = sequence as usize + 1;
                    let counted = self.times[self.settled..last].iter().filter(|time| **time >= self.measured_from);
                    let round_trips = counted.map(|time| now.duration_since(*time).as_micros() as u32);
                    self.measurements.round_trips.extend(round_trips);
                    self.settled = last;
                }
                FromServer::Refused { sentence, .. } => return Err(sentence.into()),
                _ => {}
            }
            message = rest;
        }
        if acknowledged.is_empty() { Ok(()) } else { connection.send(&acknowledged).await }
    }
}

/// Pose with a head, two hands and a pointer.
pub fn pose(sequence: u32, epoch: Instant) -> Pose {
    let head = Placement { position: [0.0, 1.7, 0.0], rotation: [0, 0, 0, 32767] };
    Pose {
        sequence,
        clock: epoch.elapsed().as_micros() as u64,
        is_acknowledged: true,
        stops: false,
        head,
        hands: [Some(head); 2],
        pointer: Some((PointerOrigin::Right, 20.0)),
    }
}
