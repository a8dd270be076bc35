//! Lookups of blocks of directions with one filter in one picture, cube or not: blocks inside, one by one at seams.

use glam::DVec3;

use super::blocks::{self, BLOCK, Inner, LEAST_WEIGHT, Lanes, Placed};
use super::convert::Picture;
use super::cubic::Rim;
use super::faces::{Faces, Number, is_known};
use super::flat;
use super::lookup::{Filter, in_blocks};
use super::taps::Taps;
use crate::base::{Real, Result};

/// Lookups in one picture with one filter.
pub(super) struct Sampler<'a, T> {
    values: &'a [T],
    /// Texels of a row.
    width: usize,
    channels: usize,
    filter: Filter,
    /// Whether there are directions for which the filter crosses no edge.
    has_inside: bool,
    whole: Whole<'a, T>,
}

/// What seams need to know.
enum Whole<'a, T> {
    Cube(Faces<'a, T>, Rim<'a, T>),
    Flat(Picture<'a, T>),
}

/// How many texels a filter reaches before and after the one above and to the left of a direction.
fn reach(filter: Filter) -> [u32; 2] {
    if filter == Filter::Cubic { [1, 2] } else { [0, 1] }
}

impl<'a, T: Number> Sampler<'a, T> {
    /// Prepares for about `count` lookups in a cube.
    pub fn cube(faces: Faces<'a, T>, filter: Filter, count: usize) -> Result<Self> {
        // What lies beyond edges is worth a table where more would be looked up than it holds.
        let many = filter == Filter::Cubic && count > (faces.size as usize).pow(2);
        let (values, width, channels) = (faces.values, faces.size as usize, faces.channels);
        let has_inside = faces.size > reach(filter)[0] + reach(filter)[1];
        let whole = Whole::Cube(faces, Rim::new(faces, many)?);
        Ok(Self { values, width, channels, filter, has_inside, whole })
    }

    /// Prepares for lookups in a layout without faces.
    pub fn flat(picture: Picture<'a, T>, filter: Filter) -> Self {
        let (values, width, channels) = (picture.values, picture.grid.width as usize, picture.channels);
        let has_inside = picture.grid.width.min(picture.grid.height) > reach(filter)[0] + reach(filter)[1];
        Self { values, width, channels, filter, has_inside, whole: Whole::Flat(picture) }
    }

    /// Writes values along directions; the index of the first one that is zero or not finite. Layouts without faces
    /// take it that there is none, and that lengths are moderate.
    pub fn sample<D: Number>(&self, directions: &[[D; 3]], out: &mut [T]) -> Option<usize> {
        let mut placed = Placed::new();
        in_blocks(directions, out, self.channels, |block, out| {
            let wrong = match &self.whole {
                Whole::Cube(faces, _) => {
                    let [before, after] = reach(self.filter);
                    D::find_places(block, faces.size, Inner::new(faces.size, before, after), &mut placed)
                }
                Whole::Flat(picture) => {
                    let mut wide = [[0.0; 3]; BLOCK];
                    for (wide, d) in wide.iter_mut().zip(block) {
                        *wide = d.map(Real::wide);
                    }
                    flat::find_places(&wide, picture.grid, reach(self.filter), &mut placed);
                    0
                }
            };
            if wrong == 0 {
                if self.has_inside {
                    self.inside(&placed, out);
                }
                self.at_seams(block, &placed.seam, out);
            }
            wrong
        })
    }

    /// Values of a block; those of directions at seams mean nothing.
    fn inside(&self, placed: &Placed, out: &mut [T]) {
        match (self.filter, self.channels) {
            (Filter::Cubic, _) => self.cubic(placed, out),
            (_, 1) => self.squares::<1>(placed, 0, out),
            (_, 3) => self.squares::<3>(placed, 0, out),
            (_, 4) => self.squares::<4>(placed, 0, out),
            (_, channels) => (0..channels).for_each(|channel| self.squares::<1>(placed, channel, out)),
        }
    }

