//! Load test for rooms: users send poses and acknowledge those of others; the server runs in its own process.
//!
//! `rooms_load USERS GROUP HERTZ SECONDS [OPTION VALUE] …`, such as `rooms_load 32 4 72 10`, prints measurements as
//! JSON: round-trip time (the paper's Eq. 3), one-way delay between users, residence time in the server, its CPU time
//! and memory, and bytes per user against the closed form. Options:
//!
//! - `--attack NAME`: eight other users misbehave meanwhile in the group of the first users.
//! - `--by WAY`: `websocket`, the default, or `datagrams`.
//! - `--stay SECONDS`: users leave and rejoin after this time.
//! - `--serve ADDRESS`: address at which the server listens, 127.0.0.1:0 by default.
//! - `--in NAMESPACE`: the server's network namespace, such as one end of the example `link`.

mod attack;
mod line;
mod options;
mod server;
mod told;
mod user;

use std::sync::Arc;
use std::time::{Duration, Instant};

use attack::{INTRUDERS, attack};
use line::Line;
use options::{Failure, Load};
use server::Process;
use tokio::sync::Barrier;
use told::Took;
use user::{Seen, WARM};

/// Number of samples of the server's memory.
const LOOKS: u32 = 10;

fn main() -> Result<(), Failure> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let [first, address] = &arguments[..]
        && first == "serve"
    {
        return server::serve(address.parse()?);
    }
    let load = Load::read(&arguments)?;
    let process = Process::start(&load)?;
    let runtime = tokio::runtime::Builder::new_multi_thread().worker_threads(2).enable_all().build()?;
    let (seen, took) = runtime.block_on(run(&load, &process))?;
    let residence = process.residence()?;
    process.stop()?;
    println!("{:#}", told::figures(&load, &seen, &took, residence));
    Ok(())
}

/// Runs all users until the time is over.
async fn run(load: &Load, process: &Process) -> Result<(Vec<Seen>, Took), Failure> {
    let alone = process.kilobytes()?;
    let (epoch, together) = (Instant::now(), Arc::new(Barrier::new(load.users + 1)));
    let mut users = Vec::new();
    for number in 0..load.users {
        let line = Line::join(load, number, &process.listens).await?;
        let (together, load, listens) = (Arc::clone(&together), load.clone(), process.listens.clone());
        users.push(tokio::spawn(async move {
            together.wait().await;
            user::play(&load, number, &listens, epoch, line).await
        }));
    }
    let attacks = load.attack.map_or(0..0, |_| 0..INTRUDERS).zip(load.attack.into_iter().cycle());
    let attacks: Vec<_> =
        attacks.map(|(number, kind)| tokio::spawn(attack(kind, process.listens.address, number, epoch))).collect();
    together.wait().await;
    tokio::time::sleep(WARM).await;
    let (before, mut kilobytes) = (process.cpu_seconds()?, Vec::new());
    for _ in 0..LOOKS {
        tokio::time::sleep(Duration::from_secs_f64(load.seconds) / LOOKS).await;
        kilobytes.push(process.kilobytes()?);
    }
    let cpu_seconds = process.cpu_seconds()? - before;
    let kilobytes_per_user = (process.kilobytes()? - alone) / load.users as f64;
    let mut seen = Vec::new();
    for user in users {
        seen.push(user.await??);
    }
    attacks.iter().for_each(|attack| attack.abort());
    Ok((seen, Took { cpu_seconds, kilobytes_per_user, kilobytes }))
}
