//! A picture of views as numbers for a shader that draws it, and the frame of what it found.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec4};
use rayon::prelude::*;

use super::draw::{Part, parts_of};
use super::lanes::Constants;
use super::picture::{Counts, Picture, Prepared};
use super::projector::{Projector, Rect, Seen, ordered};
use super::resolve::Resolver;
use super::screen::{Key, OTHER};
use super::splats::{BORDER, LEAST_COSINE, SQUARED_RADIUS, Splats};
use crate::base::{Error, Result};
use crate::camera::Camera;
use crate::render::{Frame, Sample};

/// Blocks of a piece, at most.
const PIECE: u32 = 16;

/// Samples that a thread of a shader looks at for one piece, at most: drivers in software end a thread's loops after 65,535
/// turns.
const TURNS: f64 = 49_152.0;

/// Width and height of the tiles in which splats are drawn that may cover more.
const TILE: i32 = 128;

/// Bits of a splat's place in its block.
pub const LANE_BITS: u32 = 6;

/// A view before a camera, as a shader reads it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct ViewNumbers {
    /// Changes of the projector's functions by a column, a row and a depth step.
    pub steps: [[f32; 4]; 3],
    /// The projector's gradients, times the radius of a ball over that of an ellipse.
    pub gradients: [[f32; 4]; 3],
    /// The axes of the view; those to the right and upwards in depth steps for each pixel.
    pub axes: [[f32; 4]; 3],
    /// Scale of a normal's numbers to −1 … 1, and the least distance of what is shown.
    pub rest: [f32; 4],
    /// Number of its first block among those of all views, and three numbers of where its words lie on an adapter.
    pub place: [u32; 4],
}

/// Some blocks of a view, which are drawn or left out together.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct Piece {
    /// The projector's functions at the middle of the pixel `corner`, half a step before the front.
    pub start: [f32; 3],
    /// The nearest point's nearness, as `order` of keys.
    pub order: u32,
    /// First column and row of the part of the picture in which it is drawn.
    pub low: [i32; 2],
    /// Those after the last.
    pub high: [i32; 2],
    /// Column and row of a pixel of the view.
    pub corner: [u32; 2],
    /// Number of the view.
    pub view: u32,
    /// Its first block, and from bit 24 on how many there are; bit 31 is the shader's.
    pub blocks: u32,
    /// Number of its splats; where it is drawn in several parts, its share.
    pub count: u32,
    /// Fills the record.
    pub unused: [u32; 3],
}

/// Rays of the samples: of the ray through the picture's corner, and changes by a sample to the right and down.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct Rays {
    /// Where it starts, relative to the camera.
    pub start: [[f32; 4]; 3],
    /// Its direction, as long as the projector's W is 1.
    pub direction: [[f32; 4]; 3],
}

impl Rays {
    fn new(camera: &Camera) -> Self {
        let [corner, right, down] = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(|(x, y)| camera.ray(x, y));
        let single = |value: DVec3| value.as_vec3().extend(0.0).to_array();
        Self {
            start: [corner.0, right.0 - corner.0, down.0 - corner.0].map(single),
            direction: [corner.1, right.1 - corner.1, down.1 - corner.1].map(single),
        }
    }
}

/// A picture of views, ready to be drawn by a shader.
pub struct Plan<'a> {
    picture: &'a Picture<'a>,
    /// The camera of the samples.
    camera: Camera,
    projector: Projector,
    prepared: Vec<Prepared<'a>>,
    /// Number of splats of boxes that reach into the picture.
    in_picture: u64,
    /// For each view, what a shader knows of it.
    pub views: Vec<ViewNumbers>,
    /// Nearest first.
    pub pieces: Vec<Piece>,
    /// Rays of the samples.
    pub rays: Rays,
}

/// The images that a shader found, in rows.
#[derive(Clone, Copy, Debug, Default)]
pub struct Found<'a> {
    /// Sum of the samples' colours over their number, and share of those that show a splat.
    pub colors: &'a [[f32; 4]],
    /// Bits of the samples that show what was there before, row by row.
    pub others: &'a [[u32; 2]],
    /// Keys of the pixels' middles: complement of a block's number among all views' and a place in it, and the order.
    pub middles: &'a [[u32; 2]],
}

