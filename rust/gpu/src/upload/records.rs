//! Instances as records: a transform and the part of the mesh that it places.

use std::sync::Arc;

use nearfar_core::base::Result;
use nearfar_core::scene::Instance;
use wgpu::BufferUsages;

use crate::device::Device;

/// Words of a record: three rows of a matrix mesh→scene, and the part.
pub(crate) const RECORD_WORDS: usize = 16;
/// Index of the part in a record.
pub(super) const PART_WORD: usize = 12;

/// Records of static instances that fit into one binding.
pub(crate) struct Records {
    pub buffer: Arc<wgpu::Buffer>,
    /// First record of the set.
    pub first: u32,
    pub count: u32,
}

impl Records {
    /// Uploads records in as many buffers as they need.
    pub fn of_static(device: &Device, words: &[u32]) -> Result<Vec<Self>> {
        let most = device.largest_binding() as usize / (4 * RECORD_WORDS);
        let mut first = 0;
        let batches = words.chunks(most * RECORD_WORDS).map(|words| {
            let count = (words.len() / RECORD_WORDS) as u32;
            let buffer = device.filled_buffer("records", words, BufferUsages::STORAGE)?;
            first += count;
            Ok(Self { buffer: Arc::new(buffer), first: first - count, count })
        });
        batches.collect()
    }
}

/// Returns a record of an instance and a part's number.
pub(super) fn record_words(instance: &Instance, part: u32) -> [u32; RECORD_WORDS] {
    let (m, t) = (instance.to_scene.matrix3, instance.to_scene.translation);
    let row = |i: usize| [m.x_axis[i], m.y_axis[i], m.z_axis[i], t[i]].map(|x| (x as f32).to_bits());
    let mut words = [0; RECORD_WORDS];
    for (i, slot) in words.chunks_exact_mut(4).take(3).enumerate() {
        slot.copy_from_slice(&row(i));
    }
    words[PART_WORD] = part;
    words
}
