//! Pictures with the distances of their surfaces, and the reprojection of an earlier picture to the camera of a later
//! one. Points are homogeneous, so that they include the sky.

use glam::{DVec2, DVec3};
use rayon::prelude::*;

use crate::base::{Progress, Result, ensure};
use crate::camera::{Camera, Rays};
use crate::orthoview::splat::Projector;
use crate::render::temporal::cubic;

/// Linear RGB.
pub type Color = [f32; 3];

/// A picture with the distances of its surfaces.
#[derive(Clone, Copy, Debug)]
pub struct Image<'a> {
    /// Its camera.
    pub camera: &'a Camera,
    /// Linear RGB.
    pub color: &'a [Color],
    /// Distance from the camera, metres; +∞ for the sky.
    pub range: &'a [f32],
}

impl Image<'_> {
    pub(super) fn check(&self, name: &'static str) -> Result<()> {
        let count = self.camera.width as usize * self.camera.height as usize;
        for length in [self.color.len(), self.range.len()] {
            ensure!(length == count, name, format!("{count} pixels"), length);
        }
        Ok(())
    }
}

impl Projector {
    /// Evaluates the functions X, Y and W at the homogeneous point (`offset`, `inverse`): the point at
    /// `offset`/`inverse` from the eye, or the sky in the direction of `offset` if `inverse` is 0. Here W is 1 for
    /// parallel rays, so that the camera always shows a point at X/W, Y/W.
    pub(super) fn homogeneous(&self, offset: DVec3, inverse: f64) -> DVec3 {
        let [x, y, w] = self.derivative(offset);
        DVec3::new(x, y, if self.is_parallel { inverse } else { w })
    }

    /// Returns the distance of a point, given its offset from the eye; along the axis for parallel rays.
    pub(super) fn distance_of(&self, offset: DVec3) -> f64 {
        if self.is_parallel { self.rows[2].dot(offset) } else { offset.length() }
    }
}

/// Returns the image position X/W, Y/W in pixels; `None` behind the camera, and for the sky along parallel rays.
pub(super) fn image_position(point: DVec3) -> Option<DVec2> {
    (point.z > 0.0).then(|| point.truncate() / point.z)
}

/// Relative tolerance of the distances of one surface if pixel motion is given. Parallax is then no test, because
/// surfaces may move; a surface at another distance is a different one.
const SAME_DISTANCE: f64 = 0.02;
/// Maximum parallax in pixels at which two surfaces count as one.
const MAX_PARALLAX: f64 = 0.5;
/// Speed from which a surface fades at the full rate of moving ones, pixels per picture. Look-ups between pixels blur,
/// but hardly at a tenth of a pixel.
const MOVING: f64 = 0.1;
/// Minimum total weight of the agreeing taps around a position. A single tap reaches it only if it is the nearest.
const MIN_WEIGHT: f64 = 0.25;

/// Fade rate of colours: the time between two pictures divided by the time in which a difference falls to 1/e.
#[derive(Clone, Copy, Debug)]
pub struct Fade {
    /// Rate where the picture is still.
    pub still: f64,
    /// Rate where it moves.
    pub moving: f64,
}

impl Fade {
    /// Returns the exponent at a speed, pixels per picture. The exponent also limits the parallax in pixels at which
    /// two surfaces count as one, so the afterimage of a moving surface trails it by at most a pixel.
    fn exponent(&self, speed: f64) -> f64 {
        self.still + (self.moving - self.still) * (speed / MOVING).min(1.0)
    }
}

/// An earlier picture.
#[derive(Debug)]
pub struct Past<'a> {
    image: Image<'a>,
    projector: Projector,
    rays: Rays,
    /// 1/range of each pixel.
    inverse: Vec<f64>,
}

/// (origin, direction, inverse): the point at 1/inverse along a direction, from an origin relative to the earlier eye.
type PointOnRay = (DVec3, DVec3, f64);

/// Test whether a distance in the earlier picture agrees with the surface of a pixel of the later one.
enum Test {
    /// A surface at the inverse distance x would appear |e (x − s) / (a x + b)| pixels from the pixel. It agrees up to
    /// `max_parallax` pixels.
    Parallax { e: f64, s: f64, a: f64, b: f64, max_parallax: f64 },
    /// The inverse distance must be s.
    Distance { s: f64 },
}

impl Test {
    fn accepts(&self, inverse: f64) -> bool {
        match *self {
            Self::Parallax { e, s, a, b, max_parallax } => e * (inverse - s).abs() <= max_parallax * (a * inverse + b),
            Self::Distance { s } => (inverse - s).abs() <= SAME_DISTANCE * s,
        }
    }
}

impl<'a> Past<'a> {
    /// Prepares an earlier picture.
    pub fn new(image: Image<'a>) -> Result<Self> {
        image.check("past")?;
        let inverse = image.range.par_iter().map(|range| 1.0 / f64::from(*range)).collect();
        Ok(Self { image, projector: Projector::new(image.camera), rays: image.camera.rays(), inverse })
    }

