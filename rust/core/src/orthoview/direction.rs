//! Canonical directions, and the axes of their views.

use glam::{DMat3, DQuat, DVec3, IVec3};

use crate::base::{Result, ensure};

/// A side from which a cell is seen: −1, 0 or 1 along each axis, not all 0. A view looks against it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Direction(IVec3);

/// Axes of a view as integer vectors, not normalised.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Right axis; horizontal, perpendicular to y.
    pub right: IVec3,
    /// Upwards in the picture.
    pub up: IVec3,
    /// Towards the viewer: the direction itself.
    pub toward: IVec3,
}

/// Returns the sum of a vector's absolute coordinates: a unit cube's extent along it, times the vector's length.
fn extent(axis: IVec3) -> i32 {
    axis.abs().element_sum()
}

fn unit(axis: IVec3) -> DVec3 {
    axis.as_dvec3().normalize()
}

impl Direction {
    /// Creates a direction from three numbers.
    pub fn new(numbers: [i8; 3]) -> Result<Self> {
        let vector = IVec3::from_array(numbers.map(i32::from));
        let is_direction = vector != IVec3::ZERO && vector.abs().max_element() <= 1;
        ensure!(is_direction, "directions", "−1, 0 or 1 along each axis, not all 0", format!("{numbers:?}"));
        Ok(Self(vector))
    }

    /// Returns the axes of its views: right = y × toward, or x for views along y, and up = toward × right.
    pub fn frame(self) -> Frame {
        let toward = self.0;
        let right = if toward.x == 0 && toward.z == 0 { IVec3::X } else { IVec3::new(toward.z, 0, -toward.x) };
        Frame { right, up: toward.cross(right), toward }
    }
}

impl Frame {
    /// Returns the extents of a unit cube to the right, upwards and towards the viewer.
    pub fn extents(&self) -> DVec3 {
        let extent_along = |axis: IVec3| f64::from(extent(axis)) / axis.as_dvec3().length();
        DVec3::new(extent_along(self.right), extent_along(self.up), extent_along(self.toward))
    }

    /// Returns the unit vectors to the right, upwards and towards the viewer.
    pub fn axes(&self) -> [DVec3; 3] {
        [unit(self.right), unit(self.up), unit(self.toward)]
    }

    /// Returns the orientation of a camera that looks against `toward`.
    pub fn orientation(&self) -> DQuat {
        let [right, up, toward] = self.axes();
        DQuat::from_mat3(&DMat3::from_cols(right, up, toward))
    }

    /// Returns column and row of a child's first pixel in the parent's picture of 2 size × 2 size pixels. The size
    /// must be a multiple of 4.
    pub fn place(&self, octant: IVec3, size: usize) -> (usize, usize) {
        let (size, doubled) = (size as i32, 2 * octant - IVec3::ONE);
        // In units of a child's side, the centres differ by doubled/2, that is by doubled · axis/(2 |axis|) along an
        // axis. `size` pixels cover the child's extent, which is extent(axis)/|axis|; |axis| cancels.
        let offset = |axis: IVec3| size * doubled.dot(axis) / (2 * extent(axis));
        ((size / 2 + offset(self.right)) as usize, (size / 2 - offset(self.up)) as usize)
    }

    /// Returns by how many depth steps a child's range begins behind the front of the parent's range. A child's range
    /// has `steps` steps.
    pub fn steps_before(&self, octant: IVec3, steps: u32) -> u32 {
        let parts = extent(self.toward);
        let before = parts - (2 * octant - IVec3::ONE).dot(self.toward);
        steps * before as u32 / (2 * parts as u32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns all 26 directions.
    pub fn all() -> Vec<Direction> {
        let numbers = (0..27).map(|n: i8| [n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1]);
        numbers.filter_map(|numbers| Direction::new(numbers).ok()).collect()
    }

    fn octants() -> impl Iterator<Item = IVec3> {
        (0..8).map(|n| IVec3::new(n & 1, n >> 1 & 1, n >> 2))
    }

    #[test]
    fn axes_are_right_handed_and_extents_are_those_of_the_cube_of_side_1() {
        assert_eq!(all().len(), 26);
        for direction in all() {
            let frame = direction.frame();
            let [right, up, toward] = frame.axes();
            assert!((right.cross(up) - toward).length() < 1e-15);
            assert_eq!(frame.right.y, 0);
            let corners: Vec<DVec3> = octants().map(|octant| octant.as_dvec3()).collect();
            let reach = |axis: DVec3| {
                let places = corners.iter().map(|corner| corner.dot(axis));
                places.clone().fold(f64::MIN, f64::max) - places.fold(f64::MAX, f64::min)
            };
            assert!((frame.extents() - DVec3::new(reach(right), reach(up), reach(toward))).length() < 1e-15);
            assert!((frame.orientation() * DVec3::Z - toward).length() < 1e-15);
        }
        assert!(Direction::new([0; 3]).is_err());
        assert!(Direction::new([0, 2, 0]).is_err());
    }

    #[test]
    fn children_lie_on_whole_pixels_and_steps() {
        for direction in all() {
            let frame = direction.frame();
            let ([right, up, toward], extents) = (frame.axes(), frame.extents());
            for (octant, size) in octants().flat_map(|octant| [4usize, 12, 256].map(|size| (octant, size))) {
                let center = octant.as_dvec3() - DVec3::splat(0.5);
                let pixels = extents / size as f64;
                let (column, row) = frame.place(octant, size);
                let left = (center.dot(right) + extents.x / 2.0) / pixels.x;
                let top = (extents.y / 2.0 - center.dot(up)) / pixels.y;
                assert!((column as f64 - left).abs() < 1e-9 && (row as f64 - top).abs() < 1e-9, "{direction:?}");
                assert!(column <= size && row <= size);
                let steps = 1020;
                let front = (extents.z / 2.0 - center.dot(toward)) / extents.z * f64::from(steps);
                assert!((f64::from(frame.steps_before(octant, steps)) - front).abs() < 1e-9, "{direction:?}");
            }
        }
    }
}
