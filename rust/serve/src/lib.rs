//! Serves scenes to thin clients: files of bundles, and regions on demand.
//!
//! Nothing here knows Python; a binding gives what makes regions.

pub mod demand;
mod ranges;
mod regions;
mod respond;
mod router;
mod server;
pub mod site;

pub use axum::http::{HeaderName, HeaderValue};
pub use router::Router;
pub use server::{Limits, Server, Settings};
