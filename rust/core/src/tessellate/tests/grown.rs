use glam::{DVec2, DVec3};
use proptest::prelude::*;

use super::{check_neighbours, greatest_miss, ground, pieces, point};
use crate::tessellate::rule::Rule;
use crate::tessellate::settings::{Precision, ServedMorphs, Settings};
use crate::tessellate::split::Piece;

const NEAR: f64 = 0.7;

fn settings(radii: [f64; 2], is_full: bool, reach: f64, tolerance: f64) -> Settings {
    let [least, r2] = radii;
    let served = ServedMorphs::Cylinder { least, is_full };
    let center = DVec3::new(1.0, 1.7, -2.0);
    Settings { center, r1: NEAR * r2, r2, drawn: f64::INFINITY, reach, tolerance, served }
}

/// Settings for which the bound holds, with a growth or without.
fn any_settings() -> impl Strategy<Value = Settings> {
    (3.0..60.0f64, 0.0..1.0f64, any::<bool>(), any::<bool>(), 0.02..0.49f64, 2e-3..2e-2f64).prop_map(
        |(r2, growth, grows, is_full, reach, tolerance)| {
            let least = if grows { r2 * (0.3 + 0.7 * growth) } else { r2 };
            let reach = if is_full { reach } else { reach / 4.0 };
            settings([least, r2], is_full, reach * NEAR * least, tolerance * (1.0 + 20.0 * reach))
        },
    )
}

/// Splits a triangle, scaled about its first corner, and compares its error with the bound.
fn check_bound([a, b, c]: [DVec3; 3], size: f64, settings: &Settings, seed: u64) -> Result<(), TestCaseError> {
    let rule = Rule::new(settings, Precision::Double).unwrap();
    prop_assert!(rule.require_bound().is_ok());
    let split = pieces([a, a + (b - a) * size, a + (c - a) * size], &rule);
    prop_assert!(split.len() < 600_000, "{}", split.len());
    let (morphs, points) = if split.len() > 500 { (4, 5) } else { (16, 10) };
    let greatest = greatest_miss(&split, settings, seed, morphs, points);
    prop_assert!(greatest <= settings.tolerance + 1e-12, "{greatest} of {}", settings.tolerance);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn no_user_sees_a_point_further_off_while_the_morph_grows(
        a in point(), b in point(), c in point(), settings in any_settings(), seed in any::<u64>(), size in 0.02..0.6f64,
    ) {
        check_bound([a, b, c], size, &Settings { tolerance: 2.0 * settings.tolerance, ..settings }, seed)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]
    #[test]
    #[ignore = "minutes without optimisation"]
    fn no_user_sees_a_point_further_off_in_many_cases(
        a in point(), b in point(), c in point(), settings in any_settings(), seed in any::<u64>(), size in 0.05..4.0f64,
    ) {
        check_bound([a, b, c], size, &settings, seed)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4096))]
    #[test]
    fn no_step_changes_the_stretch_by_more_than_its_bound(
        e in 0.01..0.5f64, kappa in 0.0..1.0f64, turn in 0.0..6.2f64, step in 0.0..6.2f64,
    ) {
        // In units of ρ, with the user at (e, 0).
        let (user, x) = (DVec2::new(e, 0.0), DVec2::from_angle(turn));
        let stretch = |x: DVec2, kappa: f64| {
            let y = x - user * kappa;
            let along = user.dot(y);
            ((along * along - y.length_squared() * (e * e - x.length_squared())).sqrt() - along) / y.length_squared()
        };
        let (d, tiny) = (DVec2::from_angle(step) * 1e-5, 1e-5);
        let by_place = (stretch(x + d, kappa) / stretch(x - d, kappa)).ln().abs() / 2e-5;
        prop_assert!(by_place <= e * (1.0 - kappa) / ((1.0 - e) * (1.0 - kappa * e)) + 1e-8);
        let by_eye = (stretch(x, kappa + tiny) / stretch(x, kappa - tiny)).ln().abs() / 2e-5;
        prop_assert!(by_eye <= e / (1.0 - (kappa + tiny) * e) + 1e-8);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn neighbours_get_the_same_vertices_and_pieces_cover_them(
        a in point(), b in point(), c in point(), d in point(), settings in any_settings(), single in any::<bool>(),
    ) {
        let settings = Settings { tolerance: 16.0 * settings.tolerance, ..settings };
        check_neighbours([a, b, c, d], &settings, single);
    }
}

#[test]
fn two_triangles_of_ground_are_bounded_tightly() {
    for (radii, is_full, tolerance, max_pieces) in
        [([10.0, 10.0], true, 6e-3, 8_000), ([22.0, 32.0], true, 6e-3, 9_000), ([10.0, 14.0], false, 2.4e-2, 50_000)]
    {
        let settings = settings(radii, is_full, 1.0, tolerance);
        let rule = Rule::new(&settings, Precision::Double).unwrap();
        let all: Vec<Piece> = ground(100.0).into_iter().flat_map(|corners| pieces(corners, &rule)).collect();
        let ratio = greatest_miss(&all, &settings, 3, 6, 4) / tolerance;
        // The bound covers the worst of all heights and directions, and all radii at once.
        assert!((0.05..=1.0).contains(&ratio), "{ratio} of {tolerance}, {} pieces", all.len());
        assert!(all.len() < max_pieces, "{}", all.len());
    }
}

#[test]
fn pieces_grow_with_the_height_above_the_centre() {
    let settings = settings([10.0, 10.0], true, 1.0, 4e-2);
    let rule = Rule::new(&settings, Precision::Double).unwrap();
    let count = |height: f64| {
        let [a, b, c, d] =
            [(-20.0, 0.0), (20.0, 0.0), (20.0, height), (-20.0, height)].map(|(x, y)| DVec3::new(x, y, 8.0));
        pieces([a, b, c], &rule).len() + pieces([a, c, d], &rule).len()
    };
    let counts = [10.0, 1e3, 1e6].map(count);
    // From 10 m to 1000 km the height doubles 17 times, and each doubling needs about as many pieces.
    assert!(counts[2] < 20 * counts[0], "{counts:?}");
}
