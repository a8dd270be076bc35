//! Warp mesh of a headset's runtime: exact at its vertices, linear between them.

use super::polynomial::{derivative, range};
use super::radial::RadialLens;
use super::warp::WarpView;
use crate::base::{Error, Progress, Result};

/// Maximum number of intervals into which a cell's range of radii is divided.
const PARTS: f64 = 16.0;

/// Grid over the target picture, the output of the warp.
#[derive(Clone, Debug)]
pub struct WarpMesh {
    /// Positions in the target picture as fractions from its top left corner, row by row.
    pub places: Vec<[f64; 2]>,
    /// For each lens, positions in the source picture as fractions.
    pub sources: Vec<Vec<[f64; 2]>>,
    /// Two triangles for each cell within the lens's reach, counter-clockwise with y up.
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
    let at = |n: usize| (n % (columns + 1), n / (columns + 1));
    let count = (columns + 1) * (rows + 1);
    let places: Vec<[f64; 2]> =
        (0..count).map(at).map(|(i, j)| [i as f64 / columns as f64, j as f64 / rows as f64]).collect();
    let seen: Vec<[f64; 2]> = places.iter().map(|[x, y]| view.place(*x, *y)).collect();
    let mut sources = Vec::new();
    for lens in lenses {
        let mut of = vec![[0.0; 2]; count];
        view.sources(lens, &seen, &mut of, progress)?;
        sources.push(of.into_iter().map(|source| view.share(source)).collect::<Vec<_>>());
    }
    let density = view.density(&view.from, width, height);
    let (mut faces, mut error) = (Vec::new(), 0.0f64);
    for cell in 0..columns * rows {
        if cell % columns == 0 {
            progress.check()?;
        }
        let first = cell / columns * (columns + 1) + cell % columns;
        let corners = [first, first + 1, first + columns + 1, first + columns + 2];
        if corners.iter().any(|&n| sources.iter().any(|of| of[n][0].is_nan())) {
            continue;
        }
        let [a, b, c, d] = corners.map(|n| n as u32);
        faces.extend([[a, c, b], [b, c, d]]);
        for (lens, of) in lenses.iter().zip(&sources) {
            let bend = lens.bend_of_cell(view, corners.map(|n| seen[n]));
            let off = [bend * density[0], bend * density[1]];
            if shows(corners.map(|n| of[n]), [off[0] / width as f64, off[1] / height as f64]) {
                error = error.max(off[0].max(off[1]));
            }
        }
    }
    if faces.is_empty() {
        return Err(Error::value("fov", "a field of view within the fold of the lens", "one beyond it"));
    }
    Ok(WarpMesh { places, sources, faces, error })
}

/// Returns whether a cell may show a part of the picture if its positions are wrong by up to `off`.
fn shows(corners: [[f64; 2]; 4], off: [f64; 2]) -> bool {
    (0..2).all(|axis| {
        let ends = corners.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), corner| {
            (low.min(corner[axis]), high.max(corner[axis]))
        });
        ends.0 - off[axis] <= 1.0 && ends.1 + off[axis] >= 0.0
    })
}

impl RadialLens {
    /// Returns an upper bound of the error in a cell's triangles, in units of the lens.
    ///
    /// The error of linear interpolation on a triangle is at most R²/2 times the maximum second derivative along any
    /// line, with R the circumradius (Waldron 1998). The diagonal of a cell is 2R.
    fn bend_of_cell(&self, view: &WarpView, [a, b, c, d]: [[f64; 2]; 4]) -> f64 {
        let length = |[x, y]: [f64; 2]| x.hypot(y);
        let diagonal = length([a[0] - d[0], a[1] - d[1]]);
        let high = [a, b, c, d].map(length).into_iter().fold(0.0, f64::max);
        // Coordinates of the cell's point nearest to the axis.
        let near = |from: f64, to: f64| if from.min(to) > 0.0 { from.min(to) } else { -from.max(to).min(0.0) };
        let low = near(a[0], d[0]).hypot(near(a[1], d[1]));
        // Polynomial ranges are tight only on short intervals.
        let parts = (PARTS * (high - low) / high).ceil().clamp(1.0, PARTS);
        let radius = |n: usize| low + (high - low) * (n as f64 / parts);
        let bends = (0..parts as usize).map(|n| {
            let (low, high) = (radius(n), radius(n + 1));
            if view.distort { self.bend_back(low, high) } else { self.bend(low, high) }
        });
        diagonal * diagonal / 8.0 * bends.fold(0.0, f64::max)
    }

    /// Returns the maximum second derivative along lines of p ↦ p f(|p|)/|p| plus the tangential terms, between two
    /// radii.
    fn bend(&self, low: f64, high: f64) -> f64 {
        let [a, b] = self.curvatures(low, high);
        greatest(a, b) + 6.0 * self.tangential[0].hypot(self.tangential[1])
    }

    /// Returns the same bound for the inverse map, between two distorted radii.
    fn bend_back(&self, low: f64, high: f64) -> f64 {
        let p = self.tangential[0].hypot(self.tangential[1]);
        if p > 0.0 {
            // The tangential terms move images by up to 3|p|r². Within reach f′ > 6|p|r, so both functions below
            // increase with r.
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
        let (scale, other) = (slope.max(0.0).powi(-3), 1.0 / (slope.max(0.0) * factor * factor));
        greatest([a[0].min(0.0) * scale, a[1].max(0.0) * scale], [b[0].min(0.0) * other, b[1].max(0.0) * other])
    }

    /// Returns two close radii within reach between which a function that increases from 0 passes a value.
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
        let mut f = vec![0.0; 2 * self.radial.k.len() + 2];
        let mut around = f.clone();
        f[1] = 1.0;
        for (n, c) in self.radial.k.iter().enumerate() {
            f[2 * n + 3] = *c;
            around[2 * n + 1] = (2 * n + 2) as f64 * c;
        }
        [derivative(&derivative(&f)), around].map(|each| range(&each, low, high).into())
    }

    /// Returns the minimum f′ and the minimum f/r between two radii.
    fn least_slopes(&self, low: f64, high: f64) -> [f64; 2] {
        let mut factor = vec![1.0];
        factor.extend(&self.radial.k);
        [&self.radial.slope, &factor].map(|each| range(each, low * low, high * high).0)
    }
}

/// Returns the maximum length of the second derivative along lines at an angle to the radius with squared cosine c.
/// Its radial part is A c + B (1−c), its tangential part 2 √(c (1−c)) B, for A and B in ranges. Its square is convex
/// in A and in B, so the ends of the ranges suffice.
fn greatest(a: [f64; 2], b: [f64; 2]) -> f64 {
    let square = |a: f64, b: f64, c: f64| (b + (a - b) * c).powi(2) + 4.0 * c * (1.0 - c) * b * b;
    let mut most = 0.0f64;
    for a in a {
        for b in b {
            let flat = -(b * (a - b) + 2.0 * b * b) / ((a - b).powi(2) - 4.0 * b * b);
            let places = [0.0, 1.0, if flat > 0.0 && flat < 1.0 { flat } else { 0.0 }];
            most = places.iter().fold(most, |most, &c| most.max(square(a, b, c)));
        }
    }
    most.sqrt()
}
