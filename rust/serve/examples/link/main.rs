//! Emulates a network link between two namespaces with delay, bandwidth and loss, for Linux systems without `netem`;
//! needs root.
//!
//! `link NAMESPACE ADDRESS NAMESPACE ADDRESS DELAY_MS MBIT LOSS_PERCENT`, such as `link near 10.77.0.1 far 10.77.0.2 10
//! 100 1`, creates both namespaces with a TUN device in each, prints `ready`, and forwards packets until standard input
//! closes. Delay, bandwidth and loss apply to each direction.

#[cfg(target_os = "linux")]
mod linux;

fn main() -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
    #[cfg(target_os = "linux")]
    return linux::run(&std::env::args().skip(1).collect::<Vec<_>>());
    #[cfg(not(target_os = "linux"))]
    return Err("expected Linux, whose network namespaces and TUN devices the link uses".into());
}
