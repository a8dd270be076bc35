//! Ranges of environment maps as byte planes: the texels that a ring changes, and their new codes.
//!
//! A code c stands for a range proportional to exp(c · step), [`NOTHING`] for no surface. Texels are visited face by
//! face, row by row; each is predicted from texels visited before (`walk.rs`), and only the differences are written
//! (`planes.rs`). The caller compresses the bytes. All arithmetic is exact or rounded as in IEEE 754, so that every
//! client makes the same predictions.

mod planes;
mod scale;
#[cfg(test)]
mod tests;
mod walk;

pub use scale::{Faces, MAX_STEP, NOTHING};

use crate::base::{Error, Progress, Result, ensure};
use planes::{Reader, Writer, damage_error};
use walk::Walk;

/// Encodes a map's codes as planes: the codes of `changed` texels if the map has the previous codes `before`, otherwise
/// all. Texels outside the listed tiles must not be changed.
pub fn encode(
    codes: &[u16],
    before: Option<&[u16]>,
    changed: &[bool],
    faces: Faces<'_>,
    progress: &Progress,
) -> Result<Vec<Vec<u8>>> {
    faces.count(codes.len())?;
    let tiles_per_row = faces.size / faces.tile;
    let is_listed = |texel: usize| {
        let (row, column) = (texel / faces.size, texel % faces.size);
        faces.lists(row / faces.tile * tiles_per_row + column / faces.tile)
    };
    if let Some(texel) = changed.iter().enumerate().position(|(texel, &is_changed)| is_changed && !is_listed(texel)) {
        return Err(Error::value("tiles", "the tiles of all changed texels", format!("a change of texel {texel}")));
    }
    let is_missed = |((code, before), is_changed): ((&u16, &u16), &bool)| code != before && !is_changed;
    let is_complete = !before.is_some_and(|before| codes.iter().zip(before).zip(changed).any(is_missed));
    ensure!(is_complete, "changed", "all texels whose codes differ", "fewer");
    let mut writer = Writer::default();
    walk(&mut codes.to_vec(), before, &mut changed.to_vec(), faces, &mut writer, progress)?;
    Ok(writer.planes())
}

/// Decodes the codes of `count` faces, and which texels are changed. `before` has the previous codes if the planes have
/// only those of changed texels.
pub fn decode(
    planes: &[&[u8]],
    count: usize,
    before: Option<&[u16]>,
    faces: Faces<'_>,
    progress: &Progress,
) -> Result<(Vec<u16>, Vec<bool>)> {
    let texels = count.saturating_mul(faces.size.saturating_mul(faces.size));
    let mut reader = Reader::new(planes)?;
    if before.is_none() && planes[1].len() < texels / 8 {
        return Err(damage_error("fewer bytes"));
    }
    let mut codes = before.map_or_else(|| vec![0; texels], <[u16]>::to_vec);
    let mut changed = vec![false; codes.len()];
    ensure!(codes.len() == texels, "before", format!("{texels} codes"), codes.len());
    walk(&mut codes, before, &mut changed, faces, &mut reader, progress)?;
    reader.finish()?;
    Ok((codes, changed))
}

fn walk(
    codes: &mut [u16],
    before: Option<&[u16]>,
    changed: &mut [bool],
    faces: Faces<'_>,
    link: &mut impl planes::Link,
    progress: &Progress,
) -> Result<()> {
    let count = faces.count(codes.len())?;
    let is_complete = changed.len() == codes.len() && before.is_none_or(|before| before.len() == codes.len());
    ensure!(is_complete, "changed", "as many texels as codes", changed.len());
    let texels = faces.size * faces.size;
    let mut walk = Walk::new(faces);
    for face in 0..count {
        let range = face * texels..(face + 1) * texels;
        let before = before.map(|before| &before[range.clone()]);
        walk.face(face, &mut codes[range.clone()], before, &mut changed[range], link, progress)?;
    }
    Ok(())
}
