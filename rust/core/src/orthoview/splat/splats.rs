//! A view's pixels as splats, in blocks of 8 × 8 pixels. Splats can be clipped to a box, in place of a smaller cell
//! whose own views are missing, or to the outside of a cylinder.

use glam::{DVec3, Vec3};

use crate::base::mapped::set_bits;
use crate::base::{Error, Result, ensure};
use crate::orthoview::cell::Cell;
use crate::orthoview::connect::{is_surfel, neighbours};
use crate::orthoview::direction::{Direction, Frame};
use crate::orthoview::normals;
use crate::orthoview::view::{Format, Texel, Views};

/// Side of a block, pixels.
pub(super) const BLOCK: usize = 8;

/// Boxes along each axis of a view. A box is the unit of culling.
const BOXES: usize = 4;

/// Squared radius of a surfel's ellipse in pixels of its view: the corners of the pixel lie on it.
pub const SQUARED_RADIUS: f32 = 0.5;

/// Radius factor of surfels at the border of a surface. A border pixel is empty if the surface covers less than a
/// quarter of its width, and ellipses of radius 1/√2 end at the corners of their pixels. So a gap of up to half a pixel
/// would remain where the surface continues in the next cell. A radius of 1.27/√2 = 0.9 closes it: the ellipse reaches
/// a quarter of a pixel beyond the corners, √(0.9² − 0.5²) = 0.75 from the middle.
pub const BORDER: f32 = 1.27;

/// Number of neighbours of a pixel in the interior of a view.
const ALL_NEIGHBOURS: u8 = 8;

/// Minimum cosine between a surfel's normal and the direction of its view. Pixels of steeper surfaces are not connected
/// (`connect`), so only normals averaged across edges are steeper. The minimum bounds the length of their surfels.
pub const MIN_COSINE: f32 = 0.25;

/// A part of a view: pixels from `low` to `high` (columns, rows, depth steps; `high` is exclusive).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Extent {
    pub low: [u16; 3],
    pub high: [u16; 3],
}

impl Extent {
    pub const NOTHING: Self = Self { low: [u16::MAX; 3], high: [0; 3] };

    fn of_pixel([x, y]: [u16; 2], depth: u16) -> Self {
        Self { low: [x, y, depth - 1], high: [x + 1, y + 1, depth] }
    }

    pub fn add(&mut self, other: &Self) {
        for axis in 0..3 {
            self.low[axis] = self.low[axis].min(other.low[axis]);
            self.high[axis] = self.high[axis].max(other.high[axis]);
        }
    }
}

/// A block of 8 × 8 pixels of a view, some of which show a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Block {
    /// Tight extent of the shown pixels.
    pub extent: Extent,
    /// Column and row of its first pixel.
    pub corner: [u16; 2],
    /// Number of its first splat.
    pub first: u32,
    /// Bit mask of the pixels that show a surface; bit 8 row + column.
    pub shown: u64,
    /// Bit mask of the surfels.
    pub surfels: u64,
    /// Bit mask of the pixels connected with all neighbours.
    pub inner: u64,
}

/// Blocks of a view that are culled together.
#[derive(Clone, Copy, Debug)]
pub(super) struct BoxOfBlocks {
    pub extent: Extent,
    /// Number of the first block, and of the one after the last.
    pub blocks: [u32; 2],
    /// Number of its splats.
    pub count: u32,
}

/// A packed pixel: 24 bits of colour, 24 of its normal, 16 of its depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Packed(u64);

impl Packed {
    pub fn new(depth: u16, normal: [u16; 2], color: [u8; 3]) -> Self {
        let ([red, green, blue], [u, v]) = (color.map(u64::from), normal.map(u64::from));
        Self(red | green << 8 | blue << 16 | u << 24 | v << 36 | u64::from(depth) << 48)
    }

    pub fn color(self) -> [u8; 3] {
        [self.0 as u8, (self.0 >> 8) as u8, (self.0 >> 16) as u8]
    }

    /// Returns the two components of its normal.
    #[inline(always)]
    pub fn normal(self) -> [u16; 2] {
        [(self.0 >> 24) as u16 & 0xFFF, (self.0 >> 36) as u16 & 0xFFF]
    }

    #[inline(always)]
    pub fn depth(self) -> u16 {
        (self.0 >> 48) as u16
    }
}

