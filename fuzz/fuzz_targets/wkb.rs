//! Reads arbitrary bytes as WKB, which must give an error, or consistent outlines that take no more memory than the bytes.

#![no_main]

use libfuzzer_sys::fuzz_target;
use nearfar_core::base::Progress;
use nearfar_core::scene::polygons::{Polygons, wkb};

fuzz_target!(|bytes: &[u8]| {
    let middle = bytes.first().map_or(0, |&byte| usize::from(byte) * bytes.len() / 256);
    let offsets = [0, middle as i64, bytes.len() as i64];
    let Ok(found) = wkb::read(bytes, &offsets, &Progress::new()) else { return };
    assert!(found.points.len() * 16 <= bytes.len());
    assert!((found.rings.len() + found.polygons.len()) * 4 <= bytes.len() + 8);
    assert_eq!(found.rows.len(), offsets.len());
    let is_in_range = found.points.as_flattened().iter().all(|value| value.abs() <= 1e30);
    assert_eq!(Polygons::new(&found.points, &found.rings, &found.polygons).is_ok(), is_in_range);
});
