use glam::{DMat3, DQuat, DVec2, DVec3};

use super::*;
use crate::base::Progress;
use crate::camera::Fov;

/// The Vive of the paper, with its printed tangents.
fn vive() -> [Eye; 2] {
    let left = Fov { left: -1.391_937, right: 1.247_409, down: -1.464_287, up: 1.468_819 };
    let right = Fov { left: -1.246_557, right: 1.398_447, down: -1.472_458, up: 1.465_505 };
    let eye = |fov, x| Eye { fov, position: DVec3::new(x, 0.0, 0.0), orientation: DQuat::IDENTITY };
    [eye(left, -0.032), eye(right, 0.032)]
}

/// Canted eyes, moved forwards and upwards.
fn canted(degrees: f64) -> [Eye; 2] {
    let fov = Fov { left: -1.3, right: 1.0, down: -1.1, up: 1.2 };
    let mirrored = Fov { left: -1.0, right: 1.3, ..fov };
    let eye = |fov, x: f64| Eye {
        fov,
        position: DVec3::new(x, 0.01, -0.02),
        orientation: DQuat::from_rotation_y(-x.signum() * degrees.to_radians()),
    };
    [eye(fov, -0.031), eye(mirrored, 0.033)]
}

fn zoned(eyes: [Eye; 2], begin: f64, end: f64) -> Rig {
    Rig::new(eyes, Planes { begin, end }, (1344, 1512)).unwrap()
}

fn rig(eyes: [Eye; 2], m: f64) -> Rig {
    zoned(eyes, m, m)
}

fn fractions() -> impl Iterator<Item = DVec2> {
    (0..121).map(|n| DVec2::new(f64::from(n % 11) / 10.0, f64::from(n / 11) / 10.0))
}

#[test]
fn the_published_headset_has_the_published_error() {
    let rig = rig(vive(), 8.0);
    // The paper: "4 pixels"; vertically 2.18 by the closed form.
    assert!((rig.max_error(f64::INFINITY, Axis::Horizontal).unwrap() - 3.86).abs() < 0.01);
    assert!((rig.max_error(1000.0, Axis::Horizontal).unwrap() - 3.83).abs() < 0.01);
    assert!((rig.max_error(f64::INFINITY, Axis::Vertical).unwrap() - 2.18).abs() < 0.01);
    assert!((rig.setback - 0.032 / 1.391_937).abs() < 1e-15);
}

#[test]
fn errors_follow_the_closed_form() {
    let eyes = vive();
    for (m, z) in [(0.5, 0.6), (1.6, 40.0), (8.0, 1000.0), (40.0, f64::INFINITY)] {
        let rig = rig(eyes, m);
        let s = rig.setback;
        let grown = if z.is_finite() { (z - m) / ((z + s) * m) } else { 1.0 / m };
        for side in Side::BOTH {
            let eye = rig.eye(side);
            for fraction in fractions() {
                let at = eye.fov.point(fraction.x, fraction.y);
                let expected = (at * s - eye.position.truncate()) * grown * rig.pixels_per_tangent(side);
                // Roundings of a thousand pixels.
                assert!((rig.error(side, at, z) - expected).length() < 1e-11, "{m} {z} {at}");
            }
        }
    }
}

#[test]
fn points_before_the_plane_are_not_displaced() {
    let rig = rig(canted(5.0), 8.0);
    let at = DVec2::new(0.3, -0.4);
    for depth in [0.1, 3.0, 8.0] {
        assert_eq!(rig.displayed_tangents(Side::Left, at, depth), at);
    }
    // The error begins at the plane, without a step.
    assert!((rig.displayed_tangents(Side::Left, at, 8.0 + 1e-9) - at).length() < 1e-9);
}

/// Compares `displayed_tangents` and `homography` with points computed step by step in space.
#[test]
fn displayed_tangents_and_homography_agree_with_points_in_space() {
    for (degrees, m) in [(0.0, 2.0), (5.0, 8.0), (-10.0, 1.0), (20.0, 30.0)] {
        let rig = rig(canted(degrees), m);
        let camera = DVec3::new(0.0, 0.0, rig.setback);
        let fov = rig.center_fov;
        let ((width, height), (wide, high)) = (rig.center_size, rig.size);
        for side in Side::BOTH {
            let eye = rig.eye(side);
            let homography = rig.homography(side);
            for fraction in fractions() {
                let at = eye.fov.point(fraction.x, fraction.y);
                let direction = eye.orientation * at.extend(-1.0);
                let depth = 3.0 * m;
                let point = eye.position + direction * ((depth + eye.position.z) / -direction.z);
                assert!((point.z + depth).abs() < 1e-12 * depth);
                let from_camera = point - camera;
                let through = camera + from_camera * ((-m - camera.z) / from_camera.z);
                let seen = eye.orientation.inverse() * (through - eye.position);
                let expected = seen.truncate() / -seen.z;
                assert!((rig.displayed_tangents(side, at, depth) - expected).length() < 1e-12);
                // Its pixel in the third camera's picture, which the homography maps to the same position.
                let tangent = from_camera.truncate() / -from_camera.z;
                let pixel = DVec3::new(
                    (tangent.x - fov.left) / (fov.right - fov.left) * f64::from(width),
                    (fov.up - tangent.y) / (fov.up - fov.down) * f64::from(height),
                    1.0,
                );
                let mapped = homography * pixel;
                let place = mapped.truncate() / mapped.z;
                let wanted = DVec2::new(
                    (expected.x - eye.fov.left) / (eye.fov.right - eye.fov.left) * f64::from(wide),
                    (eye.fov.up - expected.y) / (eye.fov.up - eye.fov.down) * f64::from(high),
                );
                assert!((place - wanted).length() < 1e-8, "{degrees} {m} {place} {wanted}");
            }
        }
    }
}

