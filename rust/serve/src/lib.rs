//! Serves scenes to thin clients: files of bundles, and regions on demand.
//!
//! Independent of Python; a binding provides the maker of regions.

mod clients;
pub mod log;
mod file;
mod gzip;
pub mod tls;
pub mod demand;
pub mod site;
mod respond;
mod regions;
mod webtransport;
pub mod rooms;
mod metrics;
mod offer;
mod router;
mod record;
mod connection;
mod quic;
mod server;

pub use axum::http::{HeaderName, HeaderValue};
pub use clients::Limits;
pub use router::{Router, ServerContent};
pub use server::{Server, Settings};
#[cfg(fuzzing)]
pub use webtransport::trial as session_trial;
