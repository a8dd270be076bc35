//! Cube maps: six square faces of texels. `lookup` reads values by direction and by cone; `layouts` converts cube maps
//! to and from equirectangular and octahedral pictures. This folder holds what both share, and mipmap levels.

mod environment;
mod faces;
mod layouts;
mod lookup;
mod mips;
mod solid;
#[cfg(test)]
mod tests;

pub use environment::EnvironmentMap;
pub use faces::{CubeFaces, MAX_SIZE, center_of, direction_from_texel, texel_from_direction};
pub use layouts::{Grid, Layout, Panorama, convert, convert_nearest, grid_directions, grid_texels};
pub use lookup::{Taps, TexelFilter, footprint, lookup, nearest};
pub use mips::{Reduction, next_level, next_size};
pub use solid::solid_angles;
