use glam::DVec3;
use proptest::prelude::*;

use super::blend::{Constants, block};
use super::lanes::BLOCK;
use super::stream::blend_block;
use super::{Kind, Morph};
use crate::base::Progress;

fn blend(user: DVec3, center: DVec3) -> Morph {
    Morph::new(user, center, 30.0, 50.0, Kind::Blend).unwrap()
}

/// Computes Eq. 1–3 as printed, relative to the centre.
fn printed_formula(morph: &Morph, p: DVec3) -> DVec3 {
    let u = morph.user - morph.center;
    let rho = p.x.hypot(p.z);
    let w = ((morph.r2 - rho) / (morph.r2 - morph.r1)).clamp(0.0, 1.0);
    let d = (w * (p - u).normalize() + (1.0 - w) * p.normalize()).normalize();
    u + (w * (p - u).length() + (1.0 - w) * p.length()) * d
}

fn point(reach: f64) -> impl Strategy<Value = DVec3> {
    (-reach..reach, -reach..reach, -reach..reach).prop_map(DVec3::from)
}

proptest! {
    #[test]
    fn scalar_and_printed_forms_agree(p in point(60.0), u in point(15.0), o in point(1e3)) {
        let morph = blend(o + u, o);
        let expected = printed_formula(&morph, p);
        let shown = morph.apply(o + p) - o;
        // A dozen roundings at coordinates of 10³ m; the error of w grows by r₂/(r₂−r₁) = 2.5.
        prop_assert!((shown - expected).length() < 1e-11, "{shown} {expected}");
    }

    #[test]
    fn float32_streams_keep_their_bound(
        p in prop::collection::vec(point(70.0), 200), u in point(25.0), o in point(1e7),
    ) {
        let morph = blend(o + u, o);
        let points: Vec<[f32; 3]> = p.iter().map(|&p| (o + p).as_vec3().to_array()).collect();
        let mut shown = vec![[0.0; 3]; points.len()];
        morph.apply_all(&points, &mut shown, &Progress::new()).unwrap();
        for (point, shown) in points.iter().zip(&shown) {
            let exact = morph.apply(DVec3::from_array(point.map(f64::from)));
            for axis in 0..3 {
                let step = f64::from((exact[axis] as f32).abs().next_up() - (exact[axis] as f32).abs());
                // The documented bound, plus 4e-9 m for the float64 oracle's own rounding at 10⁷ m.
                let bound = 0.5 * step + 2f64.powi(-24) * (6.0 + 3.0 * 2.5) * u.length() + 4e-9;
                prop_assert!((f64::from(shown[axis]) - exact[axis]).abs() <= bound, "{point:?} {shown:?} {exact}");
            }
        }
    }

    #[test]
    fn float64_streams_agree_with_the_scalar_form(p in prop::collection::vec(point(70.0), 200), u in point(25.0)) {
        let morph = blend(u, DVec3::ZERO);
        let points: Vec<[f64; 3]> = p.iter().map(DVec3::to_array).collect();
        let mut shown = vec![[0.0; 3]; points.len()];
        morph.apply_all(&points, &mut shown, &Progress::new()).unwrap();
        for (&p, &shown) in p.iter().zip(&shown) {
            // Two dozen float64 roundings at 100 m.
            prop_assert!((DVec3::from_array(shown) - morph.apply(p)).length() < 1e-12);
        }
    }

    #[test]
    fn both_kinds_of_wide_blocks_agree_with_the_scalar_form(
        p in prop::collection::vec(point(70.0), 1..200), u in point(60.0), is_blend in any::<bool>(), strength in 0.0..2.0f64,
    ) {
        // The radii are too close for the blend kernel in the points' own precision.
        let (kind, r1) = if is_blend { (Kind::Blend, 49.0) } else { (Kind::Cylinder, 35.0) };
        let full = Morph::new(u, DVec3::ZERO, r1, 50.0, kind).unwrap();
        let morph = full.with_strength(strength.min(1.0)).unwrap();
        let points: Vec<[f64; 3]> = p.iter().map(DVec3::to_array).chain([u.to_array(), [0.0; 3]]).collect();
        let single: Vec<[f32; 3]> = points.iter().map(|p| p.map(|x| x as f32)).collect();
        let (mut shown, mut shown_single) = (vec![[0.0; 3]; points.len()], vec![[0.0; 3]; points.len()]);
        morph.apply_all(&points, &mut shown, &Progress::new()).unwrap();
        morph.apply_all(&single, &mut shown_single, &Progress::new()).unwrap();
        for i in 0..points.len() {
            let exact = morph.apply(DVec3::from_array(points[i]));
            // The error of w grows by 50, more for steep exits or near the cylinder of the user's own radius.
            prop_assert!((DVec3::from_array(shown[i]) - exact).length() < 1e-8 * (1.0 + exact.length()));
            let exact = morph.apply(DVec3::from_array(single[i].map(f64::from)));
            let single = DVec3::from_array(shown_single[i].map(f64::from));
            // Rounded once to float32.
            prop_assert!((single - exact).length() < 1.2e-7 * (1.0 + exact.length()));
        }
    }

    #[test]
    fn the_cylinder_kind_keeps_rho(p in point(80.0), u in point(10.0)) {
        let morph = Morph::new(u, DVec3::ZERO, 30.0, 50.0, Kind::Cylinder).unwrap();
        let (rho, shown) = (p.x.hypot(p.z), morph.apply(p));
        prop_assume!(rho > u.x.hypot(u.z) + 1.0);
        // The exit is a root of a quadratic equation with coefficients of size 10⁴; steep directions divide by |d_h|,
        // which is at least 0.01 here.
        prop_assert!((shown.x.hypot(shown.z) - rho).abs() < 1e-9 * (1.0 + shown.length()));
    }
}

