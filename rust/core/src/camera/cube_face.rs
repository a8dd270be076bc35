//! The six faces of a cube, +x −x +y −y +z −z, in the Vulkan/WebGPU orientation.
//!
//! | face | right (u) | down (v) |
//! | --- | --- | --- |
//! | +x | −z | −y |
//! | −x | +z | −y |
//! | +y | +x | +z |
//! | −y | +x | −z |
//! | +z | +x | −y |
//! | −z | −x | −y |

use glam::DVec3;

/// Returns the direction through a point of a face: u to the right, v down, −1 to 1. Its longest component is ±1.
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

/// Returns the components of a vector along a face's right, down and outward directions.
#[inline]
pub fn along_face(face: u8, d: DVec3) -> (f64, f64, f64) {
    match face {
        0 => (-d.z, -d.y, d.x),
        1 => (d.z, -d.y, -d.x),
        2 => (d.x, d.z, d.y),
        3 => (d.x, -d.z, -d.y),
        4 => (d.x, -d.y, d.z),
        _ => (-d.x, -d.y, -d.z),
    }
}

/// Returns the face, u and v of a direction of any length: the inverse of `direction_from_face`. Ties between
/// components go to the alphabetically first axis.
#[inline]
pub fn face_from_direction(d: DVec3) -> (u8, f64, f64) {
    // Tables instead of branches, which the processor would mispredict for random directions.
    let size = d.abs();
    let not_x = (size.x < size.y) | (size.x < size.z);
    let axis = usize::from(not_x) + usize::from(not_x & (size.y < size.z));
    let major = [d.x, d.y, d.z][axis];
    let sign = 1.0f64.copysign(major);
    let u = [-sign * d.z, d.x, sign * d.x][axis] / major.abs();
    let v = [-d.y, sign * d.z, -d.y][axis] / major.abs();
    (2 * axis as u8 + u8::from(major < 0.0), u, v)
}
