//! A picture of views, drawn by a device in bands of rows.

use std::ops::Range;
use std::sync::Arc;

use nearfar_core::base::{Error, Progress, Result};
use nearfar_core::orthoview::splat::{Counts, Found, Picture, Piece, Plan, Splats};
use nearfar_core::render::Frame;
use wgpu::{BindingResource, Buffer};

use super::Views;
use super::arena::Place;
use super::programs::{Kernel, Kernels};
use super::uniforms::{DrawBlock, Uniforms};
use crate::compute::memory::{LentBuffer, Results};
use crate::compute::programs::{ROW, Work, groups};
use crate::device::Device;

/// Bytes of a sample's key.
const KEY: u64 = 8;
/// Bytes of the keys of a band, at most.
const BAND: u64 = 1 << 28;
/// Width and height of a tile of samples.
const TILE: u32 = 16;
/// Shares of a picture's splats that are drawn before tiles are looked at again, as powers of ½.
const BATCHES: [u32; 5] = [4, 3, 2, 1, 0];
/// Place of an image that is not wanted.
const NONE: u32 = u32::MAX;
/// Words of a pixel: colours, samples that show what was before, the middle's key.
const WORDS: [u32; 3] = [4, 2, 2];

/// Draws views; of the samples that show none, those of `before` or the sky.
pub fn draw(
    device: &Device,
    views: &[Arc<Splats>],
    picture: &Picture<'_>,
    progress: &Progress,
) -> Result<(Frame, Counts)> {
    device.check()?;
    let own: Vec<&Splats> = views.iter().map(|view| &**view).collect();
    let mut plan = Plan::new(&own, picture)?;
    let layout = Layout::new(device, &plan)?;
    let residents = device.state::<Views>();
    let compressed = residents.compressed(views);
    let mut found = Images::new(&layout, picture);
    progress.expect(u64::from(layout.bands().count() as u32) + 1);
    let bands = {
        // Until the work is submitted nobody else may take the room of these views.
        let mut arena = residents.arena();
        let places = arena.keep(device, views, &compressed)?;
        set_places(&mut plan, &places);
        let pages = arena.buffers(device)?;
        Drawing::new(device, &plan, &layout, &pages)?.submit(progress)?
    };
    let mut seen = 0;
    for band in bands {
        band.found.read(progress, |bytes| found.add(&layout, band.pixels, bytemuck::cast_slice(bytes)))?;
        let count = |bytes: &[u8]| bytes.first_chunk().copied().map_or(0, u32::from_ne_bytes);
        seen += u64::from(band.tiles.read(progress, count)?);
        progress.report(1)?;
    }
    let frame = plan.frame(&found.whole())?;
    progress.report(1)?;
    Ok((frame, plan.counts(seen)))
}

fn set_places(plan: &mut Plan<'_>, places: &[Place]) {
    for (view, [page, heads, bits]) in plan.views.iter_mut().zip(places) {
        view.place = [view.place[0], *page, *heads, *bits];
    }
}

/// How a picture is divided into bands, and the words of its output.
struct Layout {
    /// Width and height of the picture, and samples along an axis of a pixel.
    size: [u32; 2],
    grid: u32,
    /// Rows of pixels of a band.
    rows: u32,
    /// Which images are found.
    wanted: [bool; 3],
}

impl Layout {
    fn new(device: &Device, plan: &Plan<'_>) -> Result<Self> {
        let picture = plan.picture();
        let (grid, size) = (picture.grid, [picture.camera.width, picture.camera.height]);
        let colored = picture.channels.any_sampled();
        let wanted = [colored, colored && picture.before.is_some(), picture.channels.any_surface()];
        let words: u32 = WORDS.iter().zip(wanted).filter(|(_, wanted)| *wanted).map(|(words, _)| words).sum();
        let row = u64::from(size[0]) * (KEY * u64::from(grid * grid)).max(4 * u64::from(words));
        let most = BAND.min(device.largest_binding());
        if row > most {
            let label = device.report().label();
            return Err(Error::Device(format!("{label}: a row of {} pixels does not fit; use backend='cpu'", size[0])));
        }
        let rows = (most / row).min(u64::from(size[1])) as u32;
        Ok(Self { size, grid, rows, wanted })
    }

    /// Rows of pixels of all bands.
    fn bands(&self) -> impl Iterator<Item = Range<u32>> {
        let (rows, height) = (self.rows, self.size[1]);
        (0..height).step_by(rows as usize).map(move |first| first..(first + rows).min(height))
    }

