//! Pixel mask at several resolutions, for culling of geometry that no drawn pixel can show.

use glam::DVec2;
use rayon::prelude::*;

use crate::base::Aabb;
use crate::camera::Camera;

/// Base-2 logarithm of the side of level 0's blocks, pixels.
const FINEST_SHIFT: usize = 2;
/// Maximum number of blocks that a test reads along each axis.
const MAX_READ_BLOCKS: usize = 4;
/// Rows of blocks per task.
const TASK_ROWS: usize = 32;

/// Flags of blocks of pixels. Blocks of each level are twice as wide as those before, up to a single block.
#[derive(Clone, Debug)]
pub struct MaskPyramid {
    size: (usize, usize),
    /// Blocks per row, and for each block, row by row, whether any of its pixels is drawn.
    levels: Vec<(usize, Vec<bool>)>,
}

impl MaskPyramid {
    /// Creates the levels of a mask with `width` pixels per row.
    pub fn new(mask: &[bool], width: usize) -> Self {
        let height = mask.len() / width.max(1);
        let side = 1 << FINEST_SHIFT;
        let blocks_per_row = width.div_ceil(side);
        let mut finest = vec![false; blocks_per_row * height.div_ceil(side)];
        if width > 0 {
            let bands = finest.par_chunks_mut(blocks_per_row).zip(mask.par_chunks(side * width));
            bands.with_min_len(TASK_ROWS).for_each(|(flags, band)| {
                band.chunks_exact(width).for_each(|row| mark_blocks(row, flags));
            });
        }
        let mut levels = vec![(blocks_per_row, finest)];
        while let Some((blocks_per_row, flags)) = levels.last().filter(|(_, flags)| flags.len() > 1) {
            let next = coarser(*blocks_per_row, flags);
            levels.push(next);
        }
        Self { size: (width, height), levels }
    }

    /// Returns whether a rectangle, in pixels and grown to whole blocks, contains a drawn pixel.
    pub fn touches(&self, low: DVec2, high: DVec2) -> bool {
        let (width, height) = self.size;
        if high.x < 0.0 || high.y < 0.0 || low.x >= width as f64 || low.y >= height as f64 {
            return false;
        }
        let column = |x: f64| (x.max(0.0) as usize).min(width - 1);
        let row = |y: f64| (y.max(0.0) as usize).min(height - 1);
        let ([left, right], [top, bottom]) = ([column(low.x), column(high.x)], [row(low.y), row(high.y)]);
        let fits = |shift: usize| {
            (right >> shift) - (left >> shift) < MAX_READ_BLOCKS && (bottom >> shift) - (top >> shift) < MAX_READ_BLOCKS
        };
        let level =
            (0..self.levels.len() - 1).find(|level| fits(FINEST_SHIFT + level)).unwrap_or(self.levels.len() - 1);
        let (blocks_per_row, flags) = &self.levels[level];
        let shift = FINEST_SHIFT + level;
        (top >> shift..=bottom >> shift).any(|y| {
            flags[y * blocks_per_row + (left >> shift)..=y * blocks_per_row + (right >> shift)].contains(&true)
        })
    }

    /// Returns whether a drawn pixel or a neighbour of one may show a box; `camera` is in the box's frame of reference.
    pub fn sees(&self, camera: &Camera, bounds: &Aabb) -> bool {
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let ends = [bounds.min.as_dvec3(), bounds.max.as_dvec3()];
        for n in 0..8 {
            let corner = glam::DVec3::new(ends[n & 1].x, ends[n >> 1 & 1].y, ends[n >> 2].z);
            // A box around the camera may appear anywhere.
            let Some(position) = camera.project(corner) else { return true };
            (low, high) = (low.min(position.truncate()), high.max(position.truncate()));
        }
        self.touches(low - 1.0, high + 1.0)
    }
}

