//! Images of a screen tile, computed from the keys of its samples.

use glam::{DVec3, Vec3};

use super::picture::PreparedPicture;
use super::projector::{Rect, float_of_bits};
use super::screen::{BEFORE, Key, Screen};
use super::splats::{Packed, Splats};
use crate::render::shade::{background, irradiance};
use crate::render::{Frame, Sample};
use crate::scene::srgb::linear_from_srgb;

/// Converter from keys to images.
pub(super) struct Resolver<'a> {
    prepared: &'a PreparedPicture<'a>,
    linear: &'static [f32; 256],
    /// Direction through the picture's corner, and its changes per sample to the right and down.
    directions: [Vec3; 3],
}

/// Cache of the last splat, which neighbouring samples often show, too.
#[derive(Clone, Copy)]
struct Last {
    number: u32,
    normal: Vec3,
    /// Colours on the side of the normal and on the other side.
    colors: [[f32; 3]; 2],
    /// Number of its view.
    view: usize,
}

/// Returns whether a normal points away from the viewer of a ray. Views can show insides, because a cell's side cuts
/// closed surfaces open.
fn faces_away(normal: Vec3, direction: Vec3) -> bool {
    normal.dot(direction) > 0.0
}

impl<'a> Resolver<'a> {
    pub fn new(prepared: &'a PreparedPicture<'a>) -> Self {
        let rays = prepared.camera.rays();
        let [right, down] = rays.direction_steps;
        let directions = [rays.direction, right, down].map(|direction| direction.as_vec3());
        Self { prepared, linear: linear_from_srgb(), directions }
    }

    /// Returns the initial key of a sample, from `before`.
    pub fn initial_key(&self, x: i32, y: i32) -> Key {
        let Some(before) = self.prepared.picture.before else { return Key::default() };
        let range = before.range[self.index(x, y)];
        if !range.is_finite() {
            return Key::default();
        }
        let distance = f64::from(range) / self.direction(x, y).length();
        Key::new(self.prepared.projector.nearness(distance) as f32, BEFORE)
    }

    fn index(&self, x: i32, y: i32) -> usize {
        y as usize * self.prepared.camera.width as usize + x as usize
    }

    /// Returns the ray direction through the centre of a sample, scaled so that W is 1.
    fn direction(&self, x: i32, y: i32) -> DVec3 {
        self.prepared.camera.ray(f64::from(x) + 0.5, f64::from(y) + 0.5).1
    }

    /// Same as `direction`, in float32.
    #[inline]
    fn direction_f32(&self, x: i32, y: i32) -> Vec3 {
        let [start, right, down] = self.directions;
        start + right * (x as f32 + 0.5) + down * (y as f32 + 0.5)
    }

    /// Computes the images of a tile of pixels.
    pub fn resolve(&self, screen: &Screen, tile: &Rect) -> Frame {
        let (mut frame, channels) = (Frame::default(), self.prepared.picture.channels);
        let (grid, mask) = (self.prepared.picture.grid as i32, self.prepared.picture.pixels.mask);
        let mut last = Last { number: BEFORE, normal: Vec3::ZERO, colors: [[0.0; 3]; 2], view: 0 };
        for (y, x) in (tile.low[1]..tile.high[1]).flat_map(|y| (tile.low[0]..tile.high[0]).map(move |x| (y, x))) {
            if mask.is_some_and(|mask| !mask[(y * self.prepared.picture.camera.width as i32 + x) as usize]) {
                frame.push(channels, [0.0; 3], 0.0, &Sample::default());
                continue;
            }
            let (mut color, mut coverage) = ([0.0; 3], 0.0);
            if channels.any_sampled() {
                for (row, column) in (0..grid).flat_map(|row| (0..grid).map(move |column| (row, column))) {
                    let sample = (x * grid + column, y * grid + row);
                    let (sample_color, covered) = self.sample_color(screen.key(sample.0, sample.1), sample, &mut last);
                    (0..3).for_each(|i| color[i] += sample_color[i]);
                    coverage += covered;
                }
                let per_sample = 1.0 / (grid * grid) as f32;
                color = color.map(|sum| sum * per_sample);
                coverage *= per_sample;
            }
            let middle = (x * grid + grid / 2, y * grid + grid / 2);
            let sample = if channels.any_surface() {
                self.sample(screen.key(middle.0, middle.1), middle)
            } else {
                Sample::default()
            };
            frame.push(channels, color, coverage, &sample);
        }
        frame
    }

