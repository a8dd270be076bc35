//! How far neighbours in the true picture are torn apart. Popescu, Lee, Choi, Fahmy (2022), Eq. 5–6:
//! with p₀ the place of a pixel's scene point in the truth, and N_p the pixels q ≠ p with |p₀(q) − p₀(p)| < ε,
//! δ(p) = mean over N_p of |p − q| / |p₀(p) − p₀(q)| − 1.

use glam::{DVec2, DVec3, Vec3};
use rayon::prelude::*;

use crate::base::simd::widest;
use crate::base::{Error, Progress, Result};
use crate::camera::Camera;

/// Which pixels are compared.
#[derive(Clone, Copy, Debug)]
pub struct Neighbourhood {
    /// ε: pixels of the truth within which points are neighbours.
    pub epsilon: f64,
    /// Distances in the truth below this, its resolution, are raised to it. Pixels.
    pub least: f64,
}

/// Bands of points for each ε: narrower ones hold fewer points that are too far away, wider ones are fewer.
const BANDS: f64 = 2.0;
/// Points side by side.
const LANES: usize = 16;
/// Points that one task takes.
const TILE: usize = 512;

/// Points by where they are in the truth: in bands of y, each in order of x. A place is the pixel plus its shift, which
/// is held apart: float32 alone would be off by 1e-4 of a pixel, and the truth itself would not be whole.
#[derive(Default)]
struct Points {
    x: Vec<f32>,
    y: Vec<f32>,
    shift_x: Vec<f32>,
    shift_y: Vec<f32>,
    /// In the truth, for the search alone.
    truth_x: Vec<f32>,
    band: Vec<i32>,
    pixel: Vec<u32>,
    /// First point of each band that has any.
    bands: Vec<(i32, usize)>,
}

/// δ for each pixel of a frame, rows of `width`; NaN for pixels without a surface, behind the truth's camera, or without
/// neighbours. Positions are relative to `origin`.
pub fn discontinuity(
    position: &[[f32; 3]],
    origin: DVec3,
    width: usize,
    truth: &Camera,
    neighbourhood: Neighbourhood,
    progress: &Progress,
) -> Result<Vec<f32>> {
    let Neighbourhood { epsilon, least } = neighbourhood;
    for (argument, value) in [("epsilon", epsilon), ("min_distance", least)] {
        if !(value.is_finite() && value > 0.0 && value <= 1e4) {
            return Err(Error::value(argument, "a positive number of pixels up to 10,000", value));
        }
    }
    if u32::try_from(position.len()).is_err() || width == 0 {
        return Err(Error::value("frame", "fewer than 2³² pixels", position.len()));
    }
    let points = Points::new(position, origin, width, truth, epsilon);
    progress.expect(points.x.len() as u64);
    let mut deltas = vec![f32::NAN; points.x.len()];
    deltas.par_chunks_mut(TILE).enumerate().try_for_each(|(tile, out)| {
        for (n, out) in out.iter_mut().enumerate() {
            *out = points.delta(tile * TILE + n, neighbourhood);
        }
        progress.report(out.len() as u64)
    })?;
    let mut image = vec![f32::NAN; position.len()];
    for (&pixel, &delta) in points.pixel.iter().zip(&deltas) {
        image[pixel as usize] = delta;
    }
    Ok(image)
}

impl Points {
    fn new(position: &[[f32; 3]], origin: DVec3, width: usize, truth: &Camera, epsilon: f64) -> Self {
        let place = |(pixel, at): (usize, &[f32; 3])| {
            let point = Vec3::from_array(*at).as_dvec3() + origin;
            let there = truth.project(point).filter(|there| there.is_finite())?.truncate();
            // Beyond this float32 has no pixels left, and no neighbours are near.
            let is_near = there.abs().max_element() < 1e7;
            is_near.then_some((pixel, there))
        };
        let mut places: Vec<(usize, DVec2)> = position.par_iter().enumerate().filter_map(place).collect();
        let band = |there: DVec2| (there.y * BANDS / epsilon).floor() as i32;
        places.par_sort_unstable_by(|a, b| {
            (band(a.1), a.1.x).partial_cmp(&(band(b.1), b.1.x)).unwrap_or(std::cmp::Ordering::Equal).then(a.0.cmp(&b.0))
        });
        let mut points = Self::default();
        for (n, &(pixel, there)) in places.iter().enumerate() {
            let here = DVec2::new((pixel % width) as f64 + 0.5, (pixel / width) as f64 + 0.5);
            points.x.push(here.x as f32);
            points.y.push(here.y as f32);
            points.shift_x.push((there.x - here.x) as f32);
            points.shift_y.push((there.y - here.y) as f32);
            points.truth_x.push(there.x as f32);
            points.pixel.push(pixel as u32);
            let band = band(there);
            points.band.push(band);
            if points.bands.last().is_none_or(|&(last, _)| last != band) {
                points.bands.push((band, n));
            }
        }
        points
    }

