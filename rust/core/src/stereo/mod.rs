//! Hybrid mono-stereo rendering (Fink et al. 2019): near geometry for each eye, one shared picture beyond a plane.
//!
//! Head axes have their origin in the middle between the eyes: x to the right, y up, looking along −z. The mono plane
//! lies m metres ahead, z = −m, for any rotation of the eyes. The third camera C stands s metres behind the middle.

mod assembly;
mod contents;
mod error;
mod head;
mod needed;
mod resolved;
mod rig;
#[cfg(test)]
mod tests;
mod zone;

pub use contents::{Contents, Triangles};
pub use error::Axis;
pub use head::Head;
pub use resolved::FarPicture;
pub use rig::{Eye, Planes, Rig, Side};
