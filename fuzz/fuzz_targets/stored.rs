//! Reads arbitrary tables of rows over arbitrary bytes. A table must be refused, or its usable meshes must join to one mesh
//! whose faces lie between its vertices.

#![no_main]

use arbitrary::Arbitrary;
use glam::DAffine3;
use libfuzzer_sys::fuzz_target;
use nearfar_core::base::Progress;
use nearfar_core::scene::stored::{Attributes, ComponentType, Rows, StoredFaces, StoredMeshes, StoredPart};

#[derive(Arbitrary, Debug)]
struct Input {
    bytes: Vec<u8>,
    rows: Vec<(u8, u8, u8, u8, u8, bool)>,
    /// Rows whose places are absurd.
    wild: Vec<(usize, usize, usize, usize, u8)>,
    faces: Vec<([u8; 4], Option<u8>, bool)>,
    factor: f64,
}

fn component(code: u8) -> ComponentType {
    [
        ComponentType::I8,
        ComponentType::U8,
        ComponentType::I16,
        ComponentType::U16,
        ComponentType::U32,
        ComponentType::F32,
    ][usize::from(code) % 6]
}

fn rows_of(input: &Input) -> Vec<Rows> {
    let near = input.rows.iter().map(|&(start, step, count, width, code, is_fraction)| Rows {
        block: 0,
        start: start.into(),
        step: step.into(),
        count: count.into(),
        width: usize::from(width % 5),
        component: component(code),
        is_fraction,
    });
    let wild = input.wild.iter().map(|&(block, start, step, count, code)| Rows {
        block,
        start,
        step,
        count,
        width: 3,
        component: component(code),
        is_fraction: false,
    });
    near.chain(wild).collect()
}

fuzz_target!(|input: Input| {
    let mut mesh = 0;
    let faces: Vec<StoredFaces> = input
        .faces
        .iter()
        .map(|&([positions, normals, uvs, colors], corners, is_next)| {
            mesh += usize::from(is_next);
            let some = |number: u8| (number < 128).then_some(usize::from(number));
            let attributes = Attributes {
                positions: positions.into(),
                normals: some(normals),
                uvs: some(uvs),
                colors: some(colors),
            };
            StoredFaces { mesh, attributes, corners: corners.map(usize::from), material: 0 }
        })
        .collect();
    let progress = Progress::new();
    let rows = rows_of(&input);
    let Ok(stored) = StoredMeshes::new(vec![input.bytes.into()], rows, &faces, &progress) else { return };
    let usable: Vec<usize> = (0..stored.len()).filter(|&mesh| stored.is_usable(mesh)).collect();
    assert_eq!(stored.see_through().len(), faces.len());
    let boxes = stored.face_bounds(&progress).unwrap();
    let parts: Vec<StoredPart> =
        usable.iter().map(|&mesh| StoredPart { mesh, to_scene: DAffine3::IDENTITY, object: 0 }).collect();
    let joined = stored.join(&parts, &progress).unwrap();
    let counts = |of: &dyn Fn(usize) -> usize| usable.iter().map(|&mesh| of(mesh)).sum::<usize>();
    assert_eq!(joined.faces.len(), counts(&|mesh| stored.face_count(mesh)));
    assert_eq!(joined.positions.len(), counts(&|mesh| stored.vertex_count(mesh)));
    assert!(joined.faces.as_flattened().iter().all(|&vertex| (vertex as usize) < joined.positions.len()));
    for &mesh in &usable {
        let alone = stored.mesh(mesh, &progress).unwrap().bounds();
        assert_eq!([alone.min, alone.max].map(|corner| corner.as_dvec3().to_array()), boxes[mesh]);
    }
    let _ = stored.scaled(input.factor).join(&parts, &progress);
});
