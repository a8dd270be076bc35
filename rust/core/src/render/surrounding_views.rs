//! Silhouettes of a scene from many sides, and the luma of the pixels near them, for comparison with another scene from
//! the same cameras. Most of a picture of one object is sky, which needs no comparison.
//!
//! Pixels are bit-equal to those of `draw`, because a ray's hit does not depend on the rays traced beside it.

use rayon::prelude::*;

use super::limits::Limits;
use super::tiles::{Picture, TILE, ViewRays, check_position, check_samples, sample_offsets};
use super::truth::Truth;
use crate::base::{Progress, Result, ensure, memory::try_vec};
use crate::camera::Camera;
use crate::scene::Scene;
use crate::scene::srgb::srgb_from_linear;
use crate::trace::{AcceptAll, AlphaFilter, Hit, any_hits, beam_touches, closest_hits, closest_hits_apart};

/// Number of rays traced together.
const PACKET: usize = 64;
/// Number of rows per task, a multiple of every block's height; also the side of a square that is tested for geometry.
const ROWS: usize = 16;
/// Maximum number of triangles per block of pixels, if spread evenly over the picture, for which rays are traced as a
/// packet. With more, rays share so few nodes of the tree that single rays are faster. Measured on an object that
/// covers a fifth of its picture.
const MAX_PACKET_TRIANGLES: f64 = 150.0;

/// A scene and cameras around it, all with pictures of one size.
pub struct SurroundingViews<'a> {
    scene: &'a Scene,
    cameras: &'a [Camera],
    width: usize,
    height: usize,
}

/// Settings of luma.
#[derive(Clone, Copy, Debug)]
pub struct Luma {
    /// Colour samples of each pixel, 1 to `MAX_SAMPLES`.
    pub samples: u32,
    /// Weights of red, green and blue as sRGB codes.
    pub weights: [f64; 3],
    /// Pixels at most this many columns and rows away from a silhouette pixel are computed.
    pub reach: usize,
}

impl<'a> SurroundingViews<'a> {
    /// Checks the cameras and builds the scene's trees.
    pub fn new(scene: &'a Scene, cameras: &'a [Camera], progress: &Progress) -> Result<Self> {
        let size = |camera: &Camera| (camera.width, camera.height);
        let (width, height) = cameras.first().map_or((0, 0), size);
        for camera in cameras {
            check_position("cameras", camera.position - scene.origin)?;
            let (wide, high) = size(camera);
            let is_equal = (wide, high) == (width, height);
            ensure!(is_equal, "cameras", format!("{width} × {height} pixels"), format!("{wide} × {high}"));
        }
        scene.build_to_shade(progress)?;
        Ok(Self { scene, cameras, width: width as usize, height: height as usize })
    }

    /// Returns whether each pixel's centre shows the scene, picture by picture and row by row.
    pub fn silhouettes(&self, progress: &Progress) -> Result<Vec<bool>> {
        let (scene, block) = (self.scene, [TILE, TILE]);
        let filter = &AlphaFilter::new(scene, AcceptAll);
        let is_crowded = self.is_crowded(block);
        let order = pixel_order(block);
        self.bands(progress, |view, _, first_row, shown| {
            let size = [shown.len() / self.width, self.width];
            let (mut pixels, mut rays) = (Vec::new(), Vec::new());
            let (mut hits, mut is_hit) = ([Hit::MISS; PACKET], [false; PACKET]);
            for (square, square_size) in blocks([0, 0], size, [ROWS, ROWS]) {
                let corners = [[0, 0], [0, square_size[1]], [square_size[0], 0], square_size];
                let corner = |[down, right]: [usize; 2]| {
                    view.ray((square[1] + right) as f64, (first_row + square[0] + down) as f64)
                };
                if !beam_touches(scene, &corners.map(corner)) {
                    continue;
                }
                for (start, size) in blocks(square, square_size, block) {
                    pixels.clear();
                    pixels.extend(pixels_of(start, size, &order));
                    rays.clear();
                    let center =
                        |&[row, column]: &[usize; 2]| view.ray(column as f64 + 0.5, (first_row + row) as f64 + 0.5);
                    rays.extend(pixels.iter().map(center));
                    let (hits, is_hit) = (&mut hits[..rays.len()], &mut is_hit[..rays.len()]);
                    if is_crowded {
                        any_hits(scene, &rays, filter, is_hit);
                    } else {
                        closest_hits(scene, &rays, filter, hits);
                        is_hit.iter_mut().zip(hits).for_each(|(is_hit, hit)| *is_hit = !hit.is_miss());
                    }
                    for ([row, column], is_hit) in pixels.iter().zip(is_hit) {
                        shown[row * self.width + column] = *is_hit;
                    }
                }
            }
        })
    }

