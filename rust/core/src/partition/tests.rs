use std::sync::Arc;

use glam::{DAffine3, DVec3};
use proptest::prelude::*;

use super::{LoadCurve, Partition, TriangleSet};
use crate::base::{Error, FaceMap, Progress};
use crate::scene::{Instance, Mesh, Scene};

/// Triangles with corners on a coarse grid, which often touch the axis or have collinear or coincident corners.
fn triangles(count: usize) -> impl Strategy<Value = Vec<[[f32; 3]; 3]>> {
    let coordinate = (-40i32..40).prop_map(|i| i as f32 * 0.5);
    prop::collection::vec(prop::array::uniform3(prop::array::uniform3(coordinate)), 1..count)
}

fn mesh(triangles: &[[[f32; 3]; 3]]) -> Arc<Mesh> {
    Mesh::of_triangles(triangles, FaceMap::Uniform(-1))
}

fn scene(origin: DVec3, static_instances: Vec<Instance>, moving: Vec<Instance>) -> Scene {
    Scene::new(origin, static_instances, moving, Arc::default(), Arc::default()).unwrap()
}

fn instance(mesh: &Arc<Mesh>, to_scene: DAffine3) -> Instance {
    Instance::new(Arc::clone(mesh), to_scene, None).unwrap()
}

fn radii_of<T: Into<f64>>(corners: [[T; 2]; 3], axis: [f64; 2]) -> [f64; 2] {
    let [a, b, c] = corners.map(|corner| corner.map(Into::into));
    super::radii_of(a, b, c, axis)
}

/// Computes the minimum ρ by definition: over the convex hull of the corners, sampled on a fine grid of weights.
fn sampled_min_radius(triangle: &[[f32; 3]; 3], axis: [f64; 2]) -> f64 {
    let n = 60;
    let mut least = f64::INFINITY;
    for i in 0..=n {
        for j in 0..=n - i {
            let weights = [i, j, n - i - j].map(|k| f64::from(k) / f64::from(n));
            let coordinate = |k: usize| triangle.iter().zip(weights).map(|(c, w)| f64::from(c[k]) * w).sum::<f64>();
            least = least.min((coordinate(0) - axis[0]).hypot(coordinate(2) - axis[1]));
        }
    }
    least
}

proptest! {
    #[test]
    fn least_radius_equals_the_sampled_triangle(all_triangles in triangles(6), x in -20i32..20, z in -20i32..20) {
        let axis = [f64::from(x) * 0.5, f64::from(z) * 0.5];
        for triangle in &all_triangles {
            let [least, greatest] = radii_of(triangle.map(|c| [c[0], c[2]]), axis);
            let sampled_radius = sampled_min_radius(triangle, axis);
            let longest_edge = (0..3).map(|i| {
                let (a, b) = (triangle[i], triangle[(i + 1) % 3]);
                f64::from(a[0] - b[0]).hypot(f64::from(a[2] - b[2]))
            }).fold(0.0, f64::max);
            // Samples lie inside the triangle, so none is nearer than the nearest point, and one lies within a step of
            // the grid, longest_edge / 60, of that point.
            prop_assert!(least <= sampled_radius + 1e-12);
            let bound = least + longest_edge / 60.0 + 1e-12;
            prop_assert!(sampled_radius <= bound, "{least} {sampled_radius} {triangle:?}");
            let corners = triangle.map(|c| (f64::from(c[0]) - axis[0]).hypot(f64::from(c[2]) - axis[1]));
            prop_assert!((greatest - corners.into_iter().fold(0.0, f64::max)).abs() < 1e-13);
        }
    }

    #[test]
    fn instances_are_partitioned_like_merged_triangles(
        all_triangles in triangles(40),
        placements in prop::collection::vec((-30.0..30.0, 0.0..6.0, 0.5..3.0), 1..6),
        r1 in 0.0..12.0,
        width in 0.1..15.0,
    ) {
        let shared = mesh(&all_triangles);
        let static_instances: Vec<Instance> = placements.iter().map(|&(x, angle, scale): &(f64, f64, f64)| {
            let rotation_and_scale = DAffine3::from_rotation_y(angle) * DAffine3::from_scale(DVec3::splat(scale));
            instance(&shared, DAffine3::from_translation(DVec3::new(x, 0.0, -x)) * rotation_and_scale)
        }).chain([instance(&shared, DAffine3::IDENTITY)]).collect();
        let (origin, progress) = (DVec3::new(1e6, 0.0, -3e5), Progress::new());
        let instanced = scene(origin, static_instances, vec![]);
        let corners: Vec<[[f32; 3]; 3]> =
            instanced.triangles(&Progress::new()).unwrap().chunks_exact(9).map(|c| [0, 3, 6].map(|i| [c[i], c[i + 1], c[i + 2]])).collect();
        let merged = scene(origin, vec![instance(&mesh(&corners), DAffine3::IDENTITY)], vec![]);
        let center = origin + DVec3::new(1.0, 5.0, -2.0);
        let [a, b] = [&instanced, &merged].map(|s| Partition::new(s, center, r1, r1 + width, &progress).unwrap());
        for part in [TriangleSet::Near, TriangleSet::Intermediate, TriangleSet::Far, TriangleSet::Nsf, TriangleSet::Sf] {
            prop_assert_eq!(a.triangles(part, &Progress::new()).unwrap(), b.triangles(part, &Progress::new()).unwrap());
        }
        a.validate(&progress).unwrap();
        b.validate(&progress).unwrap();
        let curve = LoadCurve::new(&instanced, center, &progress).unwrap();
        prop_assert_eq!(curve.count(r1 + width).unwrap(), a.counts.nsf);
        let nsf_numbers: Vec<i64> = a.nsf().map(|(i, face)| instanced.triangle_offset(i) + i64::from(face)).collect();
        prop_assert_eq!(nsf_numbers, a.triangles(TriangleSet::Nsf, &Progress::new()).unwrap());
    }
}

