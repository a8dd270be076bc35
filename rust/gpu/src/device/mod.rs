//! Adapters, the device opened on one, and the state kept on it between frames.

mod adapters;
mod buffers;
mod errors;
mod extensions;
mod open;
mod registry;
mod wait;

pub use adapters::{AdapterKind, AdapterReport};
pub use buffers::Counters;
pub use open::Device;
pub use registry::{adapters, close, device, end_without_drivers, is_hardware};

pub(crate) use adapters::{SAMPLES, VISIBILITY_FORMAT};
pub(crate) use buffers::{Counter, PipelineCache};
pub(crate) use errors::Scope;
pub(crate) use extensions::lock;
pub(crate) use wait::{Submission, UNREADABLE};
