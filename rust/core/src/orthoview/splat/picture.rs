//! Settings of a picture drawn from views, and the per-view data of one picture.

use glam::DVec3;

use super::lanes::Constants;
use super::projector::{Projector, ViewProjection};
use super::splats::Splats;
use crate::base::{Result, ensure};
use crate::camera::Camera;
use crate::render::{Channels, Frame, Limits, Pixels};

/// Maximum number of samples along each axis of a pixel.
const MAX_GRID: u32 = 8;

/// A picture to be drawn from views.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'a> {
    /// The camera.
    pub camera: &'a Camera,
    /// World position that positions are relative to.
    pub origin: DVec3,
    /// Requested images.
    pub channels: Channels,
    /// Samples along each axis of a pixel.
    pub grid: u32,
    /// Visible volume, in world coordinates. Splats whose centres lie in it are drawn.
    pub limits: Limits,
    /// Pixels to draw.
    pub pixels: Pixels<'a>,
    /// Frame of all other surfaces, drawn before: `grid` × `grid` pixels per pixel, with `range` among its images.
    pub before: Option<&'a Frame>,
}

/// Splat counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Splats of all views.
    pub total: u64,
    /// Splats of parts whose bounding boxes intersect the picture.
    pub in_picture: u64,
    /// Splats of parts that are not hidden.
    pub seen: u64,
    /// Projected splats, counted once per screen tile.
    pub projected: u64,
}

impl Picture<'_> {
    /// Returns the number of its pixels.
    pub(super) fn pixel_count(&self) -> usize {
        self.camera.width as usize * self.camera.height as usize
    }
}

/// A view with its precomputed data for a picture.
pub(super) struct PreparedView<'a> {
    pub splats: &'a Splats,
    /// Index of its first splat among those of all views.
    pub first: u32,
    pub projection: ViewProjection,
    pub constants: Constants,
}

/// A picture with its prepared views.
pub(super) struct PreparedPicture<'a> {
    pub picture: &'a Picture<'a>,
    /// Camera of the samples.
    pub camera: Camera,
    pub projector: Projector,
    pub views: Vec<PreparedView<'a>>,
}

impl<'a> PreparedPicture<'a> {
    /// Checks a picture and prepares its views.
    pub fn new(views: &[&'a Splats], picture: &'a Picture<'a>) -> Result<Self> {
        let grid = picture.grid;
        ensure!((1..=MAX_GRID).contains(&grid), "grid", format!("1 to {MAX_GRID}"), grid);
        let total: u64 = views.iter().map(|splats| splats.count() as u64).sum();
        ensure!(total < u64::from(u32::MAX), "views", format!("fewer than {} splats", u32::MAX), total);
        picture.pixels.check(picture.pixel_count())?;
        let has_middle = !grid.is_multiple_of(2) || !picture.channels.any_surface();
        ensure!(has_middle, "grid", "an odd number for images of the pixels' middles", grid);
        let samples = picture.pixel_count() * (grid as usize).pow(2);
        let ranges = picture.before.map_or(samples, |before| before.range.len());
        ensure!(ranges == samples, "before", format!("ranges of {samples} samples"), ranges);
        let (width, height) = (picture.camera.width * grid, picture.camera.height * grid);
        let camera = Camera { width, height, ..*picture.camera };
        let projector = Projector::new(&camera);
        let mut first = 0;
        let prepare = |&splats: &&'a Splats| {
            let projection = ViewProjection::new(splats, &projector);
            let view =
                PreparedView { splats, first, projection, constants: Constants::new(splats, &projector, &projection) };
            first += splats.count() as u32;
            view
        };
        let views = views.iter().map(prepare).collect();
        Ok(Self { picture, camera, projector, views })
    }

    /// Returns the number of splats of all views.
    pub fn splat_count(&self) -> u64 {
        self.views.last().map_or(0, |view| u64::from(view.first) + view.splats.count() as u64)
    }
}
