//! Least-squares affine map of a neighbourhood, and its residual.

use glam::{DMat2, DVec2};

use super::points::TruthPoints;
use crate::base::Real;

/// Neighbours summed per vector operation.
pub(super) const WIDE: usize = 8;
/// Relative spread across a line below which neighbours count as collinear, up to float32's rounding.
const THIN: f64 = 1e-9;

/// Sums over a pixel and its neighbours: positions in the truth, and shifts from there to the picture, both relative
/// to the pixel's own. An affine fit of the shifts has the same residual as one of the positions in the picture.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Moments {
    pub count: f64,
    /// Number of points on the far side of the border.
    pub side: f64,
    place: DVec2,
    shift: DVec2,
    /// u², uv, v² of positions.
    places: [f64; 3],
    /// |shift|².
    shifts: f64,
    /// Shifts times u, and times v.
    mixed: [DVec2; 2],
}

impl Moments {
    /// Returns the root-mean-square residual of the best affine map.
    pub fn residual(&self) -> f64 {
        let (place, shift) = (self.place / self.count, self.shift / self.count);
        let [uu, uv, vv] = self.places.map(|sum| sum / self.count);
        let covariance = DMat2::from_cols_array(&[
            uu - place.x * place.x,
            uv - place.x * place.y,
            uv - place.x * place.y,
            vv - place.y * place.y,
        ]);
        let variance = self.shifts / self.count - shift.length_squared();
        let [along_u, along_v] =
            [self.mixed[0] / self.count - place.x * shift, self.mixed[1] / self.count - place.y * shift];
        let explained: f64 = [DVec2::new(along_u.x, along_v.x), DVec2::new(along_u.y, along_v.y)]
            .map(|mixed| mixed.dot(solve(covariance, mixed)))
            .iter()
            .sum();
        (variance - explained).max(0.0).sqrt()
    }
}

/// Returns the minimum-norm x with S x = c; S is symmetric, and c lies in its range.
fn solve(covariance: DMat2, mixed: DVec2) -> DVec2 {
    let (trace, determinant) = (covariance.x_axis.x + covariance.y_axis.y, covariance.determinant());
    if trace <= 0.0 {
        return DVec2::ZERO;
    }
    if determinant > THIN * trace * trace {
        return covariance.inverse() * mixed;
    }
    // All points are collinear: S = trace · e eᵀ.
    mixed / trace
}

/// Moments per lane.
#[derive(Default)]
pub(super) struct LaneMoments {
    sums: [[f64; WIDE]; TERMS],
}

/// Number of terms: count, side, u, v, x, y, u², uv, v², x² + y², ux, uy, vx, vy, with (u, v) a position and (x, y) a
/// shift.
const TERMS: usize = 14;

impl LaneMoments {
    /// Adds those of the `few` points from `at` on whose squared distance from point `n` is below `farthest`.
    #[inline(always)]
    pub fn add<const FUSED: bool>(
        &mut self,
        points: &TruthPoints,
        sides: &[f32],
        [at, few, n]: [usize; 3],
        farthest: f32,
    ) {
        let lanes =
            [&points.x, &points.y, &points.shift_x, &points.shift_y].map(|values| values[at..].first_chunk::<WIDE>());
        let ([Some(x), Some(y), Some(shift_x), Some(shift_y)], Some(side)) = (lanes, sides[at..].first_chunk::<WIDE>())
        else {
            return;
        };
        let (own_x, own_y, own_shift) = (points.x[n], points.y[n], [points.shift_x[n], points.shift_y[n]]);
        for lane in 0..WIDE {
            let (moved_x, moved_y) = (shift_x[lane] - own_shift[0], shift_y[lane] - own_shift[1]);
            let (u, v) = ((x[lane] - own_x) + moved_x, (y[lane] - own_y) + moved_y);
            let counts = (f32::fuse::<FUSED>(u, u, v * v) < farthest) & (lane < few);
            let one = if counts { 1.0 } else { 0.0 };
            let [u, v, x, y] = [u, v, moved_x, moved_y].map(|value| if counts { f64::from(value) } else { 0.0 });
            let side = one * f64::from(side[lane]);
            let terms = [one, side, u, v, x, y, u * u, u * v, v * v, x * x + y * y, u * x, u * y, v * x, v * y];
            for (sum, term) in self.sums.iter_mut().zip(terms) {
                sum[lane] += term;
            }
        }
    }

    pub fn total(&self) -> Moments {
        let [count, side, u, v, x, y, uu, uv, vv, shifts, ux, uy, vx, vy] = self.sums.map(|lanes| lanes.iter().sum());
        Moments {
            count,
            side,
            place: DVec2::new(u, v),
            shift: DVec2::new(x, y),
            places: [uu, uv, vv],
            shifts,
            mixed: [DVec2::new(ux, uy), DVec2::new(vx, vy)],
        }
    }
}
