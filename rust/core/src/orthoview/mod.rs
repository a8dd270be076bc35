//! Orthoviews (Chaudhuri et al.): an octree of orthographic depth images of a world.
//!
//! Cells are cubes; a parent consists of eight children of half its side. Each cell has one view for each canonical
//! direction of the tree: q × q pixels that cover the cell's projection exactly. A parent is first drawn with 2 q × 2 q
//! pixels, which coincide with its children's pixels. A pixel stores a colour as sRGB bytes, a depth quantised in
//! equal steps, and an octahedrally encoded normal.

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
