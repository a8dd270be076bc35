//! Any bytes as OBJ text: an error, or parts whose indices name what the text holds.

#![no_main]

use libfuzzer_sys::fuzz_target;
use nearfar_core::base::Progress;
use nearfar_core::scene::wavefront::{NONE, read};

fuzz_target!(|text: &[u8]| {
    let Ok(found) = read(text, &Progress::new()) else { return };
    let names = |index: u32, count: usize| (index as usize) < count;
    assert!(found.colors.is_empty() || found.colors.len() == found.positions.len());
    for part in &found.parts {
        assert!(part.object.iter().chain(&part.material).all(|&name| names(name, found.names.len())));
        for &[position, uv, normal] in &part.vertices {
            assert!(names(position, found.positions.len()));
            assert!(uv == NONE || names(uv, found.uvs.len()));
            assert!(normal == NONE || names(normal, found.normals.len()));
        }
        assert!(part.faces.iter().flatten().all(|&corner| names(corner, part.vertices.len())));
    }
});
