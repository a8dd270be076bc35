//! Division of a picture into bands, and its output layout.

use std::ops::Range;

use nearfar_core::base::Result;
use nearfar_core::base::memory::{room_for, try_with_capacity};
use nearfar_core::orthoview::splat::{Found, Plan};

use crate::device::Device;

/// Bytes of a sample's key.
pub(super) const KEY_BYTES: u64 = 8;
/// Maximum bytes of a band's keys.
const MAX_BAND_BYTES: u64 = 1 << 28;
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
    /// Whether each image is requested.
    is_requested: [bool; 3],
}

impl Layout {
    /// Creates the bands of a plan's picture on a device.
    pub fn new(device: &Device, plan: &Plan<'_>) -> Result<Self> {
        let picture = plan.picture();
        let (grid, size) = (picture.grid, [picture.camera.width, picture.camera.height]);
        let colored = picture.channels.any_sampled();
        let is_requested = [colored, colored && picture.before.is_some(), picture.channels.any_surface()];
        let layout = Self { size, grid, rows: 0, is_requested };
        let output_bytes = 4 * u64::from(layout.outputs(1).1);
        let row_bytes = u64::from(size[0]) * (KEY_BYTES * u64::from(grid * grid)).max(output_bytes);
        let max_bytes = MAX_BAND_BYTES.min(device.largest_binding());
        if row_bytes > max_bytes {
            return Err(device.error(format!("a row of {} pixels does not fit; use backend='cpu'", size[0])));
        }
        room_for(output_bytes * u64::from(size[0]) * u64::from(size[1]))?;
        let bytes = size_of_val(&*plan.pieces) as u64;
        if bytes > device.largest_binding() {
            let message = format!("large splats take {bytes} bytes, more than its limit; use backend='cpu'");
            return Err(device.error(message));
        }
        Ok(Self { rows: (max_bytes / row_bytes).min(u64::from(size[1])) as u32, ..layout })
    }

    /// Returns the rows of pixels of each band.
    pub fn bands(&self) -> impl Iterator<Item = Range<u32>> {
        let (rows, height) = (self.rows, self.size[1]);
        (0..height).step_by(rows as usize).map(move |first| first..(first + rows).min(height))
    }

    /// Returns the first word of each image for some pixels, and the total number of words.
    pub fn outputs(&self, pixels: u32) -> ([u32; 3], u32) {
        let mut end = 0;
        let first_word = |n: usize| {
            let first = end;
            end += if self.is_requested[n] { WORDS[n] * pixels } else { 0 };
            if self.is_requested[n] { first } else { NONE }
        };
        ([0, 1, 2].map(first_word), end)
    }
}

/// Images of a picture.
pub(super) struct Images {
    colors: Vec<[f32; 4]>,
    before_masks: Vec<[u32; 2]>,
    center_keys: Vec<[u32; 2]>,
}

impl Images {
    /// Creates empty images.
    pub fn new(layout: &Layout) -> Result<Self> {
        let pixels = layout.size[0] as usize * layout.size[1] as usize;
        let [colors, before_masks, center_keys] =
            layout.is_requested.map(|requested| if requested { pixels } else { 0 });
        Ok(Self {
            colors: try_with_capacity(colors)?,
            before_masks: try_with_capacity(before_masks)?,
            center_keys: try_with_capacity(center_keys)?,
        })
    }

    /// Adds a band's results.
    pub fn add(&mut self, layout: &Layout, pixels: u32, words: &[u32]) {
        let (firsts, _) = layout.outputs(pixels);
        let image = |n: usize| match firsts[n] {
            NONE => &[],
            first => &words[first as usize..][..(WORDS[n] * pixels) as usize],
        };
        self.colors.extend_from_slice(bytemuck::cast_slice(image(0)));
        self.before_masks.extend_from_slice(bytemuck::cast_slice(image(1)));
        self.center_keys.extend_from_slice(bytemuck::cast_slice(image(2)));
    }

    /// Returns the complete images.
    pub fn as_found(&self) -> Found<'_> {
        Found { colors: &self.colors, before_masks: &self.before_masks, center_keys: &self.center_keys }
    }
}
