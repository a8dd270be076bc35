//! Regions of a scene, made on request.
//!
//! Requests wait in a queue that is fair between clients. A region that several clients request is made once; all of
//! them get its parts as they become ready. Abandoned work is cancelled. Complete regions are cached on disk.

mod cache;
mod maker;
mod place;
mod queue;
mod region;
mod requests;
mod ticket;
mod unlisted;
mod workers;

pub use cache::{Cache, CompleteRegion, RegionFile};
pub use maker::{Maker, Making, Part, Wanted};
pub use place::Place;
pub use region::{Outcome, Region};
pub use requests::{Answer, Demand, Limits, Refusal};
pub use ticket::{Event, Ticket};
pub use workers::Figures;
