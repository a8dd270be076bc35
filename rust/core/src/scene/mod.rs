//! Scenes: meshes shared between instances, objects that group faces or instances, base colours and emission.

mod albedo;
mod compact;
mod edit;
mod instance;
mod join;
mod levels;
mod material;
mod merge;
mod mesh;
pub mod meshopt;
mod normal;
pub mod ply;
pub mod polygons;
mod query;
mod sampler;
pub mod srgb;
pub mod stored;
mod texture;
pub mod wavefront;
mod world;

pub use albedo::{Spot, texel_density, texture_level};
pub use instance::{Instance, InstanceSet};
pub use join::Joined;
pub use levels::LevelMeshes;
pub use material::{Alpha, Material};
pub(crate) use merge::is_mirror;
pub use merge::{PlacedMesh, merge};
pub use mesh::Mesh;
pub(crate) use mesh::flipped;
pub use normal::facing_normals;
pub use query::{Queried, Region};
pub use sampler::{Sampler, Wrap};
pub use texture::{MipLevel, Texture};
pub use world::Scene;
