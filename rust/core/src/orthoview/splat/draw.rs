//! Drawing of views: culls their boxes and draws them tile by tile.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use rayon::prelude::*;

use super::lanes::Lanes;
use super::picture::{Counts, Picture, Prepared};
use super::projector::{Projector, Rect, Seen, Sight};
use super::resolve::Resolver;
use super::screen::Screen;
use super::splats::{BoxOfBlocks, Extent, Splats};
use crate::base::{Progress, Result};
use crate::render::{Frame, Limits};

/// Maximum width and height of a screen tile, samples. Its keys take 512 kB, which fit in the second-level cache;
/// smaller tiles project more splats several times.
const TILE: i32 = 256;

/// Maximum width and height of a tile, pixels, so that several threads share a small picture, too.
const MAX_PIXELS: i32 = 128;

/// A box of a view in the picture.
pub(super) struct Part<'a> {
    view: &'a Prepared<'a>,
    /// Number of the view.
    pub number: u32,
    pub contents: &'a BoxOfBlocks,
    pub seen: Seen,
    is_drawn: AtomicBool,
}

/// Draws views; samples without a splat show `before` or the sky.
pub fn draw(views: &[&Splats], picture: &Picture<'_>, progress: &Progress) -> Result<(Frame, Counts)> {
    picture.check(views)?;
    let sampled = picture.sampled();
    let projector = Projector::new(&sampled);
    let whole = Rect { low: [0, 0], high: [sampled.width as i32, sampled.height as i32] };
    let prepared = Prepared::prepare_views(views, &projector);
    let parts = parts_of(&prepared, &whole);
    let projected = AtomicU64::new(0);
    let resolver = Resolver::new(picture, &sampled, &projector, &prepared);
    let mut frame = Frame::new(picture.channels, picture.pixel_count())?;
    let (columns, rows) = (picture.camera.width as i32, picture.camera.height as i32);
    let tiles = tiles_of(columns, rows, (TILE / picture.grid as i32).min(MAX_PIXELS));
    progress.expect(tiles.len() as u64);
    let one = |tile: &Rect| {
        let scaled = |corner: [i32; 2]| corner.map(|at| at * picture.grid as i32);
        let rect = Rect { low: scaled(tile.low), high: scaled(tile.high) };
        let mut screen = Screen::new(rect, |x, y| resolver.initial_key(x, y));
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
        total: views.iter().map(|splats| splats.count() as u64).sum(),
        in_picture: count(&|_| true),
        seen: count(&|part| part.is_drawn.load(Ordering::Relaxed)),
        projected: projected.into_inner(),
    };
    Ok((frame, counts))
}

/// Divides a picture into tiles of at most `side` pixels along each axis.
fn tiles_of(columns: i32, rows: i32, side: i32) -> Vec<Rect> {
    let corners =
        (0..rows).step_by(side as usize).flat_map(|y| (0..columns).step_by(side as usize).map(move |x| (x, y)));
    corners.map(|(x, y)| Rect { low: [x, y], high: [(x + side).min(columns), (y + side).min(rows)] }).collect()
}

/// Returns the boxes of all views that may be visible, the nearest first.
pub(super) fn parts_of<'a>(prepared: &'a [Prepared<'a>], whole: &Rect) -> Vec<Part<'a>> {
    let of_view = |(number, view): (usize, &'a Prepared<'a>)| {
        let number = number as u32;
        view.splats.boxes.iter().filter_map(move |contents| {
            let seen = view.sight.project_extent(&contents.extent, whole)?;
            (!seen.rect.is_empty()).then_some(Part { view, number, contents, seen, is_drawn: AtomicBool::new(false) })
        })
    };
    let mut parts: Vec<Part<'a>> = prepared.par_iter().enumerate().flat_map_iter(of_view).collect();
    parts.sort_by(|one, other| other.seen.nearness.total_cmp(&one.seen.nearness));
    parts
}

/// Draws a screen tile; returns the number of projected splats.
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
            let start = view.sight.evaluate([column + 0.5, row + 0.5, -0.5]);
            let count = lanes.gather(splats, block);
            lanes.project(count, start.map(|value| value as f32), &view.constants, &screen.rect, screen.pitch());
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
    sight.project_extent(extent, rect).is_some_and(|seen| !seen.rect.is_empty())
}
