//! Tests of the tracer against a brute-force search over all triangles of all instances. Single rays, packets and all
//! instruction sets must also give the same bits.

mod defects;
mod watertight;

use std::slice;
use std::sync::Arc;

use glam::{DAffine3, DQuat, DVec3, Vec3};
use proptest::prelude::*;

use super::dispatch::{any_hits_with, closest_hits_with};
use super::lanes::InstructionSet;
use super::*;
use crate::base::{FaceMap, Progress};
use crate::scene::{Instance, Mesh, Scene};

impl Scene {
    /// Returns a scene without materials at the world's origin.
    pub(crate) fn of_instances(standing: Vec<Instance>, moving: Vec<Instance>) -> Self {
        Self::new(DVec3::ZERO, standing, moving, Arc::default(), Arc::default()).unwrap()
    }
}

pub(super) fn mesh(triangles: &[[Vec3; 3]]) -> Arc<Mesh> {
    let triangles: Vec<_> = triangles.iter().map(|corners| corners.map(|corner| corner.to_array())).collect();
    Mesh::of_triangles(&triangles, FaceMap::Uniform(-1))
}

pub(super) fn scene(standing: Vec<(Arc<Mesh>, DAffine3)>, moving: Vec<(Arc<Mesh>, DAffine3)>) -> Scene {
    let place = |list: Vec<(Arc<Mesh>, DAffine3)>| {
        list.into_iter().map(|(mesh, map)| Instance::new(mesh, map, None).unwrap()).collect()
    };
    let scene = Scene::of_instances(place(standing), place(moving));
    scene.build(&Progress::new()).unwrap();
    scene
}

fn ray(origin: Vec3, direction: Vec3) -> Ray {
    Ray { origin, direction, t_min: 0.0, t_max: f32::INFINITY }
}

fn point() -> impl Strategy<Value = Vec3> {
    [-1.0f32..1.0, -1.0f32..1.0, -1.0f32..1.0].prop_map(Vec3::from_array)
}

