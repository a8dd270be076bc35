use std::sync::Arc;

use glam::{DAffine3, DVec3};
use proptest::prelude::*;

use super::cover::cover;
use super::layer::{place, tiles_across};
use super::paint::{Quad, sharpen};
use super::plane::{Bound, Plane};
use super::probe::Probe;
use super::strips::cells;
use super::tile::{Place, SIDE, Tile, WIDE, column_and_row};
use super::world::{FarOnly, Seen, World};
use super::{Impostors, Settings, Sheet, atlas, bake};
use crate::base::{FaceMap, Progress};
use crate::camera::{direction_from_face, face_from_direction};
use crate::partition::Partition;
use crate::scene::{Instance, Mesh, Scene};
use crate::trace::{AcceptAll, Hit, Ray, closest_hits};

const R2: f64 = 20.0;
const REACH: f64 = 4.0;
const ANGLE: f64 = 2.0 / 1146.0;

fn scene(triangles: &[[[f32; 3]; 3]]) -> Scene {
    let instance = Instance::new(Mesh::of_triangles(triangles, FaceMap::Uniform(-1)), DAffine3::IDENTITY, None);
    Scene::new(DVec3::ZERO, vec![instance.unwrap()], Vec::new(), Arc::default(), Arc::default()).unwrap()
}

fn settings(size: u32) -> Settings {
    let (center, missing) = (DVec3::new(0.0, 1.7, 0.0), 5e-4);
    Settings { center, reach: REACH, height: 0.5, r2: R2, size, angle: ANGLE, centers: 10, missing }
}

fn baked(triangles: &[[[f32; 3]; 3]], size: u32) -> Impostors {
    bake(&scene(triangles), &settings(size), &[], &Progress::new()).unwrap()
}

/// Two triangles of a wall with its normal along z.
fn wall(x: [f32; 2], y: [f32; 2], z: f32) -> [[[f32; 3]; 3]; 2] {
    let corner = |i: usize, j: usize| [x[i], y[j], z];
    [[corner(0, 0), corner(1, 0), corner(1, 1)], [corner(0, 0), corner(1, 1), corner(0, 1)]]
}

fn unit() -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-1.0f64..1.0)
        .prop_map(DVec3::from_array)
        .prop_filter("a direction", |v| v.length() > 0.1 && v.length() <= 1.0)
        .prop_map(DVec3::normalize)
}

