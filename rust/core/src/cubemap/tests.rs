use glam::{DVec2, DVec3};
use proptest::prelude::*;

use super::*;
use crate::base::{Progress, random::uniform};
use crate::camera::{direction_from_face, face_from_direction};

fn random_directions(count: u64, seed: u64) -> Vec<[f64; 3]> {
    let mut directions: Vec<[f64; 3]> =
        (0..count).map(|i| [0, 1, 2].map(|axis| 2.0 * uniform(seed, axis, i) - 1.0)).collect();
    for (i, d) in directions.iter_mut().enumerate() {
        // Edges, corners, and the centres and borders of texels.
        match i % 11 {
            0 => d[1] = -d[0],
            1 => *d = d.map(f64::signum),
            2 => *d = d.map(|x| (x * 8.0).round() / 8.0 + f64::from(u8::from(x == 0.0))),
            _ => (),
        }
        if d.iter().all(|&x| x == 0.0) {
            d[0] = 1.0;
        }
    }
    directions
}

fn grid(size: u32) -> Grid {
    Grid::new(Layout::Cube, size, size).unwrap()
}

pub(super) fn centers(size: u32) -> Vec<[f64; 3]> {
    let mut directions = vec![[0.0; 3]; grid(size).texels()];
    grid_directions(grid(size), &mut directions, &Progress::new()).unwrap();
    directions
}

#[test]
fn blocks_equal_single_lookups_bit_for_bit() {
    for (size, channels) in [(1, 1), (2, 3), (3, 2), (4, 1), (16, 3), (37, 5)] {
        let values: Vec<f64> = (0..6 * u64::from(size * size) * channels).map(|i| uniform(9, 1, i)).collect();
        let channels = channels as usize;
        let faces = CubeFaces::new(&values, size, channels).unwrap();
        let directions = random_directions(1000, size.into());
        let mut out = vec![0.0; directions.len() * channels];
        nearest(faces, &directions, &mut out, &Progress::new()).unwrap();
        for (i, &d) in directions.iter().enumerate() {
            let number = texel_from_direction(DVec3::from_array(d), size);
            assert_eq!(out[i * channels..][..channels], *faces.texel(number));
        }
        lookup(faces, &directions, TexelFilter::Linear, &mut out, &Progress::new()).unwrap();
        let [mut least, mut greatest] = [out.clone(), out.clone()];
        lookup(faces, &directions, TexelFilter::Min, &mut least, &Progress::new()).unwrap();
        lookup(faces, &directions, TexelFilter::Max, &mut greatest, &Progress::new()).unwrap();
        for (i, &d) in directions.iter().enumerate() {
            let taps = Taps::new(DVec3::from_array(d), size);
            for channel in 0..channels {
                let term = |k: usize| faces.texel(taps.texel[k])[channel] * taps.weight[k];
                let mean = (term(0) + term(1)) + (term(2) + term(3));
                // At an outermost centre a weight may differ in its last digit, because blocks clamp it to 0..1.
                assert!((out[i * channels + channel] - mean).abs() <= 4.0 * f64::EPSILON);
                let texels = (0..4).filter(|&k| taps.weight[k] > 1e-12).map(|k| faces.texel(taps.texel[k])[channel]);
                let (low, high) =
                    texels.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
                assert!(least[i * channels + channel] <= low && greatest[i * channels + channel] >= high);
            }
        }
    }
}

