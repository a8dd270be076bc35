//! Base colour images, filtered in linear light.
//!
//! Williams: Pyramidal parametrics, 1983 (trilinear filtering). Level 0 is the original image in sRGB. Coarser levels
//! are means of linear light, computed on first use. Cut-out materials have coarser levels of their own, weighted by
//! alpha: otherwise the colour in the holes, often black, would darken distant leaves.

use std::sync::OnceLock;

use super::sampler::Sampler;
use super::srgb::{linear_from_srgb, srgb_from_linear};
use crate::base::memory::{room_for, room_for_values};
use crate::base::{Buffer, Progress, Result, ensure};

/// An sRGB image with linear alpha, row 0 on top, and its sampler.
#[derive(Debug)]
pub struct Texture {
    /// Width, texels.
    pub width: u32,
    /// Height, texels.
    pub height: u32,
    /// `width * height` texels, rows from the top.
    pub texels: Buffer<[u8; 4]>,
    /// Continuation beyond the sides, and filter of magnified texels.
    pub sampler: Sampler,
    /// Levels 1 and coarser, without and with weights by alpha.
    mips: [OnceLock<Vec<MipLevel>>; 2],
}

/// Bytes per texel while an image is halved: the image in float32, and at most three more of at most half the size.
const HALVING_BYTES: u64 = 16 + 3 * 8;
/// Same for an image of one column, which is copied twice before it is halved.
const COLUMN_HALVING_BYTES: u64 = 3 * 16 + 8;
/// Bytes per texel of a side while it is halved: a list of weights for every second texel, 32 bytes and an allocation
/// of at most 32.
const WEIGHT_BYTES: u64 = 32;

/// Weight of a transparent texel, which gives a coarser texel entirely in a hole a colour.
const MIN_WEIGHT: f32 = 1.0 / 1024.0;

/// A coarser level: linear RGB in steps of 1/65535, which is a twentieth of sRGB's smallest step.
#[derive(Debug)]
pub struct MipLevel {
    /// Width, texels.
    pub width: u32,
    /// Height, texels.
    pub height: u32,
    /// Texels, rows from the top.
    pub texels: Vec<[u16; 3]>,
}

impl Texture {
    /// Creates a texture that repeats; checks that the texels fill the image.
    pub fn new(width: u32, height: u32, texels: Buffer<[u8; 4]>) -> Result<Self> {
        let is_filled = width > 0 && height > 0 && texels.len() as u64 == u64::from(width) * u64::from(height);
        ensure!(is_filled, "texture", format!("{width} x {height} texels"), texels.len());
        Ok(Self { width, height, texels, sampler: Sampler::default(), mips: Default::default() })
    }

    /// Returns the texture with another sampler.
    pub fn with_sampler(self, sampler: Sampler) -> Self {
        Self { sampler, ..self }
    }

    /// Returns a copy that shares the texels, without coarser levels.
    pub(super) fn share(&self) -> Self {
        let (texels, mips) = (self.texels.clone(), Default::default());
        Self { width: self.width, height: self.height, texels, sampler: self.sampler, mips }
    }

