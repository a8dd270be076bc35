//! Shader input for a picture of views, and the frame from the shader's results.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec4};
use rayon::prelude::*;

use super::draw::{Part, parts_of};
use super::lanes::Constants;
use super::picture::{Counts, Picture, PreparedPicture, PreparedView};
use super::projector::{Rect, ScreenBounds, sortable_bits};
use super::resolve::Resolver;
use super::screen::{BEFORE, Key};
use super::splats::{BORDER, MIN_COSINE, SQUARED_RADIUS, Splats};
use crate::base::memory::{try_append, try_vec};
use crate::base::{Result, ensure};
use crate::camera::Camera;
use crate::render::{Frame, Sample};

/// Maximum number of blocks per piece.
const PIECE: u32 = 16;

/// Maximum samples that a shader thread visits per piece: software drivers end a thread's loops after 65,535 steps.
const MAX_SAMPLES: f64 = 49_152.0;

/// Width and height of the tiles in which large splats are drawn.
const TILE: i32 = 128;

/// Bits of a splat's position in its block.
pub const LANE_BITS: u32 = 6;

/// A view relative to a camera, in the shader's layout.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct ViewUniforms {
    /// Changes of (X, Y, W), the homogeneous screen position of `Projector`, per column, row and depth step.
    pub steps: [[f32; 4]; 3],
    /// Gradients of X, Y, W by world position, scaled by (radius of a ball) / (radius of a surfel's ellipse).
    pub gradients: [[f32; 4]; 3],
    /// Axes of the view; right and up in depth steps per pixel.
    pub axes: [[f32; 4]; 3],
    /// Scale of a normal's components to −1 … 1, and the minimum visible distance.
    pub rest: [f32; 4],
    /// Number of its first block among those of all views. The GPU crate fills in the others: the buffer of the view's
    /// packed splats, and the first words of their headers and bits there.
    pub place: [u32; 4],
}

/// Some blocks of a view, drawn or culled together.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct Piece {
    /// (X, Y, W) at the centre of the pixel `corner`, half a depth step in front of depth 0.
    pub start: [f32; 3],
    /// 1/W of the nearest point (−W for parallel rays) as a sortable integer, as in `Key`.
    pub nearness_bits: u32,
    /// First column and row of the image rectangle in which it is drawn.
    pub low: [i32; 2],
    /// End column and row of this rectangle.
    pub high: [i32; 2],
    /// Column and row in the view of the first block's first pixel.
    pub corner: [u32; 2],
    /// Number of the view.
    pub view: u32,
    /// First block, and from bit 24 on the number of blocks; bit 31 belongs to the shader.
    pub blocks: u32,
    /// Number of its splats. If a block has several pieces, each has its share.
    pub count: u32,
    /// Padding.
    pub unused: [u32; 3],
}

/// Rays of the samples: the ray through the picture's corner, and its changes per sample to the right and down.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct Rays {
    /// Start, relative to the camera.
    pub start: [[f32; 4]; 3],
    /// Direction, scaled so that the projector's W is 1.
    pub direction: [[f32; 4]; 3],
}

impl Rays {
    fn new(camera: &Camera) -> Self {
        let rays = camera.rays();
        let rows = |corner: DVec3, [right, down]: [DVec3; 2]| {
            [corner, right, down].map(|value| value.as_vec3().extend(0.0).to_array())
        };
        Self { start: rows(rays.start, rays.start_steps), direction: rows(rays.direction, rays.direction_steps) }
    }
}

/// A picture of views, ready to be drawn by a shader.
pub struct Plan<'a> {
    prepared: PreparedPicture<'a>,
    /// Number of splats of those parts of the views whose bounding boxes intersect the picture.
    in_picture: u64,
    /// Shader input for each view.
    pub views: Vec<ViewUniforms>,
    /// Pieces, the nearest first.
    pub pieces: Vec<Piece>,
    /// Rays of the samples.
    pub rays: Rays,
}

/// Images from a shader, in rows.
#[derive(Clone, Copy, Debug, Default)]
pub struct Found<'a> {
    /// Mean colour of the samples, and fraction of those that show a splat.
    pub colors: &'a [[f32; 4]],
    /// For each pixel, a bit mask of its samples, row by row, at which `Picture::before`, drawn earlier, is in front.
    pub before_masks: &'a [[u32; 2]],
    /// For each pixel, the key of its centre: `!(block << LANE_BITS | position in the block)`, with the block's number
    /// among all views, and the nearness as a sortable integer. The greatest key wins, so splats are complemented.
    pub center_keys: &'a [[u32; 2]],
}

