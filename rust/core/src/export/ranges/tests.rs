use proptest::prelude::*;

use super::{Faces, NOTHING, decode, encode};
use crate::base::{Progress, random};

const SIZE: usize = 16;
const TILE: usize = 4;
const TEXELS: usize = 6 * SIZE * SIZE;

/// Two maps of slopes, steps, noise and holes. In the second, patches of listed tiles are farther or holes.
struct Maps {
    before: Vec<u16>,
    after: Vec<u16>,
    changed: Vec<bool>,
    listed: Vec<u32>,
}

impl Maps {
    fn new(seed: u64, noise: u16) -> Self {
        let draw = |cell: u64, index: usize, most: u16| random::bits(seed, cell, index as u64) as u16 % most.max(1);
        let listed: Vec<u32> =
            (0..(TEXELS / TILE / TILE) as u32).filter(|&tile| draw(0, tile as usize, 3) == 0).collect();
        let before: Vec<u16> = (0..TEXELS)
            .map(|place| {
                let (x, y) = (place % SIZE, place / SIZE);
                let level = draw(1, x / 5 + 100 * (y / 5), 4) * 9000;
                let code = level + (3 * x + y % SIZE) as u16 + draw(2, place, noise);
                if draw(3, x / 3 + 100 * (y / 4), 7) == 0 { NOTHING } else { code }
            })
            .collect();
        let tile = |place: usize| (place / SIZE / TILE * (SIZE / TILE) + place % SIZE / TILE) as u32;
        let changed: Vec<bool> =
            (0..TEXELS).map(|place| listed.contains(&tile(place)) && draw(4, place / 3, 2) == 0).collect();
        let after = (0..TEXELS)
            .map(|place| match (changed[place], draw(5, place / 5, 3)) {
                (false, _) => before[place],
                (true, 0) => NOTHING,
                (true, _) => 40_000 + (place % SIZE) as u16 + draw(6, place, noise),
            })
            .collect();
        Self { before, after, changed, listed }
    }

    fn faces(&self) -> Faces<'_> {
        Faces { size: SIZE, tile: TILE, listed: &self.listed, step: 0.001 }
    }

    fn encoded(&self, is_delta: bool) -> Vec<Vec<u8>> {
        let before = is_delta.then_some(&self.before[..]);
        encode(&self.after, before, &self.changed, self.faces(), &Progress::new()).unwrap()
    }

    fn decoded(&self, planes: &[Vec<u8>], is_delta: bool) -> crate::base::Result<(Vec<u16>, Vec<bool>)> {
        let before = is_delta.then_some(&self.before[..]);
        let planes: Vec<&[u8]> = planes.iter().map(|plane| &plane[..]).collect();
        decode(&planes, 6, before, self.faces(), &Progress::new())
    }
}

proptest! {
    #[test]
    fn maps_are_restored(seed: u64, noise in prop::sample::select(vec![1u16, 2, 5, 300, 25_000]), is_delta: bool) {
        let maps = Maps::new(seed, noise);
        let (codes, changed) = maps.decoded(&maps.encoded(is_delta), is_delta).unwrap();
        prop_assert_eq!(&codes, &maps.after);
        prop_assert_eq!(&changed, &maps.changed);
    }

    #[test]
    fn damaged_bytes_are_refused_or_read_as_other_codes(
        seed in 0..20u64, plane in 0..9usize, place: prop::sample::Index, value: u8, cut: bool, is_delta: bool,
    ) {
        let maps = Maps::new(seed, 9);
        let mut planes = maps.encoded(is_delta);
        if planes[plane].is_empty() {
            return Ok(());
        }
        let place = place.index(planes[plane].len());
        if cut {
            planes[plane].truncate(place);
            prop_assert!(maps.decoded(&planes, is_delta).is_err());
        } else {
            planes[plane][place] ^= value;
            let _ = maps.decoded(&planes, is_delta);
        }
    }
}

#[test]
fn planes_of_walls_take_few_bits() {
    // A slanted wall: its range is not linear in the texels, but the reciprocal of its depth is.
    let (size, step) = (256, 2f64.powi(-10));
    let centre = |place: usize| (2 * place + 1) as f64 / size as f64 - 1.0;
    let code = |place: usize| {
        let (u, v) = (centre(place % size), centre(place / size));
        (((1.0 + u * u + v * v).sqrt() / (1.3 + u)).ln() / step + 3000.0).round() as u16
    };
    let codes: Vec<u16> = (0..size * size).map(code).collect();
    let faces = Faces { size, tile: 64, listed: &[], step };
    let planes = encode(&codes, None, &vec![false; size * size], faces, &Progress::new()).unwrap();
    // One bit per texel flags a surface, one a correct prediction; few predictions fail.
    let bytes: usize = planes.iter().map(Vec::len).sum();
    assert!(bytes < size * size / 8 * 3, "{bytes}");
}

#[test]
fn wrong_arguments_are_refused() {
    let maps = Maps::new(7, 3);
    let good = maps.faces();
    let progress = Progress::new();
    let run = |faces, changed: &[bool]| encode(&maps.after, Some(&maps.before), changed, faces, &progress);
    assert!(run(good, &maps.changed).is_ok());
    for faces in [
        Faces { size: 0, ..good },
        Faces { tile: 0, ..good },
        Faces { tile: 5, ..good },
        Faces { size: 32, tile: 5, ..good },
        Faces { listed: &[3, 2], ..good },
        Faces { listed: &[2, 2], ..good },
        Faces { listed: &[96], ..good },
        Faces { listed: &[1], ..good },
        Faces { step: 0.0, ..good },
        Faces { step: f64::NAN, ..good },
        Faces { step: 0.02, ..good },
    ] {
        assert!(run(faces, &maps.changed).is_err(), "{faces:?}");
    }
    assert!(run(good, &vec![false; TEXELS]).is_err());
    assert!(run(good, &maps.changed[1..]).is_err());
    assert!(maps.decoded(&[], true).is_err());
    assert!(maps.decoded(&vec![vec![]; 9], true).is_err());
    assert!(maps.decoded(&vec![vec![]; 9], false).is_err());
    let mut longer = maps.encoded(true);
    longer[6].push(0);
    assert!(maps.decoded(&longer, true).is_err());
    let planes: Vec<&[u8]> = longer.iter().map(|plane| &plane[..]).collect();
    assert!(decode(&planes, 5, Some(&maps.before), good, &progress).is_err());
    assert!(decode(&planes, usize::MAX, None, good, &progress).is_err());
    progress.cancel();
    assert_eq!(run(good, &maps.changed), Err(crate::base::Error::Cancelled));
}