#[test]
fn minimum_and_maximum_bracket_the_mean_and_texels_without_weight_do_not_count() {
    let size = 4;
    let values: Vec<f32> = (0..96).map(|i| if i == 5 { f32::INFINITY } else { i as f32 }).collect();
    let faces = CubeFaces::new(&values, size, 1).unwrap();
    let directions: Vec<[f64; 3]> = (0..96).map(|t| direction_from_texel(t, size).to_array()).collect();
    let mut out = vec![0.0; 96];
    for filter in [TexelFilter::Linear, TexelFilter::Min, TexelFilter::Max] {
        lookup(faces, &directions, filter, &mut out, &Progress::new()).unwrap();
        // The size is a power of two, so the centres of inner texels are exact and no neighbour has weight.
        assert_eq!(out[5..7], values[5..7]);
    }
    // On face +x, between texels 5, 6, 9 and 10.
    let between = [[1.0, 0.01, 0.02f64]];
    let [mut least, mut mean, mut greatest] = [[0.0], [0.0], [0.0]];
    lookup(faces, &between, TexelFilter::Min, &mut least, &Progress::new()).unwrap();
    lookup(faces, &between, TexelFilter::Linear, &mut mean, &Progress::new()).unwrap();
    lookup(faces, &between, TexelFilter::Max, &mut greatest, &Progress::new()).unwrap();
    assert_eq!((least, mean[0], greatest), ([6.0], f32::INFINITY, [f32::INFINITY]));
}

#[test]
fn zero_directions_are_refused() {
    let values = [0.0f32; 6];
    let faces = CubeFaces::new(&values, 1, 1).unwrap();
    let mut out = vec![0.0; 20_000];
    for wrong in [[0.0; 3], [f64::NAN, 1.0, 0.0], [1.0, f64::INFINITY, 0.0], [0.0, 0.0, f64::NEG_INFINITY]] {
        for index in [0, 63, 64, 8191, 8192, 19_999] {
            let mut directions = vec![[1.0, 0.0, 0.0]; 20_000];
            directions[index..].fill(wrong);
            for filter in [TexelFilter::Linear, TexelFilter::Cubic, TexelFilter::Min] {
                let error = lookup(faces, &directions, filter, &mut out, &Progress::new()).unwrap_err();
                assert!(error.to_string().contains(&format!("index {index}")), "{error}");
            }
            assert!(nearest(faces, &directions, &mut out, &Progress::new()).is_err());
            assert!(grid_texels(grid(1), &directions, &mut vec![0; 20_000], &Progress::new()).is_err());
        }
    }
    assert!(CubeFaces::new(&values, 0, 1).is_err() && CubeFaces::new(&values, 2, 1).is_err());
    assert!(lookup(faces, &[[1.0; 3]], TexelFilter::Linear, &mut out, &Progress::new()).is_err());
}

#[test]
fn a_table_of_texels_beyond_edges_changes_no_bit() {
    let size = 6;
    let values: Vec<f64> = (0..6 * 36 * 5).map(|i| uniform(2, 2, i)).collect();
    let faces = CubeFaces::new(&values, size, 5).unwrap();
    let directions = random_directions(64, 4);
    let [mut without_table, mut with_table] = [vec![0.0; 64 * 5], vec![0.0; 64 * 5]];
    lookup::cube_sampler(faces, TexelFilter::Cubic, 0).unwrap().sample(&directions, &mut without_table);
    lookup::cube_sampler(faces, TexelFilter::Cubic, 1000).unwrap().sample(&directions, &mut with_table);
    assert_eq!(without_table, with_table);
}

#[test]
fn cubic_errors_fall_as_fast_at_seams_as_inside() {
    let f = |d: DVec3| (1.7 * d.x - 0.6 * d.y).sin() + 0.8 * (2.1 * d.z + d.y).cos();
    for size in [8, 16, 32, 64, 128] {
        let values: Vec<f64> = centers(size).into_iter().map(|d| f(DVec3::from_array(d).normalize())).collect();
        let faces = CubeFaces::new(&values, size, 1).unwrap();
        // Directions with nearly equal components: a quarter lie near corners, a quarter near edges.
        let mut directions = random_directions(40_000, 7);
        for (i, d) in directions.iter_mut().enumerate() {
            let near = |x: f64| x.signum() + 4.0 * x / f64::from(size);
            match i % 4 {
                0 => *d = d.map(near),
                1 => *d = [near(d[0]), near(d[1]), d[2]],
                _ => (),
            }
        }
        let mut out = vec![0.0; directions.len()];
        lookup(faces, &directions, TexelFilter::Cubic, &mut out, &Progress::new()).unwrap();
        let (mut seam, mut inside) = (0.0f64, 0.0f64);
        for (&d, &value) in directions.iter().zip(&out) {
            let d = DVec3::from_array(d);
            let m = d.abs() / d.abs().max_element();
            let second = m.x + m.y + m.z - 1.0 - m.min_element();
            let worst = if second > 1.0 - 3.0 / f64::from(size) { &mut seam } else { &mut inside };
            *worst = worst.max((value - f(d.normalize())).abs());
        }
        assert!(seam <= inside, "size {size}: {seam} at seams, {inside} inside");
    }
}

