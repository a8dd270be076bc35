//! Drawing of frames: instance sets drawn in order, each in its style, and the resulting images.

mod cull;
mod device_frame;
mod encode;
mod inputs;
mod job;
mod picture;
mod pipelines;
mod plan;
mod read;
mod slots;
mod style;
mod timing;
mod view;
mod window;

pub use device_frame::DeviceFrame;
pub use job::Job;

pub(crate) use picture::{Backdrop, Layer, Picture, Set, Sources};
pub(crate) use pipelines::shading_constants;
pub(crate) use style::{Cut, Displacement, Parameters, Snippet, Style};
pub(crate) use view::Axes;
pub(crate) use window::Mask;
