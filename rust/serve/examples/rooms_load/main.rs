//! Users of rooms who send poses and acknowledge those of others, on a server in a process of its own.
//!
//! `rooms_load USERS GROUP HERTZ SECONDS [ATTACK]`, such as `rooms_load 32 4 72 10`, prints a row of a table: median
//! and 99th percentile of the round trip (the paper's Eq. 3) and of the way from user to user, the server's residence
//! and CPU, and bytes of a user against the closed form. With a last word of `attack`, eight others misbehave meanwhile
//! in the group of the first users.

mod attack;

use std::io::{BufRead, BufReader, Read, Write};
use std::net::SocketAddr;
use std::process::{Child, Command, Stdio};
use std::sync::Arc;
use std::time::{Duration, Instant};

use attack::{Attack, INTRUDERS, NAMES, attack};
use futures_util::{SinkExt, StreamExt};
use nearfar_serve::rooms::frame::{FromServer, FromUser, HEAD};
use nearfar_serve::rooms::pose::{Begin, Placed, Pose};
use nearfar_serve::rooms::{self, Rooms};
use nearfar_serve::{Answering, Router, Server, Settings};
use tokio::net::TcpStream;
use tokio::sync::Barrier;
use tokio::time::{Instant as Tick, MissedTickBehavior, interval_at};
use tokio_tungstenite::tungstenite::Message;
use tokio_tungstenite::tungstenite::client::IntoClientRequest;
use tokio_tungstenite::{WebSocketStream, client_async};

type Failure = Box<dyn std::error::Error + Send + Sync>;
type Socket = WebSocketStream<TcpStream>;

/// Users of a room, if groups are not larger.
const ROOM: usize = 64;
/// Time before anything is counted.
const WARM: Duration = Duration::from_secs(1);
/// Clock ticks of a second in `/proc`.
const TICKS: f64 = 100.0;
/// Bytes of `ack` and of `settled`.
const ACK: usize = HEAD + 6;
const SETTLED: usize = HEAD + 4;

#[derive(Clone, Copy)]
struct Load {
    users: usize,
    group: usize,
    hertz: f64,
    seconds: f64,
    attack: Option<Attack>,
}

/// Times in microseconds, and bytes of messages with their heads.
#[derive(Default)]
struct Seen {
    round_trips: Vec<u32>,
    ways: Vec<u32>,
    unsettled: usize,
    sent: usize,
    received: usize,
}

fn main() -> Result<(), Failure> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if arguments == ["serve"] {
        return serve();
    }
    let load = match &arguments[..] {
        [users, group, hertz, seconds, attack @ ..] if attack.len() < 2 => Load {
            users: users.parse()?,
            group: group.parse()?,
            hertz: hertz.parse()?,
            seconds: seconds.parse()?,
            attack: attack.first().map(|text| text.parse()).transpose()?,
        },
        _ => return Err(format!("expected USERS GROUP HERTZ SECONDS, and perhaps one of {NAMES}").into()),
    };
    let (mut server, address) = started()?;
    let runtime = tokio::runtime::Builder::new_multi_thread().worker_threads(2).enable_all().build()?;
    let (seen, cpu) = runtime.block_on(run(load, address, server.id()))?;
    let residence = residence(address)?;
    drop(server.stdin.take());
    server.wait()?;
    tell(load, seen, cpu, residence);
    Ok(())
}

/// Be the server until the standard input ends.
fn serve() -> Result<(), Failure> {
    let most = 1 << 14;
    let limits = rooms::Limits { rooms: most, users: 1 << 10, ..rooms::Limits::default() };
    let rooms = Some(Arc::new(Rooms::new(limits, None)?));
    let answering = Answering { sites: [].into(), hosts: None, headers: Vec::new(), origin: None, rooms };
    let limits = nearfar_serve::Limits { connections: most, ..nearfar_serve::Limits::default() };
    let address = ([127, 0, 0, 1], 0).into();
    let server = Server::start(Settings { address, limits, certificate: None, router: Router::new(answering) })?;
    println!("{}", server.address());
    std::io::stdin().read_to_end(&mut Vec::new())?;
    Ok(())
}

fn started() -> Result<(Child, SocketAddr), Failure> {
    let mut command = Command::new(std::env::current_exe()?);
    let mut child = command.arg("serve").stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
    let mut line = String::new();
    BufReader::new(child.stdout.take().ok_or("no output")?).read_line(&mut line)?;
    Ok((child, line.trim().parse()?))
}

