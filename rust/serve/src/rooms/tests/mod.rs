//! Tests of rooms, most of them with a server on this machine.

mod capabilities;
mod clock;
mod faults;
mod frames;
mod handshake;
mod leaving;
mod parts;
mod rules;
mod session_faults;
mod session_support;
mod sessions;
pub mod support;
mod tokens;
mod trials;
