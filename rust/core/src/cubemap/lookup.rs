//! Values of a cube map along many directions.

use std::sync::atomic::{AtomicUsize, Ordering};

use glam::DVec3;
use rayon::prelude::*;

use super::{MAX_SIZE, Taps, direction_from_texel, texel_from_direction};
use crate::base::{Error, Result};

/// Directions handled by one task.
const TILE: usize = 1 << 13;

/// How texels around a direction become one value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Filter {
    /// The texel that the direction passes through.
    Nearest,
    /// Seamless bilinear.
    Linear,
    /// The least of the texels that `Linear` would mix.
    Min,
    /// The greatest of the texels that `Linear` would mix.
    Max,
}

/// Float32 or float64.
pub trait Real: Copy + PartialOrd + Send + Sync {
    /// Widens exactly.
    fn to_f64(self) -> f64;
    /// Rounds once.
    fn from_f64(value: f64) -> Self;
}

impl Real for f32 {
    #[inline(always)]
    fn to_f64(self) -> f64 {
        f64::from(self)
    }
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        value as f32
    }
}

impl Real for f64 {
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self
    }
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        value
    }
}

/// Six faces of `size`² texels of `channels` values each.
#[derive(Clone, Copy)]
pub struct Faces<'a, T> {
    values: &'a [T],
    size: u32,
    channels: usize,
}

impl<'a, T: Real> Faces<'a, T> {
    /// Checks that the values fill the faces.
    pub fn new(values: &'a [T], size: u32, channels: usize) -> Result<Self> {
        check_size(size)?;
        let expected = 6 * size as usize * size as usize * channels;
        if values.len() != expected {
            return Err(Error::value("faces", format!("{expected} values for size {size}"), values.len()));
        }
        Ok(Self { values, size, channels })
    }

    #[inline]
    fn texel(&self, number: u32) -> &'a [T] {
        &self.values[number as usize * self.channels..][..self.channels]
    }

    /// Writes the value along one direction (finite, not zero).
    #[inline]
    fn sample(&self, d: DVec3, filter: Filter, out: &mut [T]) {
        if filter == Filter::Nearest {
            out.copy_from_slice(self.texel(texel_from_direction(d, self.size)));
            return;
        }
        let taps = Taps::new(d, self.size);
        let rows = taps.texel.map(|number| self.texel(number));
        for (channel, value) in out.iter_mut().enumerate() {
            let texels = rows.map(|row| row[channel]);
            *value = match filter {
                Filter::Min => extreme(texels, &taps, |a, b| a < b),
                Filter::Max => extreme(texels, &taps, |a, b| a > b),
                _ => mean(texels, &taps),
            };
        }
    }
}

/// Weighted mean. Texels without weight are left out, because 0 times infinity is NaN.
#[inline(always)]
fn mean<T: Real>(texels: [T; 4], taps: &Taps) -> T {
    let term = |i: usize| if taps.weight[i] > 0.0 { texels[i].to_f64() * taps.weight[i] } else { 0.0 };
    T::from_f64((term(0) + term(1)) + (term(2) + term(3)))
}

/// The texel that comes before all others that have weight.
#[inline(always)]
fn extreme<T: Real>(texels: [T; 4], taps: &Taps, before: impl Fn(T, T) -> bool) -> T {
    let (mut chosen, mut found) = (texels[0], taps.weight[0] > 0.0);
    for (&texel, &weight) in texels.iter().zip(&taps.weight).skip(1) {
        if weight > 0.0 && (!found || before(texel, chosen)) {
            (chosen, found) = (texel, true);
        }
    }
    chosen
}

/// The map's value along each direction of any length, `channels` values each. Fails at a direction that is zero or
/// not finite.
pub fn lookup<T: Real, D: Real>(
    faces: Faces<'_, T>,
    directions: &[[D; 3]],
    filter: Filter,
    out: &mut [T],
) -> Result<()> {
    if out.len() != directions.len() * faces.channels {
        return Err(Error::value("out", format!("{} values", directions.len() * faces.channels), out.len()));
    }
    if faces.channels == 0 {
        return check(directions);
    }
    let wrong = AtomicUsize::new(usize::MAX);
    out.par_chunks_mut(TILE * faces.channels).zip(directions.par_chunks(TILE)).enumerate().for_each(
        |(tile, (out, directions))| {
            for (i, (d, out)) in directions.iter().zip(out.chunks_exact_mut(faces.channels)).enumerate() {
                match direction(d) {
                    Some(d) => faces.sample(d, filter, out),
                    None => drop(wrong.fetch_min(tile * TILE + i, Ordering::Relaxed)),
                }
            }
        },
    );
    refuse(wrong.into_inner())
}

