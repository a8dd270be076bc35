//! Bindings of `scene`.

pub mod decode;
pub mod levels;
pub mod mesh;
#[expect(clippy::module_inception, reason = "the file of the class Scene")]
pub mod scene;
pub mod stored;

pub use mesh::Mesh;
pub use scene::Scene;
pub(crate) use scene::texture;
