//! Bindings of `scene`.

pub mod levels;
pub mod mesh;
pub mod meshopt;
pub mod parts;
pub mod placements;
pub mod polygons;
#[expect(clippy::module_inception, reason = "the file of the class Scene")]
pub mod scene;
pub mod stored;
pub mod wavefront;

pub use mesh::Mesh;
pub use scene::Scene;
pub(crate) use scene::texture;
