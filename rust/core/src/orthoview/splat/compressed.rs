//! Lossless packing of a view's splats into words for GPUs, block by block.
//!
//! Each field of a block's splats (depth, normal, colour, kind) is stored as its difference from the block's minimum,
//! with as many bits as the maximum difference needs. Depths are first reduced by a plane through the block, because
//! walls and roofs are planes. All splats of a block have the same number of bits, so that a shader can access each
//! one directly.

use super::splats::{BLOCK, Block, Packed, Splats};
use crate::base::mapped::set_bits;

/// Words of a block's header: its column and row in blocks; the shown pixels (2); its first word of bits; the field
/// widths and the minimum kind; the minimum depth; the plane's slopes; the minimum normal; the minimum colour.
pub const HEAD: usize = 9;

/// Fraction bits of a slope: depth steps per pixel, in eighths.
const FRACTION: u32 = 3;

/// Bits of the field widths in the header's fifth word, in the order of the fields; the minimum kind follows.
const WIDTHS: [u32; FIELDS] = [5, 4, 4, 4, 4, 4, 2];

/// Fields: depth, two normal components, red, green, blue, kind.
const FIELDS: usize = 7;

/// Kinds of splats: balls, and surfels at the border and in the interior of a surface.
const BALL: u32 = 0;
const BORDERING: u32 = 1;
const INNER: u32 = 2;

/// A view's splats as words: the headers of all blocks, followed by the splats' bits.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Compressed {
    /// Words, with one extra at the end, so that fields can be read from pairs of words.
    pub words: Vec<u32>,
    /// Number of blocks.
    pub blocks: usize,
}

/// Fields of a splat.
type Fields = [u32; FIELDS];

impl Splats {
    /// Packs the splats into words for GPUs.
    pub fn compressed(&self) -> Compressed {
        let blocks = self.blocks.iter().map(|block| (block, &self.texels[block.first as usize..]));
        Compressed::from_blocks(blocks)
    }
}

impl Compressed {
    fn from_blocks<'a>(blocks: impl ExactSizeIterator<Item = (&'a Block, &'a [Packed])>) -> Self {
        let (count, mut bits) = (blocks.len(), Bits::default());
        let mut words = Vec::with_capacity(HEAD * count);
        blocks.for_each(|(block, texels)| words.extend(put_block(block, texels, &mut bits)));
        words.append(&mut bits.words);
        words.push(0);
        Self { words, blocks: count }
    }
}

/// Adds the bits of a block's splats; returns its header.
fn put_block(block: &Block, texels: &[Packed], bits: &mut Bits) -> [u32; HEAD] {
    let mut fields = fields_of(block, texels);
    let depths: Vec<_> = set_bits(block.shown).zip(&fields).map(|(pixel, splat)| (pixel, splat[0] as i32)).collect();
    let [flat, sloped] = [[0, 0], slopes(&depths)].map(|slopes| (spread(&depths, slopes), slopes));
    let ((least, _), slopes) = if sloped.0.1 < flat.0.1 { sloped } else { flat };
    for ((pixel, depth), splat) in depths.iter().zip(&mut fields) {
        splat[0] = (depth - rise(*pixel, slopes) - least) as u32;
    }
    // The minimum of depths, relative to the plane, is already 0.
    let base: Fields = std::array::from_fn(|n| fields.iter().map(|splat| splat[n]).min().unwrap_or(0));
    let widths: Fields = std::array::from_fn(|n| {
        let max = fields.iter().map(|splat| splat[n] - base[n]).max().unwrap_or(0);
        u32::BITS - max.leading_zeros()
    });
    let first = bits.align();
    for splat in &fields {
        (0..FIELDS).for_each(|n| bits.put(splat[n] - base[n], widths[n]));
    }
    let [_, u, v, red, green, blue, kind] = base;
    let (mut packed, mut shift) = (0, 0);
    for (width, bits) in widths.iter().zip(WIDTHS) {
        packed |= width << shift;
        shift += bits;
    }
    let [column, row] = block.corner.map(|pixel| u32::from(pixel) / BLOCK as u32);
    let [by_column, by_row] = slopes.map(|slope| u32::from(slope as u16));
    [
        column | row << 16,
        block.shown as u32,
        (block.shown >> 32) as u32,
        first,
        packed | kind << shift,
        least as u32,
        by_column | by_row << 16,
        u | v << 12,
        red | green << 8 | blue << 16,
    ]
}

