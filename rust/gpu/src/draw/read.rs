//! Copies the output to a frame's images, and converts record and face numbers to the scene's object and triangle
//! numbers.

use bytemuck::Pod;
use nearfar_core::base::Result;
use nearfar_core::render::Frame;
use rayon::prelude::*;

use super::picture::{Layer, Picture};
use super::plan::Numbering;
use super::slots::Submitted;
use super::window::{Outputs, Window};
use crate::device::Device;

/// Copies a window to its position in each view's frame, with `width` pixels per row.
pub(super) fn copy(
    device: &Device,
    submitted: &Submitted,
    picture: &Picture,
    width: u32,
    frames: &mut [Frame],
) -> Result<()> {
    let view = submitted.slot.readable().get_mapped_range(..submitted.slot.shape.output_bytes.next_multiple_of(8));
    let view = view.map_err(|error| device.failure(error))?;
    for (frame, outputs) in frames.iter_mut().zip(&submitted.outputs) {
        fill(bytemuck::cast_slice(&view), submitted, outputs, picture, width, frame);
    }
    // The data are undefined if the device was lost meanwhile.
    device.check()
}

/// Writes a window's words to its position in a frame with `width` pixels per row.
pub(super) fn fill(
    words: &[u32],
    submitted: &Submitted,
    outputs: &Outputs,
    picture: &Picture,
    width: u32,
    frame: &mut Frame,
) {
    let window = &submitted.window;
    let section = |channel: usize, words_per_pixel: usize| {
        let start = outputs[channel] as usize;
        &words[start..start + words_per_pixel * window.pixels()]
    };
    let vectors = [
        (0, &mut frame.color),
        (3, &mut frame.position),
        (4, &mut frame.normal),
        (5, &mut frame.albedo),
        (6, &mut frame.shading_normal),
    ];
    for (channel, image) in vectors.into_iter().filter(|(_, image)| !image.is_empty()) {
        fill_rows(image, section(channel, 3), window, width, <[[f32; 3]]>::copy_from_slice);
    }
    for (channel, image) in [(1, &mut frame.range), (7, &mut frame.coverage)] {
        if !image.is_empty() {
            fill_rows(image, section(channel, 1), window, width, <[f32]>::copy_from_slice);
        }
    }
    let numbers = FaceNumbers { picture, numbering: &submitted.numbering };
    if !frame.object_id.is_empty() {
        fill_rows(&mut frame.object_id, section(2, 2), window, width, |to, from| {
            numbers.fill(to, from, Layer::object_of, |texel| numbers.map_object(texel), -1);
        });
    }
    if !frame.face_id.is_empty() {
        fill_rows(&mut frame.face_id, section(2, 2), window, width, |to, from| {
            numbers.fill(to, from, Layer::triangle_of, |_| -1, -1);
        });
    }
}

/// Fills the parts of an image's rows that a window covers from the window's words.
fn fill_rows<T: Send, W: Pod + Sync>(
    image: &mut [T],
    words: &[u32],
    window: &Window,
    width: u32,
    fill: impl Fn(&mut [T], &[W]) + Sync,
) {
    let (first, columns) = (window.column as usize, window.width as usize);
    let rows = image.par_chunks_mut(width as usize).skip(window.row as usize);
    let pixels: &[W] = bytemuck::cast_slice(words);
    rows.zip(pixels.par_chunks(columns)).for_each(|(row, from)| fill(&mut row[first..first + columns], from));
}

/// Map from the record and face numbers of a frame to the numbers of its scenes.
struct FaceNumbers<'a> {
    picture: &'a Picture,
    numbering: &'a [Numbering],
}

impl FaceNumbers<'_> {
    /// Writes the numbers of a row's pixels. The last number is reused, because neighbours mostly show one face.
    fn fill<T: Copy>(
        &self,
        to: &mut [T],
        from: &[[u32; 2]],
        of_face: impl Fn(&Layer, u32, u32) -> T,
        of_texel: impl Fn(u32) -> T,
        none: T,
    ) {
        let (mut last_id, mut value) = ([u32::MAX; 2], none);
        for (slot, &id) in to.iter_mut().zip(from) {
            if id != last_id {
                let [record, face] = id;
                value = match self.locate(record) {
                    Some((layer, record)) => {
                        let (instance, first_face) = layer.set_tables().record_faces[record as usize];
                        of_face(layer, instance, first_face + face)
                    }
                    None if face != u32::MAX => of_texel(face),
                    None => none,
                };
                last_id = id;
            }
            *slot = value;
        }
    }

    /// Returns the layer of a record, and its index in the layer's set.
    fn locate(&self, record: u32) -> Option<(&Layer, u32)> {
        let after = self.numbering.partition_point(|numbering| numbering.first <= record);
        let numbering = self.numbering.get(after.checked_sub(1)?)?;
        let index = record - numbering.first;
        (index < numbering.count).then(|| (&self.picture.layers[numbering.layer], numbering.first_in_set + index))
    }

    fn map_object(&self, texel: u32) -> i32 {
        let objects = self.picture.backdrop.as_ref().and_then(|backdrop| backdrop.objects.as_ref());
        objects.and_then(|objects| objects.get(texel as usize)).copied().unwrap_or(-1)
    }
}