#[test]
fn texels_and_directions_are_inverses() {
    for size in [1, 2, 3, 7, 64] {
        for texel in 0..6 * size * size {
            let d = direction_from_texel(texel, size);
            assert_eq!(d.abs().max_element(), 1.0);
            assert_eq!(texel_from_direction(d, size), texel);
            assert_eq!(texel_from_direction(d * 1e-300, size), texel);
        }
    }
}

#[test]
fn axes_are_the_centres_of_their_faces() {
    let axes = [DVec3::X, -DVec3::X, DVec3::Y, -DVec3::Y, DVec3::Z, -DVec3::Z];
    for (face, axis) in axes.into_iter().enumerate() {
        assert_eq!(direction_from_face(face as u8, 0.0, 0.0), axis);
        let (found, u, v) = face_from_direction(axis * 7.0);
        assert_eq!((found, u.abs(), v.abs()), (face as u8, 0.0, 0.0));
    }
}

proptest! {
    #[test]
    fn a_direction_survives_its_face(x in -1.0..1.0f64, y in -1.0..1.0f64, z in -1.0..1.0f64) {
        let d = DVec3::new(x, y, z);
        prop_assume!(d.abs().max_element() > 1e-9);
        let (face, u, v) = face_from_direction(d);
        prop_assert!(u.abs() <= 1.0 && v.abs() <= 1.0);
        let back = direction_from_face(face, u, v) * d.abs().max_element();
        // One division and one multiplication: two roundings of values up to 1.
        prop_assert!((back - d).abs().max_element() <= 2.0 * f64::EPSILON);
    }
}

/// Returns the angle between a direction and a texel: 0 inside it, otherwise the minimum angle to its four sides.
fn angle_to_texel(d: DVec3, texel: u32, size: u32) -> f64 {
    if texel_from_direction(d, size) == texel {
        return 0.0;
    }
    let (row, column) = (texel / size % size, texel % size);
    let face = (texel / size / size) as u8;
    let at = |x: u32| f64::from(x) * 2.0 / f64::from(size) - 1.0;
    let corner = |i: u32, j: u32| direction_from_face(face, at(column + i), at(row + j));
    let corners = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
    (0..4).map(|k| angle_to_arc(d.normalize(), corners[k], corners[(k + 1) % 4])).fold(f64::INFINITY, f64::min)
}

fn angle_to_arc(d: DVec3, from: DVec3, to: DVec3) -> f64 {
    let normal = from.cross(to).normalize();
    let foot = d - normal * d.dot(normal);
    let within = from.cross(foot).dot(normal) >= 0.0 && foot.cross(to).dot(normal) >= 0.0;
    let angle = |p: DVec3| d.cross(p).length().atan2(d.dot(p));
    if within && foot.length() > 1e-9 { angle(foot) } else { angle(from).min(angle(to)) }
}

