//! Reduced scenes: near geometry, morphed by the vertex shader, in front of an environment map.

mod near;
mod renderer;

pub use renderer::Reduced;
