//! WebTransport over a QUIC connection: the subset of HTTP/3 that a session needs.

pub mod session;
#[cfg(any(test, fuzzing))]
#[path = "tests/trial.rs"]
pub mod trial;
pub mod wire;