    /// δ of one point.
    fn delta(&self, n: usize, Neighbourhood { epsilon, least }: Neighbourhood) -> f32 {
        let reach = BANDS as i32;
        let low = self.bands.partition_point(|&(band, _)| band < self.band[n] - reach);
        let mut sums = Sums::default();
        for (at, &(band, first)) in self.bands.iter().enumerate().skip(low) {
            if band > self.band[n] + reach {
                break;
            }
            let end = self.bands.get(at + 1).map_or(self.x.len(), |&(_, next)| next);
            // A rounding more than float32's, so that no neighbour is left out here.
            let margin = (epsilon * (1.0 + 1e-6) + 1e-6 * f64::from(self.truth_x[n]).abs()) as f32;
            let row = &self.truth_x[first..end];
            let from = first + row.partition_point(|&x| x < self.truth_x[n] - margin);
            let to = first + row.partition_point(|&x| x <= self.truth_x[n] + margin);
            let limits = [epsilon * epsilon, least * least].map(|limit| limit as f32);
            let of = [self.x[n], self.y[n], self.shift_x[n], self.shift_y[n]];
            let others = [&self.x[from..to], &self.y[from..to], &self.shift_x[from..to], &self.shift_y[from..to]];
            add_neighbours(of, others, limits, &mut sums);
        }
        let count: f32 = sums.count.iter().sum();
        if count == 0.0 {
            return f32::NAN;
        }
        let sum: f64 = sums.excess.iter().map(|&lane| f64::from(lane)).sum();
        (sum / f64::from(count)) as f32
    }
}

/// Sums over neighbours, lane by lane.
#[derive(Default)]
struct Sums {
    /// Of |p − q| / |p₀(p) − p₀(q)| − 1.
    excess: [f32; LANES],
    count: [f32; LANES],
}

widest! {
    fn add_neighbours(of: [f32; 4], others: [&[f32]; 4], limits: [f32; 2], sums: &mut Sums) = kernel;
}

#[inline(always)]
fn kernel(of: [f32; 4], others: [&[f32]; 4], limits: [f32; 2], sums: &mut Sums) {
    let length = others[0].len();
    let whole = length / LANES * LANES;
    let load = |from: usize| others.map(|values| std::array::from_fn(|lane| values[from + lane]));
    for from in (0..whole).step_by(LANES) {
        block(of, &load(from), limits, sums);
    }
    if whole < length {
        // What fills up the last block is the point itself, which is no neighbour.
        let rest =
            std::array::from_fn(|i| std::array::from_fn(|lane| others[i].get(whole + lane).copied().unwrap_or(of[i])));
        block(of, &rest, limits, sums);
    }
}

#[inline(always)]
#[expect(clippy::needless_range_loop, reason = "a loop over lanes of fixed number becomes vector instructions")]
fn block(of: [f32; 4], others: &[[f32; LANES]; 4], [farthest, least]: [f32; 2], sums: &mut Sums) {
    for lane in 0..LANES {
        let (x, y) = (others[0][lane] - of[0], others[1][lane] - of[1]);
        let (u, v) = (x + (others[2][lane] - of[2]), y + (others[3][lane] - of[3]));
        let (shown, truth) = (x * x + y * y, u * u + v * v);
        let raised = if truth > least { truth } else { least };
        let excess = (shown / raised).sqrt() - 1.0;
        let counts = (truth < farthest) & (shown > 0.0);
        sums.excess[lane] += if counts { excess } else { 0.0 };
        sums.count[lane] += if counts { 1.0 } else { 0.0 };
    }
}
