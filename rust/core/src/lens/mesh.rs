//! Warp mesh for a headset's runtime. It is exact at its vertices and linear between them.

use super::polynomial::{derivative, range};
use super::radial::RadialLens;
use super::warp::WarpView;
use crate::base::memory::{try_list, try_vec, try_with_capacity};
use crate::base::{Progress, Result, ensure};

/// Maximum number of intervals that a cell's range of radii is divided into.
const PARTS: f64 = 16.0;

/// Grid over the target picture, the output of the warp.
#[derive(Clone, Debug)]
pub struct WarpMesh {
    /// Positions in the target picture as fractions from its top left corner, row by row.
    pub places: Vec<[f64; 2]>,
    /// For each lens, positions in the source picture as fractions.
    pub sources: Vec<Vec<[f64; 2]>>,
    /// Two triangles for each cell within the reach of all lenses, counter-clockwise with y up.
    pub faces: Vec<[u32; 3]>,
    /// Upper bound of the error of a source position, in pixels of the source picture.
    pub error: f64,
}

/// Creates a mesh of `columns` × `rows` cells for a source picture of `width` × `height` pixels.
pub fn warp_mesh(
    lenses: &[RadialLens],
    view: &WarpView,
    [columns, rows]: [usize; 2],
    [width, height]: [usize; 2],
    progress: &Progress,
) -> Result<WarpMesh> {
    let (pitch, count) = (columns + 1, (columns + 1) * (rows + 1));
    let place = |n: usize| [(n % pitch) as f64 / columns as f64, (n / pitch) as f64 / rows as f64];
    let places = try_list((0..count).map(place))?;
    let points = try_list(places.iter().map(|[x, y]| view.lens_position(*x, *y)))?;
    let mut sources = Vec::new();
    for lens in lenses {
        let mut lens_sources = try_vec([0.0; 2], count)?;
        view.sources(lens, &points, &mut lens_sources, progress)?;
        lens_sources.iter_mut().for_each(|source| *source = view.source_fraction(*source));
        sources.push(lens_sources);
    }
    let density = view.density(&view.from, width, height);
    let (mut faces, mut error) = (try_with_capacity(2 * columns * rows)?, 0.0f64);
    for cell in 0..columns * rows {
        if cell % columns == 0 {
            progress.check()?;
        }
        let first = cell / columns * pitch + cell % columns;
        let corners = [first, first + 1, first + pitch, first + pitch + 1];
        if corners.iter().any(|&n| sources.iter().any(|lens_sources| lens_sources[n][0].is_nan())) {
            continue;
        }
        let [a, b, c, d] = corners.map(|n| n as u32);
        faces.extend([[a, c, b], [b, c, d]]);
        for (lens, lens_sources) in lenses.iter().zip(&sources) {
            let cell_error = lens.cell_error(view, corners.map(|n| points[n]));
            let bound = [cell_error * density[0], cell_error * density[1]];
            let fractions = [bound[0] / width as f64, bound[1] / height as f64];
            if may_show_source(corners.map(|n| lens_sources[n]), fractions) {
                error = error.max(bound[0].max(bound[1]));
            }
        }
    }
    ensure!(!faces.is_empty(), "fov", "a field of view within the fold of the lens", "one beyond the fold");
    Ok(WarpMesh { places, sources, faces, error })
}

/// Returns whether a cell may show a part of the source picture if its source positions have errors of up to `error`.
fn may_show_source(corners: [[f64; 2]; 4], error: [f64; 2]) -> bool {
    (0..2).all(|axis| {
        let positions = corners.map(|corner| corner[axis]);
        positions.iter().any(|x| x - error[axis] <= 1.0) && positions.iter().any(|x| x + error[axis] >= 0.0)
    })
}

impl RadialLens {
    /// Returns an upper bound of the interpolation error in a cell's triangles, in units of the lens.
    ///
    /// The error of linear interpolation on a triangle is at most R²/2 times the maximum second derivative along any
    /// line, with R the circumradius (Waldron 1998). The diagonal of a cell is 2R.
    fn cell_error(&self, view: &WarpView, [a, b, c, d]: [[f64; 2]; 4]) -> f64 {
        let length = |[x, y]: [f64; 2]| x.hypot(y);
        let diagonal = length([a[0] - d[0], a[1] - d[1]]);
        let high = [a, b, c, d].map(length).into_iter().fold(0.0, f64::max);
        // Returns a coordinate of the cell's point nearest to the axis.
        let near = |from: f64, to: f64| if from.min(to) > 0.0 { from.min(to) } else { -from.max(to).min(0.0) };
        let low = near(a[0], d[0]).hypot(near(a[1], d[1]));
        // Polynomial ranges are tight only on short intervals.
        let parts = (PARTS * (high - low) / high).ceil().clamp(1.0, PARTS);
        let radius = |n: usize| low + (high - low) * (n as f64 / parts);
        let bends = (0..parts as usize).map(|n| {
            let (low, high) = (radius(n), radius(n + 1));
            if view.distort { self.inverse_bend(low, high) } else { self.bend(low, high) }
        });
        diagonal * diagonal / 8.0 * bends.fold(0.0, f64::max)
    }

