//! Cameras: position, orientation and projection of a view; rays; depth buffers; orientation of cube-map faces.

mod cube_face;
mod depth;
mod rays;
mod view;

pub use cube_face::{along_face, direction_from_face, face_from_direction};
pub use depth::{Depth, DepthBuffer, Planes, Ranged};
pub use rays::{Footprint, Rays};
pub use view::{Camera, Fov, MAX_SIZE, Projection};
