//! Serves scenes to thin clients: files of bundles, and regions on demand.
//!
//! Nothing here knows Python; a binding gives what makes regions.

pub mod demand;
