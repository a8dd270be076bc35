use glam::DVec3;
use proptest::prelude::*;

use super::*;
use crate::base::Progress;

/// Radius of the smallest enclosing sphere, by brute force over all spheres that one to four points determine.
fn brute_force_radius(points: &[[f64; 3]]) -> f64 {
    let points: Vec<DVec3> = points.iter().map(|&point| point.into()).collect();
    let mut least = f64::INFINITY;
    let mut try_center = |center: DVec3| {
        let radius = points.iter().map(|point| (*point - center).length()).fold(0.0, f64::max);
        if center.is_finite() {
            least = least.min(radius);
        }
    };
    for (i, &a) in points.iter().enumerate() {
        try_center(a);
        for (j, &b) in points.iter().enumerate().skip(i + 1) {
            try_center((a + b) / 2.0);
            for (k, &c) in points.iter().enumerate().skip(j + 1) {
                try_center(bounding::equidistant(&[a, b, c]));
                for &d in points.iter().skip(k + 1) {
                    try_center(bounding::equidistant(&[a, b, c, d]));
                }
            }
        }
    }
    least
}

proptest! {
    #[test]
    fn few_points_have_the_smallest_sphere(
        points in prop::collection::vec(prop::array::uniform3(-1.0..1.0f64), 1..9), flat: bool, shift in -1e3..1e3f64,
    ) {
        let points: Vec<[f64; 3]> =
            points.iter().map(|&[x, y, z]| [x + shift, y - shift, if flat { shift } else { z }]).collect();
        let found = bounding_sphere(&points, SphereMethod::Exact, &Progress::new()).unwrap();
        prop_assert!((found.radius - brute_force_radius(&points)).abs() <= 1e-12);
        for method in [SphereMethod::Ritter, SphereMethod::Average, SphereMethod::MinMax, SphereMethod::Best] {
            prop_assert!(bounding_sphere(&points, method, &Progress::new()).unwrap().radius >= found.radius * (1.0 - 1e-12));
        }
    }

    #[test]
    fn spheres_of_many_points_contain_all(seed in 0..1000u32, count in 4000..9000usize, thin in 0.0..1.0f64) {
        let unit = |n: usize, axis: u64| crate::base::random::uniform(u64::from(seed), axis, n as u64) - 0.5;
        let points: Vec<[f64; 3]> = (0..count).map(|n| [unit(n, 0), unit(n, 1) * thin, unit(n, 2)]).collect();
        let found = bounding_sphere(&points, SphereMethod::Exact, &Progress::new()).unwrap();
        let farthest = points.iter().map(|&p| (DVec3::from(p) - found.center).length()).fold(0.0, f64::max);
        prop_assert!(farthest <= found.radius * (1.0 + 4.0 * f64::EPSILON));
        let narrow = bounding_sphere(&points[..4000], SphereMethod::Exact, &Progress::new()).unwrap();
        prop_assert!(narrow.radius <= found.radius * (1.0 + 1e-14));
    }
}

#[test]
fn nan_radii_are_refused() {
    let refused = |radius: f64| check_spheres(&[[0.0; 3]], &[radius], DVec3::ONE, 0).is_err();
    assert_eq!([f64::NAN, f64::INFINITY, -1e-300, -0.0, 0.0].map(refused), [true, true, true, false, false]);
}
