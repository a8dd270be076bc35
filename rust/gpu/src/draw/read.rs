//! The output as a frame's images: copies, and numbers of records and faces replaced by the scene's.

use nearfar_core::base::Result;
use nearfar_core::render::Frame;
use rayon::prelude::*;

use super::layers::Layer;
use super::picture::Picture;
use super::plan::Numbering;
use super::submitted::Submitted;
use crate::device::Device;

/// Copies a window into its place in a frame of `width` pixels a row.
pub(super) fn copy(
    device: &Device,
    submitted: &Submitted,
    picture: &Picture,
    width: u32,
    frame: &mut Frame,
) -> Result<()> {
    let view = submitted.slot.readable().get_mapped_range(..submitted.slot.shape.bytes.next_multiple_of(8));
    let view = view.map_err(|error| device.failure(&error))?;
    fill(bytemuck::cast_slice(&view), submitted, picture, width, frame);
    Ok(())
}

/// Puts a window's words into its place in a frame of `width` pixels a row.
pub(super) fn fill(words: &[u32], submitted: &Submitted, picture: &Picture, width: u32, frame: &mut Frame) {
    let window = &submitted.window;
    let section = |channel: usize, each: usize| {
        let start = submitted.outputs[channel] as usize;
        &words[start..start + each * window.pixels()]
    };
    let (columns, stride) = (window.width as usize, width as usize);
    let first = window.row as usize * stride + window.column as usize;
    // First pixel of a row of the window in the frame.
    let place = |image_row: usize| first + image_row * stride;
    let vectors = [(0, &mut frame.color), (3, &mut frame.position), (4, &mut frame.normal)];
    for (channel, image) in vectors.into_iter().filter(|(_, image)| !image.is_empty()) {
        let values: &[[f32; 3]] = bytemuck::cast_slice(section(channel, 3));
        rows(image, place(0), stride, columns, window.height).zip(values.par_chunks(columns)).for_each(|(to, from)| {
            to.copy_from_slice(from);
        });
    }
    if !frame.range.is_empty() {
        let values: &[f32] = bytemuck::cast_slice(section(1, 1));
        rows(&mut frame.range, place(0), stride, columns, window.height)
            .zip(values.par_chunks(columns))
            .for_each(|(to, from)| to.copy_from_slice(from));
    }
    let numbers = FaceNumbers { picture, numbering: &submitted.numbering };
    if !frame.object_id.is_empty() {
        let values: &[[u32; 2]] = bytemuck::cast_slice(section(2, 2));
        rows(&mut frame.object_id, place(0), stride, columns, window.height).zip(values.par_chunks(columns)).for_each(
            |(to, from)| {
                numbers.fill(
                    to,
                    from,
                    |layer, instance, face| layer.object_of(instance, face),
                    |n| numbers.far_object(n),
                    -1,
                )
            },
        );
    }
    if !frame.face_id.is_empty() {
        let values: &[[u32; 2]] = bytemuck::cast_slice(section(2, 2));
        rows(&mut frame.face_id, place(0), stride, columns, window.height).zip(values.par_chunks(columns)).for_each(
            |(to, from)| numbers.fill(to, from, |layer, instance, face| layer.triangle_of(instance, face), |_| -1, -1),
        );
    }
}

/// The parts of an image's rows that a window covers.
fn rows<T: Send>(
    image: &mut [T],
    first: usize,
    stride: usize,
    columns: usize,
    height: u32,
) -> impl IndexedParallelIterator<Item = &mut [T]> {
    let column = first % stride;
    let rows = image[first - column..].par_chunks_mut(stride).take(height as usize);
    rows.map(move |row| &mut row[column..column + columns])
}

/// Numbers of the scene by numbers of a frame's records.
struct FaceNumbers<'a> {
    picture: &'a Picture,
    numbering: &'a [Numbering],
}

impl FaceNumbers<'_> {
    /// Numbers of a row's pixels; neighbours mostly show one face.
    fn fill<T: Copy>(
        &self,
        to: &mut [T],
        from: &[[u32; 2]],
        of_face: impl Fn(&Layer, u32, u32) -> T,
        of_texel: impl Fn(u32) -> T,
        none: T,
    ) {
        let mut last = ([u32::MAX; 2], none);
        for (slot, &id) in to.iter_mut().zip(from) {
            if id != last.0 {
                let [record, face] = id;
                let value = match self.locate(record) {
                    Some((layer, record)) => {
                        let (instance, first_face) = layer.record_faces()[record as usize];
                        of_face(layer, instance, first_face + face)
                    }
                    None if face != u32::MAX => of_texel(face),
                    None => none,
                };
                last = (id, value);
            }
            *slot = last.1;
        }
    }

    /// The layer of a record, and its place in the layer's set.
    fn locate(&self, record: u32) -> Option<(&Layer, u32)> {
        let after = self.numbering.partition_point(|numbering| numbering.first <= record);
        let found = self.numbering.get(after.checked_sub(1)?)?;
        let local = record - found.first;
        (local < found.count).then(|| (&self.picture.layers[found.layer], found.first_in_set + local))
    }

    fn far_object(&self, texel: u32) -> i32 {
        let objects = self.picture.backdrop.as_ref().and_then(|backdrop| backdrop.objects.as_ref());
        objects.and_then(|objects| objects.get(texel as usize)).copied().unwrap_or(-1)
    }
}