    /// First words of the images of some pixels, and the number of all words.
    fn outputs(&self, pixels: u32) -> ([u32; 3], u32) {
        let mut next = 0;
        let place = |n: usize| {
            let first = next;
            next += if self.wanted[n] { WORDS[n] * pixels } else { 0 };
            if self.wanted[n] { first } else { NONE }
        };
        ([0, 1, 2].map(place), next)
    }
}

/// Work that was submitted for a band.
struct Band<'a> {
    pixels: u32,
    found: Results<'a>,
    tiles: Results<'a>,
}

/// The images of a picture.
struct Images {
    colors: Vec<[f32; 4]>,
    others: Vec<[u32; 2]>,
    middles: Vec<[u32; 2]>,
}

impl Images {
    fn new(layout: &Layout, picture: &Picture<'_>) -> Self {
        let pixels = picture.camera.width as usize * picture.camera.height as usize;
        let room = |n: usize| if layout.wanted[n] { pixels } else { 0 };
        Self {
            colors: Vec::with_capacity(room(0)),
            others: Vec::with_capacity(room(1)),
            middles: Vec::with_capacity(room(2)),
        }
    }

    /// Adds what a band found.
    fn add(&mut self, layout: &Layout, pixels: u32, words: &[u32]) {
        let ([colors, others, middles], _) = layout.outputs(pixels);
        let part = |first: u32, n: usize| {
            let length = if first == NONE { 0 } else { WORDS[n] * pixels };
            &words[if first == NONE { 0 } else { first } as usize..][..length as usize]
        };
        self.colors.extend_from_slice(bytemuck::cast_slice(part(colors, 0)));
        self.others.extend_from_slice(bytemuck::cast_slice(part(others, 1)));
        self.middles.extend_from_slice(bytemuck::cast_slice(part(middles, 2)));
    }

    fn whole(&self) -> Found<'_> {
        Found { colors: &self.colors, others: &self.others, middles: &self.middles }
    }
}

/// Buffers and kernels of a picture.
struct Drawing<'a, 'b> {
    device: &'a Device,
    plan: &'b Plan<'b>,
    layout: &'b Layout,
    pages: [BindingResource<'b>; 4],
    kernels: Kernels,
    /// Numbers of the pieces at the ends of the batches.
    batches: Vec<Range<u32>>,
    views: LentBuffer<'a>,
    pieces: LentBuffer<'a>,
    keys: LentBuffer<'a>,
}

impl<'a, 'b> Drawing<'a, 'b> {
    fn new(device: &'a Device, plan: &'b Plan<'b>, layout: &'b Layout, pages: &[&'b Buffer]) -> Result<Self> {
        let page = |n: usize| pages.get(n).unwrap_or(&pages[0]).as_entire_binding();
        let kernels =
            Kernels { is_parallel: plan.is_parallel(), is_long: device.uses_long_atomics(), pages: pages.len() as u32 };
        let samples = u64::from(layout.size[0]) * u64::from(layout.rows) * u64::from(layout.grid * layout.grid);
        let filled = |bytes: &[u8]| {
            let buffer = LentBuffer::scratch(device, bytes.len() as u64)?;
            buffer.fill(bytes, &Progress::new())?;
            Ok(buffer)
        };
        Ok(Self {
            device,
            plan,
            layout,
            pages: [0, 1, 2, 3].map(page),
            kernels,
            batches: batches(&plan.pieces),
            views: filled(bytemuck::cast_slice(&plan.views))?,
            pieces: filled(bytemuck::cast_slice(&plan.pieces))?,
            keys: LentBuffer::scratch(device, KEY * samples)?,
        })
    }

    /// Submits the work of all bands.
    fn submit(&self, progress: &Progress) -> Result<Vec<Band<'a>>> {
        let tiles_of = |rows: u32| {
            [self.layout.size[0], rows].map(|length| (length * self.layout.grid).div_ceil(TILE)).iter().product::<u32>()
        };
        let mut bands: Vec<Band<'a>> = Vec::new();
        for rows in self.layout.bands() {
            let count = rows.end - rows.start;
            let pixels = self.layout.size[0] * count;
            let found = Results::new(self.device, 4 * u64::from(self.layout.outputs(pixels).1))?;
            let tiles = Results::new(self.device, 4 * u64::from(1 + tiles_of(count)))?;
            let mut work = Work::new(self.device);
            self.encode(&mut work, &rows, &found, &tiles, tiles_of(count))?;
            work.submit(progress)?;
            bands.push(Band { pixels, found, tiles });
        }
        Ok(bands)
    }