impl<'a> Plan<'a> {
    /// Creates the plan of a picture.
    pub fn new(views: &[&'a Splats], picture: &'a Picture<'a>) -> Result<Self> {
        let prepared = PreparedPicture::new(views, picture)?;
        let blocks: u64 = views.iter().map(|view| view.blocks.len() as u64).sum();
        let limit = u32::MAX >> LANE_BITS;
        ensure!(blocks < u64::from(limit), "views", format!("fewer than {limit} blocks"), blocks);
        let mut first = 0;
        let uniforms = |view: &PreparedView<'_>| {
            let uniforms = view.constants.uniforms(first);
            first += view.splats.blocks.len() as u32;
            uniforms
        };
        let (views, rays) = (prepared.views.iter().map(uniforms).collect(), Rays::new(&prepared.camera));
        let mut plan = Self { prepared, in_picture: 0, views, pieces: vec![], rays };
        let parts = parts_of(&plan.prepared)?;
        let mut pieces = vec![];
        parts.iter().try_for_each(|part| try_append(&mut pieces, &plan.pieces_of(part)))?;
        plan.pieces = pieces;
        plan.in_picture = parts.iter().map(|part| u64::from(part.contents.count)).sum();
        Ok(plan)
    }

    /// Divides a part into pieces.
    fn pieces_of(&self, part: &Part<'_>) -> Vec<Piece> {
        let [first, end] = part.contents.blocks;
        let samples = self.max_samples(part);
        if samples > MAX_SAMPLES {
            return (first..end).flat_map(|block| self.tiled_pieces(part.view_index, block)).collect();
        }
        let count = ((MAX_SAMPLES / samples) as u32).clamp(1, PIECE);
        let starts = (first..end).step_by(count as usize);
        starts.map(|block| self.piece(part.view_index, block..(block + count).min(end), &part.bounds)).collect()
    }

    /// Returns the pieces of a block with large splats: one for each tile of its part of the picture.
    fn tiled_pieces(&self, view_index: u32, block: u32) -> Vec<Piece> {
        let view = &self.prepared.views[view_index as usize];
        let picture = Rect::of_camera(&self.prepared.camera);
        let Some(bounds) = view.projection.project_extent(&view.splats.blocks[block as usize].extent, &picture) else {
            return vec![];
        };
        let (tiles, undivided) = (bounds.rect.tiles(TILE), self.piece(view_index, block..block + 1, &bounds));
        let count_before = |n: usize| (u64::from(undivided.count) * n as u64 / tiles.len() as u64) as u32;
        let piece = |(n, &Rect { low, high }): (usize, &Rect)| {
            let count = count_before(n + 1) - count_before(n);
            Piece { low, high, count, ..undivided }
        };
        tiles.iter().enumerate().map(piece).collect()
    }

    /// Creates a piece of some blocks of a view.
    fn piece(&self, view_index: u32, blocks: Range<u32>, bounds: &ScreenBounds) -> Piece {
        let view = &self.prepared.views[view_index as usize];
        let contents = &view.splats.blocks[blocks.start as usize..blocks.end as usize];
        let corner = contents.first().map(|block| block.corner).unwrap_or_default();
        let [column, row] = corner.map(f64::from);
        Piece {
            start: view.projection.evaluate([column + 0.5, row + 0.5, -0.5]).map(|value| value as f32),
            nearness_bits: sortable_bits(bounds.nearness),
            low: bounds.rect.low,
            high: bounds.rect.high,
            corner: corner.map(u32::from),
            view: view_index,
            blocks: blocks.start | (contents.len() as u32) << 24,
            count: contents.iter().map(|block| block.shown.count_ones()).sum(),
            unused: [0; 3],
        }
    }

    /// Returns the maximum number of samples in the bounding rectangle of a splat of a part.
    fn max_samples(&self, part: &Part<'_>) -> f64 {
        let ScreenBounds { rect, nearness } = part.bounds;
        let size = [0, 1].map(|axis| f64::from(rect.high[axis] - rect.low[axis]));
        if !nearness.is_finite() {
            return size[0] * size[1];
        }
        // The ellipse's axes u, v have |u|² + |v|² ≤ (x² + y²)/c² for a pixel of x × y metres and the minimum cosine c.
        let radius = f64::from(BORDER * SQUARED_RADIUS.sqrt() / MIN_COSINE);
        let reach = radius * self.prepared.views[part.view_index as usize].splats.pitch().truncate().length();
        let [x, y, w] = self.prepared.projector.rows.map(DVec3::length);
        let extent = |axis: usize, gradient: f64| {
            // The gradient of X/W is (∇X − X/W ∇W)/W.
            let farthest = f64::from(rect.high[axis].abs().max(rect.low[axis].abs()));
            let slope = if self.is_parallel() { gradient } else { (gradient + farthest * w) * f64::from(nearness) };
            (2.0 * reach * slope + 2.0).min(size[axis])
        };
        extent(0, x) * extent(1, y)
    }

