//! Tests of rooms, most of them with a server on this machine.

mod clock;
mod faults;
mod frames;
mod handshake;
mod parts;
mod rules;
mod settled;
mod seats;
mod slow;
mod support;
mod tokens;
mod trials;
mod vectors;
