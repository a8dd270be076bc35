//! Axis-aligned boxes in float32, the precision of the geometry that they enclose.

use glam::{DAffine3, DVec3, Vec3};

/// Maximum absolute coordinate of geometry and of ray origins, metres from the scene's origin. Beyond it, a distance
/// divided by a small direction component overflows float32, and a ray would hit empty slots of the trees.
pub const MAX_COORDINATE: f64 = 1e30;

/// An axis-aligned box; empty while `min > max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// Minimum corner.
    pub min: Vec3,
    /// Maximum corner.
    pub max: Vec3,
}

impl Aabb {
    /// The empty box.
    pub const EMPTY: Self = Self { min: Vec3::INFINITY, max: Vec3::NEG_INFINITY };

    /// Returns the smallest box that contains some points.
    pub fn of_points(points: impl IntoIterator<Item = Vec3>) -> Self {
        let mut bounds = Self::EMPTY;
        points.into_iter().for_each(|point| bounds.extend(point));
        bounds
    }

    /// Returns whether the box is empty.
    pub fn is_empty(&self) -> bool {
        self.min.x > self.max.x
    }

    /// Maximum absolute coordinate; 0 for the empty box.
    pub fn max_coordinate(&self) -> f32 {
        if self.is_empty() { 0.0 } else { self.min.abs().max(self.max.abs()).max_element() }
    }

    /// Extends the box to contain a point.
    #[inline]
    pub fn extend(&mut self, point: Vec3) {
        self.min = self.min.min(point);
        self.max = self.max.max(point);
    }

    /// The smallest box that contains both boxes.
    pub fn union(&self, other: &Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Rounds a float64 box inwards to float32. Both boxes contain the same float32 points. Along an axis where no
    /// float32 number lies between the float64 sides, the result has `min > max`.
    pub fn from_f64_inside(min: DVec3, max: DVec3) -> Self {
        Self { min: round_up(min), max: round_down(max) }
    }

    /// Returns whether the boxes share a point, sides included. An empty box shares none with a finite box.
    pub fn touches(&self, other: &Self) -> bool {
        self.min.cmple(other.max).all() && self.max.cmpge(other.min).all()
    }

    /// Returns whether another box lies inside this one; an empty box does.
    pub fn contains(&self, other: &Self) -> bool {
        other.is_empty() || (self.min.cmple(other.min).all() && self.max.cmpge(other.max).all())
    }

    /// Returns the smallest float32 box around the transformed box. It fits the transformed geometry tightly only if
    /// the transform maps axes to axes.
    pub fn transformed(&self, map: &DAffine3) -> Self {
        if self.is_empty() {
            return Self::EMPTY;
        }
        let (low, high) = (self.min.as_dvec3(), self.max.as_dvec3());
        let center = map.transform_point3((low + high) * 0.5);
        let half = (high - low) * 0.5;
        let m = &map.matrix3;
        let extent = m.x_axis.abs() * half.x + m.y_axis.abs() * half.y + m.z_axis.abs() * half.z;
        Self { min: round_down(center - extent), max: round_up(center + extent) }
    }
}

fn round_down(v: DVec3) -> Vec3 {
    let near = v.as_vec3();
    Vec3::from_array(std::array::from_fn(|i| if f64::from(near[i]) > v[i] { near[i].next_down() } else { near[i] }))
}

fn round_up(v: DVec3) -> Vec3 {
    -round_down(-v)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rotated_box_contains_its_rotated_corners() {
        let unit = Aabb { min: Vec3::splat(-1.0), max: Vec3::ONE };
        let map = DAffine3::from_rotation_y(0.7) * DAffine3::from_translation(DVec3::new(1e4, 0.1, -3.3));
        let image = unit.transformed(&map);
        for corner in 0..8 {
            let sign = |bit: u32| if corner >> bit & 1 == 1 { 1.0 } else { -1.0 };
            let p = map.transform_point3(DVec3::new(sign(0), sign(1), sign(2)));
            // One float64 rounding at 10⁴ is 2e-12; the box was widened by a float32 step, which is far larger.
            assert!((p - image.min.as_dvec3()).min_element() >= -2e-12);
            assert!((image.max.as_dvec3() - p).min_element() >= -2e-12);
        }
    }
}