/// Marks the blocks in which a row of pixels has a drawn pixel.
fn mark_blocks(row: &[bool], flags: &mut [bool]) {
    // The four pixels of a block are tested as one word.
    let (blocks, last_pixels) = row.as_chunks::<{ 1 << FINEST_SHIFT }>();
    for (flag, block) in flags.iter_mut().zip(blocks) {
        *flag |= u32::from_ne_bytes(block.map(u8::from)) != 0;
    }
    if let Some(last) = flags.get_mut(blocks.len()) {
        *last |= last_pixels.contains(&true);
    }
}

/// Builds the next level: a block is drawn if one of its four children is.
fn coarser(blocks_per_row: usize, flags: &[bool]) -> (usize, Vec<bool>) {
    let next_blocks_per_row = blocks_per_row.div_ceil(2);
    let mut next = Vec::with_capacity(next_blocks_per_row * (flags.len() / blocks_per_row).div_ceil(2));
    for pair in flags.chunks(2 * blocks_per_row) {
        let (upper, lower) = pair.split_at(blocks_per_row);
        let lower = if lower.is_empty() { upper } else { lower };
        let children = upper.chunks(2).zip(lower.chunks(2));
        next.extend(children.map(|(upper, lower)| upper.contains(&true) || lower.contains(&true)));
    }
    (next_blocks_per_row, next)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random::uniform;
    use crate::camera::{Fov, Projection};
    use glam::{DQuat, DVec3};

    #[test]
    fn rectangles_with_a_drawn_pixel_are_touched_and_far_ones_are_not() {
        let (width, height) = (203, 117);
        for fraction in [0.0, 0.0005, 0.02, 1.0] {
            let mask: Vec<bool> = (0..width * height).map(|n| uniform(3, n as u64, 0) < fraction).collect();
            let pyramid = MaskPyramid::new(&mask, width);
            let mut empty = 0;
            for n in 0..2000 {
                let draw = |axis| uniform(5, n, axis);
                let low = DVec2::new(draw(0) * 240.0 - 20.0, draw(1) * 140.0 - 10.0);
                let high = low + DVec2::new(draw(2), draw(3)) * 60.0 * draw(4);
                let drawn = |x: i64, y: i64| {
                    (0..width as i64).contains(&x)
                        && (0..height as i64).contains(&y)
                        && mask[y as usize * width + x as usize]
                };
                let floor = |x: f64| x.floor() as i64;
                let any = (floor(low.y)..=floor(high.y)).any(|y| (floor(low.x)..=floor(high.x)).any(|x| drawn(x, y)));
                assert!(pyramid.touches(low, high) || !any, "{low} {high}");
                empty += u32::from(!pyramid.touches(low, high));
            }
            assert!(fraction > 0.0 || empty == 2000);
            assert!(fraction < 1.0 || empty < 900);
        }
    }

    #[test]
    fn boxes_behind_drawn_pixels_are_seen() {
        let fov = Fov { left: -1.0, right: 1.0, down: -1.0, up: 1.0 };
        let camera = Camera::new(DVec3::ZERO, DQuat::IDENTITY, Projection::Perspective(fov), 64, 64).unwrap();
        let mut mask = vec![false; 64 * 64];
        mask[10 * 64 + 50] = true;
        let pyramid = MaskPyramid::new(&mask, 64);
        let sees_box = |x: f64, y: f64, depth: f64, size: f32| {
            let (_, direction) = camera.ray(x, y);
            let center = (direction * (depth / -direction.z)).as_vec3();
            pyramid.sees(&camera, &Aabb { min: center - size, max: center + size })
        };
        assert!(sees_box(50.5, 10.5, 5.0, 0.1) && sees_box(50.5, 10.5, 500.0, 0.1));
        assert!(!sees_box(20.5, 40.5, 5.0, 0.1) && !sees_box(50.5, 40.5, 5.0, 0.1));
        assert!(sees_box(20.5, 40.5, 2.0, 3.0), "a box around the camera");
    }
}
