//! Loop over a view's pixels, shared by ground truth, environment maps and reduced scenes.
//!
//! Threads process bands of eight rows, and the tracer receives tiles of 8 × 8 pixels within them. A pixel's samples
//! are summed in a fixed order, so the result does not depend on the number of threads.

use glam::DVec3;
use rayon::prelude::*;

use super::frame::{Band, Channels, Frame, Sample};
use super::limits::{Limits, Segment};
use crate::base::{MAX_COORDINATE, Progress, Result, ensure};
use crate::camera::{Camera, Footprint, Rays};
use crate::trace::{Hit, Ray};

/// Width of a tile, pixels; a tile has 64 neighbouring rays.
pub(super) const TILE: usize = 8;
pub(crate) const PIXELS: usize = TILE * TILE;
/// Centre of a pixel, as an offset from its corner.
pub(super) const CENTER: [f64; 2] = [0.5, 0.5];
/// Empty buffer for the rays of a tile.
pub(super) const NO_RAYS: [Ray; PIXELS] = [Ray::EMPTY; PIXELS];

/// Maximum number of colour samples per pixel.
pub const MAX_SAMPLES: u32 = 1024;

/// A picture rendered by rays.
pub trait Picture: Sync {
    /// Traces the coherent rays of a tile's drawn pixels; it may first shorten them (`t_min`, `t_max`). Directions are
    /// unit vectors.
    fn trace(&self, rays: &mut [Ray], hits: &mut [Hit], pixels: &RayPixels<'_>);

    /// Adds the linear RGB of a tile's traced rays, hits or misses, to their sums.
    fn add_colors(&self, rays: &[Ray], hits: &[Hit], footprint: impl Fn(usize) -> Footprint, sums: &mut [[f32; 3]]);

    /// Returns the other channels of a traced ray, hit or miss. Channels that are not requested may keep defaults.
    fn sample(&self, ray: &Ray, hit: &Hit, footprint: impl FnOnce() -> Footprint, channels: Channels) -> Sample;
}

/// Pixels of a tile's rays, and their positions there.
pub struct RayPixels<'a> {
    tile: &'a ImageTile,
    offset: [f64; 2],
}

impl RayPixels<'_> {
    /// Column and row of the tile, in tiles.
    pub(super) fn tile(&self) -> (usize, usize) {
        (self.tile.first_column / TILE, self.tile.first_row / TILE)
    }

    /// Returns the image index of the n-th ray's pixel.
    #[inline]
    pub fn index(&self, n: usize) -> usize {
        self.tile.index(n)
    }

    /// Returns the position of the n-th ray in the tile, as fractions of the full tile's width and height.
    #[inline]
    pub(super) fn position_in_tile(&self, n: usize) -> [f32; 2] {
        let (column, row) = self.tile.offset_in_tile(n);
        let fraction = |pixel: usize, offset: f64| ((pixel as f64 + offset) / TILE as f64) as f32;
        [fraction(column, self.offset[0]), fraction(row, self.offset[1])]
    }
}

/// Pixels to draw, and the background of samples without a triangle.
#[derive(Clone, Copy, Debug, Default)]
pub struct Pixels<'a> {
    /// Flag per pixel whether it is drawn; `None` draws all. Pixels that are not drawn are black misses.
    pub mask: Option<&'a [bool]>,
    /// Whether samples without a triangle are black instead of showing map or sky.
    pub bare: bool,
    /// Whether GPUs also cull geometry that projects only to pixels that are not drawn.
    pub culls_masked: bool,
    /// Flag per instance whether the picture may show it, if known; GPUs cull the others.
    pub instances: Option<&'a [bool]>,
}

impl Pixels<'_> {
    /// Fails for a mask of another size.
    pub(crate) fn check(&self, pixels: usize) -> Result<()> {
        let count = self.mask.map_or(pixels, <[_]>::len);
        ensure!(count == pixels, "mask", format!("{pixels} pixels"), count);
        Ok(())
    }
}