fn in_ball() -> impl Strategy<Value = DVec3> {
    // Users on the border of the region see the greatest errors.
    (unit(), prop_oneof![Just(1.0), 0.0f64..1.0]).prop_map(|(direction, radius)| direction * radius * REACH)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// By definition: the angle between the directions in which a user sees both points.
    #[test]
    fn no_user_sees_a_shown_point_farther_off_than_the_angle(
        center in in_ball(), user in in_ball(), direction in unit(), distance in 1.001f64..100.0, share in 0.0f64..=1.0,
        angle in 1e-4f64..0.1,
    ) {
        let point = direction * distance * REACH;
        let ray = point - center;
        let bound = Bound::new(center, DVec3::ZERO, REACH, angle);
        let [nearest, farthest] = bound.distances(ray.normalize(), ray.length());
        prop_assert!(nearest <= ray.length() && ray.length() <= farthest);
        let inverse = (1.0 - share) / nearest + share / farthest;
        let shown = center + ray.normalize() / inverse.max(1e-9);
        let seen = (point - user).cross(shown - user).length().atan2((point - user).dot(shown - user));
        prop_assert!(seen <= angle * (1.0 + 1e-6), "{seen} > {angle}");
    }

    /// Texture coordinates in the triangles of a quad, interpolated in space, against the texel in whose direction the
    /// point lies.
    #[test]
    fn texture_coordinates_are_off_by_at_most_half_a_texel(
        a in 0.01f64..0.1, slope in prop::array::uniform2(-0.9f64..0.9), left in 0isize..40, top in 0isize..40,
        sides in prop::array::uniform2(1isize..24), weights in prop::array::uniform2(0.0f64..1.0),
    ) {
        let (size, center) = (512, DVec3::new(1.0, 2.0, 3.0));
        let plane = Plane([a, a * slope[0], a * slope[1]]);
        let place = Place { face: 4, left: 192, top: 256 };
        let rectangle = [left, top, left + sides[0], top + sides[1]];
        let tile = Tile::blank(place, size);
        let cells = cells(&plane, &tile, rectangle);
        let texels = vec![[0; 4]; (sides[0] * sides[1]) as usize];
        let mesh = {
            let quads = vec![Arc::new(Quad { plane, place, rectangle, own: vec![], object: 0, cells, texels })];
            atlas::build(&[Sheet { center, size, quads }], DVec3::ZERO).unwrap()
        };
        let [s, t] = if weights[0] + weights[1] > 1.0 { weights.map(|w| 1.0 - w) } else { weights };
        for face in &mesh.faces {
            let mix = |values: [[f64; 3]; 3]| DVec3::from_array(values[0]) * (1.0 - s - t) + DVec3::from_array(values[1]) * s + DVec3::from_array(values[2]) * t;
            let position = mix(face.map(|v| mesh.positions[v as usize].map(f64::from))) - center;
            let uv = mix(face.map(|v| { let [x, y] = mesh.uv[v as usize]; [f64::from(x), f64::from(y), 0.0] }));
            let (_, u, v) = face_from_direction(position);
            let at = |x: f64, first: usize| (x + 1.0) * 0.5 * size as f64 - first as f64;
            let expected = [at(u, place.left) - left as f64 + 1.0, at(v, place.top) - top as f64 + 1.0];
            let found = [uv.x * f64::from(mesh.size[0]), (1.0 - uv.y) * f64::from(mesh.size[1])];
            for (expected, found) in expected.iter().zip(found) {
                prop_assert!((expected - found).abs() <= 0.5 + 1e-3, "{expected} {found}");
            }
        }
    }

    /// Every far surface that a centre sees is shown once, by a plane that no user sees farther off than the angle.
    #[test]
    fn planes_show_all_texels_within_the_bound(
        corners in prop::collection::vec((unit(), 1.0f64..5.0), 3..60), center in in_ball(), number in 0usize..24,
        users in prop::collection::vec(in_ball(), 8),
    ) {
        let point = |(direction, distance): &(DVec3, f64)| (*direction * *distance * R2).as_vec3().to_array();
        let triangles: Vec<[[f32; 3]; 3]> =
            corners.chunks_exact(3).map(|c| [point(&c[0]), point(&c[1]), point(&c[2])]).collect();
        let (scene, size) = (scene(&triangles), 128);
        scene.build_to_shade(&Progress::new()).unwrap();
        let partition = Partition::new(&scene, DVec3::ZERO, 0.0, R2, &Progress::new()).unwrap();
        let world = World { scene: &scene, partition: &partition, eye: DVec3::ZERO, reach: REACH, angle: ANGLE, seen: Seen::new(&scene).unwrap() };
        let place = place(number, size);
        prop_assert_eq!(tiles_across(size).pow(2) * 6, 24);
        let tile = Tile::trace(&world, center, size, place, &[], &[]);
        let mut shown = vec![0; SIDE * SIDE];
        for cover in cover(&tile) {
            for &texel in &cover.texels {
                shown[usize::from(texel)] += 1;
                let (column, row) = column_and_row(texel);
                let (u, v) = (tile.u(column), tile.v(row));
                let at = direction_from_face(place.face, u, v);
                let points = [at / tile.texel_inside(column, row).w, at / cover.plane.w(u, v)].map(|point| center + point);
                for user in &users {
                    let [a, b] = points.map(|point| point - *user);
                    prop_assert!(a.cross(b).length().atan2(a.dot(b)) <= ANGLE * (1.0 + 1e-5));
                }
            }
        }
        for (texel, &count) in shown.iter().enumerate() {
            let ray = tile.ray(center, (texel % SIDE) as f64 + 0.5, (texel / SIDE) as f64 + 0.5);
            let mut hits = [Hit::MISS];
            closest_hits(&scene, &[ray], &AcceptAll, &mut hits);
            prop_assert_eq!(count, u32::from(world.is_far(&hits[0])));
        }
    }
}

