//! View frustum as half-spaces.

use glam::{DVec3, DVec4};

use crate::camera::Camera;

/// Position of a box relative to a frustum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Outside,
    Across,
    Inside,
}

/// Half-spaces n·x + d ≥ 0 of a picture's sides and of the camera plane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frustum([DVec4; 5]);

impl Frustum {
    pub fn new(camera: &Camera) -> Self {
        let (width, height) = (f64::from(camera.width), f64::from(camera.height));
        let corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)].map(|(x, y)| camera.ray(x, y));
        let (start, middle) = camera.ray(width / 2.0, height / 2.0);
        let inside = camera.position + start + middle;
        let plane = |normal: DVec3, through: DVec3| {
            let unit = normal.normalize();
            let unit = if unit.dot(inside - through) < 0.0 { -unit } else { unit };
            unit.extend(-unit.dot(through))
        };
        let side = |n: usize| {
            let ((from, along), (to, other)) = (corners[n], corners[(n + 1) % 4]);
            // Two rays of one side, from one point or, for parallel rays, side by side.
            let across = if camera.is_parallel() { to - from } else { other };
            plane(along.cross(across), camera.position + from)
        };
        // Normal of the camera plane, from two steps in the picture.
        let [first, right, _, down] = corners.map(|(start, direction)| start + direction);
        let before = plane((right - first).cross(down - first), camera.position + start);
        Self([side(0), side(1), side(2), side(3), before])
    }

    /// Returns whether a cube lies outside one half-space, inside all of them, or across.
    pub fn side(&self, center: DVec3, side: f64) -> Side {
        let mut found = Side::Inside;
        for plane in &self.0 {
            let distance = plane.truncate().dot(center) + plane.w;
            let reach = plane.truncate().abs().element_sum() * side / 2.0;
            if distance < -reach {
                return Side::Outside;
            }
            if distance < reach {
                found = Side::Across;
            }
        }
        found
    }
}
