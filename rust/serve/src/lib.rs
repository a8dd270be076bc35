//! Serves scenes to thin clients: files of bundles, and regions on demand.
//!
//! Nothing here knows Python; a binding gives what makes regions.

mod clients;
mod connection;
pub mod demand;
mod file;
mod flow;
pub mod log;
mod metrics;
mod open;
mod packed;
mod quic;
mod ranges;
mod record;
mod regions;
mod respond;
pub mod rooms;
mod router;
mod server;
pub mod site;
pub mod tls;

pub use axum::http::{HeaderName, HeaderValue};
#[cfg(fuzzing)]
pub use quic::trial as session_trial;
pub use router::{Answering, Router};
pub use server::{Limits, Server, Settings};