    /// Returns the maximum second derivative along lines, between two radii, of p f(|p|)/|p| plus the tangential terms.
    fn bend(&self, low: f64, high: f64) -> f64 {
        let [a, b] = self.curvatures(low, high);
        greatest(a, b) + 6.0 * self.tangential[0].hypot(self.tangential[1])
    }

    /// Returns the same maximum for the inverse map, between two distorted radii.
    fn inverse_bend(&self, low: f64, high: f64) -> f64 {
        let p = self.tangential[0].hypot(self.tangential[1]);
        if p > 0.0 {
            // The tangential terms move images by up to 3|p|r². As f′ > 6|p|r, both functions below increase.
            let low = self.radius_of(|r| self.distort(r) + 3.0 * p * r * r, low)[0];
            let high = self.radius_of(|r| self.distort(r) - 3.0 * p * r * r, high)[1];
            let [slope, factor] = self.least_slopes(low, high);
            // g″(d, d) = −J⁻¹ F″(J⁻¹d, J⁻¹d)
            return self.bend(low, high) / (slope.min(factor) - 6.0 * p * high).max(0.0).powi(3);
        }
        let (low, high) = (self.undistort(low) * (1.0 - 1e-14), self.undistort(high) * (1.0 + 1e-14));
        let [slope, factor] = self.least_slopes(low, high);
        // g″ = −f″/f′³, and (g′x − g)/x² = −(f′r − f)/r² / (f′ (f/r)²)
        let [a, b] = self.curvatures(low, high);
        let (radial_scale, scale) = (slope.max(0.0).powi(-3), 1.0 / (slope.max(0.0) * factor * factor));
        let [a, b] =
            [(a, radial_scale), (b, scale)].map(|([low, high], scale)| [low.min(0.0) * scale, high.max(0.0) * scale]);
        greatest(a, b)
    }

    /// Returns two close radii within reach between which a function that rises from 0 passes a value.
    fn radius_of(&self, rising: impl Fn(f64) -> f64, value: f64) -> [f64; 2] {
        let (mut low, mut high) = (0.0, value.min(self.reach));
        while high < self.reach && rising(high) < value {
            (low, high) = (high, (2.0 * high).min(self.reach));
        }
        while high - low > 1e-9 * high {
            let middle = 0.5 * (low + high);
            if rising(middle) < value { low = middle } else { high = middle }
        }
        [low, high]
    }

    /// Returns the ranges of f″ and (f′r − f)/r² between two radii.
    fn curvatures(&self, low: f64, high: f64) -> [[f64; 2]; 2] {
        let k = self.radial.k.iter().enumerate();
        let quotient: Vec<f64> = k.flat_map(|(n, c)| [0.0, (2 * n + 2) as f64 * c]).collect();
        let second = derivative(&derivative(&self.radial.coefficients()));
        [second, quotient].map(|polynomial| range(&polynomial, low, high).into())
    }

    /// Returns the minimum f′ and the minimum f/r between two radii.
    fn least_slopes(&self, low: f64, high: f64) -> [f64; 2] {
        [&self.radial.slope, &self.radial.factor()].map(|polynomial| range(polynomial, low * low, high * high).0)
    }
}

/// Returns the maximum length of the second derivative along lines, for A in range `a` and B in range `b`. Along a line
/// at an angle to the radius with squared cosine c, the radial part is A c + B (1−c), the tangential part
/// 2 √(c (1−c)) B. The squared length is convex in A and in B, so the ends of the ranges suffice.
fn greatest(a: [f64; 2], b: [f64; 2]) -> f64 {
    let square = |a: f64, b: f64, c: f64| (b + (a - b) * c).powi(2) + 4.0 * c * (1.0 - c) * b * b;
    let mut max_square = 0.0f64;
    for a in a {
        for b in b {
            let flat = -(b * (a - b) + 2.0 * b * b) / ((a - b).powi(2) - 4.0 * b * b);
            let candidates = [0.0, 1.0, if flat > 0.0 && flat < 1.0 { flat } else { 0.0 }];
            max_square = candidates.iter().fold(max_square, |max, &c| max.max(square(a, b, c)));
        }
    }
    max_square.sqrt()
}