    /// Returns the luma, 0 to 255, of the pixels near those of `shown` (ordered as in `silhouettes`); 0 elsewhere.
    pub fn luma(&self, shown: &[bool], settings: &Luma, progress: &Progress) -> Result<Vec<f64>> {
        check_samples(settings.samples)?;
        let expected = format!("{} pixels", self.pixel_count());
        ensure!(shown.len() == self.pixel_count(), "shown", expected, shown.len());
        let filter = &AlphaFilter::new(self.scene, AcceptAll);
        let samples = settings.samples as usize;
        let (offsets, block) = (sample_offsets(settings.samples), block_size(samples));
        let (scale, sample_weight) = (1.0 / f64::from(settings.samples).sqrt(), 1.0 / settings.samples as f32);
        let (is_crowded, order) = (self.is_crowded(block), pixel_order(block));
        let picture = Truth { scene: self.scene, filter };
        let size = self.width * self.height;
        self.bands(progress, |view, number, first_row, luma| {
            let rows = luma.len() / self.width;
            let is_near = self.mask_near(&shown[number * size..][..size], first_row, rows, settings.reach);
            let (mut pixels, mut positions) = (Vec::new(), Vec::new());
            let (mut rays, mut hits, mut sums) = (Vec::new(), Vec::new(), Vec::new());
            for (start, size) in blocks([0, 0], [rows, self.width], block) {
                pixels.clear();
                pixels
                    .extend(pixels_of(start, size, &order).filter(|[row, column]| is_near[row * self.width + column]));
                if pixels.is_empty() {
                    continue;
                }
                positions.clear();
                for &[row, column] in &pixels {
                    let position =
                        |offset: &[f64; 2]| (column as f64 + offset[0], (first_row + row) as f64 + offset[1]);
                    positions.extend(offsets.iter().map(position));
                }
                rays.clear();
                rays.extend(positions.iter().map(|&(x, y)| view.ray(x, y)));
                hits.clear();
                hits.resize(rays.len(), Hit::MISS);
                if is_crowded {
                    closest_hits_apart(self.scene, &rays, filter, &mut hits);
                } else {
                    closest_hits(self.scene, &rays, filter, &mut hits);
                }
                sums.clear();
                sums.resize(rays.len(), [0.0f32; 3]);
                let footprint = |n: usize| view.rays.footprint(positions[n].0, positions[n].1, scale);
                picture.add_colors(&rays, &hits, footprint, &mut sums);
                for ([row, column], colors) in pixels.iter().zip(sums.chunks(samples)) {
                    let codes: [u8; 3] = std::array::from_fn(|i| {
                        srgb_from_linear(colors.iter().map(|color| color[i]).sum::<f32>() * sample_weight)
                    });
                    luma[row * self.width + column] = (0..3).map(|i| settings.weights[i] * f64::from(codes[i])).sum();
                }
            }
        })
    }

    fn pixel_count(&self) -> usize {
        self.cameras.len() * self.width * self.height
    }

    /// Calls a function for each band of rows of each picture with the view, the picture's number, the band's first row
    /// and its values.
    fn bands<T: Copy + Default + Send>(
        &self,
        progress: &Progress,
        paint: impl Fn(&ViewRays, usize, usize, &mut [T]) + Sync,
    ) -> Result<Vec<T>> {
        progress.expect(self.pixel_count() as u64);
        let mut values = try_vec(T::default(), self.pixel_count())?;
        let size = (self.width * self.height).max(1);
        let pictures = values.par_chunks_mut(size).zip(self.cameras).enumerate();
        pictures.try_for_each(|(number, (picture, camera))| {
            let view = ViewRays::new(camera, self.scene.origin, &Limits::NONE);
            picture.par_chunks_mut(ROWS * self.width).enumerate().try_for_each(|(band, values)| {
                paint(&view, number, band * ROWS, values);
                progress.report(values.len() as u64)
            })
        })?;
        Ok(values)
    }

