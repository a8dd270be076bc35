//! Any bytes as planes of ranges: an error, or codes that are encoded and decoded to the same codes.

#![no_main]

use arbitrary::Arbitrary;
use libfuzzer_sys::fuzz_target;
use nearfar_core::base::Progress;
use nearfar_core::export::ranges::{Faces, decode, encode};

#[derive(Arbitrary, Debug)]
struct Input {
    faces: u8,
    tiles: u8,
    tile: u8,
    listed: Vec<u32>,
    before: Option<Vec<u16>>,
    planes: [Vec<u8>; 9],
}

fuzz_target!(|input: Input| {
    let (tile, count) = (usize::from(input.tile % 9), usize::from(input.faces % 7));
    let size = tile * usize::from(input.tiles % 5);
    let texels = count * size * size;
    let before =
        input.before.map(|codes| codes.into_iter().chain(std::iter::repeat(9)).take(texels).collect::<Vec<_>>());
    let faces = Faces { size, tile, listed: &input.listed, step: 0.001 };
    let read = |planes: &[Vec<u8>]| {
        let planes: Vec<&[u8]> = planes.iter().map(|plane| &plane[..]).collect();
        decode(&planes, count, before.as_deref(), faces, &Progress::new())
    };
    let Ok((codes, changed)) = read(&input.planes) else { return };
    assert_eq!((codes.len(), changed.len()), (texels, texels));
    let planes =
        encode(&codes, before.as_deref(), &changed, faces, &Progress::new()).expect("what was read is written");
    assert_eq!(read(&planes), Ok((codes, changed)));
});
