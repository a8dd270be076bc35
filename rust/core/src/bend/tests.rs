use glam::{DVec2, DVec3};
use proptest::prelude::*;

use super::curve::MAX_CHORDS;
use super::*;
use crate::morph::{Kind, Morph};

fn morph(user: [f64; 3]) -> Morph {
    Morph::new(DVec3::from_array(user), DVec3::new(3.0, 1.7, -2.0), 30.0, 50.0, Kind::Blend).unwrap()
}

fn angle(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}

/// Returns the angle between a ray's direction and the direction in which the morph shows a point of the ray's curve.
fn direction_error(morph: &Morph, point: DVec3, direction: DVec3) -> f64 {
    angle(morph.apply(point) - morph.user, direction)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]
    #[test]
    fn vertices_are_shown_in_the_rays_direction_and_chords_within_the_tolerance(
        x in -9.0..9.0f64, y in -5.0..5.0f64, z in -9.0..9.0f64,
        azimuth in 0.0..std::f64::consts::TAU, elevation in -1.55..1.55f64, log_tolerance in -6.0..-2.0f64,
    ) {
        let center = DVec3::new(3.0, 1.7, -2.0);
        let morph = morph((center + DVec3::new(x, y, z)).to_array());
        let direction = DVec3::new(azimuth.cos() * elevation.cos(), elevation.sin(), azimuth.sin() * elevation.cos());
        let tolerance = 10f64.powf(log_tolerance);
        let points = RayCurve::new(&morph, direction).polyline(tolerance);
        prop_assert_eq!(points[0], morph.user);
        for &point in &points[1..] {
            // Coordinates of up to 2,500 m are rounded to 5e-13 m.
            prop_assert!(direction_error(&morph, point, direction) < 1e-10);
        }
        for leg in points[1..].windows(2) {
            for i in 0..=64 {
                let point = leg[0].lerp(leg[1], f64::from(i) / 64.0);
                prop_assert!(direction_error(&morph, point, direction) <= tolerance);
            }
        }
        if points.len() == 1 {
            // The user is at the centre or looks along the line through it.
            return Ok(());
        }
        let last = points[points.len() - 1] - morph.center;
        prop_assert!((on_ground(last).length() - 50.0).abs() < 1e-9);
        prop_assert!(angle(last, direction) < 1e-12);
    }

    #[test]
    fn chords_of_weaker_morphs_meet_the_tolerance_also_beside_the_user_and_the_centre(
        x in -3.0..3.0f64, y in -3.0..3.0f64, z in -3.0..3.0f64, strength in 0.0..1.0f64, r1 in 4.5..30.0f64,
        azimuth in 0.0..std::f64::consts::TAU, elevation in -1.5..1.5f64, log_tolerance in -4.0..-2.0f64,
    ) {
        let user = DVec3::new(x, y, z);
        let morph = Morph::new(user, DVec3::ZERO, r1, 50.0, Kind::Blend).unwrap().with_strength(strength).unwrap();
        let direction = DVec3::new(azimuth.cos() * elevation.cos(), elevation.sin(), azimuth.sin() * elevation.cos());
        let tolerance = 10f64.powf(log_tolerance);
        for leg in RayCurve::new(&morph, direction).polyline(tolerance).windows(2) {
            for i in 0..=128 {
                let share = 10f64.powf(-7.0 * (1.0 - f64::from(i % 65) / 64.0));
                let point = leg[usize::from(i > 64)].lerp(leg[usize::from(i <= 64)], 0.5 * share);
                // Nearer to U and O the rounding of positions is an angle.
                if point.distance(user).min(point.length()) > 1e-9 {
                    prop_assert!(direction_error(&morph, point, direction) <= tolerance);
                }
            }
        }
    }

    #[test]
    fn curves_end_for_any_user_and_radii(
        x in -90.0..90.0f64, y in -50.0..50.0f64, z in -90.0..90.0f64, r1 in 0.0..40.0f64, width in 1e-3..40.0f64,
        dx in -1.0..1.0f64, dy in -1.0..1.0f64, dz in -1.0..1.0f64, strength in 0.0..2.0f64,
    ) {
        let full = Morph::new(DVec3::new(x, y, z), DVec3::ZERO, r1, r1 + width, Kind::Blend).unwrap();
        let morph = full.with_strength(strength.min(1.0)).unwrap();
        let direction = DVec3::new(dx, dy, dz).normalize_or(DVec3::Y);
        let points = RayCurve::new(&morph, direction).polyline(1e-4);
        // At most four stretches: two beside U or O, each cut where it crosses r₁.
        prop_assert!(!points.is_empty() && points.len() < 4 * (MAX_CHORDS / 1e-4f64.sqrt()) as usize);
        prop_assert!(points.iter().all(|point| point.is_finite()));
    }

    #[test]
    fn points_in_the_interval_are_inside_the_cylinder(
        x in -20.0..20.0f64, z in -20.0..20.0f64, dx in -1.0..1.0f64, dy in -1.0..1.0f64, dz in -1.0..1.0f64,
        radius in 0.1..15.0f64, s in 0.0..60.0f64,
    ) {
        let (start, direction) = (DVec2::new(x, z), on_ground(DVec3::new(dx, dy, dz).normalize_or(DVec3::Y)));
        let interval = within_cylinder(start, direction, radius);
        let rho = (start + direction * s).length();
        let inside = interval.is_some_and(|(enter, leave)| (enter..=leave).contains(&s));
        // Rounding of squares of up to 800 m², divided by twice the radius.
        prop_assert!(inside == (rho <= radius) || (rho - radius).abs() < 1e-11);
    }
}

