//! The tracer against the slow obvious way: every triangle of every instance, in order.

use std::sync::Arc;

use glam::{DAffine3, DVec3, Vec3};
use proptest::prelude::*;

use super::*;
use crate::base::Progress;
use crate::scene::{FaceMap, Instance, Mesh};

pub(super) fn mesh(triangles: &[[Vec3; 3]]) -> Arc<Mesh> {
    let positions: Vec<[f32; 3]> = triangles.iter().flatten().map(Vec3::to_array).collect();
    let faces: Vec<[u32; 3]> = (0..triangles.len() as u32).map(|f| [3 * f, 3 * f + 1, 3 * f + 2]).collect();
    let none = FaceMap::Uniform(-1);
    Arc::new(Mesh::new(positions.into(), faces.into(), None, None, none.clone(), none).unwrap())
}

pub(super) fn scene(standing: Vec<(Arc<Mesh>, DAffine3)>, moving: Vec<(Arc<Mesh>, DAffine3)>) -> Scene {
    let place = |list: Vec<(Arc<Mesh>, DAffine3)>| {
        list.into_iter().map(|(mesh, map)| Instance::new(mesh, map, None).unwrap()).collect()
    };
    let scene = Scene::new(DVec3::ZERO, place(standing), place(moving), Arc::default(), Arc::default()).unwrap();
    scene.build(&Progress::new()).unwrap();
    scene
}

fn ray(origin: Vec3, direction: Vec3) -> Ray {
    Ray { origin, direction, t_min: 0.0, t_max: f32::INFINITY }
}

fn point() -> impl Strategy<Value = Vec3> {
    [-1.0f32..1.0, -1.0f32..1.0, -1.0f32..1.0].prop_map(Vec3::from_array)
}

/// Möller–Trumbore in float64, two-sided.
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

proptest! {
    #[test]
    fn a_soup_agrees_with_the_oracle(
        triangles in prop::collection::vec([point(), point(), point()], 0..60),
        rays in prop::collection::vec((point(), point()), 20),
    ) {
        let scene = scene(vec![(mesh(&triangles), DAffine3::IDENTITY)], vec![]);
        for (origin, direction) in rays {
            let ray = ray(origin, direction);
            let found = closest_hit(&scene, &ray, &All);
            let expected = oracle(&triangles, &ray);
            // Corners within 2 of the origin, 24 bits: a relative 1e-4 leaves three digits for slivers.
            match expected {
                Some((t, _)) => prop_assert!((f64::from(found.t) - t).abs() <= 1e-4 * (1.0 + t), "{found:?} {expected:?}"),
                None => prop_assert!(found.is_miss()),
            }
        }
    }
}
