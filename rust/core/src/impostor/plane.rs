//! Planes over a cube face, and the interval of depths that keeps a texel within the error bound.

use glam::DVec3;

use crate::camera::{along_face, direction_from_face};

/// A plane as a linear function over a cube face: w = a + b u + c v, where w is the inverse of the depth along the
/// face's axis and (u, v) is the position on the face, −1 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane(pub [f64; 3]);

impl Plane {
    /// Returns the plane of constant depth.
    pub fn frontal(w: f64) -> Self {
        Self([w, 0.0, 0.0])
    }

    /// Returns the plane through a point relative to the layer's centre; `None` if the centre lies on it.
    pub fn through(face: u8, point: DVec3, normal: DVec3) -> Option<Self> {
        let distance = normal.dot(point);
        let (right, down, outward) = along_face(face, normal);
        let plane = Self([outward / distance, right / distance, down / distance]);
        plane.0.iter().all(|x| x.is_finite()).then_some(plane)
    }

    /// Returns the inverse depth at a position on the face.
    #[inline]
    pub fn w(&self, u: f64, v: f64) -> f64 {
        self.0[0] + self.0[1] * u + self.0[2] * v
    }

    /// Returns the unit normal.
    pub fn normal(&self, face: u8) -> DVec3 {
        // w = 1/depth makes the plane a x + b right + c down = 1 in the face's frame.
        let [a, b, c] = self.0;
        let axis = direction_from_face(face, 0.0, 0.0);
        let (right, down) = (direction_from_face(face, 1.0, 0.0) - axis, direction_from_face(face, 0.0, 1.0) - axis);
        (axis * a + right * b + down * c).normalize_or_zero()
    }
}

/// Error bound of one layer. A point P that the layer's centre C sees at the distance t may be shown at another distance
/// t′ on the same ray if no user within `reach` of O sees both farther apart than `angle`. With h the user's distance
/// from the ray, the sine of that angle is |P − P′| h / (|U−P| |U−P′|). Here h ≤ k = reach + |C−O|, |U−P| ≥ |P−O| − reach,
/// and |U−P′| is at least the greater of |P−O| − |P − P′| − reach and t′ − k.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    center: DVec3,
    eye: DVec3,
    reach: f64,
    angle: f64,
    /// Greatest distance of a user from the layer's centre.
    k: f64,
}

impl Bound {
    /// Creates the bound of a layer baked from `center`, for users within `reach` metres of `eye` (O).
    pub fn new(center: DVec3, eye: DVec3, reach: f64, angle: f64) -> Self {
        Self { center, eye, reach, angle: angle.sin(), k: reach + center.distance(eye) }
    }

    /// Returns the least and greatest distance from the centre at which the point at distance t in a unit direction may
    /// be shown.
    pub fn distances(&self, direction: DVec3, t: f64) -> [f64; 2] {
        let margin = (self.center + direction * t).distance(self.eye) - self.reach;
        if margin <= 0.0 {
            return [t, t];
        }
        // Solutions of s k = angle margin (margin − s) and s k = angle margin (t − k ± s) for s = |P − P′|.
        let slack = self.angle * margin;
        let both = slack * margin / (self.k + slack);
        let nearer = (slack * (t - self.k) / (self.k + slack)).max(both);
        let farther = match self.k - slack {
            rest if rest <= 0.0 && t > self.k => f64::INFINITY,
            rest => (slack * (t - self.k) / rest).max(both),
        };
        [t - nearer.min(t), t + farther]
    }
}