    /// Blends a picture with this one where both show the same surface; elsewhere the picture stays.
    ///
    /// Each pixel's surface is looked up at its position in the earlier picture. The surface found there counts as the
    /// same if it would now appear near the pixel, even at another distance. `motion` has the pixels to the right and
    /// down by which surfaces have moved; with it, the distances must be equal. `agrees` receives whether the surfaces
    /// are the same.
    pub fn blend(
        &self,
        now: &Image<'_>,
        motion: Option<&[[f32; 2]]>,
        fade: Fade,
        mixed: &mut [Color],
        agrees: &mut [bool],
        progress: &Progress,
    ) -> Result<()> {
        now.check("now")?;
        let count = now.color.len();
        for (name, length) in
            [("motion", motion.map_or(count, <[_]>::len)), ("mixed", mixed.len()), ("agrees", agrees.len())]
        {
            ensure!(length == count, name, format!("{count} pixels"), length);
        }
        let (projector, rays) = (Projector::new(now.camera), now.camera.rays());
        let width = now.camera.width as usize;
        let rows = mixed.par_chunks_mut(width).zip(agrees.par_chunks_mut(width)).enumerate();
        rows.try_for_each(|(row, (mixed, agrees))| {
            for column in 0..width {
                let pixel = row * width + column;
                let position = DVec2::new(column as f64 + 0.5, row as f64 + 0.5);
                let (start, direction) = rays.ray(position.x, position.y);
                let point =
                    (now.camera.position + start - self.projector.eye, direction, 1.0 / f64::from(now.range[pixel]));
                let reprojection = match motion {
                    None => self.reproject(&projector, &fade, position, point),
                    Some(motion) => {
                        self.reproject_moved(position - DVec2::from_array(motion[pixel].map(f64::from)), point)
                    }
                };
                let before = reprojection.and_then(|(earlier, test)| Some((earlier, self.color(earlier, &test)?)));
                let color = now.color[pixel];
                agrees[column] = before.is_some();
                mixed[column] = before.map_or(color, |(earlier, before)| {
                    let weight = (-fade.exponent(position.distance(earlier))).exp() as f32;
                    std::array::from_fn(|i| color[i] + (before[i] - color[i]) * weight)
                });
            }
            progress.check()
        })
    }

    /// Returns where the earlier picture shows a point, and the test for the surface there. The later camera, `now`,
    /// shows the point at `position`.
    fn reproject(&self, now: &Projector, fade: &Fade, position: DVec2, point: PointOnRay) -> Option<(DVec2, Test)> {
        let (origin, direction, inverse) = point;
        let offset = origin * inverse + direction;
        let earlier = image_position(self.projector.homogeneous(offset, inverse))?;
        let distance = self.projector.distance_of(offset);
        let (start, toward) = if self.projector.is_parallel {
            let (start, toward) = self.rays.ray(earlier.x, earlier.y);
            (self.image.camera.position + start, toward)
        } else {
            (self.projector.eye, offset / distance)
        };
        let s = inverse / distance;
        // The later camera shows the point at 1/s from `start` at (A s + B)/(a s + b).
        let (start_point, direction_point) = (now.homogeneous(start - now.eye, 1.0), now.homogeneous(toward, 0.0));
        let e = (start_point.truncate() - position * start_point.z).length();
        let max_parallax = fade.exponent(position.distance(earlier)).min(MAX_PARALLAX);
        Some((earlier, Test::Parallax { e, s, a: start_point.z, b: direction_point.z, max_parallax }))
    }

    /// Same as `reproject`, for a point that was at `position` in the earlier picture.
    fn reproject_moved(&self, position: DVec2, (origin, direction, inverse): PointOnRay) -> Option<(DVec2, Test)> {
        let distance = self.projector.distance_of(origin * inverse + direction);
        position.is_finite().then_some((position, Test::Distance { s: inverse / distance }))
    }

    /// Returns the colour at a position from the agreeing pixels; `None` outside the picture and if too few agree.
    fn color(&self, position: DVec2, test: &Test) -> Option<Color> {
        let (width, height) = (self.image.camera.width as usize, self.image.camera.height as usize);
        let is_inside = (0.0..=width as f64).contains(&position.x) && (0.0..=height as f64).contains(&position.y);
        if !is_inside {
            return None;
        }
        let (columns, rows) = (Taps::new(position.x, width), Taps::new(position.y, height));
        let agrees = |i: usize, j: usize| test.accepts(self.inverse[rows.pixels[j] * width + columns.pixels[i]]);
        let pixel = |i: usize, j: usize| self.image.color[rows.pixels[j] * width + columns.pixels[i]];
        if (0..4).all(|j| (0..4).all(|i| agrees(i, j))) {
            let color = cubic(self.image.color, width, position.to_array());
            // Clamped, because a cubic overshoots at edges, and the overshoot would grow from picture to picture.
            let around = [pixel(1, 1), pixel(2, 1), pixel(1, 2), pixel(2, 2)];
            return Some(std::array::from_fn(|c| {
                let (low, high) = around
                    .iter()
                    .fold((f32::MAX, f32::MIN), |(low, high), color| (low.min(color[c]), high.max(color[c])));
                color[c].clamp(low, high)
            }));
        }
        let (mut sum, mut total) = ([0.0; 3], 0.0);
        for (i, j) in [(1, 1), (2, 1), (1, 2), (2, 2)] {
            if agrees(i, j) {
                let weight = columns.weight(i) * rows.weight(j);
                let color = pixel(i, j);
                (0..3).for_each(|c| sum[c] += f64::from(color[c]) * weight);
                total += weight;
            }
        }
        (total >= MIN_WEIGHT).then(|| sum.map(|value| (value / total) as f32))
    }
}

/// Four pixels around a coordinate; outside the picture its edge is repeated.
struct Taps {
    pixels: [usize; 4],
    /// Fraction of the way from the centre of the second to that of the third pixel.
    between: f64,
}

impl Taps {
    fn new(coordinate: f64, count: usize) -> Self {
        let first = (coordinate - 0.5).floor();
        let last = count as i64 - 1;
        let pixels = std::array::from_fn(|n| (first as i64 - 1 + n as i64).clamp(0, last) as usize);
        Self { pixels, between: coordinate - 0.5 - first }
    }

    /// Returns the weight of the second or the third pixel.
    fn weight(&self, tap: usize) -> f64 {
        if tap == 1 { 1.0 - self.between } else { self.between }
    }
}