/// A view of a cell, ready to be splatted: 8 bytes per pixel with a surface.
#[derive(Clone, Debug)]
pub struct Splats {
    pub(super) frame: Frame,
    /// Centre of the cell, metres.
    pub(super) center: DVec3,
    /// Extents of the view to the right, upwards and towards the viewer, metres.
    pub(super) extents: DVec3,
    pub(super) format: Format,
    pub(super) boxes: Vec<BoxOfBlocks>,
    pub(super) blocks: Vec<Block>,
    pub(super) texels: Vec<Packed>,
}

impl Splats {
    /// Creates the splats of a cell's view by direction number; `connected` has the connections of all views' pixels.
    pub fn new(views: &Views, number: usize, connected: &[u8], cell: &Cell) -> Result<Self> {
        let count = views.directions.len();
        let (Some(view), Some(&direction)) = (views.views().get(number), views.directions.get(number)) else {
            return Err(Error::value("number", format!("one of {count} views"), number));
        };
        let (format, pixels) = (views.format, views.format.pixels());
        ensure!(connected.len() == pixels * count, "connected", format!("pixels of {count} views"), connected.len());
        let connected = &connected[pixels * number..][..pixels];
        let frame = Direction::frame(direction);
        let center = cell.corner + cell.side / 2.0;
        let extents = frame.extents() * cell.side;
        let mut splats = Self { frame, center, extents, format, boxes: vec![], blocks: vec![], texels: vec![] };
        splats.gather(view, &neighbours(connected, format.size));
        Ok(splats)
    }

    fn gather(&mut self, texels: &[Texel], connected: &[u8]) {
        let blocks_per_row = self.format.size.div_ceil(BLOCK);
        let blocks_per_box = blocks_per_row.div_ceil(BOXES);
        let range = |n: usize| n * blocks_per_box..((n + 1) * blocks_per_box).min(blocks_per_row);
        for (row, column) in (0..BOXES).flat_map(|row| (0..BOXES).map(move |column| (row, column))) {
            let first = self.blocks.len();
            for (y, x) in range(row).flat_map(|y| range(column).map(move |x| (y, x))) {
                self.gather_block([x * BLOCK, y * BLOCK], texels, connected);
            }
            self.close_box(first);
        }
    }

    /// Adds a block, unless none of its pixels shows a surface.
    fn gather_block(&mut self, [left, top]: [usize; 2], texels: &[Texel], connected: &[u8]) {
        let size = self.format.size;
        let (corner, first) = ([left as u16, top as u16], self.texels.len() as u32);
        let mut block = Block { extent: Extent::NOTHING, corner, first, shown: 0, surfels: 0, inner: 0 };
        for (row, column) in (0..BLOCK).flat_map(|row| (0..BLOCK).map(move |column| (row, column))) {
            let (x, y) = (left + column, top + row);
            if x >= size || y >= size || texels[y * size + x].depth == 0 {
                continue;
            }
            let (texel, bit) = (&texels[y * size + x], 1u64 << (BLOCK * row + column));
            block.shown |= bit;
            let neighbours = connected[y * size + x];
            block.surfels |= if is_surfel(neighbours) { bit } else { 0 };
            block.inner |= if neighbours == ALL_NEIGHBOURS { bit } else { 0 };
            block.extent.add(&Extent::of_pixel([x as u16, y as u16], texel.depth));
            self.texels.push(Packed::new(texel.depth, texel.normal, texel.color));
        }
        if block.shown != 0 {
            self.blocks.push(block);
        }
    }

    /// Creates a box of the blocks from number `first` on, unless there are none.
    fn close_box(&mut self, first: usize) {
        let Some(first_block) = self.blocks.get(first) else { return };
        let count = self.texels.len() as u32 - first_block.first;
        let mut extent = Extent::NOTHING;
        self.blocks[first..].iter().for_each(|block| extent.add(&block.extent));
        self.boxes.push(BoxOfBlocks { extent, blocks: [first as u32, self.blocks.len() as u32], count });
    }

    /// Returns the splats of a block: the pixel's number in the block, its column and row, and the splat.
    fn pixels(&self, block: &Block) -> impl Iterator<Item = (u32, [u16; 2], Packed)> {
        let [left, top] = block.corner;
        let texels = &self.texels[block.first as usize..];
        set_bits(block.shown).zip(texels).map(move |(bit, &texel)| {
            let (row, column) = (bit as u16 / BLOCK as u16, bit as u16 % BLOCK as u16);
            (bit, [left + column, top + row], texel)
        })
    }

