//! A user who sends poses and acknowledges those of others.

use std::time::{Duration, Instant};

use nearfar_serve::rooms::frame::{FromServer, FromUser};
use nearfar_serve::rooms::pose::{Begin, Placed, Pose};
use tokio::time::{Instant as Tick, MissedTickBehavior, interval_at};

use crate::line::Line;
use crate::options::{Failure, Load};
use crate::server::Listens;

/// Warm-up time that is not measured.
pub const WARM: Duration = Duration::from_secs(1);

/// Times in microseconds, and bytes of messages with their headers.
#[derive(Default)]
pub struct Seen {
    pub round_trips: Vec<u32>,
    pub ways: Vec<u32>,
    pub unsettled: usize,
    pub poses: usize,
    pub sent: usize,
    pub received: usize,
}

/// Sends poses and acknowledges those of others until the time is over, rejoining if the load asks for it.
pub async fn play(
    load: &Load,
    number: usize,
    listens: &Listens,
    epoch: Instant,
    mut line: Line,
) -> Result<Seen, Failure> {
    let begun = Tick::now();
    let end = begun + WARM + Duration::from_secs_f64(load.seconds);
    let mut visit = Visit { warm: begun + WARM, epoch, seen: Seen::default(), times: Vec::new(), settled: 0 };
    // Departures are spread evenly over the stay.
    let mut stay = load.stay.mul_f64((number + 1) as f64 / load.users as f64);
    loop {
        let until = Tick::now().checked_add(stay).map_or(end, |leaves| leaves.min(end));
        visit.run(load, number, until, &mut line).await?;
        if until == end {
            return Ok(visit.seen);
        }
        line.leave().await?;
        (line, stay) = (Line::join(load, number, listens).await?, load.stay);
    }
}

/// State of a user during one stay in the room.
struct Visit {
    /// Start of the measurement.
    warm: Tick,
    epoch: Instant,
    seen: Seen,
    /// Send time of each pose.
    times: Vec<Tick>,
    /// Number of settled poses.
    settled: usize,
}

impl Visit {
    async fn run(&mut self, load: &Load, number: usize, until: Tick, line: &mut Line) -> Result<(), Failure> {
        let phase = Duration::from_secs_f64(number as f64 * 0.618_034 % 1.0 / load.hertz);
        let mut ticks = interval_at(Tick::now() + phase, Duration::from_secs_f64(1.0 / load.hertz));
        ticks.set_missed_tick_behavior(MissedTickBehavior::Skip);
        (self.times, self.settled) = (Vec::new(), 0);
        let mut before = None;
        loop {
            if before.is_none() && Tick::now() >= self.warm {
                before = Some(line.bytes());
            }
            tokio::select! {
                () = tokio::time::sleep_until(until) => break,
                _ = ticks.tick() => {
                    let pose = pose(self.times.len() as u32, self.epoch);
                    self.times.push(Tick::now());
                    line.send(&[FromUser::Pose(pose)]).await?;
                    self.seen.poses += usize::from(Tick::now() >= self.warm);
                }
                message = line.receive() => {
                    let message = message?;
                    self.heard(&message, line).await?;
                }
            }
        }
        let (after, before) = (line.bytes(), before.unwrap_or_else(|| line.bytes()));
        self.seen.sent += after.0 - before.0;
        self.seen.received += after.1 - before.1;
        self.seen.unsettled += self.times.len() - self.settled;
        Ok(())
    }

    /// Reads the frames of a message and acknowledges its poses.
    async fn heard(&mut self, mut message: &[u8], line: &mut Line) -> Result<(), Failure> {
        let (now, mut acknowledged) = (Tick::now(), Vec::new());
        while !message.is_empty() {
            let (frame, rest) = FromServer::read(message).map_err(|fault| format!("{fault:?}"))?;
            match frame {
                FromServer::Pose { user, pose } => {
                    let way = (self.epoch.elapsed().as_micros() as u64).saturating_sub(pose.clock);
                    self.seen.ways.extend((now >= self.warm).then_some(way as u32));
                    acknowledged.push(FromUser::Ack { user, sequence: pose.sequence });
                }
                // Datagrams can overtake each other.
                FromServer::Settled { sequence } if sequence as usize >= self.settled => {
                    let last = sequence as usize + 1;
                    let counted = self.times[self.settled..last].iter().filter(|time| **time >= self.warm);
                    self.seen.round_trips.extend(counted.map(|time| now.duration_since(*time).as_micros() as u32));
                    self.settled = last;
                }
                FromServer::Refused { sentence, .. } => return Err(sentence.into()),
                _ => {}
            }
            message = rest;
        }
        if acknowledged.is_empty() { Ok(()) } else { line.send(&acknowledged).await }
    }
}

/// Pose with a head, two hands and a pointer.
pub fn pose(sequence: u32, epoch: Instant) -> Pose {
    let head = Placed { position: [0.0, 1.7, 0.0], rotation: [0, 0, 0, 32767] };
    Pose {
        sequence,
        clock: epoch.elapsed().as_micros() as u64,
        is_acknowledged: true,
        stops: false,
        head,
        hands: [Some(head); 2],
        pointer: Some((Begin::Right, 20.0)),
    }
}
