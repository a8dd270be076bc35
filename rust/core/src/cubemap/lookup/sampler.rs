//! Look-ups of blocks of directions in a cube map or a flat picture. Vector kernels process directions inside the
//! picture; directions at seams are processed one by one.

use glam::DVec3;

use super::super::faces::is_known;
use super::blocks::{self, BLOCK, BlockValues, Positions};
use super::chunks::process_blocks;
use crate::base::Real;

/// Rule that combines the texels around a direction into one value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TexelFilter {
    /// Seamless bilinear.
    Linear,
    /// Seamless bicubic.
    Cubic,
    /// Minimum of the texels that `Linear` would mix.
    Min,
    /// Maximum of the texels that `Linear` would mix.
    Max,
}

impl TexelFilter {
    /// Returns the number of texels that the filter reads before and after `Positions::first` along each axis.
    pub(in crate::cubemap) fn extent(self) -> [u32; 2] {
        if self == Self::Cubic { [1, 2] } else { [0, 1] }
    }
}

/// A panorama that a sampler can read.
pub(in crate::cubemap) trait SampledPicture<T> {
    /// Finds each direction's position between texels. Returns the number of directions that are zero or not finite.
    fn locate<D: Real>(&self, block: &[[D; 3]; BLOCK], filter_extent: [u32; 2], positions: &mut Positions) -> u32;

    /// Writes the value in one direction (finite, not zero). It must agree with the value of the block kernels.
    fn sample(&self, d: DVec3, filter: TexelFilter, out: &mut [T]);
}

/// Texels of a picture, and the filter that reads them.
pub(in crate::cubemap) struct Texels<'a, T> {
    values: &'a [T],
    /// Number of texels in a row.
    width: usize,
    pub(in crate::cubemap) channels: usize,
    pub(in crate::cubemap) filter: TexelFilter,
}

/// Sampler of one picture with one filter.
pub(in crate::cubemap) struct Sampler<'a, T, S> {
    pub(in crate::cubemap) texels: Texels<'a, T>,
    /// Whether the picture is large enough for directions whose filter crosses no edge.
    has_inside: bool,
    picture: S,
}

impl<'a, T: Real, S: SampledPicture<T>> Sampler<'a, T, S> {
    /// Creates a sampler of texels in rows of `width` texels. `edge` is the shorter side of a face or picture.
    pub(in crate::cubemap) fn new(
        (values, width, channels): (&'a [T], u32, usize),
        edge: u32,
        filter: TexelFilter,
        picture: S,
    ) -> Self {
        let [texels_before, texels_after] = filter.extent();
        let texels = Texels { values, width: width as usize, channels, filter };
        Self { texels, has_inside: edge > texels_before + texels_after, picture }
    }

    /// Writes the values in directions. Returns the index of the first direction that is zero or not finite.
    pub(in crate::cubemap) fn sample<D: Real>(&self, directions: &[[D; 3]], out: &mut [T]) -> Option<usize> {
        let mut positions = Positions::new();
        process_blocks(directions, out, self.texels.channels, |block, out| {
            let invalid_count = self.picture.locate(block, self.texels.filter.extent(), &mut positions);
            if invalid_count == 0 {
                if self.has_inside {
                    self.texels.sample_inside(&positions, out);
                }
                self.sample_seams(block, &positions.seam, out);
            }
            invalid_count
        })
    }

    /// Overwrites the values of directions at seams.
    fn sample_seams<D: Real>(&self, block: &[[D; 3]; BLOCK], seam: &BlockValues<u8>, out: &mut [T]) {
        for (eight, flags) in seam.0.as_chunks::<8>().0.iter().enumerate() {
            if u64::from_ne_bytes(*flags) == 0 {
                continue;
            }
            for lane in (0..8).filter(|&lane| flags[lane] != 0).map(|lane| 8 * eight + lane) {
                // The last block may be partly filled.
                let Some(values) = out.chunks_exact_mut(self.texels.channels).nth(lane) else { return };
                self.picture.sample(DVec3::from_array(block[lane].map(Real::wide)), self.texels.filter, values);
            }
        }
    }
}

// Shared by cube maps and flat pictures, so that the kernels are compiled once.
impl<T: Real> Texels<'_, T> {
    /// Writes the values of a block; those of directions at seams are undefined.
    fn sample_inside(&self, positions: &Positions, out: &mut [T]) {
        match (self.filter, self.channels) {
            (TexelFilter::Cubic, _) => self.sample_4x4(positions, out),
            (_, 1) => self.sample_2x2::<1>(positions, 0, out),
            (_, 3) => self.sample_2x2::<3>(positions, 0, out),
            (_, 4) => self.sample_2x2::<4>(positions, 0, out),
            (_, channels) => (0..channels).for_each(|channel| self.sample_2x2::<1>(positions, channel, out)),
        }
    }