    /// Returns the splats selected by `bits`, a mask per block.
    pub(super) fn select(&self, bits: impl Fn(&Block) -> u64) -> Self {
        let mut selection = Self { boxes: vec![], blocks: vec![], texels: vec![], ..*self };
        for source in &self.boxes {
            let first = selection.blocks.len();
            for block in &self.blocks[source.blocks[0] as usize..source.blocks[1] as usize] {
                let shown = bits(block) & block.shown;
                let (mut extent, first) = (Extent::NOTHING, selection.texels.len() as u32);
                for (_, pixel, texel) in self.pixels(block).filter(|(bit, ..)| shown >> bit & 1 == 1) {
                    extent.add(&Extent::of_pixel(pixel, texel.depth()));
                    selection.texels.push(texel);
                }
                selection.blocks.extend((shown != 0).then_some(Block { extent, first, shown, ..*block }));
            }
            selection.close_box(first);
        }
        selection
    }

    /// Returns the splats with centres in a half-open box, so that adjacent boxes share no splats.
    pub fn clip_to_box(&self, low: DVec3, high: DVec3) -> Self {
        self.select_centers(|center| center.cmpge(low).all() && center.cmplt(high).all())
    }

    /// Returns the splats with centres at least at a distance from the vertical axis through a point.
    pub fn clip_outside_cylinder(&self, axis_point: DVec3, radius: f64) -> Self {
        self.select_centers(|center| (center - axis_point).with_y(0.0).length() >= radius)
    }

    /// Returns the splats whose centres are accepted.
    fn select_centers(&self, accepts: impl Fn(DVec3) -> bool) -> Self {
        let center = |[x, y]: [u16; 2], step| self.place(f64::from(x) + 0.5, f64::from(y) + 0.5, f64::from(step) - 0.5);
        self.select(|block| {
            let accepted = self.pixels(block).filter(|&(_, pixel, texel)| accepts(center(pixel, texel.depth())));
            accepted.fold(0, |bits, (bit, ..)| bits | 1 << bit)
        })
    }

    /// Returns the number of splats.
    pub fn count(&self) -> usize {
        self.texels.len()
    }

    /// Returns the size in memory, bytes.
    pub fn bytes(&self) -> usize {
        size_of::<Self>() + size_of_val(&*self.texels) + size_of_val(&*self.blocks) + size_of_val(&*self.boxes)
    }

    /// Returns the width and height of a pixel, and the length of a step, metres.
    pub(super) fn pitch(&self) -> DVec3 {
        let size = self.format.size as f64;
        self.extents / DVec3::new(size, size, f64::from(self.format.steps))
    }

    /// Returns the radius of a ball, which encloses its pixel, metres.
    pub(super) fn ball_radius(&self) -> f64 {
        self.pitch().truncate().length() / 2.0
    }

    /// Returns the columns, rows and depth steps by which splats extend beyond their pixels and depths.
    pub(super) fn margin(&self) -> [f64; 3] {
        let (pitch, ball, radius) = (self.pitch(), self.ball_radius(), f64::from(BORDER * SQUARED_RADIUS.sqrt()));
        let in_plane = |pitch: f64| radius.max(ball / pitch) - 0.5;
        let slope = radius * (pitch.x + pitch.y) / f64::from(MIN_COSINE);
        [in_plane(pitch.x), in_plane(pitch.y), slope.max(ball) / pitch.z]
    }

    /// Returns the position at a column, a row and a number of depth steps, which may be fractional. Integer columns
    /// and rows are corners of pixels; 0 steps is the front of the cell's extent.
    pub(super) fn place(&self, column: f64, row: f64, depth: f64) -> DVec3 {
        let [right, up, toward] = self.frame.axes();
        let (pitch, half) = (self.pitch(), self.extents / 2.0);
        self.center
            + right * (column * pitch.x - half.x)
            + up * (half.y - row * pitch.y)
            + toward * (half.z - depth * pitch.z)
    }

    /// Returns the vectors of one column, one row and one depth step, metres.
    pub(super) fn steps(&self) -> [DVec3; 3] {
        let ([right, up, toward], pitch) = (self.frame.axes(), self.pitch());
        [right * pitch.x, up * -pitch.y, toward * -pitch.z]
    }

    /// Returns the unit normal of a splat.
    pub(super) fn normal(&self, texel: Packed) -> Vec3 {
        normals::decode(texel.normal(), self.format.normal_bits)
    }
}