/// The Möller–Trumbore intersection in float64, two-sided.
fn oracle(triangles: &[[Vec3; 3]], ray: &Ray) -> Option<(f64, usize)> {
    let (o, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let hit = |(face, corners): (usize, &[Vec3; 3])| {
        let [a, b, c] = corners.map(|p| p.as_dvec3());
        let (e1, e2, s) = (b - a, c - a, o - a);
        let (p, q) = (d.cross(e2), s.cross(e1));
        let det = e1.dot(p);
        let (u, v, t) = (s.dot(p) / det, d.dot(q) / det, e2.dot(q) / det);
        (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t >= 0.0).then_some((t, face))
    };
    triangles.iter().enumerate().filter_map(hit).min_by(|a, b| a.0.total_cmp(&b.0))
}

/// A hit as bits, for comparison.
fn bits(hit: &Hit) -> [u32; 5] {
    [hit.t.to_bits(), hit.u.to_bits(), hit.v.to_bits(), hit.instance, hit.face]
}

/// Traces in packets and one by one with every instruction set; asserts that all results have the same bits.
fn trace_all_ways(scene: &Scene, rays: &[Ray], filter: &dyn HitFilter) -> Vec<Hit> {
    let mut expected = vec![Hit::MISS; rays.len()];
    for (ray, hit) in rays.iter().zip(&mut expected) {
        // Slices of one ray never become packets.
        closest_hits_with(InstructionSet::Portable, scene, slice::from_ref(ray), filter, slice::from_mut(hit));
    }
    for level in InstructionSet::available() {
        let mut together = vec![Hit::MISS; rays.len()];
        closest_hits_with(level, scene, rays, filter, &mut together);
        let mut alone = vec![Hit::MISS; rays.len()];
        for (ray, hit) in rays.iter().zip(&mut alone) {
            closest_hits_with(level, scene, slice::from_ref(ray), filter, slice::from_mut(hit));
        }
        let mut any = vec![false; rays.len()];
        any_hits_with(level, scene, rays, filter, &mut any);
        for i in 0..rays.len() {
            let name = level.name();
            assert_eq!(bits(&expected[i]), bits(&alone[i]), "{name}, alone: {:?}", rays[i]);
            assert_eq!(bits(&expected[i]), bits(&together[i]), "{name}, together: {:?}", rays[i]);
            assert_eq!(any[i], !expected[i].is_miss(), "{name}, any: {:?}", rays[i]);
        }
    }
    expected
}

/// A beam of 10 × 10 rays around a direction.
fn beam(origin: Vec3, direction: Vec3, width: f32) -> Vec<Ray> {
    let side = direction.any_orthonormal_vector();
    let up = direction.cross(side);
    let offset = |i: i32| (i as f32 - 4.5) / 10.0 * width;
    (0..100).map(|i| ray(origin, direction + side * offset(i % 10) + up * offset(i / 10))).collect()
}

fn placement() -> impl Strategy<Value = DAffine3> {
    (point(), point(), 0.2f64..3.0, any::<bool>()).prop_map(|(axis, shift, size, in_place)| {
        if in_place {
            return DAffine3::IDENTITY;
        }
        let turn = DQuat::from_scaled_axis(axis.as_dvec3() * 3.0);
        DAffine3::from_scale_rotation_translation(DVec3::splat(size), turn, shift.as_dvec3())
    })
}

fn soup(max_count: usize) -> impl Strategy<Value = Vec<[Vec3; 3]>> {
    prop::collection::vec([point(), point(), point()], 0..max_count)
}

fn direction() -> impl Strategy<Value = Vec3> {
    point().prop_filter("has a direction", |p| p.length() > 0.1).prop_map(Vec3::normalize)
}

proptest! {
    #[test]
    fn a_soup_agrees_with_the_oracle(triangles in soup(60), rays in prop::collection::vec((point(), direction()), 20)) {
        let scene = scene(vec![(mesh(&triangles), DAffine3::IDENTITY)], vec![]);
        let rays: Vec<Ray> = rays.into_iter().map(|(origin, direction)| ray(origin, direction)).collect();
        for (ray, found) in rays.iter().zip(trace_all_ways(&scene, &rays, &AcceptAll)) {
            let expected = oracle(&triangles, ray);
            // Corners are within 2 m of the origin, with 24 bits; a relative tolerance of 1e-4 allows for slivers.
            match expected {
                Some((t, _)) => prop_assert!((f64::from(found.t) - t).abs() <= 1e-4 * (1.0 + t), "{found:?} {expected:?}"),
                None => prop_assert!(found.is_miss()),
            }
        }
    }

    #[test]
    fn all_ways_through_instances_agree(
        meshes in prop::collection::vec(soup(30), 1..4),
        standing in prop::collection::vec((0usize..3, placement()), 0..8),
        moving in prop::collection::vec((0usize..3, placement()), 0..4),
        origin in point(),
        toward in direction(),
        width in 0.001f32..1.0,
        parity in any::<bool>(),
    ) {
        let meshes: Vec<_> = meshes.iter().map(|triangles| mesh(triangles)).collect();
        let place = |list: Vec<(usize, DAffine3)>| -> Vec<_> {
            list.into_iter().map(|(number, map)| (Arc::clone(&meshes[number % meshes.len()]), map)).collect()
        };
        let scene = scene(place(standing), place(moving));
        let rays = beam(origin * 2.0, toward, width);
        if parity {
            trace_all_ways(&scene, &rays, &EvenFaces);
        } else {
            trace_all_ways(&scene, &rays, &AcceptAll);
        }
    }

    #[test]
    fn instances_agree_with_their_merged_triangles(
        triangles in soup(30),
        maps in prop::collection::vec(placement(), 1..6),
        origin in point(),
        toward in direction(),
    ) {
        let mesh_once = mesh(&triangles);
        let split = maps.len() / 2;
        let mut placed: Vec<_> = maps.iter().map(|&map| (Arc::clone(&mesh_once), map)).collect();
        let moving = placed.split_off(split);
        let instanced = scene(placed, moving);
        let merged: Vec<[Vec3; 3]> = instanced
            .triangles(&Progress::new())
            .unwrap()
            .as_chunks::<9>()
            .0
            .iter()
            .map(|c| [0, 3, 6].map(|i: usize| Vec3::from_slice(&c[i..])))
            .collect();
        let rays = beam(origin * 3.0, toward, 0.4);
        for (ray, found) in rays.iter().zip(trace_all_ways(&instanced, &rays, &AcceptAll)) {
            // Merging rounds corners once, placement rounds rays twice. So near an edge the ray may hit only one of the
            // two, and only rays clear of all edges are compared.
            let Some((t, face, clear)) = clear_oracle(&merged, ray) else { continue };
            if clear {
                prop_assert!((f64::from(found.t) - t).abs() <= 1e-4 * (1.0 + t));
                let number = instanced.triangle_offset(found.instance) + i64::from(found.face);
                prop_assert_eq!(number, face as i64);
            }
        }
    }
}

/// A filter that accepts every second face.
struct EvenFaces;

impl HitFilter for EvenFaces {
    fn accepts(&self, _ray: &Ray, candidate: &Hit) -> bool {
        candidate.face.is_multiple_of(2)
    }
}

/// Returns the nearest hit, and whether it is clear: larger and smaller triangles give the same hit, and all others are
/// more than 1e-3 farther away.
fn clear_oracle(triangles: &[[Vec3; 3]], ray: &Ray) -> Option<(f64, usize, bool)> {
    let (t, face) = oracle(triangles, ray)?;
    let grown = |factor: f32| -> Vec<[Vec3; 3]> {
        let grow = |[a, b, c]: [Vec3; 3]| {
            let center = (a + b + c) / 3.0;
            [a, b, c].map(|p| center + (p - center) * factor)
        };
        triangles.iter().map(|&corners| grow(corners)).collect()
    };
    let alike = |factor: f32| {
        oracle(&grown(factor), ray).is_some_and(|(other, number)| number == face && (other - t).abs() < 1e-3)
    };
    let others: Vec<[Vec3; 3]> = triangles.iter().enumerate().filter(|&(i, _)| i != face).map(|(_, &c)| c).collect();
    let alone = oracle(&others, ray).is_none_or(|(other, _)| other > t + 1e-3);
    Some((t, face, alone && alike(1.003) && alike(0.997)))
}

#[test]
fn scenes_without_triangles() {
    let nothing = mesh(&[]);
    for scene in [scene(vec![], vec![]), scene(vec![(nothing, DAffine3::IDENTITY)], vec![])] {
        let hits = trace_all_ways(&scene, &beam(Vec3::ZERO, Vec3::X, 0.1), &AcceptAll);
        assert!(hits.iter().all(Hit::is_miss));
    }
}

#[test]
fn ties_go_to_the_lowest_instance_and_face() {
    let triangle = [Vec3::new(-1.0, -1.0, 2.0), Vec3::new(2.0, -1.0, 2.0), Vec3::new(-1.0, 2.0, 2.0)];
    let other = [triangle[1], triangle[2], triangle[0]];
    let twice = mesh(&[triangle, other, triangle]);
    let scene = scene(
        vec![(mesh(&[]), DAffine3::IDENTITY), (Arc::clone(&twice), DAffine3::IDENTITY)],
        vec![(twice, DAffine3::IDENTITY)],
    );
    for hit in trace_all_ways(&scene, &beam(Vec3::ZERO, Vec3::Z, 0.1), &AcceptAll) {
        assert_eq!((hit.instance, hit.face), (1, 0));
    }
}

#[test]
fn segments_end_at_their_limits() {
    let triangle = |z: f32| [Vec3::new(-9.0, -9.0, z), Vec3::new(9.0, -9.0, z), Vec3::new(0.0, 9.0, z)];
    let scene = scene(vec![(mesh(&[triangle(1.0), triangle(2.0), triangle(3.0)]), DAffine3::IDENTITY)], vec![]);
    for (t_min, t_max, face) in [(0.0, 9.0, 0), (1.0, 9.0, 0), (1.5, 9.0, 1), (1.5, 2.0, 1), (2.5, 2.75, u32::MAX)] {
        let rays: Vec<Ray> = beam(Vec3::ZERO, Vec3::Z, 0.0).iter().map(|&ray| Ray { t_min, t_max, ..ray }).collect();
        for hit in trace_all_ways(&scene, &rays, &AcceptAll) {
            assert_eq!(hit.face, face, "{t_min} {t_max}");
        }
    }
}
