//! Placements as translation, rotation and scale, and the factors by which they multiply rounding errors.

use glam::{DAffine3, DMat3, DQuat, DVec3};

use crate::base::Aabb;

/// Placement as float32 translation, unit quaternion (x, y, z, w) and scale; the scale is applied first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Trs {
    pub translation: [f32; 3],
    pub rotation: [f32; 4],
    pub scale: [f32; 3],
}

impl Trs {
    /// Decomposes a placement; shear is lost.
    pub fn decompose(to_scene: &DAffine3) -> Self {
        let (scale, rotation, translation) = to_scene.to_scale_rotation_translation();
        Self {
            translation: translation.as_vec3().to_array(),
            rotation: rotation.as_quat().to_array(),
            scale: scale.as_vec3().to_array(),
        }
    }

    /// Returns the maximum distance per axis between the two placements of a box's points.
    pub fn error(&self, to_scene: &DAffine3, bounds: &Aabb) -> f64 {
        let rotation = DQuat::from_array(self.rotation.map(f64::from)).normalize();
        let [scale, translation] = [self.scale, self.translation].map(|v| DVec3::from_array(v.map(f64::from)));
        let composed = DAffine3::from_scale_rotation_translation(scale, rotation, translation);
        displacement(to_scene, &composed, bounds)
    }
}

/// Returns whether a placement without its shear displaces the points of a box by at most a tolerance per axis.
pub(super) fn is_trs(to_scene: &DAffine3, bounds: &Aabb, tolerance: f64) -> bool {
    let (scale, rotation, translation) = to_scene.to_scale_rotation_translation();
    let recomposed = DAffine3::from_scale_rotation_translation(scale, rotation.normalize(), translation);
    displacement(to_scene, &recomposed, bounds) <= tolerance
}

/// Returns the maximum difference per axis between two placements of a box. It is largest at a corner, because each
/// axis' difference is affine in the point.
fn displacement(a: &DAffine3, b: &DAffine3, bounds: &Aabb) -> f64 {
    let ends = [bounds.min.as_dvec3(), bounds.max.as_dvec3()];
    let corner = |i: usize| DVec3::new(ends[i & 1].x, ends[i >> 1 & 1].y, ends[i >> 2 & 1].z);
    let distance = |point: DVec3| (a.transform_point3(point) - b.transform_point3(point)).abs().max_element();
    (0..8).map(|i| distance(corner(i))).fold(0.0, f64::max)
}

/// Returns the maximum factor by which a placement lengthens a line; an upper bound with shear. The factor is the
/// square root of the largest eigenvalue of MᵀM, which the maximum row sum of absolute values bounds.
pub(super) fn scale(matrix: &DMat3) -> f64 {
    stretch(&(matrix.transpose() * *matrix)).sqrt()
}

/// Returns the factor by which a placement multiplies an error per axis: the maximum row sum of absolute values.
pub(super) fn stretch(matrix: &DMat3) -> f64 {
    (matrix.x_axis.abs() + matrix.y_axis.abs() + matrix.z_axis.abs()).max_element()
}

/// Returns an upper bound of `stretch` for all rotations of a placement: an error of 1 per axis is a vector of length
/// √3, which the placement lengthens by at most `scale`.
pub(super) fn greatest_stretch(matrix: &DMat3) -> f64 {
    (3.0 * stretch(&(matrix.transpose() * *matrix))).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random::uniform;

    fn rotation(seed: u64) -> DQuat {
        let [x, y, z] = [0, 1, 2].map(|index| 6.0 * uniform(seed, 0, index));
        DQuat::from_euler(glam::EulerRot::XYZ, x, y, z)
    }

    fn placement(seed: u64) -> DAffine3 {
        let vector = |cell| DVec3::from_array([0, 1, 2].map(|index| uniform(seed, cell, index)));
        DAffine3::from_scale_rotation_translation(vector(1) + 0.5, rotation(seed), vector(2) * 1000.0)
    }

    #[test]
    fn parts_of_a_placement_equal_the_placement() {
        let bounds = Aabb { min: glam::Vec3::splat(-3.0), max: glam::Vec3::splat(5.0) };
        for seed in 0..50 {
            let to_scene = placement(seed);
            // Half of float32's step at 1000 m is 2⁻¹⁵ m; rotation and scale add three roundings of 2⁻²⁴ for 12 m.
            assert!(Trs::decompose(&to_scene).error(&to_scene, &bounds) < 1.2 * 2f64.powi(-15), "{seed}");
            assert!(is_trs(&to_scene, &bounds, 1e-9), "{seed}");
            let sheared =
                to_scene * DAffine3::from_mat3(DMat3::from_cols(DVec3::X, DVec3::new(0.1, 1.0, 0.0), DVec3::Z));
            assert!(!is_trs(&sheared, &bounds, 1e-3), "{seed}");
            let mirrored = to_scene * DAffine3::from_scale(DVec3::new(1.0, -1.0, 1.0));
            assert!(is_trs(&mirrored, &bounds, 1e-9), "{seed}");
        }
    }

    #[test]
    fn stretches_bound_the_errors_of_points() {
        for seed in 0..50 {
            let matrix = placement(seed).matrix3;
            let error =
                |i: u64| DVec3::from_array([0, 1, 2].map(|axis| 2.0 * uniform(seed, 3 + axis, i) - 1.0)).signum();
            let worst = (0..40).map(|i| (matrix * error(i)).abs().max_element()).fold(0.0, f64::max);
            assert!((worst - stretch(&matrix)).abs() < 1e-12, "{seed}: all signs occur");
            let turned = DMat3::from_quat(rotation(seed + 1)) * matrix;
            assert!(stretch(&turned) <= greatest_stretch(&matrix), "{seed}");
        }
        let sheared = DMat3::from_cols(DVec3::X, DVec3::new(3.0, 1.0, 0.0), DVec3::Z);
        let line = (sheared * DVec3::new(0.3, 0.95, 0.0)).length() / DVec3::new(0.3, 0.95, 0.0).length();
        assert!(scale(&sheared) >= line && scale(&sheared) < 1.1 * line);
        let turned = DMat3::from_quat(rotation(7)) * DMat3::from_diagonal(DVec3::new(1.0, -2.5, 0.5));
        assert!((scale(&turned) - 2.5).abs() < 1e-12);
        assert!((greatest_stretch(&DMat3::from_diagonal(DVec3::new(1.0, 2.0, 0.5))) - 12f64.sqrt()).abs() < 1e-12);
    }
}