    /// Returns colour and coverage of a sample.
    fn sample_color(&self, key: Key, (x, y): (i32, i32), last: &mut Last) -> ([f32; 3], f32) {
        let number = key.number();
        if number == BEFORE {
            return match self.prepared.picture.before {
                Some(before) if key != Key::default() => {
                    (before.color.get(self.index(x, y)).copied().unwrap_or_default(), 1.0)
                }
                _ if self.prepared.picture.pixels.bare => ([0.0; 3], 0.0),
                _ => (background(self.direction_f32(x, y).normalize()), 0.0),
            };
        }
        if number != last.number {
            let view = self.view(number, last.view);
            let (splats, texel) = self.splat(number, view);
            let (albedo, normal) = (self.albedo(texel), splats.normal(texel));
            let lit = |light: [f32; 3]| std::array::from_fn(|i| albedo[i] * light[i]);
            *last = Last { number, normal, colors: [lit(irradiance(normal)), lit(irradiance(-normal))], view };
        }
        (last.colors[usize::from(faces_away(last.normal, self.direction_f32(x, y)))], 1.0)
    }

    /// Adds the colours of `before` to a pixel, for the samples whose bits are set.
    pub fn add_before(&self, color: &mut [f32; 3], [x, y]: [usize; 2], samples: u64) {
        let Some(before) = self.prepared.picture.before else { return };
        let grid = self.prepared.picture.grid as usize;
        let per_sample = 1.0 / (grid * grid) as f32;
        for sample in (0..grid * grid).filter(|sample| samples >> sample & 1 == 1) {
            let index = self.index((x * grid + sample % grid) as i32, (y * grid + sample / grid) as i32);
            let sample_color = before.color.get(index).copied().unwrap_or_default();
            (0..3).for_each(|i| color[i] += sample_color[i] * per_sample);
        }
    }

    /// Returns the channels at the centre of a pixel.
    pub fn sample(&self, key: Key, (x, y): (i32, i32)) -> Sample {
        let number = key.number();
        if number == BEFORE {
            return match self.prepared.picture.before {
                Some(before) if key != Key::default() => before.sample(self.index(x, y)),
                _ => Sample::default(),
            };
        }
        let (splats, texel) = self.splat(number, self.view(number, 0));
        let distance = self.prepared.projector.distance(f64::from(float_of_bits(key.order())));
        let (start, direction) = self.prepared.camera.ray(f64::from(x) + 0.5, f64::from(y) + 0.5);
        let place = self.prepared.camera.position + start + direction * distance - self.prepared.picture.origin;
        let normal = splats.normal(texel);
        let normal = if faces_away(normal, self.direction_f32(x, y)) { -normal } else { normal }.to_array();
        Sample {
            range: (direction.length() * distance) as f32,
            position: place.as_vec3().to_array(),
            normal,
            shading_normal: normal,
            albedo: self.albedo(texel),
            ..Sample::default()
        }
    }

    /// Returns the number of the view that contains a splat; tries `last` first.
    fn view(&self, number: u32, last: usize) -> usize {
        let view = &self.prepared.views[last];
        if (view.first..view.first + view.splats.count() as u32).contains(&number) {
            return last;
        }
        self.prepared.views.partition_point(|view| view.first <= number) - 1
    }

    fn splat(&self, number: u32, view: usize) -> (&'a Splats, Packed) {
        let view = &self.prepared.views[view];
        (view.splats, view.splats.texels[(number - view.first) as usize])
    }

    fn albedo(&self, texel: Packed) -> [f32; 3] {
        texel.color().map(|code| self.linear[usize::from(code)])
    }
}
