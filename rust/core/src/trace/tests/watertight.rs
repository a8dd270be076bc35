//! Tests that no ray passes between triangles.

use super::*;
use crate::base::random::uniform;

/// An uneven ground of n × n squares of `size`, moved by `shift`; the diagonals of squares alternate.
fn ground(n: usize, size: f32, shift: Vec3) -> (Vec<Vec3>, Vec<[usize; 3]>) {
    let height = |i: usize| uniform(5, 0, i as u64) as f32 * size;
    let points = (0..(n + 1) * (n + 1))
        .map(|i| shift + Vec3::new((i % (n + 1)) as f32 * size, height(i), (i / (n + 1)) as f32 * size))
        .collect();
    let mut faces = vec![];
    for i in (0..n * n).map(|i| i / n * (n + 1) + i % n) {
        let (a, b, c, d) = (i, i + 1, i + n + 1, i + n + 2);
        faces.extend(if i % 2 == 0 { [[a, b, d], [a, d, c]] } else { [[a, b, c], [b, d, c]] });
    }
    (points, faces)
}

/// Rays from `eye` to points on all inner edges and to all inner vertices.
fn rays_to_edges(points: &[Vec3], faces: &[[usize; 3]], n: usize, eye: impl Fn(Vec3) -> Vec3) -> Vec<Ray> {
    let inner = |i: usize| (1..n).contains(&(i % (n + 1))) && (1..n).contains(&(i / (n + 1)));
    let mut rays = vec![];
    for (number, face) in faces.iter().enumerate() {
        for (i, j) in [(face[0], face[1]), (face[1], face[2]), (face[2], face[0])] {
            if inner(i) && inner(j) {
                let s = uniform(6, number as u64, i as u64) as f32;
                for target in [points[i], points[i].lerp(points[j], s), points[i].lerp(points[j], 0.5)] {
                    let origin = eye(target);
                    rays.push(ray(origin, target - origin));
                }
            }
        }
    }
    rays
}

#[test]
fn no_ray_passes_an_edge_or_a_vertex_near_or_far() {
    let n = 16;
    for shift in [Vec3::ZERO, Vec3::new(1e4, -30.0, -1e4), Vec3::new(-7e3, 1e4, 31.7)] {
        for size in [0.1, 1.0, 25.0] {
            let (points, faces) = ground(n, size, shift);
            let triangles: Vec<[Vec3; 3]> = faces.iter().map(|f| f.map(|v| points[v])).collect();
            let scene = scene(vec![(mesh(&triangles), DAffine3::IDENTITY)], vec![]);
            let middle = shift + Vec3::new(n as f32 * size / 2.0, 6.0 * size, n as f32 * size / 2.0);
            // From one eye, straight down (parallel to an axis), and with negative zeros.
            let one_eye = rays_to_edges(&points, &faces, n, |_| middle);
            let above = rays_to_edges(&points, &faces, n, |p| Vec3::new(p.x, shift.y + 5.0 * size, p.z));
            let mut zeros = above.clone();
            zeros.iter_mut().for_each(|ray| ray.direction = Vec3::new(-0.0, ray.direction.y, -0.0));
            for rays in [one_eye, above, zeros] {
                let hits = trace_all_ways(&scene, &rays, &AcceptAll);
                let lost = hits.iter().filter(|hit| hit.is_miss()).count();
                assert_eq!(lost, 0, "of {} at {shift}, size {size}", rays.len());
            }
        }
    }
}

#[test]
fn no_ray_leaves_a_closed_box_for_any_length_of_directions() {
    let corner = |i: usize| {
        let side = |bit: usize| if i >> bit & 1 == 1 { 1.0 } else { -1.0 };
        Vec3::new(side(0), side(1), side(2))
    };
    let quads = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
    let triangles: Vec<[Vec3; 3]> =
        quads.iter().flat_map(|q| [[q[0], q[1], q[2]], [q[0], q[2], q[3]]]).map(|f| f.map(corner)).collect();
    let scene = scene(vec![(mesh(&triangles), DAffine3::IDENTITY)], vec![]);
    let draw = |i: u64, axis: u64| uniform(9, i, axis) as f32 * 2.0 - 1.0;
    let mut rays = vec![];
    for i in 0..400 {
        let origin = Vec3::new(draw(i, 0), draw(i, 1), draw(i, 2)) * 0.99;
        // Targets on faces, edges and corners (snapped coordinates), and along the axes.
        let mut target = Vec3::new(draw(i, 3), draw(i, 4), draw(i, 5));
        let snapped = i % 4;
        (0..snapped as usize).for_each(|axis| target[axis] = target[axis].signum());
        for length in [1e-6, 1.0, 1e6] {
            rays.push(ray(origin, (target - origin) * length));
            rays.push(ray(origin, Vec3::AXES[i as usize % 3] * length));
            rays.push(ray(origin, -Vec3::AXES[i as usize % 3] * length));
        }
    }
    let hits = trace_all_ways(&scene, &rays, &AcceptAll);
    assert_eq!(hits.iter().filter(|hit| hit.is_miss()).count(), 0);
}