/// Number of the texel that each direction passes through: for maps of anything else than floats.
pub fn texels<D: Real>(size: u32, directions: &[[D; 3]]) -> Result<Vec<u32>> {
    check_size(size)?;
    check(directions)?;
    let texel = |d: &[D; 3]| texel_from_direction(DVec3::from_array(d.map(Real::to_f64)), size);
    Ok(directions.par_iter().with_min_len(TILE).map(texel).collect())
}

/// Directions of all texel centres in texel order; the longest component is ±1.
pub fn directions(size: u32) -> Result<Vec<[f64; 3]>> {
    check_size(size)?;
    let texels = (0..6 * size * size).into_par_iter().with_min_len(TILE);
    Ok(texels.map(|texel| direction_from_texel(texel, size).to_array()).collect())
}

#[inline]
fn direction<D: Real>(d: &[D; 3]) -> Option<DVec3> {
    let d = DVec3::from_array(d.map(Real::to_f64));
    (d.is_finite() && d != DVec3::ZERO).then_some(d)
}

fn check<D: Real>(directions: &[[D; 3]]) -> Result<()> {
    let wrong = directions.par_iter().with_min_len(TILE).position_first(|d| direction(d).is_none());
    refuse(wrong.unwrap_or(usize::MAX))
}

fn refuse(wrong: usize) -> Result<()> {
    if wrong == usize::MAX {
        return Ok(());
    }
    Err(Error::value("directions", "finite vectors other than zero", format!("something else at index {wrong}")))
}

fn check_size(size: u32) -> Result<()> {
    if (1..=MAX_SIZE).contains(&size) {
        return Ok(());
    }
    Err(Error::value("faces", format!("1 to {MAX_SIZE} texels across a face"), size))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn least_and_greatest_bracket_the_mean_and_infinity_stays_out_of_weightless_texels() {
        let size = 4;
        let values: Vec<f32> = (0..96).map(|i| if i == 5 { f32::INFINITY } else { i as f32 }).collect();
        let faces = Faces::new(&values, size, 1).unwrap();
        let directions: Vec<[f64; 3]> = (0..96).map(|t| direction_from_texel(t, size).to_array()).collect();
        let mut out = vec![0.0; 96];
        for filter in [Filter::Nearest, Filter::Min, Filter::Max] {
            lookup(faces, &directions, filter, &mut out).unwrap();
            // Powers of two: centres of inner texels are exact, so that no neighbour gets any weight.
            assert_eq!(out[5..7], values[5..7]);
        }
        // Face +x, between texels 5, 6, 9 and 10.
        let between = [[1.0, 0.01, 0.02f64]];
        let [mut least, mut mean, mut greatest] = [[0.0], [0.0], [0.0]];
        lookup(faces, &between, Filter::Min, &mut least).unwrap();
        lookup(faces, &between, Filter::Linear, &mut mean).unwrap();
        lookup(faces, &between, Filter::Max, &mut greatest).unwrap();
        assert_eq!((least, mean[0], greatest), ([6.0], f32::INFINITY, [f32::INFINITY]));
    }

    #[test]
    fn refuses_what_has_no_direction() {
        let values = [0.0f32; 6];
        let faces = Faces::new(&values, 1, 1).unwrap();
        let mut out = [0.0; 2];
        for wrong in [[0.0; 3], [f64::NAN, 1.0, 0.0], [f64::INFINITY, 0.0, 0.0]] {
            let error = lookup(faces, &[[1.0, 0.0, 0.0], wrong], Filter::Linear, &mut out).unwrap_err();
            assert!(error.to_string().contains("index 1"), "{error}");
            assert!(texels(1, &[wrong]).is_err());
        }
        assert!(Faces::new(&values, 0, 1).is_err() && Faces::new(&values, 2, 1).is_err());
        assert!(lookup(faces, &[[1.0; 3]], Filter::Linear, &mut out).is_err());
    }
}