impl<'a> Plan<'a> {
    /// The plan of a picture.
    pub fn new(views: &[&'a Splats], picture: &'a Picture<'a>) -> Result<Self> {
        picture.check(views)?;
        let camera = picture.sampled();
        let projector = Projector::new(&camera);
        let prepared = Prepared::all(views, &projector);
        let blocks: u64 = views.iter().map(|view| view.blocks.len() as u64).sum();
        if blocks >= u64::from(u32::MAX >> LANE_BITS) {
            return Err(Error::value("views", format!("fewer than {} blocks", u32::MAX >> LANE_BITS), blocks));
        }
        let mut first = 0;
        let numbers = |view: &Prepared<'_>| {
            let own = view.constants.numbers(first);
            first += view.splats.blocks.len() as u32;
            own
        };
        let numbers = prepared.iter().map(numbers).collect();
        let whole = Rect { low: [0, 0], high: [camera.width as i32, camera.height as i32] };
        let mut plan = Self {
            picture,
            rays: Rays::new(&camera),
            camera,
            projector,
            views: numbers,
            pieces: vec![],
            in_picture: 0,
            prepared,
        };
        let parts = parts_of(&plan.prepared, &whole);
        plan.pieces = parts.iter().flat_map(|part| plan.pieces_of(part)).collect();
        plan.in_picture = parts.iter().map(|part| u64::from(part.contents.count)).sum();
        Ok(plan)
    }

    fn pieces_of(&self, part: &Part<'_>) -> Vec<Piece> {
        let [first, after] = part.contents.blocks;
        let most = self.most_samples(part);
        if most > TURNS {
            return (first..after).flat_map(|block| self.tiled(part.number, block)).collect();
        }
        let count = ((TURNS / most) as u32).clamp(1, PIECE);
        let starts = (first..after).step_by(count as usize);
        starts.map(|block| self.piece(part.number, block..(block + count).min(after), &part.seen)).collect()
    }

    /// The pieces of a block whose splats may cover much: one for each tile of the part of the picture that shows it.
    fn tiled(&self, number: u32, block: u32) -> Vec<Piece> {
        let view = &self.prepared[number as usize];
        let whole = Rect { low: [0, 0], high: self.size().map(|length| length as i32) };
        let Some(seen) = view.sight.seen(&view.splats.blocks[block as usize].extent, &whole) else { return vec![] };
        let (tiles, one) = (tiles_of(&seen.rect), self.piece(number, block..block + 1, &seen));
        let share = |n: usize| (u64::from(one.count) * n as u64 / tiles.len() as u64) as u32;
        let piece =
            |(n, tile): (usize, &Rect)| Piece { low: tile.low, high: tile.high, count: share(n + 1) - share(n), ..one };
        tiles.iter().enumerate().map(piece).collect()
    }

    /// Some blocks of a view.
    fn piece(&self, number: u32, blocks: Range<u32>, seen: &Seen) -> Piece {
        let view = &self.prepared[number as usize];
        let own = &view.splats.blocks[blocks.start as usize..blocks.end as usize];
        let corner = own.first().map(|block| block.corner).unwrap_or_default();
        let [column, row] = corner.map(f64::from);
        Piece {
            start: view.sight.at([column + 0.5, row + 0.5, -0.5]).map(|value| value as f32),
            order: ordered(seen.nearness),
            low: seen.rect.low,
            high: seen.rect.high,
            corner: corner.map(u32::from),
            view: number,
            blocks: blocks.start | (own.len() as u32) << 24,
            count: own.iter().map(|block| block.shown.count_ones()).sum(),
            unused: [0; 3],
        }
    }

    /// Samples of the rectangle around a splat of a part, at most.
    fn most_samples(&self, part: &Part<'_>) -> f64 {
        let Seen { rect, nearness } = part.seen;
        let whole = [0, 1].map(|axis| f64::from(rect.high[axis] - rect.low[axis]));
        if !nearness.is_finite() {
            return whole[0] * whole[1];
        }
        // The ellipse's axes u and v have |u|² + |v|² ≤ (x² + y²)/c² for a pixel of x × y metres and the least cosine c.
        let radius = f64::from(BORDER * SQUARED_RADIUS.sqrt() / LEAST_COSINE);
        let reach = radius * self.prepared[part.number as usize].splats.pitch().truncate().length();
        let [x, y, w] = self.projector.rows.map(DVec3::length);
        let extent = |axis: usize, own: f64| {
            // The gradient of X/W is (∇X − X/W ∇W)/W.
            let farthest = f64::from(rect.high[axis].abs().max(rect.low[axis].abs()));
            let slope = if self.is_parallel() { own } else { (own + farthest * w) * f64::from(nearness) };
            (2.0 * reach * slope + 2.0).min(whole[axis])
        };
        extent(0, x) * extent(1, y)
    }

    /// Whether its rays are parallel.
    pub fn is_parallel(&self) -> bool {
        self.projector.is_parallel
    }

    /// Width and height of the samples.
    pub fn size(&self) -> [u32; 2] {
        [self.camera.width, self.camera.height]
    }