    /// Returns whether another texture has the same size, texels and sampler.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        let has_same_size = self.width == other.width && self.height == other.height;
        let is_alike = has_same_size && self.sampler == other.sampler;
        is_alike && (self.texels.as_ptr() == other.texels.as_ptr() || *self.texels == *other.texels)
    }

    /// Returns the memory of the texels and of the levels built so far, bytes.
    pub fn bytes(&self) -> usize {
        let levels = self.mips.iter().filter_map(OnceLock::get).flatten();
        size_of_val(&self.texels[..]) + levels.map(|level| size_of_val(&level.texels[..])).sum::<usize>()
    }

    /// Returns the linear RGB at (u, v), v upwards: bilinear within a level, linear between levels. Level 0 and less is
    /// the image itself, without interpolation if the sampler is `nearest`. Each further level halves both sides;
    /// beyond the last level the colour is the image's mean. `cutout` weights the means by alpha.
    pub fn color(&self, uv: [f32; 2], level: f32, cutout: bool) -> [f32; 3] {
        // NaN becomes level 0, because `max` returns the other operand.
        let level = level.max(0.0);
        if level == 0.0 {
            return self.finest(uv, self.sampler.nearest);
        }
        let mips = self.coarser(cutout);
        let level = level.min(mips.len() as f32);
        let (finer, weight) = (level.floor() as usize, level.fract());
        let fine = if finer == 0 { self.finest(uv, false) } else { mips[finer - 1].color(uv, self.sampler) };
        if weight == 0.0 {
            return fine;
        }
        let coarse = mips[finer].color(uv, self.sampler);
        std::array::from_fn(|i| fine[i] + (coarse[i] - fine[i]) * weight)
    }

    /// Returns levels 1 and coarser, down to one texel; `cutout` weights their means by alpha.
    pub fn coarser(&self, cutout: bool) -> &[MipLevel] {
        self.mips[usize::from(cutout)].get_or_init(|| self.build(cutout))
    }

    /// Builds missing coarser levels, with `has_cutouts` those of both kinds. Fails if memory does not suffice.
    pub(super) fn build_coarser(&self, has_cutouts: bool, progress: &Progress) -> Result<()> {
        for cutout in [false, true].into_iter().take(1 + usize::from(has_cutouts)) {
            if self.mips[usize::from(cutout)].get().is_none() {
                progress.check()?;
                let coarser_texels = self.texel_count() - self.texels.len() as u64;
                let bytes = self.halving_bytes() + coarser_texels * size_of::<[u16; 3]>() as u64;
                room_for_values::<u8>(usize::try_from(bytes).unwrap_or(usize::MAX))?;
                self.coarser(cutout);
            }
        }
        Ok(())
    }

    /// Returns the number of texels of all levels, including the image.
    pub fn texel_count(&self) -> u64 {
        let (mut width, mut height) = (u64::from(self.width), u64::from(self.height));
        let mut sum = width * height;
        while width > 1 || height > 1 {
            (width, height) = ((width / 2).max(1), (height / 2).max(1));
            sum += width * height;
        }
        sum
    }

    /// Returns the bytes of temporary memory for halving the image.
    fn halving_bytes(&self) -> u64 {
        let bytes = if self.width == 1 { COLUMN_HALVING_BYTES } else { HALVING_BYTES };
        bytes * self.texels.len() as u64 + WEIGHT_BYTES * u64::from(self.width.max(self.height))
    }

    /// Returns alpha at (u, v), 0 to 1, in level 0 with the sampler's filter.
    pub fn alpha(&self, uv: [f32; 2]) -> f32 {
        let taps = self.sampler.taps(uv, self.width, self.height, self.sampler.nearest);
        taps.blend(|column, row| [f32::from(self.texel(column, row)[3])])[0] / 255.0
    }

    fn finest(&self, uv: [f32; 2], nearest: bool) -> [f32; 3] {
        let linear = linear_from_srgb();
        let taps = self.sampler.taps(uv, self.width, self.height, nearest);
        taps.blend(|column, row| {
            let [r, g, b, _] = self.texel(column, row);
            [r, g, b].map(|code| linear[usize::from(code)])
        })
    }

    #[inline]
    fn texel(&self, column: u32, row: u32) -> [u8; 4] {
        self.texels[row as usize * self.width as usize + column as usize]
    }

    /// Returns the image with both sides halved `times` times in linear light, to at least one texel. `cutout` weights
    /// colours by alpha and averages alpha. Otherwise alpha, which is not drawn, becomes 255.
    pub fn halved(&self, times: u32, cutout: bool, progress: &Progress) -> Result<Self> {
        room_for(self.halving_bytes())?;
        let (mut image, mut width, mut height) = (self.weighted(cutout), self.width, self.height);
        // A side has one texel after as many halvings as it has bits.
        for _ in 0..times.min(u32::BITS) {
            progress.check()?;
            (image, width, height) = halved(&image, width, height);
        }
        let stored = |&[r, g, b, weight]: &[f32; 4]| {
            let [r, g, b] = [r, g, b].map(|x| srgb_from_linear(x / weight));
            let alpha = if cutout { ((weight - MIN_WEIGHT) * 255.0 + 0.5) as u8 } else { u8::MAX };
            [r, g, b, alpha]
        };
        Ok(Self::new(width, height, image.iter().map(stored).collect())?.with_sampler(self.sampler))
    }

    /// Builds all levels down to one texel on the calling thread alone: if it waited inside rayon, it could run a task
    /// that waits for this texture.
    fn build(&self, cutout: bool) -> Vec<MipLevel> {
        let (mut image, mut width, mut height) = (self.weighted(cutout), self.width, self.height);
        let mut levels = Vec::new();
        while width > 1 || height > 1 {
            (image, width, height) = halved(&image, width, height);
            let stored = |&[r, g, b, weight]: &[f32; 4]| [r, g, b].map(|x| (x / weight * 65535.0 + 0.5) as u16);
            levels.push(MipLevel { width, height, texels: image.iter().map(stored).collect() });
        }
        levels
    }

    /// Returns the linear RGB times a weight, and the weight: alpha for `cutout`, otherwise 1.
    fn weighted(&self, cutout: bool) -> Vec<[f32; 4]> {
        let linear = linear_from_srgb();
        let weighted = |&[r, g, b, alpha]: &[u8; 4]| {
            let weight = if cutout { f32::from(alpha) / 255.0 + MIN_WEIGHT } else { 1.0 };
            let [r, g, b] = [r, g, b].map(|code| linear[usize::from(code)] * weight);
            [r, g, b, weight]
        };
        self.texels.iter().map(weighted).collect()
    }
}