/// A view to be rendered.
#[derive(Clone, Copy, Debug)]
pub struct RenderView<'a> {
    /// The camera.
    pub camera: &'a Camera,
    /// World position of the scene's origin.
    pub origin: DVec3,
    /// Requested images.
    pub channels: Channels,
    /// Number of colour samples per pixel, 1 to `MAX_SAMPLES`; the other channels always use the pixel's centre.
    pub samples: u32,
    /// Visible volume, in world coordinates.
    pub limits: Limits,
    /// Pixels to draw.
    pub pixels: Pixels<'a>,
}

/// Renders a picture pixel by pixel.
pub fn draw(view: &RenderView<'_>, picture: &impl Picture, progress: &Progress) -> Result<Frame> {
    let caster = Caster::new(view)?;
    let mut frame = Frame::new(view.channels, caster.pixel_count())?;
    let paint = |tile: &ImageTile, band: &mut Band<'_>, (): &mut ()| caster.paint(picture, view, tile, band);
    caster.for_each_tile(&mut frame, progress, paint)?;
    Ok(frame)
}

/// Fails for a position too far from the scene's origin for float32 rays; see `MAX_COORDINATE`.
pub(super) fn check_position(argument: &'static str, position: DVec3) -> Result<()> {
    let farthest = position.abs().max_element();
    let expected = format!("a place within {MAX_COORDINATE:e} m of the scene's origin");
    ensure!(farthest <= MAX_COORDINATE, argument, expected, format!("{farthest:e} m"));
    Ok(())
}

/// Fails for an invalid number of colour samples per pixel.
pub(super) fn check_samples(samples: u32) -> Result<()> {
    let is_valid = (1..=MAX_SAMPLES).contains(&samples);
    ensure!(is_valid, "samples", format!("a whole number from 1 to {MAX_SAMPLES}"), samples);
    Ok(())
}

/// Returns the positions of colour samples within a pixel: a Hammersley set (Hammersley, Monte Carlo methods, 1960)
/// whose second coordinate is replaced by its rank. For any number of samples each row and column contains one sample,
/// and their mean is the pixel's centre. A single sample lies at the centre.
pub fn sample_offsets(samples: u32) -> Vec<[f64; 2]> {
    let mut order: Vec<u32> = (0..samples).collect();
    order.sort_by_key(|i| i.reverse_bits());
    let center = |stratum: u32| (f64::from(stratum) + 0.5) / f64::from(samples);
    let mut offsets = vec![[0.0; 2]; samples as usize];
    for (rank, &i) in order.iter().enumerate() {
        offsets[i as usize] = [center(i), center(rank as u32)];
    }
    offsets
}

/// A tile of an image, and its drawn pixels.
pub(super) struct ImageTile {
    first_row: usize,
    first_column: usize,
    rows: usize,
    columns: usize,
    /// Width of the image, pixels.
    width: usize,
    /// Numbers of the drawn pixels within the tile, row by row; the first `count` are valid.
    drawn: [u8; PIXELS],
    pub(super) count: usize,
}

impl ImageTile {
    fn list_drawn(&mut self, mask: Option<&[bool]>) {
        for number in 0..self.rows * self.columns {
            let (row, column) = (self.first_row + number / self.columns, self.first_column + number % self.columns);
            if mask.is_none_or(|mask| mask[row * self.width + column]) {
                self.drawn[self.count] = number as u8;
                self.count += 1;
            }
        }
    }

    /// Returns the column and row within the tile of the n-th drawn pixel.
    #[inline]
    pub(super) fn offset_in_tile(&self, n: usize) -> (usize, usize) {
        let number = usize::from(self.drawn[n]);
        (number % self.columns, number / self.columns)
    }

    /// Returns the image position of a point of the n-th drawn pixel; `offset` is relative to the pixel's corner.
    #[inline]
    fn position(&self, n: usize, offset: [f64; 2]) -> (f64, f64) {
        let (column, row) = self.offset_in_tile(n);
        ((self.first_column + column) as f64 + offset[0], (self.first_row + row) as f64 + offset[1])
    }

    /// Returns the image index of the n-th drawn pixel.
    #[inline]
    pub(super) fn index(&self, n: usize) -> usize {
        self.first_row * self.width + self.slot(n)
    }

