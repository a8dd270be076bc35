//! Reduction of four pixels to one, for pictures of leaves and parents at twice the size.

use glam::Vec3;
use rayon::prelude::*;

use super::normals;
use super::view::{Format, Texel, View};
use crate::scene::srgb::srgb_from_linear;

/// A surface shown by a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Depth in steps from the near plane of the cell's camera.
    pub depth: f32,
    /// Linear RGB.
    pub color: Vec3,
    /// Unit normal.
    pub normal: Vec3,
}

/// Returns the minimum depth of four pixels, and the mean colour and normal of the pixels at most `reach` steps behind
/// it; `None` if no pixel shows a surface.
pub fn reduce_block(block: [Option<Sample>; 4], reach: f32) -> Option<Sample> {
    let depth = block.iter().flatten().map(|sample| sample.depth).fold(f32::INFINITY, f32::min);
    let first = block.iter().flatten().find(|sample| sample.depth == depth)?;
    let (mut color, mut normal, mut count) = (Vec3::ZERO, Vec3::ZERO, 0.0);
    for sample in block.iter().flatten().filter(|sample| sample.depth <= depth + reach) {
        color += sample.color;
        normal += sample.normal;
        count += 1.0;
    }
    // If the normals cancel, the front surface's normal is used.
    Some(Sample { depth, color: color / count, normal: normal.normalize_or(first.normal) })
}

/// Depth difference, in pixel widths, up to which a pixel counts as part of the nearest surface of its block. A plane
/// whose normal is at most 70° from the view's direction spans no more over the diagonal of the block.
const REACH_PIXELS: f64 = 4.0;

/// Converts `REACH_PIXELS` to depth steps; arguments in metres.
pub fn reach(pixel: f64, step: f64) -> f32 {
    (REACH_PIXELS * pixel / step) as f32
}

/// Reduces a picture to a view of half its size. `samplers` creates, for each row, a function that returns the surface
/// of a pixel; `depth` returns the depth code of a surface.
pub fn reduce_view<S: FnMut(usize) -> Option<Sample>>(
    samplers: impl Fn() -> S + Sync,
    reach: f32,
    depth: impl Fn(&Sample) -> u32 + Sync,
    format: &Format,
) -> View {
    let size = format.size;
    let texel = |sample: Sample| Texel {
        color: sample.color.to_array().map(srgb_from_linear),
        depth: depth(&sample) as u16,
        normal: normals::encode(sample.normal, format.normal_bits),
    };
    let mut texels = vec![Texel::default(); format.pixels()];
    texels.par_chunks_mut(size).enumerate().for_each(|(row, texels)| {
        let mut sample = samplers();
        for (column, slot) in texels.iter_mut().enumerate() {
            let first = 4 * size * row + 2 * column;
            let block = [first, first + 1, first + 2 * size, first + 2 * size + 1].map(&mut sample);
            *slot = reduce_block(block, reach).map_or(Texel::default(), texel);
        }
    });
    texels
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(depth: f32, red: f32) -> Option<Sample> {
        Some(Sample { depth, color: Vec3::new(red, 0.0, 0.0), normal: Vec3::Z })
    }

    #[test]
    fn surfaces_far_behind_are_ignored_like_empty_pixels() {
        assert_eq!(reduce_block([None; 4], 1.0), None);
        let near = reduce_block([sample(3.0, 0.25), None, sample(4.0, 0.75), sample(4.5, 9.0)], 1.0).unwrap();
        assert_eq!((near.depth, near.color.x), (3.0, 0.5));
        let all = reduce_block([sample(3.0, 0.0), sample(3.0, 1.0), sample(3.0, 1.0), sample(3.0, 0.0)], 0.0).unwrap();
        assert_eq!((all.depth, all.color.x, all.normal), (3.0, 0.5, Vec3::Z));
    }

    #[test]
    fn cancelling_normals_give_the_front_one() {
        let back = Some(Sample { depth: 2.0, color: Vec3::ZERO, normal: Vec3::NEG_Z });
        assert_eq!(reduce_block([back, sample(1.0, 0.0), None, None], 5.0).unwrap().normal, Vec3::Z);
    }
}