/// All users; what they saw, CPU seconds that the server took meanwhile, and kilobytes of its memory for a user.
async fn run(load: Load, address: SocketAddr, server: u32) -> Result<(Vec<Seen>, [f64; 2]), Failure> {
    let alone = memory(server)?;
    let (epoch, together) = (Instant::now(), Arc::new(Barrier::new(load.users + 1)));
    let mut users = Vec::new();
    for number in 0..load.users {
        let mut socket = enter(load, number, address).await?;
        let together = Arc::clone(&together);
        users.push(tokio::spawn(async move {
            together.wait().await;
            let phase = Duration::from_secs_f64(number as f64 * 0.618_034 % 1.0 / load.hertz);
            play(load, epoch, phase, &mut socket).await
        }));
    }
    let attacks = load.attack.map_or(0..0, |_| 0..INTRUDERS).zip(load.attack.into_iter().cycle());
    let attacks: Vec<_> = attacks.map(|(number, kind)| tokio::spawn(attack(kind, address, number, epoch))).collect();
    together.wait().await;
    tokio::time::sleep(WARM).await;
    let before = cpu(server)?;
    tokio::time::sleep(Duration::from_secs_f64(load.seconds)).await;
    let took = [cpu(server)? - before, (memory(server)? - alone) / load.users as f64];
    let mut seen = Vec::new();
    for user in users {
        seen.push(user.await??);
    }
    attacks.iter().for_each(|attack| attack.abort());
    Ok((seen, took))
}

async fn enter(load: Load, number: usize, address: SocketAddr) -> Result<Socket, Failure> {
    let group = number / load.group;
    connect(address, group / (ROOM / load.group).max(1), group as u16).await
}

/// Join a group of a room.
async fn connect(address: SocketAddr, room: usize, group: u16) -> Result<Socket, Failure> {
    let stream = TcpStream::connect(address).await?;
    stream.set_nodelay(true)?;
    let request = format!("ws://{address}/rooms/{room}").into_client_request()?;
    let (mut socket, _) = client_async(request, stream).await?;
    let mut hello = Vec::new();
    FromUser::Hello { group, name: "load", ticket: &[] }.write(&mut hello);
    socket.send(Message::binary(hello)).await?;
    Ok(socket)
}

/// Send poses and acknowledge those of others until the time is over.
async fn play(load: Load, epoch: Instant, phase: Duration, socket: &mut Socket) -> Result<Seen, Failure> {
    let (begun, period) = (Tick::now(), Duration::from_secs_f64(1.0 / load.hertz));
    let (warm, end) = (begun + WARM, begun + WARM + Duration::from_secs_f64(load.seconds));
    let mut ticks = interval_at(begun + phase, period);
    ticks.set_missed_tick_behavior(MissedTickBehavior::Skip);
    let (mut seen, mut times, mut settled) = (Seen::default(), Vec::new(), 0);
    loop {
        let message = tokio::select! {
            () = tokio::time::sleep_until(end) => break,
            _ = ticks.tick() => {
                let mut message = Vec::new();
                FromUser::Pose(pose(times.len() as u32, epoch)).write(&mut message);
                times.push(Tick::now());
                message
            }
            message = socket.next() => {
                let message = message.ok_or("the server ended")??;
                let now = Tick::now();
                let is_counted = now >= warm;
                if is_counted {
                    seen.received += message.len() + if message.len() < 126 { 2 } else { 4 };
                }
                acknowledge(&message.into_data(), epoch, |settled_now, way| {
                    seen.ways.extend(way.filter(|_| is_counted));
                    for time in settled_now.map_or(&[][..], |last| &times[settled..=last as usize]) {
                        if *time >= warm {
                            seen.round_trips.push(now.duration_since(*time).as_micros() as u32);
                        }
                    }
                    settled = settled_now.map_or(settled, |last| last as usize + 1);
                })?
            }
        };
        if !message.is_empty() {
            if Tick::now() >= warm {
                seen.sent += message.len() + 4 + if message.len() < 126 { 2 } else { 4 };
            }
            socket.send(Message::binary(message)).await?;
        }
    }
    seen.unsettled = times.len() - settled;
    Ok(seen)
}