#[test]
fn vertical_rays_lie_inside_a_cylinder_entirely_or_not_at_all() {
    assert_eq!(within_cylinder(DVec2::new(3.0, 0.0), DVec2::ZERO, 3.0), Some((0.0, f64::INFINITY)));
    assert_eq!(within_cylinder(DVec2::new(3.5, 0.0), DVec2::ZERO, 3.0), None);
}

#[test]
fn nothing_bends_at_the_centre_or_upwards_or_along_the_offset() {
    let center = DVec3::new(3.0, 1.7, -2.0);
    for (user, direction) in [
        (center, DVec3::new(0.3, 0.1, -0.7)),
        (center + DVec3::new(5.0, 0.0, 2.0), DVec3::Y),
        (center + DVec3::new(4.0, 0.0, 0.0), DVec3::X),
    ] {
        let morph = morph(user.to_array());
        assert_eq!(RayCurve::new(&morph, direction.normalize()).polyline(1e-6), [user]);
    }
}

#[test]
fn curves_of_users_between_the_radii_are_straight_within_r1() {
    let morph = Morph::new(DVec3::new(12.0, 0.0, 1.0), DVec3::ZERO, 10.0, 50.0, Kind::Blend).unwrap();
    let curve = RayCurve::new(&morph, DVec3::NEG_X);
    let stretches = curve.stretches();
    assert_eq!(stretches.iter().map(|s| s.is_straight).collect::<Vec<_>>(), [false, true, false]);
    assert!(stretches.windows(2).all(|pair| pair[0].to == pair[1].from));
}

#[test]
fn margins_scale_with_all_lengths() {
    let margin_in =
        |unit: f64| margin(&Morph::new(DVec3::ZERO, DVec3::ZERO, 0.75 * unit, unit, Kind::Blend).unwrap()).unwrap();
    let expected = margin_in(1.0);
    for exponent in [-1060, -1022, -600, -1, 3, 500, 1020] {
        let unit = (0.5 * f64::from(exponent)).floor().exp2() * (0.5 * f64::from(exponent)).ceil().exp2();
        assert!((margin_in(unit) / unit - expected).abs() < 1e-4, "{exponent}");
    }
    let least = f64::from_bits(1);
    assert!(margin(&Morph::new(DVec3::ZERO, DVec3::ZERO, 0.0, least, Kind::Blend).unwrap()).unwrap() <= least);
}

#[test]
fn margins_equal_a_dense_search() {
    // Found by finite differences on a grid of 41 × 41 × 61 points: (r1, r2, height of U above O, margin at O), metres.
    let cases = [
        (30.0, 50.0, 0.0, 19.112),
        (30.0, 50.0, 5.0, 18.586),
        (30.0, 50.0, 25.0, 15.384),
        (40.0, 50.0, 0.0, 9.763),
        (10.0, 50.0, 60.0, 11.941),
        // The fold lies next to the user, at (r1 + r2) / 3.
        (5.0, 25.0, 0.0, 10.0),
    ];
    for (r1, r2, height, expected) in cases {
        for away in [0.0, 7.0] {
            let user = DVec3::new(away * 0.6, height, away * 0.8);
            let found = margin(&Morph::new(user, DVec3::ZERO, r1, r2, Kind::Blend).unwrap()).unwrap();
            // The nearest point of the grid lies up to half a metre from the worst point.
            assert!((found - (expected - away)).abs() < 0.02 * (r2 - r1), "{r1} {r2} {height} {found}");
        }
    }
    let cylinder = Morph::new(DVec3::new(8.0, 3.0, 6.0), DVec3::ZERO, 35.0, 50.0, Kind::Cylinder).unwrap();
    assert_eq!(margin(&cylinder).unwrap(), 25.0);
}