impl MipLevel {
    fn color(&self, uv: [f32; 2], sampler: Sampler) -> [f32; 3] {
        let taps = sampler.taps(uv, self.width, self.height, false);
        let sum =
            taps.blend(|column, row| self.texels[row as usize * self.width as usize + column as usize].map(f32::from));
        sum.map(|x| x * (1.0 / 65535.0))
    }
}

/// Returns an image of half the width and height, at least one texel each, and its size.
fn halved(image: &[[f32; 4]], width: u32, height: u32) -> (Vec<[f32; 4]>, u32, u32) {
    let (half_width, half_height) = ((width / 2).max(1), (height / 2).max(1));
    let narrow = shrink(image, width, half_width);
    let low = shrink(&transpose(&narrow, half_width), height, half_height);
    (transpose(&low, half_height), half_width, half_height)
}

/// Resamples rows from `from` to `to` texels. A new texel is the mean over the old texels that it covers, so the
/// image's mean does not change.
fn shrink(image: &[[f32; 4]], from: u32, to: u32) -> Vec<[f32; 4]> {
    if from == to {
        return image.to_vec();
    }
    let ratio = f64::from(from) / f64::from(to);
    let weights: Vec<(usize, Vec<f32>)> = (0..to)
        .map(|texel| {
            let (start, end) = (f64::from(texel) * ratio, f64::from(texel + 1) * ratio);
            let (first, last) = (start.floor() as u32, (end.ceil() as u32).min(from));
            let part = |old: u32| (end.min(f64::from(old + 1)) - start.max(f64::from(old))).max(0.0) / ratio;
            (first as usize, (first..last).map(|old| part(old) as f32).collect())
        })
        .collect();
    let mut shrunk = Vec::with_capacity(image.len() / from as usize * to as usize);
    for row in image.chunks_exact(from as usize) {
        shrunk.extend(weights.iter().map(|(first, parts)| {
            let mut sum = [0.0; 4];
            for (texel, part) in row[*first..].iter().zip(parts) {
                (0..4).for_each(|i| sum[i] += texel[i] * part);
            }
            sum
        }));
    }
    shrunk
}