    /// Returns the index in the band of the n-th drawn pixel.
    #[inline]
    pub(super) fn slot(&self, n: usize) -> usize {
        let (column, row) = self.offset_in_tile(n);
        row * self.width + self.first_column + column
    }

    /// Returns the indices in the band of the pixels that are not drawn.
    fn undrawn_slots(&self) -> impl Iterator<Item = usize> {
        let drawn = &self.drawn[..self.count];
        (0..self.rows * self.columns)
            .filter(|&number| drawn.binary_search(&(number as u8)).is_err())
            .map(|number| number / self.columns * self.width + self.first_column + number % self.columns)
    }
}

/// Rays of a camera in a visible volume, relative to a scene's origin.
pub(crate) struct ViewRays {
    pub(crate) rays: Rays,
    eye: DVec3,
    limits: Limits,
}

impl ViewRays {
    pub(crate) fn new(camera: &Camera, origin: DVec3, limits: &Limits) -> Self {
        Self { rays: camera.rays(), eye: camera.position - origin, limits: limits.relative_to(origin) }
    }

    /// Returns the ray through image position (x, y).
    #[inline]
    pub(crate) fn ray(&self, x: f64, y: f64) -> Ray {
        let (start, direction) = self.rays.ray(x, y);
        let origin = self.eye + start;
        let Segment { t_min, t_max } = self.limits.clip_ray(origin, direction);
        Ray { origin: origin.as_vec3(), direction: direction.as_vec3(), t_min, t_max }
    }
}

/// Rays of a view, tile by tile.
pub(super) struct Caster<'a> {
    width: usize,
    height: usize,
    mask: Option<&'a [bool]>,
    view: ViewRays,
    /// Positions of a pixel's samples.
    pub(super) offsets: Vec<[f64; 2]>,
    /// Side of the square that a sample represents, pixels.
    pub(super) scale: f64,
}

impl<'a> Caster<'a> {
    /// Creates the rays of a view; fails for an impossible view.
    pub(super) fn new(view: &RenderView<'a>) -> Result<Self> {
        check_samples(view.samples)?;
        check_position("position", view.camera.position - view.origin)?;
        let (width, height) = (view.camera.width as usize, view.camera.height as usize);
        view.pixels.check(width * height)?;
        Ok(Self {
            width,
            height,
            mask: view.pixels.mask,
            view: ViewRays::new(view.camera, view.origin, &view.limits),
            offsets: sample_offsets(view.samples),
            scale: 1.0 / f64::from(view.samples).sqrt(),
        })
    }

    pub(super) fn pixel_count(&self) -> usize {
        self.width * self.height
    }