    /// Returns true if rays through a block of this height and width should be traced one by one.
    fn is_crowded(&self, block: [usize; 2]) -> bool {
        let fraction = (block[0] * block[1]) as f64 / (self.width * self.height).max(1) as f64;
        self.scene.triangle_count() as f64 * fraction > MAX_PACKET_TRIANGLES
    }

    /// Returns for each pixel of some rows whether a shown pixel is at most `reach` columns and rows away.
    fn mask_near(&self, shown: &[bool], first_row: usize, rows: usize, reach: usize) -> Vec<bool> {
        let width = self.width;
        let mut is_near = vec![false; rows * width];
        // For each column, whether a pixel within reach is shown; with `reach` columns of padding on both sides.
        let mut padded = vec![false; width + 2 * reach];
        for (row, is_near) in (first_row..).zip(is_near.chunks_mut(width)) {
            let columns = &mut padded[reach..reach + width];
            columns.fill(false);
            for neighbour in row.saturating_sub(reach)..self.height.min(row + reach + 1) {
                columns.iter_mut().zip(&shown[neighbour * width..]).for_each(|(column, shown)| *column |= shown);
            }
            for shift in 0..=2 * reach {
                is_near.iter_mut().zip(&padded[shift..]).for_each(|(is_near, column)| *is_near |= column);
            }
        }
        is_near
    }
}

/// Returns height and width of the largest block of pixels whose samples fit into a packet, at least one pixel.
fn block_size(samples: usize) -> [usize; 2] {
    let mut block = [TILE, TILE];
    while block[0] * block[1] * samples > PACKET && block != [1, 1] {
        let longer = if block[0] < block[1] { 1 } else { 0 };
        block[longer] /= 2;
    }
    block
}

/// Returns rows and columns of a block's pixels, by squares of 2 × 2 pixels, so that groups of rays are compact.
fn pixel_order([high, wide]: [usize; 2]) -> Vec<[usize; 2]> {
    let mut pixels: Vec<_> = (0..high).flat_map(|row| (0..wide).map(move |column| [row, column])).collect();
    pixels.sort_by_key(|[row, column]| [row / 2, column / 2, *row, *column]);
    pixels
}

/// Returns the pixels of the block at `start`; those beyond `size` are omitted.
fn pixels_of(start: [usize; 2], size: [usize; 2], order: &[[usize; 2]]) -> impl Iterator<Item = [usize; 2]> {
    let within = order.iter().filter(move |[row, column]| *row < size[0] && *column < size[1]);
    within.map(move |[row, column]| [start[0] + row, start[1] + column])
}

/// Returns the first row and column and the size of each block of a region; the last ones may be smaller.
fn blocks(
    [top, left]: [usize; 2],
    [rows, columns]: [usize; 2],
    [high, wide]: [usize; 2],
) -> impl Iterator<Item = ([usize; 2], [usize; 2])> {
    (0..rows).step_by(high).flat_map(move |row| {
        let size = move |column| [high.min(rows - row), wide.min(columns - column)];
        (0..columns).step_by(wide).map(move |column| ([top + row, left + column], size(column)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_fill_packets() {
        let expected = [(1, [8, 8]), (2, [4, 8]), (3, [4, 4]), (4, [4, 4]), (9, [2, 2]), (32, [1, 2]), (65, [1, 1])];
        for (samples, block) in expected {
            assert_eq!(block_size(samples), block, "{samples}");
        }
    }

    #[test]
    fn blocks_hold_each_pixel_once() {
        for block in [[8, 8], [4, 8], [2, 1], [1, 1]] {
            let order = pixel_order(block);
            let mut pixels: Vec<_> =
                blocks([3, 5], [13, 11], block).flat_map(|(start, size)| pixels_of(start, size, &order)).collect();
            pixels.sort_unstable();
            let every: Vec<_> = (3..16).flat_map(|row| (5..16).map(move |column| [row, column])).collect();
            assert_eq!(pixels, every, "{block:?}");
        }
    }
}
