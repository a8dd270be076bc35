//! Rooms: users of one scene see each other's heads, hands and pointers.
//!
//! A frame is a binary message, not a picture. `socket` and `datagrams` are the transports of a user's frames; both use
//! `session` and `outbox`. docs/rooms.md specifies the frames and the rules.

mod datagrams;
mod statistics;
pub mod frame;
mod hub;
mod limits;
mod outbox;
pub mod pose;
mod reason;
pub(crate) mod requests;
mod room;
mod session;
mod settle;
mod socket;
mod token;
#[cfg(any(test, fuzzing))]
#[path = "tests/trial.rs"]
pub mod trial;

#[cfg(test)]
pub(crate) mod tests;

pub(crate) use datagrams::{MAX_DATAGRAM_BYTES, serve as serve_datagrams};
pub use hub::Rooms;
pub(crate) use hub::shutdown_end;
pub use limits::Limits;
pub(crate) use outbox::Outbox;
pub use reason::Reason;
pub use requests::Datagrams;
pub(crate) use session::{Entrance, Session};
pub(crate) use socket::{Duplex, serve};
pub use token::{Key, TokenNumber};