/// Random far triangles as two regions see them, with the distances by definition.
#[test]
fn shared_quads_show_all_their_texels_within_the_bound_of_the_other_region() {
    let (mut state, mut counts) = (1u64, [0, 0]);
    for _ in 0..4 {
        let mut number = |low: f64, high: f64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            low + (high - low) * (state >> 11) as f64 / (1u64 << 53) as f64
        };
        let mut point = || {
            let (turn, distance) = (number(0.0, std::f64::consts::TAU), number(1.0, 5.0) * R2);
            [(distance * turn.cos()) as f32, number(-0.5, 0.8) as f32 * distance as f32, (distance * turn.sin()) as f32]
        };
        let triangles: Vec<_> = (0..12).map(|_| [point(), point(), point()]).collect();
        let (scene, size, step) = (scene(&triangles), 64, DVec3::new(1.7 * REACH, 0.0, 0.0));
        let (here, there) = (settings(size), Settings { center: settings(size).center + step, ..settings(size) });
        let first = bake(&scene, &here, &[], &Progress::new()).unwrap();
        let second = bake(&scene, &there, &first.sheets, &Progress::new()).unwrap();
        assert!(second.missing.last().unwrap() <= &5e-4, "{:?}", second.missing);
        scene.build_to_shade(&Progress::new()).unwrap();
        let partition = Partition::new(&scene, there.center, 0.0, R2, &Progress::new()).unwrap();
        let seen = Seen::new(&scene).unwrap();
        let world = World { scene: &scene, partition: &partition, eye: there.center, reach: REACH, angle: ANGLE, seen };
        let offsets = [DVec3::ZERO, DVec3::X, DVec3::Z, DVec3::NEG_X, DVec3::NEG_Z].map(|side| side * REACH);
        let probe = |offset| Probe::trace(&world, there.center + offset, 64, &Progress::new()).unwrap();
        let probes = offsets.map(probe);
        let far_of = |center: DVec3, direction: DVec3| {
            let ray =
                Ray { origin: center.as_vec3(), direction: direction.as_vec3(), t_min: 0.0, t_max: f32::INFINITY };
            let mut hits = [Hit::MISS];
            closest_hits(&scene, &[ray], &FarOnly(&partition), &mut hits);
            (!hits[0].is_miss()).then(|| center + direction * f64::from(hits[0].t))
        };
        for sheet in &first.sheets {
            let found = sheet.shared_with(&world, &probes, size as usize, &Progress::new()).unwrap();
            counts[0] += found.quads.len();
            for quad in &found.quads {
                for &texel in &quad.own {
                    let (column, row) = column_and_row(texel);
                    let tile = Tile::blank(quad.place, sheet.size);
                    let (u, v) = (tile.u(column), tile.v(row));
                    let at = direction_from_face(quad.place.face, u, v);
                    let shown = sheet.center + at / quad.plane.w(u, v);
                    let truth = far_of(sheet.center, at.normalize()).unwrap();
                    for n in 0..8 {
                        let turn = f64::from(n) * 0.25 * std::f64::consts::PI;
                        let user = there.center + REACH * DVec3::new(turn.cos(), 0.0, turn.sin());
                        let [a, b] = [truth, shown].map(|point| point - user);
                        assert!(a.cross(b).length().atan2(a.dot(b)) <= ANGLE * (1.0 + 1e-4));
                    }
                }
            }
        }
        counts[1] += first.sheets.iter().map(|sheet| sheet.quads.len()).sum::<usize>();
    }
    // Most quads can be used again, but not all: some show what is near there, or are too inexact for it.
    assert!(2 * counts[0] > counts[1] && counts[0] < counts[1], "{counts:?}");
}

#[test]
fn a_region_beside_a_plane_wall_needs_few_new_quads() {
    let walls = scene(&wall([-400.0, 400.0], [-300.0, 300.0], -60.0));
    let [here, there] = [0.0, 6.0].map(|x| Settings { center: DVec3::new(x, 1.7, 0.0), ..settings(64) });
    let first = bake(&walls, &here, &[], &Progress::new()).unwrap();
    let second = bake(&walls, &there, &first.sheets, &Progress::new()).unwrap();
    assert!(first.shared == 0 && second.shared > 0);
    // New ones show the border of the wall only, whose texels are larger there.
    let texels = |baked: &Impostors| -> usize {
        baked.sheets.iter().flat_map(|sheet| &sheet.quads).map(|quad| quad.own.len()).sum()
    };
    assert!(50 * texels(&second) < texels(&first), "{} {}", texels(&second), texels(&first));
    // Twice as coarse quads are not used again.
    let fine = bake(&walls, &Settings { size: 256, ..there }, &first.sheets, &Progress::new()).unwrap();
    assert_eq!(fine.shared, 0);
}