proptest! {
    #[test]
    fn footprints_are_the_texels_touched_by_cones(
        x in -1.0..1.0f64, y in -1.0..1.0f64, z in -1.0..1.0f64,
        size in 1..24u32, kind in 0..8u8, radius in 0.0..1.57f64, scale in 0..4i32, seed in 0..99u64,
    ) {
        let d = match kind {
            0 => DVec3::new(x, x, z),
            1 => DVec3::new(x, -x, x),
            2 => DVec3::new(x, 0.0, 0.0),
            3 => DVec3::new(x, y, 0.0),
            4 => direction_from_face(2, (x * 4.0).round() * 2.0 / f64::from(size), (y * 4.0).round() / f64::from(size)),
            _ => DVec3::new(x, y, z),
        };
        prop_assume!(d.abs().max_element() > 1e-3);
        let radius = radius * 0.1f64.powi(scale);
        let values: Vec<f64> = (0..6 * u64::from(size * size)).map(|i| uniform(seed, 5, i)).collect();
        let faces = CubeFaces::new(&values, size, 1).unwrap();
        let mut found = [[0.0], [0.0]];
        footprint(faces, &[d.to_array()], radius, TexelFilter::Min, &mut found[0], &Progress::new()).unwrap();
        footprint(faces, &[d.to_array()], radius, TexelFilter::Max, &mut found[1], &Progress::new()).unwrap();
        // Cones are wider by 4e-15 / sin 2r, at most by 6.4e-8 rad.
        let margin = (4e-15 / (2.0 * radius).sin()).min(6.4e-8) + 1e-14;
        let bounds = |radius: f64| {
            let touched = values.iter().enumerate().filter(|&(i, _)| angle_to_texel(d, i as u32, size) <= radius);
            touched.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (_, &x)| (low.min(x), high.max(x)))
        };
        let (inner, outer) = (bounds(radius - 1e-14), bounds(radius + margin));
        let found = (found[0][0], found[1][0]);
        prop_assert!(outer.0 <= found.0 && found.0 <= inner.0, "{found:?} {inner:?} {outer:?}");
        prop_assert!(inner.1 <= found.1 && found.1 <= outer.1, "{found:?} {inner:?} {outer:?}");
    }
}

#[test]
fn all_layouts_find_every_texel_by_its_centre() {
    let sizes = [(Layout::Cube, 1, 1), (Layout::Cube, 7, 7), (Layout::Equirectangular, 1, 2)];
    let more = [(Layout::Equirectangular, 9, 14), (Layout::Octahedral, 1, 1), (Layout::Octahedral, 10, 10)];
    for (layout, height, width) in sizes.into_iter().chain(more).chain([(Layout::Octahedral, 7, 7)]) {
        let grid = Grid::new(layout, height, width).unwrap();
        let mut directions = vec![[0.0; 3]; grid.texels()];
        grid_directions(grid, &mut directions, &Progress::new()).unwrap();
        let mut numbers = vec![0; grid.texels()];
        grid_texels(grid, &directions, &mut numbers, &Progress::new()).unwrap();
        assert!(numbers.into_iter().eq(0..grid.texels() as i64), "{grid:?}");
    }
    assert!(Grid::new(Layout::Equirectangular, 2, 3).is_err() && Grid::new(Layout::Octahedral, 2, 3).is_err());
    assert!(Grid::new(Layout::Cube, 0, 0).is_err() && Grid::new(Layout::Cube, MAX_SIZE + 1, MAX_SIZE + 1).is_err());
}

#[test]
fn flat_layouts_continue_beyond_their_edges() {
    for (layout, height, width) in [(Layout::Equirectangular, 8, 16), (Layout::Octahedral, 8, 8)] {
        let grid = Grid::new(layout, height, width).unwrap();
        for (row, column) in
            [(-1, 3), (8, 5), (-2, 0), (9, 7), (2, -1), (5, -2), (3, width.into()), (6, width as i64 + 1)]
        {
            let number = grid.wrap(row, column) as u32;
            let center = |number: u32| DVec2::new((number % width).into(), (number / width).into()) + 0.5;
            let inside = grid.direction(center(number)).normalize();
            // Both formulas also hold beyond the edge: latitudes beyond 90°, and folds that are folded back.
            let p = DVec2::new(column as f64, row as f64) + 0.5;
            let beyond = match layout {
                Layout::Equirectangular => grid.direction(p),
                _ => {
                    let (x, y) = (p.x.clamp(0.0, 8.0), p.y.clamp(0.0, 8.0));
                    let back = if p.x == x {
                        DVec2::new(8.0 - p.x, 2.0 * y - p.y)
                    } else {
                        DVec2::new(2.0 * x - p.x, 8.0 - p.y)
                    };
                    grid.direction(back)
                }
            };
            assert!((beyond.normalize() - inside).length() < 1e-12, "{layout:?} {row} {column}");
        }
    }
}