fn transpose(image: &[[f32; 4]], width: u32) -> Vec<[f32; 4]> {
    let (width, height) = (width as usize, image.len() / width as usize);
    (0..width).flat_map(|column| (0..height).map(move |row| image[row * width + column])).collect()
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::DVec3;

    use super::*;
    use crate::scene::{Alpha, Material, Scene};

    fn noise(width: u32, height: u32) -> Texture {
        let byte = |i: u32, channel: u64| crate::base::random::bits(1, u64::from(i), channel) as u8;
        let texels: Vec<_> = (0..width * height).map(|i| std::array::from_fn(|c| byte(i, c as u64))).collect();
        Texture::new(width, height, texels.into()).unwrap()
    }

    fn mean(texture: &Texture) -> [f64; 3] {
        let linear = linear_from_srgb();
        std::array::from_fn(|c| {
            let sum: f64 = texture.texels.iter().map(|t| f64::from(linear[usize::from(t[c])])).sum();
            sum / texture.texels.len() as f64
        })
    }

    #[test]
    fn every_level_keeps_the_mean() {
        for (width, height) in [(8, 8), (7, 5), (1, 9), (13, 1), (1, 1), (64, 3)] {
            let texture = noise(width, height);
            let expected = mean(&texture);
            for level in texture.build(false) {
                for c in 0..3 {
                    let sum: f64 = level.texels.iter().map(|t| f64::from(t[c]) / 65535.0).sum();
                    // At most half a step of 1/65535 per texel, and less from float32 sums (2e-7 each).
                    assert!((sum / level.texels.len() as f64 - expected[c]).abs() < 0.6 / 65535.0);
                }
            }
            let last = texture.color([0.3, 0.8], 99.0, false);
            (0..3).for_each(|c| assert!((f64::from(last[c]) - expected[c]).abs() < 0.6 / 65535.0));
        }
    }

    #[test]
    fn levels_are_built_before_shading_if_memory_is_limited() {
        let cutout = Material { alpha: Alpha::Mask { cutoff: 0.5 }, ..Material::default() };
        for (plain, kinds) in [(Material::default(), 1), (cutout, 2)] {
            let materials = vec![plain, Material { texture: Some(1), ..plain }];
            // The first texture is not used.
            for (width, height) in [(7, 5), (1, 9), (13, 1), (1, 1), (64, 3)] {
                let textures = Arc::new(vec![noise(width, height), noise(width, height)]);
                let scene = Scene::new(DVec3::ZERO, vec![], vec![], Arc::new(materials.clone()), textures).unwrap();
                let texels = (width * height) as usize;
                let build = |is_limited| {
                    scene.build_to_shade(&Progress::watching_memory(is_limited)).unwrap();
                    [0, 1].map(|n| scene.textures[n].bytes())
                };
                assert_eq!(build(false), [4 * texels; 2]);
                let coarser = scene.textures[1].texel_count() as usize - texels;
                assert_eq!(build(true), [4 * texels, 4 * texels + kinds * 6 * coarser]);
            }
        }
    }

    #[test]
    fn texel_centres_are_exact_and_v_points_up() {
        let texture = noise(3, 2);
        let linear = linear_from_srgb();
        for row in 0..2u32 {
            for column in 0..3u32 {
                let uv = [(column as f32 + 0.5) / 3.0 - 2.0, 1.0 - (row as f32 + 0.5) / 2.0 + 7.0];
                let texel = texture.texel(column, row);
                for c in 0..3 {
                    // Rounding of u at 7 periods gives neighbours a weight of up to 7 · 2⁻²³ · 3 texels.
                    assert!((texture.color(uv, -1.0, false)[c] - linear[usize::from(texel[c])]).abs() < 3e-6);
                }
                assert!((texture.alpha(uv) - f32::from(texel[3]) / 255.0).abs() < 3e-6);
            }
        }
    }

    #[test]
    fn only_the_magnified_image_is_unfiltered() {
        let nearest = Sampler { nearest: true, ..Sampler::default() };
        let (smooth, sharp) = (noise(4, 4), noise(4, 4).with_sampler(nearest));
        let (uv, linear) = ([0.49, 0.51], linear_from_srgb());
        let texel = sharp.texel(1, 1);
        assert_eq!(sharp.color(uv, -0.5, false), [0, 1, 2].map(|c| linear[usize::from(texel[c])]));
        assert_eq!(sharp.alpha(uv), f32::from(texel[3]) / 255.0);
        assert_ne!(sharp.color(uv, 0.0, false), smooth.color(uv, 0.0, false));
        assert_eq!(sharp.color(uv, 0.5, false), smooth.color(uv, 0.5, false));
        assert_eq!(sharp.halved(1, false, &Progress::new()).unwrap().sampler, nearest);
        assert!(!sharp.is_same(&smooth) && sharp.is_same(&sharp.share()));
    }

    #[test]
    fn levels_blend() {
        let texture = noise(16, 16);
        let uv = [0.37, 0.61];
        let [one, two, between] = [1.0, 2.0, 1.25].map(|level| texture.color(uv, level, false));
        (0..3).for_each(|c| assert!((between[c] - (0.75 * one[c] + 0.25 * two[c])).abs() < 1e-6));
        assert_eq!(texture.color(uv, f32::NAN, false), texture.color(uv, 0.0, false));
        assert_eq!(texture.color(uv, f32::INFINITY, false), texture.color(uv, 4.0, false));
    }

    #[test]
    fn holes_do_not_darken_leaves() {
        let texels: Vec<[u8; 4]> = (0..64).map(|i| if i % 3 == 0 { [0, 200, 0, 255] } else { [0, 0, 0, 0] }).collect();
        let texture = Texture::new(8, 8, texels.into()).unwrap();
        let leaf = linear_from_srgb()[200];
        let [plain, cutout] = [false, true].map(|cutout| texture.color([0.5, 0.5], 3.0, cutout)[1]);
        // A third of the texels is leaf. In the weighted mean, two transparent texels of weight 1/1024 each darken one
        // leaf texel of weight 1.
        assert!((plain - leaf * 22.0 / 64.0).abs() < 1e-4);
        assert!(cutout > 0.997 * leaf && cutout <= leaf);
    }

    #[test]
    fn halved_images_are_the_coarser_levels() {
        let texture = noise(12, 5);
        for cutout in [false, true] {
            for (times, level) in texture.build(cutout).iter().enumerate() {
                let halved = texture.halved(times as u32 + 1, cutout, &Progress::new()).unwrap();
                assert_eq!((halved.width, halved.height), (level.width, level.height));
                for (&[r, g, b, _], linear) in halved.texels.iter().zip(&level.texels) {
                    let expected = linear.map(|x| i32::from(srgb_from_linear(f32::from(x) / 65535.0)));
                    // The stored levels are rounded before they are encoded, so a code may differ by one.
                    (0..3).for_each(|i| assert!((i32::from([r, g, b][i]) - expected[i]).abs() <= 1));
                }
            }
            assert_eq!(texture.halved(99, cutout, &Progress::new()).unwrap().texels.len(), 1);
        }
    }

    #[test]
    fn halved_cutouts_keep_the_mean_of_alpha() {
        let texture = noise(8, 8);
        let halved = |cutout| texture.halved(2, cutout, &Progress::new()).unwrap();
        for (n, texel) in halved(true).texels.iter().enumerate() {
            let (row, column) = (n / 2 * 4, n % 2 * 4);
            let block = (0..16).map(|i| f32::from(texture.texel((column + i % 4) as u32, (row + i / 4) as u32)[3]));
            assert!((f32::from(texel[3]) - block.sum::<f32>() / 16.0).abs() < 0.51);
        }
        assert!(halved(false).texels.iter().all(|texel| texel[3] == 255));
    }
}
