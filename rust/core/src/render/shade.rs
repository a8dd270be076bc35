//! Shading formula of all renderers: linear albedo × (sky(n) + sun · max(0, n·l)) + emission, two-sided. Here n is the
//! surface normal and l the direction towards the sun. For unlit materials the sum in parentheses is 1, its maximum.
//! Emission may exceed 1, because there is no tone mapping.
//!
//! Sky and sun are coloured. The bluish sky is brighter above than below and slightly asymmetric, so that walls in the
//! shade differ. The warm sun meets the three axes at different angles, so that lit walls differ.

use glam::Vec3;

/// Unit direction towards the sun.
pub const SUN_DIRECTION: Vec3 = Vec3::new(0.526_315_8, 0.789_473_7, 0.315_789_5);
/// Linear RGB of the sun.
pub const SUN: [f32; 3] = [0.60, 0.56, 0.50];
/// Unit direction of the brightest sky.
pub const SKY_DIRECTION: Vec3 = Vec3::new(-0.206_284_3, 0.928_279_1, 0.309_426_4);
/// Linear RGB of the sky for surfaces that face away from its brightest direction, and towards it.
pub const SKY: [[f32; 3]; 2] = [[0.130, 0.135, 0.150], [0.380, 0.420, 0.480]];
/// Linear RGB of the background at the nadir, the horizon and the zenith.
pub const BACKGROUND: [[f32; 3]; 3] = [[0.24, 0.25, 0.26], [0.66, 0.74, 0.82], [0.16, 0.34, 0.66]];

/// Returns the radiance of the background in a unit direction.
#[inline]
pub fn background(direction: Vec3) -> [f32; 3] {
    let [nadir, horizon, zenith] = BACKGROUND;
    let weight = direction.y.abs().sqrt();
    let end = if direction.y < 0.0 { nadir } else { zenith };
    std::array::from_fn(|i| horizon[i] + (end[i] - horizon[i]) * weight)
}

/// Returns the linear RGB reflected by a white surface with unit normal `n` towards the viewer.
#[inline]
pub fn irradiance(n: Vec3) -> [f32; 3] {
    let sky = 0.5 + 0.5 * n.dot(SKY_DIRECTION);
    let sun = n.dot(SUN_DIRECTION).max(0.0);
    std::array::from_fn(|i| SKY[0][i] + (SKY[1][i] - SKY[0][i]) * sky + SUN[i] * sun)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns evenly spaced directions: a Fibonacci lattice.
    fn sphere(count: u32) -> impl Iterator<Item = Vec3> {
        (0..count).map(move |i| {
            let (y, turn) = (1.0 - 2.0 * (i as f32 + 0.5) / count as f32, i as f32 * 2.399_963_2);
            let radius = (1.0 - y * y).sqrt();
            Vec3::new(radius * turn.cos(), y, radius * turn.sin())
        })
    }

    #[test]
    fn white_is_at_most_one_and_black_is_nowhere() {
        for n in sphere(100_000).chain([SUN_DIRECTION, SKY_DIRECTION]) {
            let light = irradiance(n);
            assert!(light.iter().all(|&x| (0.1..=1.0).contains(&x)), "{n} {light:?}");
            assert!(background(n).iter().all(|&x| (0.1..=1.0).contains(&x)));
        }
    }

    #[test]
    fn directions_are_unit() {
        assert!(SUN_DIRECTION.is_normalized() && SKY_DIRECTION.is_normalized());
    }

    #[test]
    fn the_six_sides_of_a_box_differ() {
        let sides = [Vec3::X, Vec3::Y, Vec3::Z, Vec3::NEG_X, Vec3::NEG_Y, Vec3::NEG_Z].map(|n| irradiance(n)[1]);
        for (i, a) in sides.iter().enumerate() {
            // A fiftieth in linear light is about 6 of sRGB's 255 steps at middle grey, which makes an edge visible.
            assert!(sides[..i].iter().all(|b| (a - b).abs() > 0.02), "{sides:?}");
        }
    }
}