#[test]
fn points_inside_keep_their_bits_and_points_beyond_shift() {
    let (user, center) = (DVec3::new(1e7 + 3.0, 1.7, 2.0), DVec3::new(1e7, 1.7, -1.0));
    let morph = blend(user, center);
    let ring = |rho: f64, count: u32| {
        (0..count).map(move |i| {
            let angle = f64::from(i);
            let p = center + DVec3::new(rho * angle.cos(), angle * 7.0, rho * angle.sin());
            [p.x as f32, p.y as f32, p.z as f32]
        })
    };
    let points: Vec<[f32; 3]> = ring(10.0, 99).chain(ring(40.0, 33)).chain(ring(500.0, 99)).collect();
    let mut shown = vec![[0.0; 3]; points.len()];
    assert_eq!(morph.apply_all(&points, &mut shown, &Progress::new()).unwrap(), 0);
    for (&point, &shown) in points.iter().zip(&shown) {
        let p = DVec3::from_array(point.map(f64::from));
        let rho = (p.x - center.x).hypot(p.z - center.z);
        if rho <= 30.0 {
            assert_eq!(point.map(f32::to_bits), shown.map(f32::to_bits));
        } else if rho >= 50.0 {
            assert_eq!(shown, (p + (user - center)).as_vec3().to_array());
        }
    }
}

#[test]
fn every_width_of_vectors_gives_the_same_bits() {
    let morph = blend(DVec3::new(4.0, 1.0, -3.0), DVec3::ZERO);
    let points: [[f32; 3]; BLOCK] = std::array::from_fn(|i| {
        let i = i as f32;
        [i.sin() * (20.0 + i), i.cos() * 9.0, (i * 0.7).cos() * (20.0 + i)]
    });
    let (mut narrow, mut widest) = ([[0.0; 3]; BLOCK], [[0.0; 3]; BLOCK]);
    let constants = Constants::new(&morph);
    assert_eq!(block(&constants, &points, &mut narrow), blend_block(&constants, &points, &mut widest));
    assert_eq!(narrow, widest);
}

#[test]
fn both_radii_are_crossed_continuously() {
    for kind in [Kind::Blend, Kind::Cylinder] {
        let morph = Morph::new(DVec3::new(4.0, 1.0, -3.0), DVec3::ZERO, 30.0, 50.0, kind).unwrap();
        for radius in [30.0, 50.0] {
            for height in [-2.0, 0.0, 400.0] {
                let shown = |rho: f64| morph.apply(DVec3::new(rho, height, 0.0));
                // w changes by 5e-14 over the step of 1e-12 m; points at 400 m move by at most w · |U−O| · 20.
                assert!((shown(radius - 5e-13) - shown(radius + 5e-13)).length() < 1e-10, "{kind:?} {radius} {height}");
            }
        }
    }
}

