mod grown;

use std::collections::BTreeSet;

use glam::DVec3;
use proptest::prelude::*;

use super::grown_bound::MAX_RATIO;
use super::rule::Rule;
use super::settings::{Precision, ServedMorphs, Settings};
use super::split::Piece;
use super::{SplitCounts, tessellate_arrays};
use crate::base::{Progress, random};
use crate::morph::{Kind, Morph};

fn settings(reach: f64, tolerance: f64) -> Settings {
    let center = DVec3::new(1.0, 1.7, -2.0);
    Settings { center, r1: 30.0, r2: 50.0, drawn: 50.0, reach, tolerance, served: ServedMorphs::Blend }
}

fn pieces(corners: [DVec3; 3], rule: &Rule) -> Vec<Piece> {
    Piece::of_triangle(corners).split(rule, Precision::Double, |_| false, |_| Ok(())).unwrap()
}

/// Returns a generator of random numbers from 0 to 1.
fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut count = 0;
    move || {
        count += 1;
        random::uniform(seed, 0, count)
    }
}

/// Returns the maximum angle between the interpolated morph of a piece's corners and the exact morph, at some points:
/// middles of edges, the centroid, and random ones.
fn miss(morph: &Morph, corners: &[DVec3; 3], points: usize, next: &mut impl FnMut() -> f64) -> f64 {
    let angle = |point: usize| {
        let [s, t, u] = match point {
            0 => [0.5, 0.5, 0.0],
            1 => [0.0, 0.5, 0.5],
            2 => [0.5, 0.0, 0.5],
            3 => [1.0 / 3.0; 3],
            _ => {
                let (s, t) = (next(), next());
                let (s, t) = if s + t > 1.0 { (1.0 - s, 1.0 - t) } else { (s, t) };
                [s, t, 1.0 - s - t]
            }
        };
        let [a, b, c] = *corners;
        let exact = morph.apply(a * s + b * t + c * u) - morph.user;
        let [a, b, c] = corners.map(|corner| morph.apply(corner) - morph.user);
        let interpolated = a * s + b * t + c * u;
        exact.cross(interpolated).length().atan2(exact.dot(interpolated))
    };
    (0..points).map(angle).fold(0.0, f64::max)
}

/// Returns the maximum error at some points of each piece, for random users, radii and strengths within the settings.
/// Most users stand at the region's border.
fn greatest_miss(pieces: &[Piece], settings: &Settings, seed: u64, morphs: usize, points: usize) -> f64 {
    let Settings { center, r1, r2, reach, .. } = *settings;
    let mut next = numbers(seed);
    let mut greatest: f64 = 0.0;
    for _ in 0..morphs {
        let aim = DVec3::new(next() - 0.5, (next() - 0.5) * next(), next() - 0.5).normalize_or_zero();
        let user = center + aim * reach * next().powf(0.1);
        let (kind, radius, strength, exempt) = match settings.served {
            ServedMorphs::Blend => (Kind::Blend, r2, 1.0, 0.0),
            ServedMorphs::Cylinder { least, is_full: true } => {
                (Kind::Cylinder, least + (r2 - least) * next(), 1.0, 0.0)
            }
            ServedMorphs::Cylinder { least, is_full: false } => {
                let strength = if next() < 0.3 { 1.0 } else { next() };
                (Kind::Cylinder, least + (r2 - least) * next(), strength, 1.15 * reach / MAX_RATIO)
            }
        };
        let morph = Morph::new(user, center, r1 * (radius / r2), radius, kind).unwrap();
        let morph = morph.with_strength(strength).unwrap();
        let is_bounded = |piece: &&Piece| piece.corners.iter().all(|&p| settings.on_ground(p).length() >= exempt);
        for piece in pieces.iter().filter(is_bounded) {
            greatest = greatest.max(miss(&morph, &piece.corners, points, &mut next));
        }
    }
    greatest
}