    /// The picture.
    pub fn picture(&self) -> &Picture<'a> {
        self.picture
    }

    /// Half-spaces that are seen, relative to the camera.
    pub fn planes(&self) -> Vec<[f32; 4]> {
        let relative = self.picture.limits.relative_to(self.camera.position);
        let single = |plane: &glam::DVec4| Vec4::new(plane.x as f32, plane.y as f32, plane.z as f32, plane.w as f32);
        relative.planes().iter().map(|plane| single(plane).to_array()).collect()
    }

    /// The keys of all samples before a splat is drawn: what was there before. `None` if there was nothing.
    pub fn before(&self) -> Option<Vec<[u32; 2]>> {
        self.picture.before?;
        let resolver = self.resolver();
        let [width, height] = self.size();
        let row = |y: u32| (0..width).map(move |x| (x, y));
        let key = |(x, y): (u32, u32)| resolver.before(x as i32, y as i32).halves();
        Some((0..height).into_par_iter().flat_map_iter(row).map(key).collect())
    }

    /// The frame of what a shader found in all rows.
    pub fn frame(&self, found: &Found<'_>) -> Result<Frame> {
        let (picture, wanted) = (self.picture, self.picture.channels);
        let resolver = self.resolver();
        let columns = picture.camera.width as usize;
        let row = |y: usize| {
            let mut part = Frame::default();
            for x in 0..columns {
                let pixel = y * columns + x;
                if picture.pixels.mask.is_some_and(|mask| !mask[pixel]) {
                    part.push(wanted, [0.0; 3], 0.0, &Sample::default());
                    continue;
                }
                let [red, green, blue, coverage] = found.colors.get(pixel).copied().unwrap_or_default();
                let mut color = [red, green, blue];
                if let Some(&[low, high]) = found.others.get(pixel) {
                    resolver.add_before(&mut color, [x, y], u64::from(high) << 32 | u64::from(low));
                }
                let sample = found.middles.get(pixel).map(|&halves| {
                    let half = picture.grid as usize / 2;
                    let at = [x, y].map(|at| (at * picture.grid as usize + half) as i32);
                    resolver.sample(self.key(halves), (at[0], at[1]))
                });
                part.push(wanted, color, coverage, &sample.unwrap_or_default());
            }
            part
        };
        let rows: Vec<Frame> = (0..picture.camera.height as usize).into_par_iter().map(row).collect();
        let mut frame = Frame::new(wanted, picture.pixel_count())?;
        rows.iter().enumerate().for_each(|(y, part)| frame.put(part, columns, [0, y], columns));
        Ok(frame)
    }

    /// Counts of the picture; a shader tells how many splats it drew.
    pub fn counts(&self, seen: u64) -> Counts {
        let total = self.prepared.iter().map(|view| view.splats.count() as u64).sum();
        Counts { total, in_picture: self.in_picture, seen, projected: seen }
    }

    fn resolver(&self) -> Resolver<'_> {
        Resolver::new(self.picture, &self.camera, &self.projector, &self.prepared)
    }

    /// A shader's key with the number of a splat instead of that of a block and a place in it.
    fn key(&self, [number, order]: [u32; 2]) -> Key {
        let place = !number;
        if place == OTHER {
            return Key::from_halves([number, order]);
        }
        let (block, lane) = (place >> LANE_BITS, place & ((1 << LANE_BITS) - 1));
        let view = self.views.partition_point(|view| view.place[0] <= block) - 1;
        let (prepared, own) = (&self.prepared[view], block - self.views[view].place[0]);
        let block = &prepared.splats.blocks[own as usize];
        let rank = (block.shown & ((1u64 << lane) - 1)).count_ones();
        Key::from_halves([!(prepared.first + block.first + rank), order])
    }
}

/// A rectangle in parts.
fn tiles_of(rect: &Rect) -> Vec<Rect> {
    let starts = |axis: usize| (rect.low[axis]..rect.high[axis]).step_by(TILE as usize);
    let tile = |x: i32, y: i32| Rect { low: [x, y], high: [x + TILE, y + TILE] }.overlap(rect);
    starts(1).flat_map(|y| starts(0).map(move |x| tile(x, y))).collect()
}

impl Constants {
    /// The same as a shader reads it.
    fn numbers(&self, first: u32) -> ViewNumbers {
        let rows = |rows: &[[f32; 3]; 3]| rows.map(|[x, y, z]| [x, y, z, 0.0]);
        ViewNumbers {
            steps: rows(&self.steps),
            gradients: rows(&self.gradients),
            axes: rows(&self.axes),
            rest: [self.scale, self.least_distance, 0.0, 0.0],
            place: [first, 0, 0, 0],
        }
    }
}