#[test]
fn walls_hidden_from_the_center_are_shown() {
    // A near wall hides the far one from O; users beside O see past both ends. The third wall is seen by nobody.
    let walls = [([-5.0, 5.0], -8.0), ([-12.0, 12.0], -30.0), ([-1.0, 1.0], -10.0)];
    let triangles = walls.map(|(x, z)| wall(x, [0.0, 6.0], z)).concat();
    let found = baked(&triangles, 256);
    assert!(found.missing.last().unwrap() <= &5e-4, "{:?}", found.missing);
    assert!(found.mesh.positions.iter().all(|p| p[2] < -25.0));
    assert_eq!(found.seen, [0, 1, 2, 3]);
    // The far wall is two planes at most in each tile of each layer, not one a texel.
    assert!(found.mesh.faces.len() < 200, "{}", found.mesh.faces.len());
}

#[test]
fn surfaces_that_only_lower_eyes_see_are_shown() {
    // A slab ends 5 cm below O. From O a user sees the wall behind it up to 1.45 m, from 10 cm below O up to 1.85 m.
    let triangles = [wall([-50.0, 50.0], [1.65, 50.0], -0.6), wall([-1.0, 1.0], [-20.0, 20.0], -3.0)].concat();
    let settings = Settings { reach: 0.2, height: 0.1, r2: 1.0, ..settings(256) };
    let found = bake(&scene(&triangles), &settings, &[], &Progress::new()).unwrap();
    let top = found.mesh.positions.iter().map(|p| p[1]).fold(f32::NEG_INFINITY, f32::max) + 1.7;
    assert!(top > 1.8, "{top}");
}

#[test]
fn quads_are_the_same_for_any_number_of_threads() {
    let triangles: Vec<_> = (0..40)
        .flat_map(|n| {
            wall([n as f32 * 3.0 - 60.0, n as f32 * 3.0 - 58.0], [0.0, (n * 7 % 11) as f32], -25.0 - (n % 5) as f32)
        })
        .collect();
    let [one, four] = [1, 4].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| format!("{:?}", baked(&triangles, 128)))
    });
    assert_eq!(one, four);
}

#[test]
fn scenes_without_a_far_part_have_no_quads() {
    let found = baked(&wall([-5.0, 5.0], [0.0, 6.0], -8.0), 64);
    assert!(found.mesh.faces.is_empty());
    assert_eq!(found.missing, [0.0]);
}

#[test]
fn linear_look_ups_of_sharpened_texels_keep_the_contrast_of_waves() {
    let amplitude = |period: f64, is_sharp: bool| {
        let wave = |x: f64| (std::f64::consts::TAU * x / period).sin();
        let texel = |slot: usize| 0.5 + 0.2 * wave((slot % WIDE) as f64);
        let shown: Vec<_> = (0..WIDE * WIDE).map(|slot| Some(([texel(slot) as f32; 3], 255))).collect();
        let value = |column: isize| match is_sharp {
            true => f64::from(sharpen(&shown, column, 9).unwrap().0[0]),
            false => texel(column as usize + 1),
        };
        // Projection on the wave over whole periods.
        let positions = (0..4800).map(|n| f64::from(n) * 0.01);
        let shares = positions.map(|x| {
            let (column, share) = (x.floor() as isize, x.fract());
            (value(column) * (1.0 - share) + value(column + 1) * share - 0.5) * wave(x + 1.0)
        });
        shares.sum::<f64>() / 480.0
    };
    for period in [4.0, 6.0, 8.0, 12.0] {
        // A look-up at a random position multiplies the wave by sinc²(π / period).
        let half = std::f64::consts::PI / period;
        let blur = (half.sin() / half).powi(2);
        assert!((amplitude(period, false) - blur).abs() < 1e-3, "{period}");
        assert!((amplitude(period, true) - 1.0).abs() < 0.3 * (1.0 - blur), "{period}");
    }
}

#[test]
fn invalid_settings_are_named() {
    let scene = scene(&wall([-5.0, 5.0], [0.0, 6.0], -30.0));
    let valid = settings(64);
    for (name, settings) in [
        ("face_size", Settings { size: 63, ..valid }),
        ("reach", Settings { reach: 0.0, ..valid }),
        ("reach", Settings { reach: f64::NAN, ..valid }),
        ("height", Settings { height: -0.1, ..valid }),
        ("height", Settings { height: REACH + 0.1, ..valid }),
        ("r2", Settings { r2: REACH, ..valid }),
        ("angle", Settings { angle: 0.0, ..valid }),
        ("angle", Settings { angle: 0.5, ..valid }),
    ] {
        let error = bake(&scene, &settings, &[], &Progress::new()).unwrap_err();
        assert!(error.to_string().starts_with(name), "{error}");
    }
}
