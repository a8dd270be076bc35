//! The link: TUN devices, and threads that carry packets between them.

use std::fs::{File, OpenOptions};
use std::io::{Read, Write};
use std::os::fd::AsRawFd;
use std::process::Command;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread;
use std::time::{Duration, Instant};

pub type Failure = Box<dyn std::error::Error + Send + Sync>;

/// Maximum size of a packet, bytes.
const PACKET: usize = 1500;
/// Maximum number of packets in flight per direction.
const MAX_IN_FLIGHT: usize = 1 << 14;
/// Longest queueing delay; a packet that would wait longer is dropped, as routers do.
const QUEUE: Duration = Duration::from_millis(50);

/// One direction of the link.
#[derive(Clone, Copy)]
struct Direction {
    delay: Duration,
    /// Bandwidth, bits per second.
    rate: f64,
    /// Packet loss rate.
    loss: f64,
    /// State of the random number generator for losses.
    random: u64,
}

/// Runs the link until standard input closes.
pub fn run(arguments: &[String]) -> Result<(), Failure> {
    let [near, near_address, far, far_address, delay, rate, loss] = arguments else {
        return Err("expected NAMESPACE ADDRESS NAMESPACE ADDRESS DELAY_MS MBIT LOSS_PERCENT".into());
    };
    let delay = Duration::from_secs_f64(delay.parse::<f64>()? / 1e3);
    let (rate, loss) = (rate.parse::<f64>()? * 1e6, loss.parse::<f64>()? / 100.0);
    let near_device = create_end(near, near_address, far_address)?;
    let far_device = create_end(far, far_address, near_address)?;
    let forth = (near_device.try_clone()?, far_device.try_clone()?, 1);
    for (from, to, random) in [forth, (far_device, near_device, 2)] {
        forward(from, to, Direction { delay, rate, loss, random });
    }
    println!("ready");
    std::io::stdin().read_to_end(&mut Vec::new())?;
    for namespace in [near, far] {
        ip(&["netns", "del", namespace])?;
    }
    Ok(())
}

/// Creates a namespace with a TUN device, a point-to-point link from `address` to `peer`.
fn create_end(namespace: &str, address: &str, peer: &str) -> Result<File, Failure> {
    let device = format!("nf-{namespace}");
    ip(&["netns", "add", namespace])?;
    let file = tun(&device)?;
    // Moving the device to the namespace keeps the open file valid.
    ip(&["link", "set", &device, "netns", namespace])?;
    let ip_inside = |arguments: &[&str]| ip(&[&["-n", namespace], arguments].concat());
    ip_inside(&["link", "set", "lo", "up"])?;
    ip_inside(&["address", "add", address, "peer", peer, "dev", &device])?;
    ip_inside(&["link", "set", &device, "mtu", &PACKET.to_string(), "up"])?;
    Ok(file)
}

fn ip(arguments: &[&str]) -> Result<(), Failure> {
    let status = Command::new("ip").args(arguments).status()?;
    if status.success() { Ok(()) } else { Err(format!("ip {}: {status}", arguments.join(" ")).into()) }
}

/// Creates a TUN device; each read and write is one packet.
fn tun(name: &str) -> Result<File, Failure> {
    let file = OpenOptions::new().read(true).write(true).open("/dev/net/tun")?;
    // SAFETY: ifreq consists of numbers, for which zeros are valid.
    let mut request: libc::ifreq = unsafe { std::mem::zeroed() };
    for (to, from) in request.ifr_name.iter_mut().zip(name.bytes()) {
        *to = from as libc::c_char;
    }
    request.ifr_ifru.ifru_flags = (libc::IFF_TUN | libc::IFF_NO_PI) as i16;
    // SAFETY: the file is open, and TUNSETIFF reads and writes one ifreq, which outlives the call.
    if unsafe { libc::ioctl(file.as_raw_fd(), libc::TUNSETIFF, &raw mut request) } < 0 {
        return Err(std::io::Error::last_os_error().into());
    }
    Ok(file)
}

/// Forwards packets in one direction, in two threads.
fn forward(from: File, to: File, direction: Direction) {
    let (sender, receiver) = sync_channel(MAX_IN_FLIGHT);
    thread::spawn(move || receive_packets(from, &sender, direction));
    thread::spawn(move || send_packets(to, &receiver));
}

/// Reads packets, drops some, and queues the others with the times at which they are due.
fn receive_packets(mut from: File, sender: &SyncSender<(Instant, Vec<u8>)>, mut direction: Direction) -> Option<()> {
    // `idle_at`: time at which the link has sent all queued packets.
    let (mut packet, mut idle_at) = ([0; PACKET], Instant::now());
    loop {
        let length = from.read(&mut packet).ok()?;
        let now = Instant::now();
        idle_at = idle_at.max(now);
        if idle_at - now > QUEUE || direction.loses() {
            continue;
        }
        idle_at += Duration::from_secs_f64(8.0 * length as f64 / direction.rate);
        sender.send((idle_at + direction.delay, packet[..length].to_vec())).ok()?;
    }
}

fn send_packets(mut to: File, receiver: &Receiver<(Instant, Vec<u8>)>) -> Option<()> {
    loop {
        let (due, packet) = receiver.recv().ok()?;
        thread::sleep(due.saturating_duration_since(Instant::now()));
        // A device that is down, or whose queue is full, drops the packet.
        let _ = to.write(&packet);
    }
}

impl Direction {
    /// Whether the next packet is lost (SplitMix64).
    fn loses(&mut self) -> bool {
        self.random = self.random.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.random ^ (self.random >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let share = (mixed ^ (mixed >> 31)) as f64 / u64::MAX as f64;
        share < self.loss
    }
}
