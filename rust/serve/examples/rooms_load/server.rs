//! The server, in its own process.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::process::{Child, Command, Stdio};
use std::sync::Arc;

use nearfar_serve::rooms::{self, Rooms};
use nearfar_serve::{Router, Server, ServerContent, Settings};

use crate::options::{Failure, Load};

/// Maximum number of rooms and of connections.
const MAX: usize = 1 << 14;
/// Clock ticks per second in `/proc`.
const TICKS: f64 = 100.0;

/// Runs the server until standard input closes.
pub fn serve(address: SocketAddr) -> Result<(), Failure> {
    let defaults = rooms::Limits::default();
    // All users may share one address.
    let limits = rooms::Limits {
        rooms: MAX,
        users: 1 << 10,
        sockets_per_client: MAX,
        rooms_per_client: MAX,
        // The load may use the full message rate for poses.
        poses_per_second: defaults.messages_per_second,
        ..defaults
    };
    let rooms = Some(Arc::new(Rooms::new(limits, None)?));
    let server_content = ServerContent { sites: [].into(), hosts: None, headers: Vec::new(), origin: None, rooms };
    let limits = nearfar_serve::Limits { connections: MAX, per_client: MAX, ..Default::default() };
    let server = Server::start(Settings { address, limits, certificate: None, router: Router::new(server_content) })?;
    let datagrams = server.datagrams().ok_or("no datagrams")?;
    println!("{} {} {}", server.address(), datagrams.port, datagrams.hashes.concat());
    std::io::stdin().read_to_end(&mut Vec::new())?;
    Ok(())
}

/// Process of the server.
pub struct Process {
    child: Child,
    pub address: ServerAddress,
}

/// Addresses at which the server listens.
#[derive(Clone)]
pub struct ServerAddress {
    pub http: SocketAddr,
    /// UDP port of WebTransport, and hash of its certificate.
    pub datagrams: (u16, String),
}

impl Process {
    pub fn start(load: &Load) -> Result<Self, Failure> {
        let program = std::env::current_exe()?;
        let mut command = match &load.namespace {
            None => Command::new(program),
            // `ip netns exec` replaces itself by the program, so the process ID stays valid.
            Some(namespace) => {
                let mut command = Command::new("ip");
                command.args(["netns", "exec", namespace]).arg(program);
                command
            }
        };
        command.arg("serve").arg(load.serve.to_string());
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
        let mut line = String::new();
        BufReader::new(child.stdout.take().ok_or("no output")?).read_line(&mut line)?;
        let [http, port, hash] = line.split_whitespace().collect::<Vec<_>>()[..] else {
            return Err("the server does not listen".into());
        };
        let address = ServerAddress { http: http.parse()?, datagrams: (port.parse()?, hash.to_owned()) };
        Ok(Process { child, address })
    }

    pub fn stop(mut self) -> Result<(), Failure> {
        drop(self.child.stdin.take());
        self.child.wait()?;
        Ok(())
    }

    /// CPU time used, seconds.
    pub fn cpu_seconds(&self) -> Result<f64, Failure> {
        let text = std::fs::read_to_string(format!("/proc/{}/stat", self.child.id()))?;
        let fields: Vec<&str> = text.rsplit(')').next().unwrap_or_default().split_whitespace().collect();
        let ticks = |index: usize| fields.get(index).ok_or("too few fields")?.parse::<f64>().map_err(Failure::from);
        Ok((ticks(11)? + ticks(12)?) / TICKS)
    }

    /// Resident memory, kilobytes.
    pub fn kilobytes(&self) -> Result<f64, Failure> {
        let text = std::fs::read_to_string(format!("/proc/{}/status", self.child.id()))?;
        let line = text.lines().find_map(|line| line.strip_prefix("VmRSS:")).ok_or("no size")?;
        Ok(line.trim().trim_end_matches(" kB").parse()?)
    }

    /// Fraction of poses that spent at most 1.024 ms in the server, which is a bound of the histogram, and an upper
    /// bound of the 99th percentile in seconds.
    pub fn residence(&self) -> Result<(f64, f64), Failure> {
        let mut stream = TcpStream::connect(self.address.http)?;
        let request = format!("GET /metrics HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n", self.address.http);
        stream.write_all(request.as_bytes())?;
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
}
