//! Draws views: culls their parts, and lets each tile of the screen draw those that it shows.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use glam::DVec3;
use rayon::prelude::*;

use super::lanes::{Constants, Lanes};
use super::projector::{Projector, Rect, Seen, Sight};
use super::resolve::Resolver;
use super::screen::Screen;
use super::splats::{BoxOfBlocks, Extent, Splats};
use crate::base::{Error, Progress, Result};
use crate::camera::Camera;
use crate::render::{Channels, Frame, Limits, Pixels};

/// Width and height of a tile of the screen, pixels. Its keys fit in the first level of the cache for one sample a pixel,
/// and in the second one for 16.
const TILE: i32 = 64;

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
    /// What else is seen: all its images have `grid` × `grid` pixels for each pixel, and `range` is one of them.
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

/// A box of a view in the picture.
struct Part<'a> {
    view: &'a Prepared<'a>,
    contents: &'a BoxOfBlocks,
    seen: Seen,
    is_drawn: AtomicBool,
}

/// A view with what is computed once for a picture.
pub(super) struct Prepared<'a> {
    pub splats: &'a Splats,
    /// Number of its first splat among those of all views.
    pub first: u32,
    sight: Sight,
    constants: Constants,
}

impl Picture<'_> {
    /// The camera of the samples.
    fn sampled(&self) -> Camera {
        let camera = *self.camera;
        Camera { width: camera.width * self.grid, height: camera.height * self.grid, ..camera }
    }

    fn check(&self, views: &[&Splats]) -> Result<()> {
        if !(1..=MOST_GRID).contains(&self.grid) {
            return Err(Error::value("grid", format!("1 to {MOST_GRID}"), self.grid));
        }
        let total: u64 = views.iter().map(|splats| splats.count() as u64).sum();
        if total >= u64::from(u32::MAX) {
            return Err(Error::value("views", format!("fewer than {} splats", u32::MAX), total));
        }
        let samples = u64::from(self.grid).pow(2) * u64::from(self.camera.width) * u64::from(self.camera.height);
        if self.grid.is_multiple_of(2) && self.channels.any_surface() {
            return Err(Error::value("grid", "an odd number for images of the pixels' middles", self.grid));
        }
        match self.before {
            Some(before) if before.range.len() as u64 != samples => {
                Err(Error::value("before", format!("ranges of {samples} samples"), before.range.len()))
            }
            _ => Ok(()),
        }
    }
}

/// Draws views; of the samples that show none, those of `before` or the sky.
pub fn draw(views: &[&Splats], picture: &Picture<'_>, progress: &Progress) -> Result<(Frame, Counts)> {
    picture.check(views)?;
    let sampled = picture.sampled();
    let projector = Projector::new(&sampled);
    let whole = Rect { low: [0, 0], high: [sampled.width as i32, sampled.height as i32] };
    let mut first = 0;
    let prepared: Vec<Prepared<'_>> = views
        .iter()
        .map(|&splats| {
            let sight = Sight::new(splats, &projector);
            let constants = Constants::new(splats, &projector, &sight);
            let view = Prepared { splats, first, sight, constants };
            first += splats.count() as u32;
            view
        })
        .collect();
    let parts = parts_of(&prepared, &whole);
    let projected = AtomicU64::new(0);
    let resolver = Resolver::new(picture, &sampled, &projector, &prepared);
    let mut frame = Frame::new(picture.channels, (picture.camera.width * picture.camera.height) as usize)?;
    let (columns, rows) = (picture.camera.width as i32, picture.camera.height as i32);
    let tiles: Vec<Rect> = (0..rows)
        .step_by(TILE as usize)
        .flat_map(|y| (0..columns).step_by(TILE as usize).map(move |x| (x, y)))
        .map(|(x, y)| Rect { low: [x, y], high: [(x + TILE).min(columns), (y + TILE).min(rows)] })
        .collect();
    progress.expect(tiles.len() as u64);
    let one = |tile: &Rect| {
        let scaled = |corner: [i32; 2]| corner.map(|at| at * picture.grid as i32);
        let rect = Rect { low: scaled(tile.low), high: scaled(tile.high) };
        let mut screen = Screen::new(rect, |x, y| resolver.before(x, y));
        projected.fetch_add(draw_tile(&mut screen, &parts, &projector, &picture.limits), Ordering::Relaxed);
        progress.report(1)?;
        Ok((*tile, resolver.resolve(&screen, tile)))
    };
    for (tile, part) in tiles.par_iter().map(one).collect::<Result<Vec<_>>>()? {
        frame.put(&part, columns as usize, tile.low.map(|at| at as usize), (tile.high[0] - tile.low[0]) as usize);
    }
    let count = |is: &dyn Fn(&Part<'_>) -> bool| {
        parts.iter().filter(|part| is(part)).map(|part| u64::from(part.contents.count)).sum()
    };
    let counts = Counts {
        total: u64::from(first),
        in_picture: count(&|_| true),
        seen: count(&|part| part.is_drawn.load(Ordering::Relaxed)),
        projected: projected.into_inner(),
    };
    Ok((frame, counts))
}

/// The boxes of all views that the picture may show, the nearest ones first.
fn parts_of<'a>(prepared: &'a [Prepared<'a>], whole: &Rect) -> Vec<Part<'a>> {
    let of_view = |view: &'a Prepared<'a>| {
        view.splats.boxes.iter().filter_map(move |contents| {
            let seen = view.sight.seen(&contents.extent, whole)?;
            (!seen.rect.is_empty()).then_some(Part { view, contents, seen, is_drawn: AtomicBool::new(false) })
        })
    };
    let mut parts: Vec<Part<'a>> = prepared.par_iter().flat_map_iter(of_view).collect();
    parts.sort_by(|one, other| other.seen.nearness.total_cmp(&one.seen.nearness));
    parts
}

/// Draws what a tile of the screen shows; returns the number of splats that were projected.
fn draw_tile(screen: &mut Screen, parts: &[Part<'_>], projector: &Projector, limits: &Limits) -> u64 {
    let (mut lanes, mut projected) = (Lanes::new(), 0);
    for part in parts {
        let rect = part.seen.rect.overlap(&screen.rect);
        if rect.is_empty() || screen.hides(&rect, part.seen.nearness) {
            continue;
        }
        part.is_drawn.store(true, Ordering::Relaxed);
        let (view, splats) = (part.view, part.view.splats);
        let [from, to] = part.contents.blocks.map(|block| block as usize);
        for block in &splats.blocks[from..to] {
            if rect != part.seen.rect && !reaches(&view.sight, &block.extent, &screen.rect) {
                continue;
            }
            let [column, row] = block.corner.map(f64::from);
            let start = view.sight.at([column + 0.5, row + 0.5, -0.5]);
            let count = lanes.gather(splats, block);
            lanes.project(count, start.map(|value| value as f32), &view.constants, &screen.rect);
            if !limits.is_none() {
                lanes.limit(count, splats, block, projector, limits);
            }
            screen.draw(&lanes, count, view.first + block.first);
            projected += count as u64;
        }
    }
    projected
}

fn reaches(sight: &Sight, extent: &Extent, rect: &Rect) -> bool {
    sight.seen(extent, rect).is_some_and(|seen| !seen.rect.is_empty())
}