#[test]
fn degenerate_triangles_have_their_zones() {
    let zone_radii = |corners: [[f32; 2]; 3]| radii_of(corners, [0.0, 0.0]);
    // A large triangle around the axis, and triangles that touch it with a corner and with an edge.
    assert_eq!(zone_radii([[-100.0, -100.0], [100.0, -100.0], [0.0, 100.0]])[0], 0.0);
    assert_eq!(zone_radii([[0.0, 0.0], [10.0, 0.0], [0.0, 10.0]])[0], 0.0);
    assert_eq!(zone_radii([[-5.0, 0.0], [5.0, 0.0], [0.0, 10.0]])[0], 0.0);
    // Walls: across the axis, beside it, and on a line through it.
    assert_eq!(zone_radii([[-3.0, 4.0], [3.0, 4.0], [3.0, 4.0]]), [4.0, 5.0]);
    assert_eq!(zone_radii([[-3.0, 0.0], [3.0, 0.0], [1.0, 0.0]]), [0.0, 3.0]);
    assert_eq!(zone_radii([[10.0, 10.0], [20.0, 20.0], [15.0, 15.0]])[0], 200f64.sqrt());
    // A point, and the axis itself.
    assert_eq!(zone_radii([[3.0, 4.0]; 3]), [5.0, 5.0]);
    assert_eq!(zone_radii([[0.0; 2]; 3]), [0.0, 0.0]);
    // A sliver on a line that nearly meets the axis does not contain it.
    let [least, _] = zone_radii([[10.0, 1e-7], [20.0, 2.0001e-7], [15.0, 1.5e-7]]);
    assert!((least - 10.0).abs() < 1e-12);
    // A millimetre at 100 km: edges are differences of the given coordinates.
    let corners = [[1e5f64, 0.0], [1e5 + 1e-3, 5e-4], [1e5, 1e-3]];
    assert!((radii_of(corners, [0.0, 5e-4])[0] - 1e5).abs() < 1e-10);
    assert!(zone_radii([[f32::NAN, 0.0], [1.0, 0.0], [0.0, 1.0]])[1].is_nan());
}

#[test]
fn moving_triangles_stay_geometry() {
    let near = mesh(&[[[1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 1.0, 1.0]]]);
    let far = DAffine3::from_translation(DVec3::X * 500.0);
    let static_instances = vec![instance(&near, DAffine3::IDENTITY), instance(&near, far)];
    let both = scene(DVec3::ZERO, static_instances, vec![instance(&near, far)]);
    let progress = Progress::new();
    let partition = Partition::new(&both, DVec3::ZERO, 30.0, 50.0, &progress).unwrap();
    partition.validate(&progress).unwrap();
    assert_eq!(partition.triangles(TriangleSet::Nsf, &Progress::new()).unwrap(), [0, 2]);
    assert_eq!(partition.triangles(TriangleSet::Sf, &Progress::new()).unwrap(), [1]);
    assert_eq!(partition.triangles(TriangleSet::Far, &Progress::new()).unwrap(), [1, 2]);
    // The boxes decided all classes: no triangle was examined.
    assert_eq!((partition.counts.examined, partition.counts.far_instances), (0, 2));
    let curve = LoadCurve::new(&both, DVec3::ZERO, &progress).unwrap();
    assert_eq!((curve.count(50.0), curve.count(1e9)), (Ok(2), Ok(3)));
    assert_eq!(curve.radius(3), Ok(f64::INFINITY));
    let radius = curve.radius(2).unwrap();
    assert_eq!((curve.count(radius), curve.count(radius.next_up())), (Ok(2), Ok(3)));
    assert!(curve.radius(0).is_err());
}

#[test]
fn empty_scenes_have_empty_partitions() {
    let (empty_scene, progress) =
        (scene(DVec3::ZERO, vec![instance(&mesh(&[]), DAffine3::IDENTITY)], vec![]), Progress::new());
    let partition = Partition::new(&empty_scene, DVec3::ZERO, 0.0, 1.0, &progress).unwrap();
    assert!(partition.counts.sf == 0 && partition.nsf().next().is_none());
    partition.validate(&progress).unwrap();
    let curve = LoadCurve::new(&empty_scene, DVec3::ZERO, &progress).unwrap();
    assert_eq!((curve.count(0.0), curve.radius(0)), (Ok(0), Ok(f64::INFINITY)));
}

#[test]
fn invalid_input_and_cancelling_stop_early() {
    let single_triangle = scene(DVec3::ZERO, vec![instance(&mesh(&[[[1.0; 3]; 3]]), DAffine3::IDENTITY)], vec![]);
    let progress = Progress::new();
    for (center, r1, r2) in
        [(DVec3::NAN, 1.0, 2.0), (DVec3::ZERO, 2.0, 2.0), (DVec3::ZERO, -1.0, 2.0), (DVec3::ZERO, 1.0, f64::NAN)]
    {
        assert!(Partition::new(&single_triangle, center, r1, r2, &progress).is_err());
    }
    assert!(LoadCurve::new(&single_triangle, DVec3::INFINITY, &progress).is_err());
    progress.cancel();
    let cancelled = Partition::new(&single_triangle, DVec3::ZERO, 1.0, 2.0, &progress);
    assert_eq!(cancelled.err(), Some(Error::Cancelled));
    assert_eq!(LoadCurve::new(&single_triangle, DVec3::ZERO, &progress).err(), Some(Error::Cancelled));
}
