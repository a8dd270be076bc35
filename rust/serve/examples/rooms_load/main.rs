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
mod connection;
mod options;
mod report;
mod server;
mod user;

use std::sync::Arc;
use std::time::{Duration, Instant};

use attack::{INTRUDERS, attack};
use connection::UserConnection;
use options::{Failure, Load};
use report::{ServerUsage, report};
use server::Process;
use tokio::sync::Barrier;
use user::{Measurements, WARM_UP};

/// Number of samples of the server's memory.
const MEMORY_SAMPLES: u32 = 10;

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
    let (measurements, usage) = runtime.block_on(run(&load, &process))?;
    let residence = process.residence()?;
    process.stop()?;
    println!("{:#}", report(&load, &measurements, &usage, residence));
    Ok(())
}

/// Runs all users until the time is over.
async fn run(load: &Load, process: &Process) -> Result<(Vec<Measurements>, ServerUsage), Failure> {
    let idle_kilobytes = process.kilobytes()?;
    let (epoch, start) = (Instant::now(), Arc::new(Barrier::new(load.users + 1)));
    let mut users = Vec::new();
    for number in 0..load.users {
        let connection = UserConnection::join(load, number, &process.address).await?;
        let (start, load, address) = (Arc::clone(&start), load.clone(), process.address.clone());
        users.push(tokio::spawn(async move {
            start.wait().await;
            user::play(&load, number, &address, epoch, connection).await
        }));
    }
    let mut attacks = Vec::new();
    if let Some(kind) = load.attack {
        attacks.extend((0..INTRUDERS).map(|number| tokio::spawn(attack(kind, process.address.http, number, epoch))));
    }
    start.wait().await;
    tokio::time::sleep(WARM_UP).await;
    let (before, mut kilobytes) = (process.cpu_seconds()?, Vec::new());
    for _ in 0..MEMORY_SAMPLES {
        tokio::time::sleep(Duration::from_secs_f64(load.seconds) / MEMORY_SAMPLES).await;
        kilobytes.push(process.kilobytes()?);
    }
    let cpu_seconds = process.cpu_seconds()? - before;
    let kilobytes_per_user = (process.kilobytes()? - idle_kilobytes) / load.users as f64;
    let mut measurements = Vec::new();
    for user in users {
        measurements.push(user.await??);
    }
    attacks.iter().for_each(|attack| attack.abort());
    Ok((measurements, ServerUsage { cpu_seconds, kilobytes_per_user, kilobytes }))
}