    /// Combines the four texels around each direction: `COUNT` channels from `first` on.
    fn sample_2x2<const COUNT: usize>(&self, positions: &Positions, first: usize, out: &mut [T]) {
        let zero = T::narrow(0.0);
        let mut texels = [[BlockValues([zero; BLOCK]); 4]; COUNT];
        let below = self.width * self.channels;
        // Loops, because the compiler does not always inline iterator adapters here.
        for i in 0..BLOCK {
            let start = positions.first.0[i] as usize * self.channels + first;
            let above = &self.values[start..start + self.channels + COUNT];
            let under = &self.values[start + below..start + below + self.channels + COUNT];
            for channel in 0..COUNT {
                texels[channel][0].0[i] = above[channel];
                texels[channel][1].0[i] = above[self.channels + channel];
                texels[channel][2].0[i] = under[channel];
                texels[channel][3].0[i] = under[self.channels + channel];
            }
        }
        let mut weights = [BlockValues([0.0; BLOCK]); 4];
        blocks::bilinear(positions, &mut weights);
        let mut values = [BlockValues([zero; BLOCK]); COUNT];
        for (texels, values) in texels.iter().zip(&mut values) {
            match self.filter {
                TexelFilter::Min => blocks::least(texels, &weights, values),
                TexelFilter::Max => blocks::greatest(texels, &weights, values),
                _ => blocks::mix(texels, &weights, values),
            }
        }
        scatter(&values, first, self.channels, out);
    }

    /// Combines the 4 × 4 texels around each direction.
    fn sample_4x4(&self, positions: &Positions, out: &mut [T]) {
        let [mut across, mut down] = [[BlockValues([0.0; BLOCK]); 4]; 2];
        blocks::cubic(&positions.s, &mut across);
        blocks::cubic(&positions.t, &mut down);
        let mut texels = [BlockValues([T::narrow(0.0); BLOCK]); 4];
        for channel in 0..self.channels {
            let mut sums = BlockValues([0.0; BLOCK]);
            for (row, weights) in down.iter().enumerate() {
                for (i, &texel) in positions.first.0.iter().enumerate() {
                    // Inside the picture there is a row above the texel and a column to its left.
                    let start = (texel as usize + row * self.width - self.width - 1) * self.channels + channel;
                    let four = &self.values[start..start + 3 * self.channels + 1];
                    for (k, texels) in texels.iter_mut().enumerate() {
                        texels.0[i] = four[k * self.channels];
                    }
                }
                blocks::add_row(&texels, &across, weights, &mut sums);
            }
            scatter(&[BlockValues(sums.0.map(T::narrow))], channel, self.channels, out);
        }
    }
}

/// Returns the value that comes before all others: the minimum for `a < b`, the maximum for `a > b`; NaN values are
/// skipped, unless all are NaN.
pub(in crate::cubemap) fn extreme<T: Real>(values: impl Iterator<Item = T>, before: impl Fn(T, T) -> bool) -> T {
    let first = |best, value| if before(value, best) || !is_known(best) { value } else { best };
    values.fold(T::narrow(f64::NAN), first)
}

/// Writes `COUNT` channels from `first` on, for as many directions as `out` has room for.
fn scatter<T: Copy, const COUNT: usize>(
    values: &[BlockValues<T>; COUNT],
    first: usize,
    channels: usize,
    out: &mut [T],
) {
    if channels == 1 {
        let count = out.len();
        return out.copy_from_slice(&values[0].0[..count]);
    }
    if channels == COUNT {
        let texels = out.as_chunks_mut::<COUNT>().0;
        for i in 0..texels.len().min(BLOCK) {
            for channel in 0..COUNT {
                texels[i][channel] = values[channel].0[i];
            }
        }
        return;
    }
    for (i, texel) in out.chunks_exact_mut(channels).enumerate() {
        for (value, lanes) in texel[first..].iter_mut().zip(values) {
            *value = lanes.0[i];
        }
    }
}