fn fields_of(block: &Block, texels: &[Packed]) -> Vec<Fields> {
    let of_pixel = |(pixel, texel): (u32, &Packed)| {
        let ([red, green, blue], [u, v]) = (texel.color().map(u32::from), texel.normal().map(u32::from));
        let kind = match (block.surfels >> pixel & 1, block.inner >> pixel & 1) {
            (0, _) => BALL,
            (_, 0) => BORDERING,
            _ => INNER,
        };
        [u32::from(texel.depth()), u, v, red, green, blue, kind]
    };
    set_bits(block.shown).zip(texels).map(of_pixel).collect()
}

/// Returns the depth steps by which a plane is deeper at a pixel than at the block's first pixel.
fn rise(pixel: u32, [by_column, by_row]: [i16; 2]) -> i32 {
    let (column, row) = ((pixel % BLOCK as u32) as i32, (pixel / BLOCK as u32) as i32);
    (column * i32::from(by_column) + row * i32::from(by_row)) >> FRACTION
}

/// Returns the minimum deviation of depths from a plane with these slopes, and the range of deviations.
fn spread(depths: &[(u32, i32)], slopes: [i16; 2]) -> (i32, i32) {
    let (min, max) = depths.iter().fold((i32::MAX, i32::MIN), |(min, max), (pixel, depth)| {
        let deviation = depth - rise(*pixel, slopes);
        (min.min(deviation), max.max(deviation))
    });
    (min, max.saturating_sub(min))
}

/// Returns the slopes of the least-squares plane.
fn slopes(depths: &[(u32, i32)]) -> [i16; 2] {
    let column_and_row = |pixel: u32| [f64::from(pixel % BLOCK as u32), f64::from(pixel / BLOCK as u32)];
    let count = depths.len().max(1) as f64;
    let mut mean = [0.0; 3];
    for &(pixel, depth) in depths {
        let [x, y] = column_and_row(pixel);
        (0..3).for_each(|n| mean[n] += [x, y, f64::from(depth)][n] / count);
    }
    let [mut xx, mut xy, mut yy, mut xd, mut yd] = [0.0; 5];
    for &(pixel, depth) in depths {
        let [x, y] = column_and_row(pixel);
        let (x, y, d) = (x - mean[0], y - mean[1], f64::from(depth) - mean[2]);
        (xx, xy, yy, xd, yd) = (xx + x * x, xy + x * y, yy + y * y, xd + x * d, yd + y * d);
    }
    let determinant = xx * yy - xy * xy;
    let slopes = if determinant > 1e-6 * xx * yy {
        [(xd * yy - yd * xy) / determinant, (yd * xx - xd * xy) / determinant]
    } else {
        // Collinear pixels: along columns, along rows, or a single pixel.
        [if xx > 0.0 { xd / xx } else { 0.0 }, if xx > 0.0 || yy == 0.0 { 0.0 } else { yd / yy }]
    };
    slopes.map(|slope| (slope * f64::from(1 << FRACTION)).round() as i16)
}

/// Bit writer, the lowest bit of a word first.
#[derive(Default)]
struct Bits {
    words: Vec<u32>,
    /// Number of used bits of the last word.
    used: u32,
}

impl Bits {
    /// Starts a new word; returns its number.
    fn align(&mut self) -> u32 {
        self.used = u32::BITS;
        self.words.len() as u32
    }