#[test]
fn the_third_cameras_picture_covers_both_eyes() {
    for (degrees, m) in [(0.0, 0.3), (5.0, 8.0), (-5.0, 1.6), (15.0, 100.0)] {
        let rig = rig(canted(degrees), m);
        let (width, height) = rig.center_size;
        for side in Side::BOTH {
            let back: DMat3 = rig.homography(side).inverse();
            let (wide, high) = rig.size;
            for fraction in fractions() {
                let mapped = back * DVec3::new(fraction.x * f64::from(wide), fraction.y * f64::from(high), 1.0);
                let place = mapped.truncate() / mapped.z;
                let end = DVec2::new(f64::from(width), f64::from(height));
                assert!(mapped.z > 0.0 && place.cmpge(DVec2::splat(-1e-7)).all() && place.cmple(end + 1e-7).all());
            }
        }
    }
}

#[test]
fn pixels_of_the_third_camera_are_as_fine_as_those_of_the_eyes() {
    // Eyes without rotation see the plane at one scale everywhere; the coarser eye decides.
    let rig = rig(vive(), 8.0);
    let fov = rig.center_fov;
    let ((width, height), distance) = (rig.center_size, 8.0 + rig.setback);
    let sizes = Side::BOTH.map(|side| 8.0 / rig.pixels_per_tangent(side));
    let pixel_width = (fov.right - fov.left) * distance / f64::from(width);
    let pixel_height = (fov.up - fov.down) * distance / f64::from(height);
    let coarsest = sizes[0].max(sizes[1]);
    assert!(pixel_width <= coarsest.x * (1.0 + 1e-9) && pixel_width > coarsest.x * 0.998);
    assert!(pixel_height <= coarsest.y * (1.0 + 1e-9) && pixel_height > coarsest.y * 0.998);
}

#[test]
fn a_zone_joins_both_parts_smoothly() {
    let zone = zoned(canted(5.0), 6.0, 10.0);
    // The pictures meet on the plane in the middle of the zone in 1/z.
    let plane = rig(canted(5.0), 7.5);
    let at = DVec2::new(0.9, -0.4);
    let displayed = |rig: &Rig, depth: f64| rig.displayed_tangents(Side::Left, at, depth);
    // At the zone's ends: the eye's own picture and the shared one.
    assert!((displayed(&zone, 6.0 + 1e-9) - at).length() < 1e-9);
    assert!((displayed(&zone, 10.0) - displayed(&plane, 10.0)).length() < 1e-12);
    assert!((displayed(&zone, 10.0 - 1e-9) - displayed(&plane, 10.0)).length() < 1e-9);
    // The slope is continuous.
    let slope = |rig: &Rig, depth: f64| (displayed(rig, depth + 1e-6) - displayed(rig, depth - 1e-6)) / 2e-6;
    assert!(slope(&zone, 6.0).length() < 1e-6);
    assert!((slope(&zone, 10.0) - slope(&plane, 10.0)).length() < 1e-6);
}

#[test]
fn impossible_rigs_are_refused() {
    let refused = |eyes, mono, stereo, size, words: &str| {
        let error = Rig::new(eyes, Planes { begin: mono, end: stereo }, size).unwrap_err().to_string();
        assert!(error.contains(words), "{error}");
    };
    let size = (10, 10);
    let [left, right] = vive();
    refused([right, left], 8.0, 8.0, size, "right: expected an eye to the right");
    refused([left, left], 8.0, 8.0, size, "right: expected an eye to the right");
    refused([left, right], 0.0, 0.0, size, "mono_plane: expected a distance above 0");
    refused([left, right], f64::NAN, 1.0, size, "mono_plane: expected a distance above 0");
    refused([left, right], 8.0, 7.0, size, "mono_plane: expected a zone that ends at 8");
    refused([left, right], 8.0, 8.0, (0, 10), "size: expected 1 to 65536 pixels");
    refused(canted(60.0), 8.0, 8.0, size, "left: expected a view whose corners lie less than 90°");
    let ahead = canted(0.0).map(|eye| Eye { position: eye.position * DVec3::new(1.0, 1.0, 0.0), ..eye });
    let tilted = [Eye { position: ahead[0].position - DVec3::Z, ..ahead[0] }, ahead[1]];
    refused(tilted, 0.4, 0.4, size, "mono_plane: expected a plane in front of the left eye");
    let narrow = Fov { left: 1.0, right: 1.1, down: -0.1, up: 0.1 };
    let inwards = [Eye { fov: narrow, ..left }, right];
    refused(inwards, 8.0, 8.0, size, "left: expected an eye whose outer edge points outwards");
    let low = Fov { down: -1.4, up: -1.3, ..left.fov };
    let high = Fov { down: 1.3, up: 1.4, ..right.fov };
    refused([Eye { fov: low, ..left }, Eye { fov: high, ..right }], 8.0, 8.0, size, "views of both eyes overlap");
}