    fn encode(
        &self,
        work: &mut Work<'a>,
        rows: &Range<u32>,
        found: &Results<'_>,
        tiles: &Results<'_>,
        tile_count: u32,
    ) -> Result<()> {
        let grid = self.layout.grid;
        let pixels = self.layout.size[0] * (rows.end - rows.start);
        let (outputs, _) = self.layout.outputs(pixels);
        let mut block = DrawBlock::new(self.plan);
        block.size = [self.layout.size[0] * grid, (rows.end - rows.start) * grid, rows.start * grid, grid];
        block.outputs = [outputs[0], outputs[1], outputs[2], 0];
        let passes = if self.kernels.is_long { 0..1 } else { 0..2u32 };
        let drawn: Vec<DrawBlock> = passes
            .flat_map(|pass| self.batches.iter().map(move |batch| (pass, batch)))
            .map(|(pass, batch)| block.with_work(batch, pass))
            .collect();
        let mut blocks = drawn.clone();
        blocks.push(block);
        let uniforms = Uniforms::new(self.device, &blocks)?;
        let bytes = KEY * u64::from(pixels) * u64::from(grid * grid);
        let before = self.plan.before(rows.start * grid..rows.end * grid);
        match &before {
            Some(keys) => self.keys.fill(bytemuck::cast_slice(keys), &Progress::new())?,
            None => work.encoder.clear_buffer(&self.keys, 0, Some(bytes)),
        }
        work.encoder.clear_buffer(&tiles.on_device, 0, Some(4 * u64::from(1 + tile_count)));
        for (number, pieces) in (0..drawn.len()).zip(self.batches.iter().cycle()) {
            if number > 0 || before.is_some() {
                let resources =
                    [(0, uniforms.binding(number)), (7, tiles.on_device.binding()), (8, self.keys.binding())];
                self.kernels.run(work, Kernel::Tiles, &resources, rows_of(tile_count))?;
            }
            let resources =
                self.resources(&uniforms, number, &[(6, &self.pieces), (7, &tiles.on_device), (8, &self.keys)]);
            self.kernels.run(work, Kernel::Draw, &resources, rows_of(pieces.end - pieces.start))?;
        }
        let resources = self.resources(&uniforms, drawn.len(), &[(6, &found.on_device), (8, &self.keys)]);
        self.kernels.run(work, Kernel::Resolve, &resources, groups(pixels))?;
        found.bring(&mut work.encoder);
        tiles.bring(&mut work.encoder);
        Ok(())
    }

    fn resources<'c>(
        &'c self,
        uniforms: &'c Uniforms,
        number: usize,
        more: &[(u32, &'c LentBuffer<'_>)],
    ) -> Vec<(u32, BindingResource<'c>)> {
        let mut found = vec![(0, uniforms.binding(number)), (1, self.views.binding())];
        found.extend((2..).zip(self.pages.iter().cloned()));
        found.extend(more.iter().map(|(number, buffer)| (*number, buffer.binding())));
        found
    }
}

/// Workgroups of a kernel of which each does one thing.
fn rows_of(count: u32) -> [u32; 2] {
    [count.clamp(1, ROW), count.div_ceil(ROW).max(1)]
}

/// Pieces of which each batch draws a share of the splats; the last one draws the rest. Batches without pieces are left out.
fn batches(pieces: &[Piece]) -> Vec<Range<u32>> {
    let total: u64 = pieces.iter().map(|piece| u64::from(piece.count)).sum();
    let (mut found, mut drawn, mut start) = (Vec::new(), 0, 0);
    let mut ends = BATCHES.iter().map(|power| total >> power).peekable();
    for (number, piece) in (1..).zip(pieces) {
        drawn += u64::from(piece.count);
        if ends.peek().is_some_and(|end| drawn >= *end) {
            while ends.next_if(|end| drawn >= *end).is_some() {}
            found.push(start..number);
            start = number;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn batches_have_all_pieces_once_and_grow() {
        let pieces = |counts: &[u32]| -> Vec<Piece> {
            let one = |&count: &u32| Piece { count, ..bytemuck::Zeroable::zeroed() };
            counts.iter().map(one).collect()
        };
        assert_eq!(batches(&pieces(&[64; 32])), [0..2, 2..4, 4..8, 8..16, 16..32]);
        assert_eq!(batches(&pieces(&[1000, 1, 1])), [0..1, 1..3]);
        assert_eq!(batches(&[]), Vec::<Range<u32>>::new());
    }
}