fn ground(extent: f64) -> [[DVec3; 3]; 2] {
    let corner = |x: f64, z: f64| DVec3::new(x * extent, 0.0, z * extent);
    let [a, b, c, d] = [corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)];
    [[a, b, c], [a, c, d]]
}

fn area([a, b, c]: &[DVec3; 3]) -> DVec3 {
    (*b - *a).cross(*c - *a) / 2.0
}

/// Splits a triangle, checks that its pieces cover it, and returns the bits of all vertices on its first edge.
fn split_edge(corners: [DVec3; 3], rule: &Rule, precision: Precision) -> BTreeSet<[u64; 3]> {
    let pieces = Piece::of_triangle(corners).split(rule, precision, |_| false, |_| Ok(())).unwrap();
    // Area vectors: a flipped piece would reduce the sum. New vertices are rounded, to 4e-6 m for float32.
    let sum: DVec3 = pieces.iter().map(|piece| area(&piece.corners)).sum();
    assert!((sum - area(&corners)).length() <= 1e-4 * (1.0 + area(&corners).length()));
    let mut bits = BTreeSet::new();
    for (corner, [s, t, u]) in pieces.iter().flat_map(|piece| piece.corners.into_iter().zip(piece.weights)) {
        let expected = corners[0] * s + corners[1] * t + corners[2] * u;
        assert!((expected - corner).length() < 1e-4);
        // On the first edge the weight of the third corner is exactly 0.
        if u == 0.0 {
            bits.insert(corner.to_array().map(f64::to_bits));
        }
    }
    bits
}

/// Checks that triangles abc and bad get the same vertices on their common edge.
fn check_neighbours(corners: [DVec3; 4], settings: &Settings, single: bool) {
    let precision = if single { Precision::Single } else { Precision::Double };
    let [a, b, c, d] = corners.map(|p| precision.round(p));
    let rule = Rule::new(settings, precision).unwrap();
    assert_eq!(split_edge([a, b, c], &rule, precision), split_edge([b, a, d], &rule, precision));
}

fn point() -> impl Strategy<Value = DVec3> {
    (-80.0..80.0f64, -5.0..60.0f64, -80.0..80.0f64).prop_map(|(x, y, z)| DVec3::new(x, y, z))
}