/// Compares with the pixels around each position, one by one, for runs (eyes without rotation) and for single pixels.
#[test]
fn needed_pixels_surround_all_positions() {
    for (eyes, turned) in [(vive(), false), (canted(4.0), true)] {
        let rig = Rig::new(eyes, Planes { begin: 2.0, end: 2.0 }, (70, 60)).unwrap();
        let (width, height) = (rig.center_size.0 as usize, rig.center_size.1 as usize);
        let share = |side: usize, n: usize| match (n / 7 + n / 70 + 3 * side) % 5 {
            0 => 0.5,
            1 | 2 => 1.0,
            _ if n / 70 > 40 => 1.0,
            _ => 0.0,
        };
        let coverage = [0, 1].map(|side| (0..70 * 60).map(|n| share(side, n)).collect::<Vec<f32>>());
        let found = rig.needed([&coverage[0], &coverage[1]], 1, &Progress::default()).unwrap();
        let mut expected = vec![false; width * height];
        for (side, shares) in Side::BOTH.into_iter().zip(&coverage) {
            let back = rig.homography(side).inverse();
            for (n, _) in shares.iter().enumerate().filter(|(_, share)| **share < 1.0) {
                let at = back * DVec3::new((n % 70) as f64 + 0.5, (n / 70) as f64 + 0.5, 1.0);
                let pixel = |at: f64, count: usize, k: f64| {
                    ((at - 0.5).clamp(0.0, (count - 1) as f64).floor() + k).min((count - 1) as f64) as usize
                };
                for (right, below) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
                    expected[pixel(at.y / at.z, height, below) * width + pixel(at.x / at.z, width, right)] = true;
                }
            }
        }
        let (extra, missing) = found.iter().zip(&expected).fold((0, 0), |(extra, missing), (found, wanted)| {
            (extra + usize::from(*found && !wanted), missing + usize::from(*wanted && !found))
        });
        assert_eq!(missing, 0);
        // A run also marks all pixels between its ends, of which few are unneeded: both pictures are about as fine.
        assert!(extra <= if turned { 0 } else { expected.len() / 100 }, "{extra}");
        assert!(expected.iter().filter(|wanted| !**wanted).count() > 100);
    }
}

/// Points on the legs, even between their ends, are displayed at the ray's position.
#[test]
fn legs_stay_close_to_the_bent_ray() {
    for (begin, end, degrees) in [(0.5, 0.6, 0.0), (3.0, 12.0, 5.0), (1.0, 100.0, 0.0), (8.0, 9.0, 10.0)] {
        let rig = zoned(canted(degrees), begin, end);
        let depths = rig.leg_depths(f64::INFINITY).unwrap();
        assert_eq!((depths[0], *depths.last().unwrap()), (begin, end));
        let (mut greatest, eye): (f64, _) = (0.0, rig.eye(Side::Left));
        for fraction in fractions() {
            let at = eye.fov.point(fraction.x, fraction.y);
            let direction = eye.orientation * at.extend(-1.0);
            for leg in depths.windows(2) {
                let [from, to] = [leg[0], leg[1]].map(|depth| rig.point_shown(Side::Left, direction, depth));
                for t in [0.0, 0.3, 0.5, 0.8, 1.0] {
                    let point = from.lerp(to, t);
                    let shown = rig.place_shown(point, rig.depth_shown(-point.z)) - eye.position;
                    let shown_at = error::tangents(eye.orientation.inverse() * shown);
                    greatest = greatest.max(((shown_at - at) * rig.pixels_per_tangent(Side::Left)).length());
                }
            }
        }
        assert!(greatest < zone::TOLERANCE, "{begin} {end}: {greatest}");
    }
}

#[test]
fn nothing_is_drawn_beyond_the_end() {
    let rig = zoned(canted(0.0), 3.0, 12.0);
    assert_eq!(rig.leg_depths(2.0).unwrap(), [3.0]);
    assert_eq!(*rig.leg_depths(5.0).unwrap().last().unwrap(), 5.0);
    assert!(rig.leg_depths(5.0).unwrap().len() > 2);
}