    /// Mixes the four texels around each direction, `COUNT` channels of them from `first` on.
    fn squares<const COUNT: usize>(&self, placed: &Placed, first: usize, out: &mut [T]) {
        let zero = T::narrow(0.0);
        let mut texels = [[Lanes([zero; BLOCK]); 4]; COUNT];
        let below = self.width * self.channels;
        // Plain loops: adapters of iterators are not always inlined where it matters.
        for i in 0..BLOCK {
            let start = placed.first.0[i] as usize * self.channels + first;
            let above = &self.values[start..start + self.channels + COUNT];
            let under = &self.values[start + below..start + below + self.channels + COUNT];
            for channel in 0..COUNT {
                texels[channel][0].0[i] = above[channel];
                texels[channel][1].0[i] = above[self.channels + channel];
                texels[channel][2].0[i] = under[channel];
                texels[channel][3].0[i] = under[self.channels + channel];
            }
        }
        let weights = blocks::bilinear(placed);
        let mut values = [Lanes([zero; BLOCK]); COUNT];
        for (texels, values) in texels.iter().zip(&mut values) {
            match self.filter {
                Filter::Min => T::least(texels, &weights, values),
                Filter::Max => T::greatest(texels, &weights, values),
                _ => T::mix(texels, &weights, values),
            }
        }
        scatter(&values, first, self.channels, out);
    }

    /// Mixes the 4 × 4 texels around each direction.
    fn cubic(&self, placed: &Placed, out: &mut [T]) {
        let (across, down) = (blocks::cubic(&placed.s), blocks::cubic(&placed.t));
        let mut texels = [Lanes([T::narrow(0.0); BLOCK]); 4];
        for channel in 0..self.channels {
            let mut sums = Lanes([0.0; BLOCK]);
            for (row, weights) in down.iter().enumerate() {
                for (i, &texel) in placed.first.0.iter().enumerate() {
                    // Inside there are a row and a column before the texel.
                    let start = (texel as usize + row * self.width - self.width - 1) * self.channels + channel;
                    let four = &self.values[start..start + 3 * self.channels + 1];
                    for (k, texels) in texels.iter_mut().enumerate() {
                        texels.0[i] = four[k * self.channels];
                    }
                }
                T::add_row(&texels, &across, weights, &mut sums);
            }
            scatter(&[Lanes(sums.0.map(T::narrow))], channel, self.channels, out);
        }
    }

    fn at_seams<D: Real>(&self, block: &[[D; 3]; BLOCK], seam: &Lanes<u8>, out: &mut [T]) {
        for (eight, flags) in seam.0.as_chunks::<8>().0.iter().enumerate() {
            if u64::from_ne_bytes(*flags) == 0 {
                continue;
            }
            for lane in (0..8).filter(|&lane| flags[lane] != 0).map(|lane| 8 * eight + lane) {
                // Blocks at the end are not full.
                let Some(values) = out.chunks_exact_mut(self.channels).nth(lane) else { return };
                self.one(DVec3::from_array(block[lane].map(Real::wide)), values);
            }
        }
    }

    /// Writes the value along one direction (finite, not zero): what blocks must agree with.
    fn one(&self, d: DVec3, out: &mut [T]) {
        let faces = match &self.whole {
            Whole::Flat(picture) => return picture.sample(d, self.filter, out),
            Whole::Cube(_, rim) if self.filter == Filter::Cubic => return rim.sample(d, out),
            Whole::Cube(faces, _) => faces,
        };
        let taps = Taps::new(d, faces.size);
        let rows = taps.texel.map(|number| faces.texel(number));
        for (channel, value) in out.iter_mut().enumerate() {
            let texels = rows.map(|row| row[channel]);
            *value = match self.filter {
                Filter::Min => extreme(texels, &taps, |a, b| a < b),
                Filter::Max => extreme(texels, &taps, |a, b| a > b),
                _ => mean(texels, &taps),
            };
        }
    }
}

/// Weighted mean. Texels without weight are left out, because 0 times infinity is NaN.
fn mean<T: Real>(texels: [T; 4], taps: &Taps) -> T {
    let term = |i: usize| if taps.weight[i] > 0.0 { texels[i].wide() * taps.weight[i] } else { 0.0 };
    T::narrow((term(0) + term(1)) + (term(2) + term(3)))
}

/// The texel that comes before all others that have weight, NaN where all of these are.
fn extreme<T: Real>(texels: [T; 4], taps: &Taps, before: impl Fn(T, T) -> bool) -> T {
    let mut chosen = T::narrow(f64::NAN);
    for (&texel, &weight) in texels.iter().zip(&taps.weight) {
        if weight > LEAST_WEIGHT && (!is_known(chosen) || before(texel, chosen)) {
            chosen = texel;
        }
    }
    chosen
}

/// Writes channels from `first` on, of as many directions as `out` has room for.
fn scatter<T: Copy, const COUNT: usize>(values: &[Lanes<T>; COUNT], first: usize, channels: usize, out: &mut [T]) {
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
