//! Regions of a scene, made on request.
//!
//! Requests wait in a queue that is fair between clients. A region that several clients request is made once; all of
//! them get its parts as they become ready. Abandoned work is cancelled. Complete regions are cached on disk.

mod cache;
mod region;
mod requests;
mod state;
mod workers;

pub use cache::Cache;
pub use region::{CompleteRegion, Maker, Outcome, Part, PartMaker, Place, Region, Wanted};
pub use requests::{Answer, Demand, Event, Limits, Refusal, Ticket};
pub use state::Statistics;
