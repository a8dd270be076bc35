//! Division of a picture into bands, and its output layout.

use std::ops::Range;

use nearfar_core::base::memory::room_for;
use nearfar_core::base::{Error, Result};
use nearfar_core::orthoview::splat::{Found, Plan};

use crate::device::Device;

/// Bytes of a sample's key.
pub(super) const KEY: u64 = 8;
/// Maximum bytes of a band's keys.
const BAND: u64 = 1 << 28;
/// Offset of an image that is not requested.
const NONE: u32 = u32::MAX;
/// Words per pixel: colours, samples that show `before`, the centre's key.
const WORDS: [u32; 3] = [4, 2, 2];

/// Bands of a picture and its output layout.
pub(super) struct Layout {
    /// Width and height of the picture, and samples along each axis of a pixel.
    pub size: [u32; 2],
    pub grid: u32,
    /// Rows of pixels per band.
    pub rows: u32,
    /// Flags of the requested images.
    wanted: [bool; 3],
}

impl Layout {
    /// Creates the bands of a plan's picture on a device.
    pub fn new(device: &Device, plan: &Plan<'_>) -> Result<Self> {
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
        room_for(4 * u64::from(words) * u64::from(size[0]) * u64::from(size[1]))?;
        let pieces = size_of_val(&*plan.pieces) as u64;
        if pieces > device.largest_binding() {
            let label = device.report().label();
            return Err(Error::Device(format!(
                "{label}: large splats take {pieces} bytes, more than its limit; use backend='cpu'"
            )));
        }
        let rows = (most / row).min(u64::from(size[1])) as u32;
        Ok(Self { size, grid, rows, wanted })
    }

    /// Returns the rows of pixels of each band.
    pub fn bands(&self) -> impl Iterator<Item = Range<u32>> {
        let (rows, height) = (self.rows, self.size[1]);
        (0..height).step_by(rows as usize).map(move |first| first..(first + rows).min(height))
    }

    /// Returns the first word of each image for some pixels, and the total number of words.
    pub fn outputs(&self, pixels: u32) -> ([u32; 3], u32) {
        let mut next = 0;
        let place = |n: usize| {
            let first = next;
            next += if self.wanted[n] { WORDS[n] * pixels } else { 0 };
            if self.wanted[n] { first } else { NONE }
        };
        ([0, 1, 2].map(place), next)
    }
}

/// Images of a picture.
pub(super) struct Images {
    colors: Vec<[f32; 4]>,
    others: Vec<[u32; 2]>,
    middles: Vec<[u32; 2]>,
}

impl Images {
    /// Creates empty images.
    pub fn new(layout: &Layout) -> Self {
        let pixels = layout.size[0] as usize * layout.size[1] as usize;
        let room = |n: usize| if layout.wanted[n] { pixels } else { 0 };
        Self {
            colors: Vec::with_capacity(room(0)),
            others: Vec::with_capacity(room(1)),
            middles: Vec::with_capacity(room(2)),
        }
    }

    /// Adds a band's results.
    pub fn add(&mut self, layout: &Layout, pixels: u32, words: &[u32]) {
        let ([colors, others, middles], _) = layout.outputs(pixels);
        let part = |first: u32, n: usize| {
            let length = if first == NONE { 0 } else { WORDS[n] * pixels };
            &words[if first == NONE { 0 } else { first } as usize..][..length as usize]
        };
        self.colors.extend_from_slice(bytemuck::cast_slice(part(colors, 0)));
        self.others.extend_from_slice(bytemuck::cast_slice(part(others, 1)));
        self.middles.extend_from_slice(bytemuck::cast_slice(part(middles, 2)));
    }

    /// Returns the complete images.
    pub fn whole(&self) -> Found<'_> {
        Found { colors: &self.colors, others: &self.others, middles: &self.middles }
    }
}
