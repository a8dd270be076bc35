//! Regions of a scene, made when somebody asks for them.
//!
//! A request waits in a queue that shares the work between clients. A place that several ask for is made once; all of
//! them get its parts as they are ready. Work that nobody waits for ends. Regions that are complete are kept on disk.

mod cache;
mod figures;
mod leftover;
mod maker;
mod place;
mod queue;
mod region;
mod requests;
mod ticket;
mod workers;

pub use cache::{Cache, Kept, Whole};
pub use figures::Figures;
pub use maker::{Maker, Making, Part, Wanted};
pub use place::Place;
pub use region::{News, Outcome, Region};
pub use requests::{Answer, Demand, Limits, Refusal};
pub use ticket::{Event, Ticket};