    /// Calls a function for each tile with its band of the frame and a value per band; returns these values in order.
    pub(super) fn for_each_tile<T: Default + Send>(
        &self,
        frame: &mut Frame,
        progress: &Progress,
        paint: impl Fn(&ImageTile, &mut Band<'_>, &mut T) + Sync,
    ) -> Result<Vec<T>> {
        progress.expect(self.pixel_count() as u64);
        let bands = frame.bands(self.width * TILE).into_par_iter().enumerate();
        let paint_band = |(index, mut band)| {
            let first_row = index * TILE;
            let rows = TILE.min(self.height - first_row);
            let mut value = T::default();
            for first_column in (0..self.width).step_by(TILE) {
                let columns = TILE.min(self.width - first_column);
                let (width, drawn) = (self.width, [0; PIXELS]);
                let mut tile = ImageTile { first_row, first_column, rows, columns, width, drawn, count: 0 };
                tile.list_drawn(self.mask);
                paint(&tile, &mut band, &mut value);
                progress.check()?;
            }
            progress.report((rows * self.width) as u64)?;
            Ok(value)
        };
        bands.map(paint_band).collect()
    }

    /// Writes the rays of a tile's drawn pixels; `offset` is relative to a pixel's corner.
    pub(super) fn write_rays(&self, tile: &ImageTile, offset: [f64; 2], rays: &mut [Ray]) {
        for (n, ray) in rays.iter_mut().enumerate() {
            let (x, y) = tile.position(n, offset);
            *ray = self.view.ray(x, y);
        }
    }

    /// Returns the weight of a sample in its pixel's colour.
    pub(super) fn sample_weight(&self) -> f32 {
        1.0 / self.offsets.len() as f32
    }

    /// Returns the footprint of a ray that represents a square of `scale` pixels.
    pub(super) fn footprint(&self, tile: &ImageTile, n: usize, offset: [f64; 2], scale: f64) -> Footprint {
        let (x, y) = tile.position(n, offset);
        self.view.rays.footprint(x, y, scale)
    }

    /// Draws the pixels of a tile into its band.
    fn paint(&self, picture: &impl Picture, view: &RenderView<'_>, tile: &ImageTile, band: &mut Band<'_>) {
        tile.undrawn_slots().for_each(|slot| band.set_sample(slot, &Sample::default()));
        if tile.count == 0 {
            return;
        }
        let mut rays = NO_RAYS;
        let mut hits = [Hit::MISS; PIXELS];
        let (rays, hits) = (&mut rays[..tile.count], &mut hits[..tile.count]);
        let channels = view.channels;
        if channels.any_sampled() {
            let mut sums = [[0.0f32; 3]; PIXELS];
            let mut counts = [0.0f32; PIXELS];
            for &offset in &self.offsets {
                self.trace(picture, tile, offset, rays, hits);
                if channels.color {
                    let before = sums;
                    picture.add_colors(rays, hits, |n| self.footprint(tile, n, offset, self.scale), &mut sums);
                    if view.pixels.bare {
                        // Misses stay black.
                        (0..hits.len()).filter(|&n| hits[n].is_miss()).for_each(|n| sums[n] = before[n]);
                    }
                }
                counts.iter_mut().zip(&*hits).filter(|(_, hit)| !hit.is_miss()).for_each(|(count, _)| *count += 1.0);
            }
            let sample_weight = self.sample_weight();
            for (n, (sum, count)) in sums.iter().zip(&counts).enumerate().take(tile.count) {
                band.color(tile.slot(n), sum.map(|sum| sum * sample_weight));
                band.coverage(tile.slot(n), count * sample_weight);
            }
        }
        if channels.any_surface() {
            if !channels.any_sampled() || self.offsets.len() > 1 {
                self.trace(picture, tile, CENTER, rays, hits);
            }
            for (n, (ray, hit)) in rays.iter().zip(hits.iter()).enumerate() {
                let footprint = || self.footprint(tile, n, CENTER, 1.0);
                band.set_sample(tile.slot(n), &picture.sample(ray, hit, footprint, channels));
            }
        }
    }

    fn trace(&self, picture: &impl Picture, tile: &ImageTile, offset: [f64; 2], rays: &mut [Ray], hits: &mut [Hit]) {
        self.write_rays(tile, offset, rays);
        picture.trace(rays, hits, &RayPixels { tile, offset });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_lie_in_the_pixel_about_its_centre() {
        assert_eq!(sample_offsets(1), [[0.5, 0.5]]);
        for count in 1..=MAX_SAMPLES {
            let offsets = sample_offsets(count);
            for axis in 0..2 {
                assert!(offsets.iter().all(|offset| (0.0..1.0).contains(&offset[axis])), "{count}");
                let mean = offsets.iter().map(|offset| offset[axis]).sum::<f64>() / f64::from(count);
                // Sum of a thousand float64 numbers of size 1.
                assert!((mean - 0.5).abs() < 1e-12, "{count} {mean}");
            }
        }
    }

    #[test]
    fn samples_fill_every_row_and_column_once() {
        for count in [2u32, 3, 4, 7, 16, 61, 64] {
            for axis in 0..2 {
                let stratum = |offset: &[f64; 2]| 1u64 << (offset[axis] * f64::from(count)) as u64;
                let strata = sample_offsets(count).iter().fold(0, |strata, offset| strata | stratum(offset));
                assert_eq!(strata.count_ones(), count);
            }
        }
    }
}
