//! Reduced scenes: NSF, morphed by the vertex shader, in front of an environment map.

mod nsf;
mod renderer;

pub use renderer::Reduced;
