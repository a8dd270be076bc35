//! Head pose: its axes, and the half-spaces of its views and depth range.

use glam::{DMat3, DQuat, DVec3, DVec4};

use super::rig::{Eye, Rig};
use crate::camera::Fov;

/// A head pose, and the range of depths from the plane of its eyes in which surfaces are drawn.
#[derive(Clone, Copy, Debug)]
pub struct Head {
    /// World position, metres.
    pub position: DVec3,
    /// Unit quaternion head→world.
    pub orientation: DQuat,
    /// Minimum depth, metres.
    pub near: f64,
    /// Maximum depth, metres; may be infinite.
    pub far: f64,
}

/// Head axes relative to an origin.
pub(super) struct Axes {
    turn: DMat3,
    head: DVec3,
    /// The middle between the eyes, in head axes.
    middle: DVec3,
}

impl Axes {
    pub fn new(rig: &Rig, origin: DVec3, head: &Head) -> Self {
        let (turn, position) = (DMat3::from_quat(head.orientation), head.position - origin);
        Self { turn, head: position, middle: rig.middle }
    }

    /// Converts a point in head axes to scene axes, relative to the scene's origin.
    pub fn to_scene(&self, point: DVec3) -> DVec3 {
        self.head + self.turn * point
    }

    /// Converts a world direction to head axes.
    pub fn to_head(&self, direction: DVec3) -> DVec3 {
        self.turn.transpose() * direction
    }

    /// Returns the half-space n·x + d ≥ 0 with a normal and a point of its plane in head axes.
    fn half_space(&self, normal: DVec3, through: DVec3) -> DVec4 {
        let normal = self.turn * normal;
        normal.extend(-normal.dot(self.to_scene(through)))
    }

    /// Returns the four sides of a view; the eye's position is in head axes.
    pub fn view(&self, eye: &Eye) -> [DVec4; 4] {
        let Fov { left, right, down, up } = eye.fov;
        let normals = [
            DVec3::new(1.0, 0.0, left),
            DVec3::new(-1.0, 0.0, -right),
            DVec3::new(0.0, 1.0, down),
            DVec3::new(0.0, -1.0, -up),
        ];
        normals.map(|normal| self.half_space(eye.orientation * normal, eye.position))
    }

    /// Returns the half-spaces between two depths from the plane of the eyes; the second depth may be infinite.
    pub fn slab(&self, from: f64, to: f64) -> Vec<DVec4> {
        let point_at = |depth: f64| self.middle - DVec3::new(0.0, 0.0, depth);
        let begin = self.half_space(DVec3::NEG_Z, point_at(from));
        if to.is_infinite() { vec![begin] } else { vec![begin, self.half_space(DVec3::Z, point_at(to))] }
    }
}
