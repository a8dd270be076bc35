//! The rays of a view, band by band and tile by tile.

use glam::DVec3;
use rayon::prelude::*;

use super::frame::{Band, Frame};
use super::limits::{Limits, Segment};
use super::tiles::{ImageTile, MAX_SAMPLES, RenderView, TILE, check_reach, sample_offsets};
use crate::base::{Error, Progress, Result};
use crate::camera::{Footprint, Rays};
use crate::trace::Ray;

/// The rays of a view, tile by tile.
pub(super) struct Caster<'a> {
    width: usize,
    height: usize,
    mask: Option<&'a [bool]>,
    rays: Rays,
    eye: DVec3,
    /// Positions of a pixel's samples.
    pub(super) offsets: Vec<[f64; 2]>,
    /// Side of the square that a sample represents, pixels.
    scale: f64,
    /// Relative to the scene's origin.
    limits: Limits,
}

impl<'a> Caster<'a> {
    /// Fails for an impossible view.
    pub(super) fn new(view: &RenderView<'a>) -> Result<Self> {
        if !(1..=MAX_SAMPLES).contains(&view.samples) {
            return Err(Error::value("samples", format!("a whole number from 1 to {MAX_SAMPLES}"), view.samples));
        }
        let eye = view.camera.position - view.origin;
        check_reach("position", eye)?;
        let (width, height) = (view.camera.width as usize, view.camera.height as usize);
        view.pixels.check(width * height)?;
        Ok(Self {
            width,
            height,
            mask: view.pixels.mask,
            rays: view.camera.rays(),
            eye,
            offsets: sample_offsets(view.samples),
            scale: 1.0 / f64::from(view.samples).sqrt(),
            limits: view.limits.relative_to(view.origin),
        })
    }

    pub(super) fn pixel_count(&self) -> usize {
        self.width * self.height
    }

    /// Calls a function for each tile with the band of a frame that holds it, and returns what it left of each band
    /// besides, in order.
    pub(super) fn for_tiles<T: Default + Send>(
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
            let mut besides = T::default();
            for first_column in (0..self.width).step_by(TILE) {
                let columns = TILE.min(self.width - first_column);
                let tile = ImageTile::new(first_row, first_column, rows, columns, self.width, self.mask);
                paint(&tile, &mut band, &mut besides);
                progress.check()?;
            }
            progress.report((rows * self.width) as u64)?;
            Ok(besides)
        };
        bands.map(paint_band).collect()
    }

    /// Writes the rays of a tile.
    pub(super) fn aim(&self, tile: &ImageTile, offset: [f64; 2], rays: &mut [Ray]) {
        for (n, ray) in rays.iter_mut().enumerate() {
            let (x, y) = position(tile, n, offset);
            *ray = ray_at(&self.rays, self.eye, x, y, &self.limits);
        }
    }

    /// The share of a sample in its pixel's colour.
    pub(super) fn share(&self) -> f32 {
        1.0 / self.offsets.len() as f32
    }

    /// The footprint of one of a pixel's samples.
    pub(super) fn of_sample(&self, tile: &ImageTile, n: usize, offset: [f64; 2]) -> Footprint {
        self.footprint(tile, n, offset, self.scale)
    }

    /// The footprint of a ray that represents a square of `scale` pixels.
    pub(super) fn footprint(&self, tile: &ImageTile, n: usize, offset: [f64; 2], scale: f64) -> Footprint {
        let (x, y) = position(tile, n, offset);
        self.rays.footprint(x, y, scale)
    }
}

/// Returns the ray through image position (x, y) from an eye; eye and limits are relative to the scene's origin.
#[inline]
pub(crate) fn ray_at(rays: &Rays, eye: DVec3, x: f64, y: f64, limits: &Limits) -> Ray {
    let (start, direction) = rays.at(x, y);
    let origin = eye + start;
    let Segment { t_min, t_max } = limits.of(origin, direction);
    Ray { origin: origin.as_vec3(), direction: direction.as_vec3(), t_min, t_max }
}

#[inline]
fn position(tile: &ImageTile, n: usize, offset: [f64; 2]) -> (f64, f64) {
    let (column, row) = tile.pixel(n);
    (column as f64 + offset[0], row as f64 + offset[1])
}
