//! Texels touched by a cone of directions, exact to rounding, face by face and row by row.
//!
//! A cone with axis d and half angle r < 90° meets the plane of a face in a convex region bounded by a conic section.
//! Within a row of texels the region extends from a minimum to a maximum u. These extremes lie on the two edges of the
//! row, or where a plane through the face's v axis touches the cone.

use std::f64::consts::FRAC_PI_2;

use glam::DVec3;

use crate::camera::along_face;

/// Added to the squared sine, so that no texel is lost to rounding: a few units of 2.2e-16 in products of numbers below
/// 2. This widens the cone by half the margin divided by the half angle, at most by 6.4e-8 rad.
const MARGIN: f64 = 4e-15;

/// Minimum squared cosine, for 90° − 1e-15 rad. A cosine of 0 would divide by zero for axes parallel to a face.
const MIN_COSINE_SQUARED: f64 = 1e-30;

/// All directions within an angle of an axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cone {
    axis: DVec3,
    sine: f64,
    cosine_squared: f64,
}

/// Consecutive rows of a face.
#[derive(Debug, Default)]
pub(super) struct ConeRows {
    pub first: usize,
    /// First column and end of the columns that the cone touches in each row.
    pub columns: Vec<(usize, usize)>,
}

impl Cone {
    /// Creates a cone around a direction (finite, not zero). `radius` is its half angle, at least 0 and below 90°.
    pub fn new(d: DVec3, radius: f64) -> Self {
        // Scaled first, so that the length does not overflow.
        let axis = (d / d.abs().max_element()).normalize();
        let sine = (radius.sin().powi(2) + MARGIN).min(1.0).sqrt();
        Self { axis, sine, cosine_squared: (radius.cos().powi(2) - MARGIN).max(MIN_COSINE_SQUARED) }
    }

    /// Finds the texels of a face that the cone touches.
    pub fn touch(&self, face: u8, size: u32, rows: &mut ConeRows) {
        rows.columns.clear();
        let (right, down, out) = along_face(face, self.axis);
        // The planes through the centre and the face's edges have normals of length √2.
        let beyond = std::f64::consts::SQRT_2 * self.sine;
        if right.abs() - out > beyond || down.abs() - out > beyond {
            return;
        }
        let section = Section { right, down, out, squares: right * right - self.cosine_squared, cone: *self };
        let (Some(tall), Some(wide)) = (self.extent(down, right, out), self.extent(right, down, out)) else { return };
        let count = f64::from(size);
        let index = |position: f64| ((position + 1.0) * 0.5 * count).floor().clamp(0.0, count) as usize;
        rows.first = index(tall[0].0);
        let last = (index(tall[1].0) + 1).min(size as usize);
        let edge = |row: usize| 2.0 * row as f64 / count - 1.0;
        let mut above = section.interval(edge(rows.first));
        for row in rows.first..last {
            let below = section.interval(edge(row + 1));
            let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
            for (from, to) in above.into_iter().chain(below) {
                (low, high) = (low.min(from), high.max(to));
            }
            for (position, position_across) in wide {
                if (edge(row)..=edge(row + 1)).contains(&position_across) {
                    (low, high) = (low.min(position), high.max(position));
                }
            }
            let columns = if low <= high && low <= 1.0 && high >= -1.0 {
                (index(low), (index(high) + 1).min(size as usize))
            } else {
                (0, 0)
            };
            rows.columns.push(columns);
            above = below;
        }
    }

    /// Returns the cone's minimum and maximum position along one axis of a face, each with its position along the other
    /// axis; `None` if the cone lies behind the face. The arguments are the components of the cone's axis along these
    /// two axes and out of the face.
    fn extent(&self, along: f64, across: f64, out: f64) -> Option<[(f64, f64); 2]> {
        // along² + out² − sin², without cancellation near 90°, where both the sum and sin² are 1.
        let remainder = self.cosine_squared - across * across;
        if remainder <= 0.0 {
            // The cone contains the other axis.
            return Some([(f64::NEG_INFINITY, f64::NAN), (f64::INFINITY, f64::NAN)]);
        }
        let remainder = remainder.sqrt();
        let (middle, half) = (along.atan2(out), self.sine.atan2(remainder));
        if middle - half >= FRAC_PI_2 || middle + half <= -FRAC_PI_2 {
            return None;
        }
        let position = |angle: f64| {
            if angle.abs() < FRAC_PI_2 {
                (angle.tan(), across / (remainder * angle.cos()))
            } else {
                (f64::INFINITY.copysign(angle), f64::NAN)
            }
        };
        Some([position(middle - half), position(middle + half)])
    }
}

/// A cone in the frame of a face.
struct Section {
    right: f64,
    down: f64,
    out: f64,
    /// right² − cos².
    squares: f64,
    cone: Cone,
}

impl Section {
    /// Returns the interval of u inside the cone on a line of constant v. There (right u + k)² ≥ cos² (u² + w) and
    /// right u + k > 0, with k = down v + out and w = v² + 1.
    fn interval(&self, v: f64) -> Option<(f64, f64)> {
        let (k, w) = (self.down * v + self.out, v * v + 1.0);
        let (a, b) = (self.squares, self.right * k);
        let discriminant = k * k + w * a;
        // For a = 0 the conic is a parabola, which contains points of the line only for k > 0.
        if discriminant < 0.0 || (a == 0.0 && k <= 0.0) {
            return None;
        }
        let root = (self.cone.cosine_squared * discriminant).sqrt();
        // Both terms of q have equal signs, so nothing cancels. The other root follows from the product of the roots.
        let q = -(b + root.copysign(b));
        // If the line only touches the border, both roots are 0.
        let (first, second) = if q == 0.0 { (0.0, 0.0) } else { (q / a, (k * k - self.cone.cosine_squared * w) / q) };
        let (low, high) = if first < second { (first, second) } else { (second, first) };
        match (a < 0.0, self.right > 0.0) {
            (true, _) => (k > 0.0).then_some((low, high)),
            (false, true) => Some((high, f64::INFINITY)),
            (false, false) => Some((f64::NEG_INFINITY, low)),
        }
    }
}
