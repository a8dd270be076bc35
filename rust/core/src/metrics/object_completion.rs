//! Object completion: visible objects compared with the reference. CloVR (2024), Eq. 1–2.

use std::collections::BTreeMap;

use rayon::prelude::*;

/// Pixels compared at once; a block with several objects is counted pixel by pixel.
const BLOCK: usize = 32;
const SUBBLOCK: usize = 4;
/// Pixels per task.
const PIXELS_PER_TASK: usize = 1 << 14;
/// Objects with smaller numbers are counted in an array.
const DENSE: usize = 1 << 20;

/// Returns the fraction of the reference's objects that are visible (OVC), and the mean fraction of each object's
/// pixels that are visible (OFC); `None` if the reference shows no object. Negative numbers stand for no object.
pub fn object_completion(reference: &[i32], test: &[i32]) -> Option<(f64, f64)> {
    let (expected, visible_counts) = rayon::join(|| PixelCounts::new(reference), || PixelCounts::new(test));
    let (mut objects, mut visible, mut fraction_sum) = (0u64, 0u64, 0.0);
    for (object, pixels) in expected.iter() {
        let visible_pixels = visible_counts.get(object);
        objects += 1;
        visible += u64::from(visible_pixels > 0);
        fraction_sum += visible_pixels.min(pixels) as f64 / pixels as f64;
    }
    (objects > 0).then(|| (visible as f64 / objects as f64, fraction_sum / objects as f64))
}

/// Pixel count of each object.
#[derive(Default)]
struct PixelCounts {
    /// Counts by object number.
    dense: Vec<u64>,
    /// Counts of objects with numbers too large for an array.
    sparse: BTreeMap<usize, u64>,
}

/// A run of pixels with the same object.
struct Run {
    id: i32,
    pixels: u64,
}

impl Run {
    /// Extends the run if all pixels have its object.
    #[inline(always)]
    fn try_extend<const COUNT: usize>(&mut self, ids: &[i32; COUNT]) -> bool {
        let is_same = ids.iter().fold(0, |differs, id| differs | (id ^ self.id)) == 0;
        self.pixels += if is_same { COUNT as u64 } else { 0 };
        is_same
    }
}

impl PixelCounts {
    fn new(ids: &[i32]) -> Self {
        // One array of counts per thread, because creating and adding arrays costs as much as counting. Integer sums
        // do not depend on the partition.
        let chunk_length = ids.len().div_ceil(rayon::current_num_threads()).max(PIXELS_PER_TASK);
        ids.par_chunks(chunk_length).map(|ids| Self::default().count(ids)).reduce(Self::default, Self::merge)
    }

    /// Adds pixels run by run, because most pixels show the same object as their neighbour.
    fn count(mut self, ids: &[i32]) -> Self {
        let (blocks, remainder) = ids.as_chunks::<BLOCK>();
        let mut run = Run { id: -1, pixels: 0 };
        for block in blocks {
            if run.try_extend(block) {
                continue;
            }
            for part in block.as_chunks::<SUBBLOCK>().0 {
                if !run.try_extend(part) {
                    part.iter().for_each(|&id| self.add_pixel(&mut run, id));
                }
            }
        }
        remainder.iter().for_each(|&id| self.add_pixel(&mut run, id));
        self.add(run.id, run.pixels);
        self
    }

    fn add_pixel(&mut self, run: &mut Run, id: i32) {
        if id != run.id {
            self.add(run.id, run.pixels);
            *run = Run { id, pixels: 0 };
        }
        run.pixels += 1;
    }

    fn add(&mut self, object: i32, pixels: u64) {
        let Ok(object) = usize::try_from(object) else { return };
        if object >= DENSE {
            *self.sparse.entry(object).or_default() += pixels;
            return;
        }
        if object >= self.dense.len() {
            self.dense.resize((object + 1).next_power_of_two(), 0);
        }
        self.dense[object] += pixels;
    }

    fn merge(mut self, mut other: Self) -> Self {
        if self.dense.len() < other.dense.len() {
            std::mem::swap(&mut self.dense, &mut other.dense);
        }
        self.dense.iter_mut().zip(&other.dense).for_each(|(sum, pixels)| *sum += pixels);
        for (object, pixels) in other.sparse {
            *self.sparse.entry(object).or_default() += pixels;
        }
        self
    }

    fn get(&self, object: usize) -> u64 {
        let dense = self.dense.get(object).copied();
        dense.or_else(|| self.sparse.get(&object).copied()).unwrap_or(0)
    }

    /// Returns the objects with pixels, in order, and their counts.
    fn iter(&self) -> impl Iterator<Item = (usize, u64)> + '_ {
        let dense = self.dense.iter().copied().enumerate().filter(|&(_, pixels)| pixels > 0);
        dense.chain(self.sparse.iter().map(|(&object, &pixels)| (object, pixels)))
    }
}
