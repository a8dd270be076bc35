//! Scenes: meshes shared between instances, objects as names of faces or instances, base colours and emission.

mod albedo;
mod edit;
mod instance;
mod levels;
mod material;
mod merge;
mod mesh;
pub mod meshopt;
mod normal;
pub mod polygons;
pub mod srgb;
mod texture;
pub mod wavefront;
mod world;

pub use albedo::{Spot, texel_density, texture_level};
pub use instance::{Instance, InstanceSet};
pub use levels::LevelMeshes;
pub use material::{Alpha, Material};
pub use merge::{PlacedMesh, merge};
pub use mesh::Mesh;
pub use normal::facing_normals;
pub use texture::{MipLevel, Texture};
pub use world::Scene;