    fn put(&mut self, value: u32, width: u32) {
        if width == 0 {
            return;
        }
        if self.used == u32::BITS {
            self.words.push(0);
            self.used = 0;
        }
        if let Some(last) = self.words.last_mut() {
            *last |= value << self.used;
        }
        let overflow = (self.used + width).saturating_sub(u32::BITS);
        if overflow > 0 {
            self.words.push(value >> (width - overflow));
            self.used = overflow;
        } else {
            self.used += width;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::splats::Extent;
    use super::*;
    use crate::base::random;

    /// Reads the pixel and the kind of a splat from a view's words as a shader does.
    fn read(compressed: &Compressed, block: usize, lane: u32) -> Option<(Packed, u32)> {
        let head = &compressed.words[HEAD * block..][..HEAD];
        let shown = u64::from(head[2]) << 32 | u64::from(head[1]);
        if shown >> lane & 1 == 0 {
            return None;
        }
        let (mut widths, mut shift) = ([0; FIELDS], 0);
        for (width, bits) in widths.iter_mut().zip(WIDTHS) {
            *width = head[4] >> shift & ((1 << bits) - 1);
            shift += bits;
        }
        let kind = head[4] >> shift;
        let rank = (shown & ((1 << lane) - 1)).count_ones();
        let mut at = 32 * (HEAD * compressed.blocks + head[3] as usize) as u64;
        at += u64::from(rank * widths.iter().sum::<u32>());
        let differences: Fields = widths.map(|width| {
            let bit = |n: u64| (compressed.words[((at + n) / 32) as usize] >> ((at + n) % 32) & 1) << n;
            let value = (0..u64::from(width)).map(bit).sum();
            at += u64::from(width);
            value
        });
        let slopes = [head[6] as i16, (head[6] >> 16) as i16];
        let depth = head[5] as i32 + rise(lane, slopes) + differences[0] as i32;
        let base = [head[7] & 0xFFF, head[7] >> 12, head[8] & 255, head[8] >> 8 & 255, head[8] >> 16];
        let values: [u32; 5] = std::array::from_fn(|n| base[n] + differences[1 + n]);
        let texel = Packed::new(depth as u16, [values[0] as u16, values[1] as u16], [2, 3, 4].map(|n| values[n] as u8));
        Some((texel, kind + differences[6]))
    }

    /// Checks that blocks are restored, each masks (shown, surfels, inner) and texels; returns the number of words.
    fn check(masks_and_texels: &[(u64, u64, u64, Vec<Packed>)]) -> usize {
        let block = |(number, &(shown, surfels, inner, _)): (usize, &(u64, u64, u64, Vec<Packed>))| {
            let corner = [8 * number as u16, 16 * number as u16];
            Block { extent: Extent::NOTHING, corner, first: 0, shown, surfels, inner }
        };
        let blocks: Vec<Block> = masks_and_texels.iter().enumerate().map(block).collect();
        let texels = masks_and_texels.iter().map(|(.., texels)| &texels[..]);
        let compressed = Compressed::from_blocks(blocks.iter().zip(texels));
        for (number, (shown, surfels, inner, texels)) in masks_and_texels.iter().enumerate() {
            assert_eq!(compressed.words[HEAD * number], number as u32 | (2 * number as u32) << 16);
            let mut texels = texels.iter();
            for lane in 0..64 {
                let expected = (shown >> lane & 1 == 1).then(|| {
                    let surfel = (surfels >> lane & 1) as u32;
                    (*texels.next().unwrap(), surfel + ((surfels & inner) >> lane & 1) as u32)
                });
                assert_eq!(read(&compressed, number, lane), expected, "block {number}, pixel {lane}");
            }
        }
        compressed.words.len()
    }

    #[test]
    fn all_bits_are_restored() {
        let draw = |salt, n, most: u64| random::bits(salt, n, 0) % most;
        let block = |n: u64| {
            // Values of a block: from all equal to all different.
            let spread = n % 17;
            let value = |salt, lane, bits: u64| {
                let most = (1 << spread.min(bits)) as u64;
                ((1 << bits) - most) * draw(salt, n, 2) + draw(salt + 1, 64 * n + lane, most)
            };
            let shown = if n.is_multiple_of(3) { u64::MAX } else { random::bits(1, n, 0) };
            let texel = |lane: u64| {
                let depth = value(10, lane, 16).max(1) as u16;
                let normal = [value(20, lane, 12) as u16, value(30, lane, 12) as u16];
                Packed::new(depth, normal, [40, 50, 60].map(|salt| value(salt, lane, 8) as u8))
            };
            let texels = (0..u64::from(shown.count_ones())).map(texel).collect();
            (shown, random::bits(2, n, 0), random::bits(3, n, 0), texels)
        };
        check(&(0..500).map(block).collect::<Vec<_>>());
    }

    #[test]
    fn a_plane_needs_only_headers() {
        // Depths that rise by 12 and fall by 3.5 steps per pixel; all other fields are equal.
        let texel = |lane: u64| {
            let depth = 40_000 + 12 * (lane % 8) as i32 + ((-28 * (lane / 8) as i32) >> 3);
            Packed::new(depth as u16, [7, 4000], [1, 200, 255])
        };
        let block = (u64::MAX, u64::MAX, u64::MAX, (0..64).map(texel).collect());
        assert_eq!(check(&[block.clone(), block]), 2 * HEAD + 1);
    }

    #[test]
    fn lines_and_single_pixels_are_restored() {
        let texel = |lane: u32| Packed::new(1 + 9 * lane as u16, [0, 0], [0; 3]);
        for shown in [1, 1 << 63, 0xFF, 0x0101_0101_0101_0101] {
            check(&[(shown, 0, 0, set_bits(shown).map(texel).collect())]);
        }
    }
}
