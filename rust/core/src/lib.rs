//! Kernels of nearfar, in the order of the data flow. They use no Python, no files and no clock.
//!
//! # Glossary
//! - **near**, **far**: inside and outside the vertical cylinder of radius r₂ about the centre O.
//! - **standing** (static), **moving**: instances that never move, and dynamic instances whose poses change.
//! - **object**: a name of faces or instances. **Mesh**: triangles in their own frame. **Instance**: a placed mesh.
//! - **range**: distance from the eye in metres. **depth**: distance along the viewing axis.
//! - **ρ**: distance from the vertical axis through O.
//!
//! Conventions: metres, radians; right-handed, y up, cameras look along −z; row 0 on top.

pub mod base;
pub mod bvh;
pub mod scene;
pub mod camera;
pub mod cubemap;
pub mod trace;
pub mod partition;
pub mod morph;
pub mod bend;
pub mod tessellate;
pub mod render;
pub mod impostor;
pub mod stereo;
pub mod export;
pub mod exr;
pub mod metrics;
pub mod bounds;
pub mod lens;
pub mod lod;
pub mod orthoview;

#[cfg(test)]
mod tests;
