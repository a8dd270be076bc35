//! Any surface for edge collapses: an error, or faces of its vertices and an error that is a number.

#![no_main]

use arbitrary::Arbitrary;
use libfuzzer_sys::fuzz_target;
use nearfar_core::base::Progress;
use nearfar_core::lod::{Allowance, Vertices, collapse, pieces};

#[derive(Arbitrary, Debug)]
struct Input {
    vertices: Vec<([f32; 3], [f32; 2], bool)>,
    /// Small numbers, so that many name a vertex.
    faces: Vec<[u8; 3]>,
    weights: [f32; 2],
    target: u8,
    allowance: u8,
}

fuzz_target!(|input: Input| {
    let positions: Vec<[f32; 3]> = input.vertices.iter().map(|vertex| vertex.0).collect();
    let attributes: Vec<f32> = input.vertices.iter().flat_map(|vertex| vertex.1).collect();
    let is_protected: Vec<bool> = input.vertices.iter().map(|vertex| vertex.2).collect();
    let faces: Vec<[u32; 3]> = input.faces.iter().map(|face| face.map(u32::from)).collect();
    let vertices = Vertices {
        positions: &positions,
        attributes: &attributes,
        weights: &input.weights,
        is_protected: &is_protected,
    };
    let allowance = [Allowance::Nothing, Allowance::Seams, Allowance::Parts][usize::from(input.allowance) % 3];
    if let Ok((left, error)) = collapse(vertices, &faces, usize::from(input.target), allowance) {
        assert!(left.len() <= faces.len());
        assert!(left.as_flattened().iter().all(|&vertex| (vertex as usize) < positions.len()));
        assert!(!error.is_nan(), "{error}");
    }
    if let Ok(numbers) = pieces(&faces, positions.len(), &Progress::new()) {
        assert_eq!(numbers.len(), faces.len());
    }
});
