//! Rooms: users of one scene see each other's heads, hands and pointers.
//!
//! `socket` is one way by which a user's messages come and go; others need `session` and `outbox`. docs/rooms.md
//! describes the frames and the rules.

mod bucket;
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
pub mod trial;
pub(crate) mod upgrade;

#[cfg(test)]
mod tests;

pub use hub::Rooms;
pub(crate) use hub::ending;
pub use limits::Limits;
pub use reason::Reason;
pub(crate) use session::{Entering, Session};
pub(crate) use socket::serve;
pub use token::{Key, Number};
