//! Any rings: triangles between the points of their polygon, none of them turned, and prisms over the same ones.

#![no_main]

use arbitrary::Arbitrary;
use libfuzzer_sys::fuzz_target;
use nearfar_core::base::Progress;
use nearfar_core::scene::polygons::{Polygons, prisms, triangulate};

#[derive(Arbitrary, Debug)]
struct Input {
    /// Small whole numbers, so that many points are equal and many rings touch.
    near: Vec<[i8; 2]>,
    far: Vec<[f64; 2]>,
    ring_sizes: Vec<u8>,
    polygon_rings: Vec<u8>,
}

/// Offsets of runs of these lengths, cut and filled to a count.
fn offsets(lengths: &[u8], count: usize) -> Vec<i64> {
    let mut ends = vec![0];
    for &length in lengths {
        let end = (ends[ends.len() - 1] + usize::from(length)).min(count);
        ends.push(end);
    }
    ends.push(count);
    ends.into_iter().map(|end| end as i64).collect()
}

fuzz_target!(|input: Input| {
    let near = input.near.iter().map(|point| point.map(f64::from));
    let points: Vec<[f64; 2]> = near.chain(input.far.iter().copied()).collect();
    let rings = offsets(&input.ring_sizes, points.len());
    let runs = offsets(&input.polygon_rings, rings.len() - 1);
    let Ok(polygons) = Polygons::new(&points, &rings, &runs) else {
        assert!(points.as_flattened().iter().any(|value| value.is_nan() || value.abs() > 1e30));
        return;
    };
    let progress = Progress::new();
    let (found, _) = triangulate(&polygons, &progress).unwrap();
    assert_eq!(found.offsets.len(), runs.len());
    for polygon in 0..runs.len() - 1 {
        let own = rings[runs[polygon] as usize] as u32..rings[runs[polygon + 1] as usize] as u32;
        let faces = &found.faces[found.offsets[polygon] as usize..found.offsets[polygon + 1] as usize];
        assert!(faces.as_flattened().iter().all(|corner| own.contains(corner)));
    }
    let floors = vec![true; runs.len() - 1];
    let (walls, _) = prisms(&polygons, &floors, &progress).unwrap();
    assert!(walls.faces.len() >= 2 * found.faces.len());
    assert!(walls.faces.as_flattened().iter().all(|&corner| (corner as usize) < 2 * points.len()));
});