/// Read the frames of a message: the number that is settled, and the time that a pose took. Acknowledgements of all
/// poses.
fn acknowledge(
    mut message: &[u8],
    epoch: Instant,
    mut saw: impl FnMut(Option<u32>, Option<u32>),
) -> Result<Vec<u8>, Failure> {
    let mut answer = Vec::new();
    while !message.is_empty() {
        let (frame, rest) = FromServer::read(message).map_err(|fault| format!("{fault:?}"))?;
        match frame {
            FromServer::Pose { user, pose } => {
                let now = epoch.elapsed().as_micros() as u64;
                saw(None, Some(now.saturating_sub(pose.clock) as u32));
                FromUser::Ack { user, sequence: pose.sequence }.write(&mut answer);
            }
            FromServer::Settled { sequence } => saw(Some(sequence), None),
            FromServer::Refused { sentence, .. } => return Err(sentence.into()),
            _ => {}
        }
        message = rest;
    }
    Ok(answer)
}

/// A head, two hands and a pointer.
fn pose(sequence: u32, epoch: Instant) -> Pose {
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

/// CPU seconds that a process has taken.
fn cpu(process: u32) -> Result<f64, Failure> {
    let text = std::fs::read_to_string(format!("/proc/{process}/stat"))?;
    let fields: Vec<&str> = text.rsplit(')').next().unwrap_or_default().split_whitespace().collect();
    let ticks = |index: usize| fields.get(index).ok_or("too few fields")?.parse::<f64>().map_err(Failure::from);
    Ok((ticks(11)? + ticks(12)?) / TICKS)
}

/// Kilobytes of memory that a process has.
fn memory(process: u32) -> Result<f64, Failure> {
    let text = std::fs::read_to_string(format!("/proc/{process}/status"))?;
    let line = text.lines().find_map(|line| line.strip_prefix("VmRSS:")).ok_or("no size")?;
    Ok(line.trim().trim_end_matches(" kB").parse()?)
}

/// Share of poses that were in the server for at most a millisecond, and the bound that 99 % of them have not passed.
fn residence(address: SocketAddr) -> Result<(f64, f64), Failure> {
    let mut stream = std::net::TcpStream::connect(address)?;
    stream.write_all(b"GET /metrics HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n")?;
    let mut text = String::new();
    stream.read_to_string(&mut text)?;
    let mut buckets = Vec::new();
    for line in text.lines().filter_map(|line| line.strip_prefix("nearfar_room_residence_seconds_bucket{le=\"")) {
        let (bound, count) = line.split_once("\"} ").ok_or("no bucket")?;
        buckets.push((bound.parse::<f64>().unwrap_or(f64::INFINITY), count.parse::<f64>()?));
    }
    let all = buckets.last().ok_or("no buckets")?.1;
    let within = buckets.iter().rfind(|(bound, _)| *bound < 1.05e-3).map_or(0.0, |(_, count)| count / all);
    let bound = buckets.iter().find(|(_, count)| *count >= 0.99 * all).map_or(f64::INFINITY, |(bound, _)| *bound);
    Ok((within, bound))
}

fn tell(load: Load, seen: Vec<Seen>, [cpu, memory]: [f64; 2], (within, bound): (f64, f64)) {
    let all = |pick: fn(&Seen) -> &Vec<u32>| {
        let mut times: Vec<u32> = seen.iter().flat_map(|each| pick(each).iter().copied()).collect();
        times.sort_unstable();
        let at =
            |share: f64| times.get((times.len() as f64 * share) as usize).map_or(f64::NAN, |time| f64::from(*time));
        format!("{:.2} | {:.2}", at(0.5) / 1e3, at(0.99) / 1e3)
    };
    let sum = |pick: fn(&Seen) -> usize| seen.iter().map(pick).sum::<usize>() as f64;
    let each = load.users as f64 * load.seconds * load.hertz;
    let (others, pose) = ((load.group - 1) as f64, (HEAD + pose(0, Instant::now()).bytes()) as f64);
    let up = pose + others * ACK as f64;
    let down = others * (pose + 2.0) + SETTLED as f64;
    println!(
        "users | group | Hz | round trip, median ms | 99 % | way, median ms | 99 % | in the server: 99 % within ms |"
    );
    println!(
        "within 1.02 ms | CPU s per s | kB a user | B up per pose | closed form | B down per pose | closed form |"
    );
    println!("unsettled");
    println!(
        "{} | {} | {} | {} | {} | {:.3} | {:.4} | {:.3} | {memory:.1} | {:.1} | {up} | {:.1} | {down} | {}",
        load.users,
        load.group,
        load.hertz,
        all(|each| &each.round_trips),
        all(|each| &each.ways),
        bound * 1e3,
        within,
        cpu / load.seconds,
        sum(|each| each.sent) / each,
        sum(|each| each.received) / each,
        sum(|each| each.unsettled),
    );
}
