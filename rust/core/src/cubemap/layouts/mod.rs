//! Layouts that show all directions in one picture (cube, equirectangular, octahedral), and conversions between them.

mod convert;
mod flat;
mod layout;
mod picture;
mod projections;

pub use convert::{convert, convert_nearest, grid_directions, grid_texels};
pub use layout::{Grid, Layout};
pub use picture::Panorama;