#[test]
fn degenerate_positions_have_results() {
    let center = DVec3::new(5.0, 1.5, 5.0);
    // If the user is at the centre, nothing moves.
    for kind in [Kind::Blend, Kind::Cylinder] {
        let still = Morph::new(center, center, 30.0, 50.0, kind).unwrap();
        for p in [center, center + DVec3::Y * 400.0, DVec3::new(46.0, 3.0, 4.0), DVec3::new(1e5, -3.0, 1e5)] {
            assert_eq!(still.apply(p), p);
        }
        let morph = Morph::new(center + DVec3::X, center, 30.0, 50.0, kind).unwrap();
        for p in [center, morph.user, center + DVec3::Y * 400.0, center + DVec3::new(10.0, 400.0, 0.0)] {
            assert_eq!(morph.apply(p), p);
        }
        // The user's eye in the intermediate zone, at the point itself.
        let outside = Morph::new(center + DVec3::X * 40.0, center, 30.0, 50.0, kind).unwrap();
        let shown = outside.examine(outside.user);
        assert!(shown.point.is_finite() && !shown.opposed);
    }
    // A point halfway between the radii, with the user twice as far out on the same side: opposed directions.
    let morph = Morph::new(center + DVec3::X * 80.0, center, 30.0, 50.0, Kind::Blend).unwrap();
    let shown = morph.examine(center + DVec3::X * 40.0);
    assert!(shown.opposed && shown.point.is_finite());
    let points = [[45f32, 1.5, 5.0]; 70];
    let mut out = [[0.0; 3]; 70];
    assert_eq!(morph.apply_all(&points, &mut out, &Progress::new()).unwrap(), 70);
    // Without near geometry w is 0 and ρ does not change.
    let none = Morph::new(center + DVec3::X, center, 0.0, 0.0, Kind::Cylinder).unwrap();
    let shown = none.apply(center + DVec3::X * 40.0);
    assert!((shown - (center + DVec3::X * 40.0)).length() < 1e-13);
}

#[test]
fn invalid_settings_are_refused() {
    let (o, nan) = (DVec3::ZERO, f64::NAN);
    for (user, center, r1, r2) in [
        (DVec3::splat(nan), o, 30.0, 50.0),
        (o, DVec3::splat(f64::INFINITY), 30.0, 50.0),
        (o, o, -1.0, 50.0),
        (o, o, 50.0, 50.0),
        (o, o, 30.0, nan),
        (o, o, nan, 50.0),
    ] {
        assert!(Morph::new(user, center, r1, r2, Kind::Blend).is_err());
    }
    assert!(Morph::new(o, o, 0.0, 0.0, Kind::Blend).is_ok());
    let morph = Morph::new(DVec3::X, o, 30.0, 50.0, Kind::Blend).unwrap();
    for strength in [-1e-9, 1.0 + 1e-9, nan] {
        assert!(morph.with_strength(strength).is_err());
    }
    let mut shown = [[0.0; 3]; 1];
    morph.apply_all(&[[f32::NAN; 3]], &mut shown, &Progress::new()).unwrap();
    assert!(shown[0].iter().all(|x| x.is_nan()));
}

#[test]
fn far_distances_equal_those_of_far_points() {
    let center = DVec3::new(2.0, 1.7, -3.0);
    for offset in [DVec3::ZERO, DVec3::new(6.0, 0.5, -4.0), DVec3::new(-80.0, 2.0, 30.0)] {
        for kind in [Kind::Blend, Kind::Cylinder] {
            let morph = Morph::new(center + offset, center, 30.0, 50.0, kind).unwrap();
            for direction in [DVec3::X, DVec3::new(0.3, -0.1, -0.7), DVec3::new(-0.6, 2.0, 0.5)].map(DVec3::normalize) {
                for range in [51.0, 90.0, 200.0, 4e3].map(|rho| rho / direction.x.hypot(direction.z)) {
                    let shown = morph.apply(center + direction * range);
                    let expected = (shown - morph.user).length();
                    // Float64 roundings of kilometres.
                    assert!((morph.far_distance(direction, range) - expected).abs() < 1e-10 * range);
                    assert!((shown - morph.user).normalize().dot(direction) > 1.0 - 1e-12);
                }
            }
            assert_eq!(morph.far_distance(DVec3::X, f64::INFINITY), f64::INFINITY);
            assert_eq!(morph.far_distance(DVec3::Y, 7.0), 7.0);
        }
    }
}
