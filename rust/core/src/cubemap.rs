//! Cube maps: six square faces +x −x +y −y +z −z in the Vulkan/WebGPU orientation.

use glam::DVec3;

/// Direction (not normalised; its longest component is ±1) of a point on a face; u to the right, v down, each −1..1.
#[inline]
pub fn direction_from_face(face: u8, u: f64, v: f64) -> DVec3 {
    match face {
        0 => DVec3::new(1.0, -v, -u),
        1 => DVec3::new(-1.0, -v, u),
        2 => DVec3::new(u, 1.0, v),
        3 => DVec3::new(u, -1.0, -v),
        4 => DVec3::new(u, -v, 1.0),
        _ => DVec3::new(-u, -v, -1.0),
    }
}
