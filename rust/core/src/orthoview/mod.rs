//! Orthoviews (Chaudhuri et al.): an octree of orthographic depth images of a world.
//!
//! A leaf is a cubic cell of side s, a parent the eight cells of half its side. Each cell has a view from each of some
//! canonical directions: q × q pixels that cover its projection tightly, so the pixels of a child lie on those of its
//! parent's picture at twice the size. Colours are sRGB bytes, depths codes of equal steps, normals octahedral codes.

mod cell;
mod connect;
pub mod cut;
mod direction;
mod leaf;
mod normals;
mod parent;
mod raster;
mod reduce;
pub mod splat;
pub mod steady;
mod surfaces;
mod unseen;
mod view;

pub use cell::Cell;
pub use connect::{Bounds, connected, surfels};
pub use direction::{Direction, Frame};
pub use leaf::SurfaceMethod;
pub use parent::Parent;
pub use unseen::unseen;
pub use view::{Format, Texel, View, Views};
