//! Any arrays as a placed mesh: an error, or a scene whose rays and nearest points name its triangles.

#![no_main]

use std::sync::Arc;

use arbitrary::Arbitrary;
use glam::{DAffine3, DVec3};
use libfuzzer_sys::fuzz_target;
use nearfar_core::base::{FaceMap, Progress};
use nearfar_core::scene::{Instance, Material, Mesh, Scene};
use nearfar_core::trace::{Points, cast, nearest};

#[derive(Arbitrary, Debug)]
struct Input {
    positions: Vec<[f32; 3]>,
    /// Small numbers, so that many name a vertex.
    faces: Vec<[u8; 3]>,
    transform: Option<[f64; 12]>,
    origin: [f64; 3],
    rays: Vec<[[f64; 3]; 2]>,
    t_max: f32,
}

fn scene(input: &Input) -> nearfar_core::base::Result<Scene> {
    let faces: Vec<[u32; 3]> = input.faces.iter().map(|face| face.map(u32::from)).collect();
    let positions = input.positions.clone().into();
    let mesh = Mesh::new(positions, faces.into(), None, None, FaceMap::Uniform(0), FaceMap::Uniform(0))?;
    let transform = input.transform.map_or(DAffine3::IDENTITY, |columns| DAffine3::from_cols_array(&columns));
    let instance = Instance::new(Arc::new(mesh), transform, Some(0))?;
    let materials = Arc::new(vec![Material::default()]);
    Scene::new(DVec3::from_array(input.origin), vec![instance], Vec::new(), materials, Arc::default())
}

fuzz_target!(|input: Input| {
    let Ok(scene) = scene(&input) else { return };
    let progress = Progress::new();
    let count = scene.triangle_count();
    let origins: Vec<[f64; 3]> = input.rays.iter().map(|ray| ray[0]).collect();
    let directions: Vec<[f64; 3]> = input.rays.iter().map(|ray| ray[1]).collect();
    let rays = (Points::Double(&origins), Points::Double(&directions));
    if let Ok(hits) = cast(&scene, rays.0, rays.1, input.t_max, &progress) {
        assert!(hits.triangle_index.iter().all(|&triangle| (-1..count).contains(&triangle)));
        assert!(hits.t_hit.iter().all(|t| !t.is_nan()));
    }
    if let Ok(found) = nearest(&scene, Points::Double(&origins), None, &progress) {
        assert!(found.triangle_index.iter().all(|&triangle| (-1..count).contains(&triangle)));
        assert!(found.distance.iter().all(|distance| !distance.is_nan()));
    }
    assert!(scene.degenerate_count(&progress).unwrap() as i64 <= count);
    scene.bounds();
});
