//! Rooms: users of one scene see each other's heads, hands and pointers.
//!
//! `socket` and `datagrams` are the transports of a user's frames; both use `session` and `outbox`. docs/rooms.md
//! specifies the frames and the rules.

pub(crate) mod about;
mod bucket;
mod datagrams;
pub(crate) mod door;
mod figures;
pub mod frame;
mod hub;
mod limits;
mod outbox;
mod places;
pub mod pose;
mod reason;
mod room;
mod session;
mod settle;
mod socket;
mod tap;
mod token;
#[cfg(any(test, fuzzing))]
#[path = "tests/trial.rs"]
pub mod trial;
pub(crate) mod upgrade;

#[cfg(test)]
pub(crate) mod tests;

pub use about::Datagrams;
pub(crate) use datagrams::{DATAGRAM, serve as serve_datagrams};
pub use hub::Rooms;
pub(crate) use hub::ending;
pub use limits::Limits;
pub use reason::Reason;
pub(crate) use session::{Entering, Session};
pub(crate) use socket::serve;
pub use token::{Key, Number};