/// Radii, reach and tolerance for which the bound holds.
fn any_settings() -> impl Strategy<Value = Settings> {
    (5.0..60.0f64, 2.0..60.0f64, 0.02..0.5f64, 3e-4..1e-2f64).prop_map(|(r1, width, reach, tolerance)| Settings {
        r1,
        r2: r1 + width,
        drawn: r1 + width,
        reach: reach * r1,
        ..settings(0.0, tolerance * (1.0 + 20.0 * reach))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]
    #[test]
    fn no_user_sees_a_point_further_off_than_the_tolerance(
        a in point(), b in point(), c in point(), settings in any_settings(), seed in any::<u64>(), size in 0.05..4.0f64,
    ) {
        let rule = Rule::new(&settings, Precision::Double).unwrap();
        prop_assert!(rule.holds());
        let split = pieces([a, a + (b - a) * size, a + (c - a) * size], &rule);
        prop_assert!(split.len() < 300_000);
        let (users, points) = if split.len() > 5_000 { (3, 5) } else { (12, 10) };
        // Coordinates of up to 700 m are rounded to 1e-13 m.
        prop_assert!(greatest_miss(&split, &settings, seed, users, points) <= settings.tolerance + 1e-12);
    }

    #[test]
    fn neighbours_get_the_same_vertices_and_pieces_cover_them(
        a in point(), b in point(), c in point(), d in point(), settings in any_settings(), single in any::<bool>(),
    ) {
        check_neighbours([a, b, c, d], &settings, single);
    }

    #[test]
    fn triangles_without_a_point_between_the_radii_are_not_split(
        a in point(), b in point(), c in point(), settings in any_settings(),
    ) {
        let rule = Rule::new(&settings, Precision::Double).unwrap();
        let beyond = DVec3::X * (settings.r2 + 81.0 + settings.center.x);
        let within = |p: DVec3| settings.center + (p / 160.0) * settings.r1;
        for corners in [[a, b, c].map(|p| p + beyond), [a, b, c].map(within)] {
            prop_assert!(rule.can_skip(&corners) || corners.iter().all(|p| p.x > settings.r2));
            prop_assert_eq!(pieces(corners, &rule), vec![Piece::of_triangle(corners)]);
        }
    }
}

#[test]
fn two_triangles_of_ground_are_bounded_tightly() {
    for tolerance in [1e-3, 2.5e-4] {
        let settings = settings(5.0, tolerance);
        let rule = Rule::new(&settings, Precision::Double).unwrap();
        let all: Vec<Piece> = ground(4000.0).into_iter().flat_map(|corners| pieces(corners, &rule)).collect();
        let ratio = greatest_miss(&all, &settings, 3, 30, 8) / tolerance;
        // The bound covers the worst of all triangles, users and heights; on the ground the error reaches half of it.
        assert!((0.3..=1.0).contains(&ratio), "{ratio} of {tolerance}, {} pieces", all.len());
        assert!(all.len() < 25_000, "{}", all.len());
    }
}

#[test]
fn splits_end_for_radii_below_the_resolution_of_coordinates() {
    let corners = [(-4e3, -4e3), (-4e3, 8e3), (8e3, -4e3)].map(|(x, z)| DVec3::new(x, 0.0, z));
    for is_blend in [true, false] {
        for (r1, r2) in [(0.0, 1e-9), (0.0, 1e-13), (0.0, 1e-300), (0.0, 50.0), (30.0, 30.0 + 1e-12), (30.0, 50.0)] {
            let reaches: &[f64] = if r2 == 50.0 { &[1e-3, 10.0, 40.0] } else { &[10.0] };
            for &reach in reaches {
                let cylinder = ServedMorphs::Cylinder { least: r2, is_full: true };
                let served = if is_blend { ServedMorphs::Blend } else { cylinder };
                let tolerance = if is_blend { 5e-4 } else { 5e-2 };
                let settings = Settings { r1, r2, drawn: r2, served, ..settings(reach, tolerance) };
                let rule = Rule::new(&settings, Precision::Double).unwrap();
                let count = pieces(corners, &rule).len();
                assert!(count < 300_000, "{r1} {r2} {reach} {count}");
                assert_eq!(rule.holds(), reach < 18.0 && r2 == 50.0 && r1 == 30.0);
            }
        }
    }
}

#[test]
fn settings_without_a_bound_are_refused_by_argument() {
    let split_with = |settings: Settings| {
        let rule = Rule::new(&settings, Precision::Double)?;
        tessellate_arrays(&[], &[], &rule, &Progress::new())
    };
    let good = settings(5.0, 5e-4);
    assert_eq!(split_with(good).unwrap().counts, SplitCounts::default());
    for (name, wrong) in [
        ("user_region", Settings { reach: 18.0, ..good }),
        ("user_region", Settings { reach: f64::NAN, ..good }),
        ("tolerance_px", Settings { tolerance: 0.0, ..good }),
        ("tolerance_px", Settings { tolerance: 1e-12, ..good }),
        ("r1", Settings { r1: -1.0, ..good }),
        ("r2", Settings { r2: 20.0, ..good }),
        ("center", Settings { center: DVec3::INFINITY, ..good }),
    ] {
        let message = split_with(wrong).unwrap_err().to_string();
        assert!(message.starts_with(name), "{message}");
    }
}

#[test]
fn a_user_who_stays_at_the_centre_needs_nothing() {
    let rule = Rule::new(&settings(0.0, 5e-4), Precision::Double).unwrap();
    let [first, _] = ground(45.0);
    // Nothing moves, so edges are cut only at the radii.
    assert!(pieces(first, &rule).len() < 2_000);
}