    /// Returns whether its rays are parallel.
    pub fn is_parallel(&self) -> bool {
        self.prepared.projector.is_parallel
    }

    /// Returns the width and height of the samples.
    pub fn size(&self) -> [u32; 2] {
        [self.prepared.camera.width, self.prepared.camera.height]
    }

    /// Returns the picture.
    pub fn picture(&self) -> &Picture<'a> {
        self.prepared.picture
    }

    /// Returns the clip half-spaces, relative to the camera.
    pub fn planes(&self) -> Vec<[f32; 4]> {
        let relative = self.picture().limits.relative_to(self.prepared.camera.position);
        let single = |plane: &glam::DVec4| Vec4::new(plane.x as f32, plane.y as f32, plane.z as f32, plane.w as f32);
        relative.planes().iter().map(|plane| single(plane).to_array()).collect()
    }

    /// Returns the initial keys of all samples, from the picture's `before`; `None` without one.
    pub fn initial_keys(&self) -> Result<Option<Vec<[u32; 2]>>> {
        if self.picture().before.is_none() {
            return Ok(None);
        }
        let resolver = Resolver::new(&self.prepared);
        let [width, height] = self.size();
        let mut keys = try_vec([0; 2], width as usize * height as usize)?;
        keys.par_chunks_mut(width.max(1) as usize).enumerate().for_each(|(y, row)| {
            row.iter_mut().enumerate().for_each(|(x, key)| *key = resolver.initial_key(x as i32, y as i32).halves());
        });
        Ok(Some(keys))
    }

    /// Returns the frame that a shader's images give.
    pub fn frame(&self, found: &Found<'_>) -> Result<Frame> {
        let (picture, channels) = (self.picture(), self.picture().channels);
        let resolver = Resolver::new(&self.prepared);
        // The rows exist twice for a moment, in `rows` and in `frame`: check that this fits into memory.
        channels.check_room(picture.pixel_count() as u64)?;
        let columns = picture.camera.width as usize;
        let row = |y: usize| {
            let mut part = Frame::default();
            for x in 0..columns {
                let pixel = y * columns + x;
                if picture.pixels.mask.is_some_and(|mask| !mask[pixel]) {
                    part.push(channels, [0.0; 3], 0.0, &Sample::default());
                    continue;
                }
                let [red, green, blue, coverage] = found.colors.get(pixel).copied().unwrap_or_default();
                let mut color = [red, green, blue];
                if let Some(&[low, high]) = found.before_masks.get(pixel) {
                    resolver.add_before(&mut color, [x, y], u64::from(high) << 32 | u64::from(low));
                }
                let sample = found.center_keys.get(pixel).map(|&halves| {
                    let middle = |pixel: usize| (pixel * picture.grid as usize + picture.grid as usize / 2) as i32;
                    resolver.sample(self.key(halves), (middle(x), middle(y)))
                });
                part.push(channels, color, coverage, &sample.unwrap_or_default());
            }
            part
        };
        let rows: Vec<Frame> = (0..picture.camera.height as usize).into_par_iter().map(row).collect();
        let mut frame = Frame::new(channels, picture.pixel_count())?;
        rows.iter().enumerate().for_each(|(y, part)| frame.put(part, columns, [0, y], columns));
        Ok(frame)
    }

    /// Returns the counts of the picture; the shader reports the number of drawn splats.
    pub fn counts(&self, seen: u64) -> Counts {
        let total = self.prepared.splat_count();
        Counts { total, in_picture: self.in_picture, seen, projected: seen }
    }

    /// Converts a shader's key, which has a block and a position in it, to one with the number of a splat.
    fn key(&self, [complement, nearness_bits]: [u32; 2]) -> Key {
        let place = !complement;
        if place == BEFORE {
            return Key::from_halves([complement, nearness_bits]);
        }
        let (block, lane) = (place >> LANE_BITS, place & ((1 << LANE_BITS) - 1));
        let view = self.views.partition_point(|view| view.place[0] <= block) - 1;
        let (prepared, block_index) = (&self.prepared.views[view], block - self.views[view].place[0]);
        let block = &prepared.splats.blocks[block_index as usize];
        let rank = (block.shown & ((1u64 << lane) - 1)).count_ones();
        Key::from_halves([!(prepared.first + block.first + rank), nearness_bits])
    }
}

impl Constants {
    /// Returns the view in the shader's layout.
    fn uniforms(&self, first: u32) -> ViewUniforms {
        let rows = |rows: &[[f32; 3]; 3]| rows.map(|[x, y, z]| [x, y, z, 0.0]);
        ViewUniforms {
            steps: rows(&self.steps),
            gradients: rows(&self.gradients),
            axes: rows(&self.axes),
            rest: [self.scale, self.min_w, 0.0, 0.0],
            place: [first, 0, 0, 0],
        }
    }
}
