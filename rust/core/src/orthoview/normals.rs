//! Normals as two integers: octahedral coordinates (Meyer, Süßmuth, Sußner, Stamminger, Greiner: On floating-point
//! normal vectors, 2010).

use glam::Vec3;

/// Encodes a unit normal as two integers of `bits` bits each.
pub fn encode(normal: Vec3, bits: u32) -> [u16; 2] {
    let normal = normal / normal.abs().element_sum();
    let (x, y) = if normal.z >= 0.0 {
        (normal.x, normal.y)
    } else {
        ((1.0 - normal.y.abs()).copysign(normal.x), (1.0 - normal.x.abs()).copysign(normal.y))
    };
    // The largest code, 2^bits − 1, is unused: an even number of steps gives 0 a code, so that axes are exact.
    let steps = ((1u32 << bits) - 2) as f32;
    let code = |value: f32| ((value * 0.5 + 0.5) * steps + 0.5) as u16;
    [code(x), code(y)]
}

/// Decodes two integers to a unit normal.
pub fn decode(code: [u16; 2], bits: u32) -> Vec3 {
    let steps = ((1u32 << bits) - 2) as f32;
    let [x, y] = code.map(|number| f32::from(number) / steps * 2.0 - 1.0);
    let z = 1.0 - x.abs() - y.abs();
    let fold = (-z).max(0.0);
    Vec3::new(x - fold.copysign(x), y - fold.copysign(y), z).normalize_or(Vec3::Z)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random;

    #[test]
    fn normals_are_restored_within_half_a_cell_and_axes_exactly() {
        // Maximum angles over many directions; a cell of the octahedron's map is largest at the axes.
        for (bits, limit) in [(8, 0.96f32), (12, 0.06)] {
            let mut worst = 0f32;
            for i in 0..200_000u64 {
                let draw = |n| random::uniform(7, n, i) as f32 * 2.0 - 1.0;
                let normal = Vec3::new(draw(0), draw(1), draw(2)).normalize_or(Vec3::X);
                let back = decode(encode(normal, bits), bits);
                worst = worst.max(back.cross(normal).length().asin().to_degrees());
                assert!(back.dot(normal) > 0.0);
            }
            assert!(worst < limit, "{bits} bits: {worst}°");
            for axis in [Vec3::X, Vec3::Y, Vec3::Z, Vec3::NEG_X, Vec3::NEG_Y, Vec3::NEG_Z] {
                assert_eq!(decode(encode(axis, bits), bits), axis);
            }
        }
    }
}
