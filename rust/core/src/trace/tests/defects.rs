//! Cases that other ray tracers get wrong.

use rayon::prelude::*;

use super::*;

/// A square of two triangles, perpendicular to the z axis.
fn wall(z: f32, half: f32) -> Vec<[Vec3; 3]> {
    let corner = |x: f32, y: f32| Vec3::new(x * half, y * half, z);
    let (a, b, c, d) = (corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0));
    vec![[a, b, c], [a, c, d]]
}

fn nearest_hit(scene: &Scene, ray: Ray) -> Hit {
    trace_all_ways(scene, &[ray; 9], &AcceptAll)[0]
}

#[test]
fn negative_zeros_and_surfaces_at_the_origin() {
    let scene = scene(vec![(mesh(&wall(5.0, 3.0)), DAffine3::IDENTITY)], vec![]);
    for x in [0.0, -0.0] {
        for y in [0.0, -0.0] {
            assert_eq!(nearest_hit(&scene, ray(Vec3::new(0.5, 0.25, 0.0), Vec3::new(x, y, 1.0))).t, 5.0);
        }
    }
    // Origins on the surface, one float32 step before it, and 1e-5 before it, on both sides.
    for (gap, toward) in [(0.0, 1.0), (4.8e-7, 1.0), (1e-5, 1.0), (-1e-5, -1.0), (0.0, -1.0)] {
        let origin = Vec3::new(0.5, 0.25, 5.0 - gap);
        let hit = nearest_hit(&scene, ray(origin, Vec3::new(0.0, 0.0, toward)));
        assert_eq!(hit.t, (5.0 - origin.z).abs(), "{gap}");
    }
}

#[test]
fn long_axis_parallel_rays_beside_a_face_of_a_box() {
    // Faces of two boxes meet at x = 1; rays run along them at a distance of up to 2e-4, 10 km from the far wall.
    let mut triangles = wall(1e4, 1.0);
    triangles.extend(wall(1e4, 1.0).iter().map(|corners| corners.map(|p| p + Vec3::X * 2.0)));
    let scene = scene(vec![(mesh(&triangles), DAffine3::IDENTITY)], vec![]);
    for offset in [0.0, 1e-7, 1e-5, 2e-4] {
        for x in [1.0 - offset, 1.0 + offset] {
            let hit = nearest_hit(&scene, ray(Vec3::new(x, 0.3, 0.0), Vec3::Z));
            // Weights and their sum are rounded three times.
            assert!((hit.t - 1e4).abs() <= 1e4 * 3.0 * f32::EPSILON, "{x}");
        }
    }
}

#[test]
fn short_and_long_directions() {
    let scene = scene(vec![(mesh(&wall(5.0, 3.0)), DAffine3::IDENTITY)], vec![]);
    for length in [1e-20, 1e-6, 1e6, 1e20] {
        let hit = nearest_hit(&scene, ray(Vec3::new(0.5, 0.25, 0.0), Vec3::Z * length));
        // Three roundings.
        assert!((hit.t * length - 5.0).abs() < 5.0 * 3.0 * f32::EPSILON, "{length}");
    }
}

#[test]
fn huge_and_tiny_extents() {
    for size in [1e-30, 1e-12, 1e12, 1e28] {
        let triangles: Vec<[Vec3; 3]> =
            (1..40).flat_map(|i| wall(i as f32, 3.0)).map(|corners| corners.map(|p| p * size)).collect();
        let scene = scene(vec![(mesh(&triangles), DAffine3::IDENTITY)], vec![]);
        let hit = nearest_hit(&scene, ray(Vec3::new(0.5, 0.25, 7.5) * size, Vec3::Z));
        // Three roundings.
        assert!((hit.t / size - 0.5).abs() < 8.0 * 3.0 * f32::EPSILON, "{size}: {hit:?}");
        assert_eq!(hit.face / 2, 7);
    }
}

#[test]
fn degenerate_triangles_are_never_hit() {
    let p = Vec3::new(0.0, 0.0, 2.0);
    let mut triangles = vec![[p, p, p], [p, p, p + Vec3::X], [p - Vec3::X, p, p + Vec3::X]];
    let flat = scene(vec![(mesh(&triangles), DAffine3::IDENTITY)], vec![]);
    assert!(nearest_hit(&flat, ray(Vec3::ZERO, Vec3::Z)).is_miss());
    triangles.extend(wall(4.0, 1.0));
    let scene = scene(vec![(mesh(&triangles), DAffine3::IDENTITY)], vec![]);
    assert_eq!(nearest_hit(&scene, ray(Vec3::ZERO, Vec3::Z)).t, 4.0);
}

