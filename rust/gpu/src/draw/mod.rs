//! Frames: what is drawn in which order, where it goes, and how it comes back.

mod bindings;
mod cull;
mod encode;
mod job;
mod kept;
mod layers;
mod pipelines;
mod read;
mod slots;
mod view;

pub use job::Job;
pub use kept::DeviceFrame;

pub(crate) use cull::Frustum;
pub(crate) use layers::{Kind, Layer, Names, Picture, Set, Sources, Split};
pub(crate) use pipelines::{Pipelines, VISIBLE};
pub(crate) use slots::{SAMPLES, Slots};
pub(crate) use view::Axes;
