//! A picture that is drawn of views, and what is computed once for each of its views.

use glam::DVec3;

use super::lanes::Constants;
use super::projector::{Projector, Sight};
use super::splats::Splats;
use crate::base::{Error, Result};
use crate::camera::Camera;
use crate::render::{Channels, Frame, Limits, Pixels};

/// Greatest number of samples along each axis of a pixel.
const MOST_GRID: u32 = 8;

/// A picture to be drawn of views.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'a> {
    /// The camera.
    pub camera: &'a Camera,
    /// World position that positions are relative to.
    pub origin: DVec3,
    /// The images that are wanted.
    pub channels: Channels,
    /// Samples along each axis of a pixel.
    pub grid: u32,
    /// The part of space in which splats are seen, in world positions; a splat is seen if its middle is.
    pub limits: Limits,
    /// The pixels that are drawn.
    pub pixels: Pixels<'a>,
    /// Everything else that is seen: its images have `grid` × `grid` pixels for each pixel, and `range` is one of them.
    pub before: Option<&'a Frame>,
}

/// Numbers of splats.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// In all views.
    pub total: u64,
    /// In parts of views that reach into the picture.
    pub in_picture: u64,
    /// In those that are not hidden.
    pub seen: u64,
    /// Projected: those that several tiles of the screen show count for each.
    pub projected: u64,
}

impl Picture<'_> {
    /// Number of its pixels.
    pub(super) fn pixel_count(&self) -> usize {
        self.camera.width as usize * self.camera.height as usize
    }

    /// The camera of the samples.
    pub(super) fn sampled(&self) -> Camera {
        let camera = *self.camera;
        Camera { width: camera.width * self.grid, height: camera.height * self.grid, ..camera }
    }

    pub(super) fn check(&self, views: &[&Splats]) -> Result<()> {
        if !(1..=MOST_GRID).contains(&self.grid) {
            return Err(Error::value("grid", format!("1 to {MOST_GRID}"), self.grid));
        }
        let total: u64 = views.iter().map(|splats| splats.count() as u64).sum();
        if total >= u64::from(u32::MAX) {
            return Err(Error::value("views", format!("fewer than {} splats", u32::MAX), total));
        }
        self.pixels.check(self.pixel_count())?;
        let samples = self.pixel_count() * (self.grid as usize).pow(2);
        if self.grid.is_multiple_of(2) && self.channels.any_surface() {
            return Err(Error::value("grid", "an odd number for images of the pixels' middles", self.grid));
        }
        match self.before {
            Some(before) if before.range.len() != samples => {
                Err(Error::value("before", format!("ranges of {samples} samples"), before.range.len()))
            }
            _ => Ok(()),
        }
    }
}

/// A view with what is computed once for a picture.
pub(super) struct Prepared<'a> {
    pub splats: &'a Splats,
    /// Number of its first splat among those of all views.
    pub first: u32,
    pub sight: Sight,
    pub constants: Constants,
}

impl<'a> Prepared<'a> {
    /// All views of a picture.
    pub fn all(views: &[&'a Splats], projector: &Projector) -> Vec<Self> {
        let mut first = 0;
        let prepare = |&splats: &&'a Splats| {
            let sight = Sight::new(splats, projector);
            let view = Self { splats, first, sight, constants: Constants::new(splats, projector, &sight) };
            first += splats.count() as u32;
            view
        };
        views.iter().map(prepare).collect()
    }
}
