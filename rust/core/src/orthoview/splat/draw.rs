//! Drawing of views tile by tile, with culling of their boxes.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use rayon::prelude::*;

use super::lanes::Lanes;
use super::picture::{Counts, Picture, PreparedPicture, PreparedView};
use super::projector::{Projector, Rect, ScreenBounds, ViewProjection};
use super::resolve::Resolver;
use super::screen::{Screen, draw_splats};
use super::splats::{BoxOfBlocks, Extent, Splats};
use crate::base::memory::room_for_values;
use crate::base::{Progress, Result};
use crate::render::{Frame, Limits};

/// Maximum width and height of a screen tile, samples. Its keys take 512 kB, which fit in the second-level cache;
/// smaller tiles project more splats several times.
const TILE: i32 = 256;

/// Maximum width and height of a tile, pixels, so that several threads share even a small picture.
const MAX_PIXELS: i32 = 128;

/// A part of a view, culled together: some blocks whose bounding box intersects the picture.
pub(super) struct Part<'a> {
    view: &'a PreparedView<'a>,
    /// Index of the view in the picture.
    pub view_index: u32,
    pub contents: &'a BoxOfBlocks,
    pub bounds: ScreenBounds,
    is_drawn: AtomicBool,
}

/// Draws views. Samples without a splat show `picture.before`, which has all other surfaces, or the sky.
pub fn draw(views: &[&Splats], picture: &Picture<'_>, progress: &Progress) -> Result<(Frame, Counts)> {
    let prepared = PreparedPicture::new(views, picture)?;
    let parts = parts_of(&prepared)?;
    let projected = AtomicU64::new(0);
    let resolver = Resolver::new(&prepared);
    let mut frame = Frame::new(picture.channels, picture.pixel_count())?;
    // The images exist twice for a moment, by tile and in `frame`: check that this fits into memory.
    picture.channels.check_room(picture.pixel_count() as u64)?;
    let tiles = Rect::of_camera(picture.camera).tiles((TILE / picture.grid as i32).min(MAX_PIXELS));
    progress.expect(tiles.len() as u64);
    let images_of_tile = |tile: &Rect| {
        let samples = |corner: [i32; 2]| corner.map(|pixel| pixel * picture.grid as i32);
        let rect = Rect { low: samples(tile.low), high: samples(tile.high) };
        let mut screen = Screen::new(rect, |x, y| resolver.initial_key(x, y));
        projected.fetch_add(draw_tile(&mut screen, &parts, &prepared.projector, &picture.limits), Ordering::Relaxed);
        progress.report(1)?;
        Ok((*tile, resolver.resolve(&screen, tile)))
    };
    for (Rect { low, high }, part) in tiles.par_iter().map(images_of_tile).collect::<Result<Vec<_>>>()? {
        let corner = low.map(|pixel| pixel as usize);
        frame.put(&part, picture.camera.width as usize, corner, (high[0] - low[0]) as usize);
    }
    let count = |is_counted: &dyn Fn(&Part<'_>) -> bool| {
        parts.iter().filter(|part| is_counted(part)).map(|part| u64::from(part.contents.count)).sum()
    };
    let counts = Counts {
        total: prepared.splat_count(),
        in_picture: count(&|_| true),
        seen: count(&|part| part.is_drawn.load(Ordering::Relaxed)),
        projected: projected.into_inner(),
    };
    Ok((frame, counts))
}

/// Returns the boxes of all views that may be visible, the nearest first.
pub(super) fn parts_of<'a>(prepared: &'a PreparedPicture<'a>) -> Result<Vec<Part<'a>>> {
    // The threads' lists, and the list of all parts.
    room_for_values::<[Part<'a>; 2]>(prepared.views.iter().map(|view| view.splats.boxes.len()).sum())?;
    let picture = &Rect::of_camera(&prepared.camera);
    let parts_of_view = |(number, view): (usize, &'a PreparedView<'a>)| {
        view.splats.boxes.iter().filter_map(move |contents| {
            let bounds = view.projection.project_extent(&contents.extent, picture)?;
            let part = Part { view, view_index: number as u32, contents, bounds, is_drawn: AtomicBool::new(false) };
            (!part.bounds.rect.is_empty()).then_some(part)
        })
    };
    let mut parts: Vec<Part<'a>> = prepared.views.par_iter().enumerate().flat_map_iter(parts_of_view).collect();
    parts.sort_by(|a, b| b.bounds.nearness.total_cmp(&a.bounds.nearness));
    Ok(parts)
}

/// Draws a screen tile; returns the number of projected splats.
fn draw_tile(screen: &mut Screen, parts: &[Part<'_>], projector: &Projector, limits: &Limits) -> u64 {
    let (mut lanes, mut projected) = (Lanes::default(), 0);
    for part in parts {
        let rect = part.bounds.rect.overlap(&screen.rect);
        if rect.is_empty() || screen.hides(&rect, part.bounds.nearness) {
            continue;
        }
        part.is_drawn.store(true, Ordering::Relaxed);
        let (view, splats) = (part.view, part.view.splats);
        let [first, end] = part.contents.blocks.map(|block| block as usize);
        for block in &splats.blocks[first..end] {
            if rect != part.bounds.rect && !overlaps(&view.projection, &block.extent, &screen.rect) {
                continue;
            }
            let [column, row] = block.corner.map(f64::from);
            let start = view.projection.evaluate([column + 0.5, row + 0.5, -0.5]);
            let count = lanes.gather(splats, block);
            lanes.project(count, start.map(|value| value as f32), &view.constants, &screen.rect, screen.pitch());
            if !limits.is_none() {
                lanes.hide_outside(count, splats, block, projector, limits);
            }
            draw_splats(screen, &lanes, count, view.first + block.first);
            projected += count as u64;
        }
    }
    projected
}

fn overlaps(projection: &ViewProjection, extent: &Extent, rect: &Rect) -> bool {
    projection.project_extent(extent, rect).is_some_and(|bounds| !bounds.rect.is_empty())
}