#[test]
fn thousands_of_equal_triangles_and_boxes() {
    // The builder's clustering alone would take 25 s for either mesh.
    let [first, second] = [wall(1.0, 1.0)[0], wall(1.0, 1.0)[1]];
    let copies = mesh(&vec![first; 20_000]);
    // Different triangles with the same box.
    let different: Vec<[Vec3; 3]> = (0..20_000)
        .map(|i| {
            let middle = Vec3::new(i as f32 / 20_000.0, -i as f32 / 40_000.0, 1.0);
            [first[0], first[2], middle]
        })
        .collect();
    let different = mesh(&different);
    let bvh = copies.build_bvh(&Progress::new()).unwrap();
    assert_eq!((bvh.validate(), bvh.blocks.len()), (Ok(()), 1));
    assert_eq!(different.build_bvh(&Progress::new()).unwrap().validate(), Ok(()));
    let scene = scene(vec![(copies, DAffine3::IDENTITY), (mesh(&[second]), DAffine3::IDENTITY)], vec![]);
    assert_eq!(nearest_hit(&scene, ray(Vec3::new(0.5, -0.5, 0.0), Vec3::Z)).face, 0);
}

#[test]
fn copies_with_other_texture_coordinates_are_kept() {
    let positions: Vec<[f32; 3]> =
        [wall(1.0, 1.0)[0], wall(1.0, 1.0)[0]].as_flattened().iter().map(Vec3::to_array).collect();
    let build = |uvs: Vec<[f32; 2]>| {
        let none = FaceMap::Uniform(-1);
        let faces = vec![[0, 1, 2], [3, 4, 5]];
        let mesh =
            Mesh::new(positions.clone().into(), faces.into(), Some(uvs.into()), None, none.clone(), none).unwrap();
        mesh.build_bvh(&Progress::new()).unwrap().blocks[0].distinct_faces().len()
    };
    assert_eq!(build(vec![[0.0, 0.0]; 6]), 1);
    let mut other = vec![[0.0, 0.0]; 6];
    other[4] = [1.0, 0.0];
    assert_eq!(build(other), 2);
}

#[test]
fn triangles_nested_over_the_whole_range_of_sizes() {
    // Each square is twice as large as the last, so the tree has the maximum possible depth.
    let triangles: Vec<[Vec3; 3]> = (-60..60).flat_map(|i| wall(1.0, 2.0f32.powi(i))).collect();
    let mesh = mesh(&triangles);
    assert_eq!(mesh.build_bvh(&Progress::new()).unwrap().validate(), Ok(()));
    let scene = scene(vec![(mesh, DAffine3::IDENTITY)], vec![]);
    // The smallest square that contains (0.7, 0.2) has a half side of 1 and is number 60, with two faces per square.
    assert_eq!(nearest_hit(&scene, ray(Vec3::new(0.7, 0.2, 0.0), Vec3::Z)).face, 120);
}

#[test]
fn a_cancelled_build_stops_and_can_be_repeated() {
    let mesh = mesh(&wall(1.0, 1.0));
    let progress = Progress::new();
    progress.cancel();
    assert!(mesh.build_bvh(&progress).is_err());
    assert!(mesh.build_bvh(&Progress::new()).is_ok());
}

#[test]
fn a_cancelled_cast_stops_and_can_be_repeated() {
    let scene = scene(vec![(mesh(&wall(1.0, 1.0)), DAffine3::IDENTITY)], vec![]);
    let (origins, directions) = ([[0.0f64; 3]], [[0.0f64, 0.0, 1.0]]);
    let (from, towards) = (Points::Double(&origins), Points::Double(&directions));
    assert_eq!(cast(&scene, from, towards, f32::INFINITY, &Progress::new()).unwrap().t_hit, [1.0]);
    let progress = Progress::new();
    progress.cancel();
    let cancelled = cast(&scene, from, towards, f32::INFINITY, &progress);
    assert_eq!(cancelled.err(), Some(crate::base::Error::Cancelled));
}

#[test]
fn rays_that_overflow_do_not_panic() {
    let placed = DAffine3::from_scale_rotation_translation(DVec3::splat(1e-35), DQuat::IDENTITY, DVec3::X);
    for transform in [DAffine3::IDENTITY, placed] {
        let scene = scene(vec![(mesh(&wall(5.0, 3.0)), transform), (mesh(&wall(7.0, 3.0)), transform)], vec![]);
        for start in [0.0, 1e9, f32::MAX, f32::INFINITY, f32::NAN] {
            for direction in [Vec3::Z, Vec3::new(0.6, 0.0, -0.8), Vec3::new(-0.5, 0.5, 0.7), Vec3::splat(f32::NAN)] {
                let rays = [Vec3::X, Vec3::Y, Vec3::ONE, Vec3::NEG_ONE].map(|p| ray(p * start, direction));
                let mut hits = [Hit::MISS; 64];
                closest_hits(&scene, &rays.repeat(16), &AcceptAll, &mut hits);
                rays.iter().for_each(|ray| closest_hits(&scene, &[*ray], &AcceptAll, &mut hits[..1]));
            }
        }
    }
}

#[test]
fn trees_can_be_built_by_all_threads_at_once() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(4).build().unwrap();
    for turn in 0..2 {
        let triangles: Vec<[Vec3; 3]> =
            (0..1_000).flat_map(|n| wall(((n * 7919 + turn) % 1_009) as f32, 1.0)).collect();
        let mesh = mesh(&triangles);
        // A thread that waits for a part of its tree may start another of these builds.
        pool.install(|| (0..8).into_par_iter().for_each(|_| assert!(mesh.build_bvh(&Progress::new()).is_ok())));
    }
}
