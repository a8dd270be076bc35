//! The images of one view; only requested channels are computed.

use crate::base::{Result, memory::room_for};

/// The images of a view that are computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Channels {
    /// Linear RGB.
    pub color: bool,
    /// Displayed distance |Q−U| in metres; infinite where nothing was hit.
    pub range: bool,
    /// Object number; −1 where nothing was hit.
    pub object_id: bool,
    /// Triangle number in the scene; −1 where nothing was hit.
    pub face_id: bool,
    /// Unmorphed surface point relative to the scene's origin; NaN where nothing was hit.
    pub position: bool,
    /// Unit geometric normal towards the viewer; NaN where nothing was hit.
    pub normal: bool,
}

impl Channels {
    /// Whether a channel other than colour is requested; these channels need one ray through each pixel's centre.
    pub fn any_surface(&self) -> bool {
        self.range || self.object_id || self.face_id || self.position || self.normal
    }

    /// Fails if the requested images do not fit into memory.
    pub fn check_room(&self, pixels: u64) -> Result<()> {
        let wanted = |wanted: bool, bytes: usize| if wanted { bytes as u64 } else { 0 };
        let bytes = wanted(self.color, size_of::<[f32; 3]>())
            + wanted(self.range, size_of::<f32>())
            + wanted(self.object_id, size_of::<i32>())
            + wanted(self.face_id, size_of::<i64>())
            + wanted(self.position, size_of::<[f32; 3]>())
            + wanted(self.normal, size_of::<[f32; 3]>());
        room_for(bytes.saturating_mul(pixels))
    }
}

/// Channels of the ray through a pixel's centre; the default is a miss.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Displayed distance, metres.
    pub range: f32,
    /// Object number.
    pub object_id: i32,
    /// Triangle number.
    pub face_id: i64,
    /// Unmorphed point relative to the scene's origin.
    pub position: [f32; 3],
    /// Unit geometric normal.
    pub normal: [f32; 3],
}

impl Default for Sample {
    fn default() -> Self {
        Self { range: f32::INFINITY, object_id: -1, face_id: -1, position: [f32::NAN; 3], normal: [f32::NAN; 3] }
    }
}

/// Images in row-major order; images that were not requested are empty.
#[derive(Debug, Default)]
pub struct Frame {
    /// Linear RGB.
    pub color: Vec<[f32; 3]>,
    /// Displayed distances, metres.
    pub range: Vec<f32>,
    /// Object numbers.
    pub object_id: Vec<i32>,
    /// Triangle numbers.
    pub face_id: Vec<i64>,
    /// Unmorphed points relative to the scene's origin.
    pub position: Vec<[f32; 3]>,
    /// Unit geometric normals.
    pub normal: Vec<[f32; 3]>,
}

/// Consecutive rows of a frame, written by one task.
#[derive(Debug)]
pub(super) struct Band<'a> {
    color: &'a mut [[f32; 3]],
    range: &'a mut [f32],
    object_id: &'a mut [i32],
    face_id: &'a mut [i64],
    position: &'a mut [[f32; 3]],
    normal: &'a mut [[f32; 3]],
}

impl Frame {
    /// Allocates the requested images for a renderer that writes every pixel. Zeros cost nothing before that: the system
    /// makes them page by page, where other values would take seconds for a large picture.
    pub fn new(channels: Channels, pixels: usize) -> Result<Self> {
        channels.check_room(pixels as u64)?;
        let size = |wanted: bool| if wanted { pixels } else { 0 };
        Ok(Self {
            color: vec![[0.0; 3]; size(channels.color)],
            range: vec![0.0; size(channels.range)],
            object_id: vec![0; size(channels.object_id)],
            face_id: vec![0; size(channels.face_id)],
            position: vec![[0.0; 3]; size(channels.position)],
            normal: vec![[0.0; 3]; size(channels.normal)],
        })
    }

    /// Splits the frame into bands of `pixels` pixels; the last may be shorter.
    pub(super) fn bands(&mut self, pixels: usize) -> Vec<Band<'_>> {
        let lengths = [
            self.color.len(),
            self.range.len(),
            self.object_id.len(),
            self.face_id.len(),
            self.position.len(),
            self.normal.len(),
        ];
        let count = lengths.into_iter().max().unwrap_or(0).div_ceil(pixels);
        let mut color = self.color.chunks_mut(pixels);
        let mut range = self.range.chunks_mut(pixels);
        let mut object_id = self.object_id.chunks_mut(pixels);
        let mut face_id = self.face_id.chunks_mut(pixels);
        let mut position = self.position.chunks_mut(pixels);
        let mut normal = self.normal.chunks_mut(pixels);
        let next = |_| Band {
            color: color.next().unwrap_or_default(),
            range: range.next().unwrap_or_default(),
            object_id: object_id.next().unwrap_or_default(),
            face_id: face_id.next().unwrap_or_default(),
            position: position.next().unwrap_or_default(),
            normal: normal.next().unwrap_or_default(),
        };
        (0..count).map(next).collect()
    }
}

impl Band<'_> {
    /// Stores a pixel's colour if colour was requested.
    #[inline]
    pub fn set_color(&mut self, pixel: usize, color: [f32; 3]) {
        set(self.color, pixel, color);
    }

    /// Stores those of a pixel's other channels that were requested.
    #[inline]
    pub fn set_sample(&mut self, pixel: usize, sample: &Sample) {
        set(self.range, pixel, sample.range);
        set(self.object_id, pixel, sample.object_id);
        set(self.face_id, pixel, sample.face_id);
        set(self.position, pixel, sample.position);
        set(self.normal, pixel, sample.normal);
    }
}

#[inline]
fn set<T>(channel: &mut [T], pixel: usize, value: T) {
    if let Some(slot) = channel.get_mut(pixel) {
        *slot = value;
    }
}
