//! Lines of sight along which viewers may see a cell's surfaces past those in front of them.

use glam::DVec3;

use super::cell::{Cell, Sight};
use super::direction::Direction;
use super::reduce::Sample;
use crate::base::Result;
use crate::render::{Limits, Segment};
use crate::scene::Scene;
use crate::trace::{All, AlphaFilter, Ray, any_hits};

/// Cosine above which two directions count as equal.
const SAME: f64 = 1.0 - 1e-9;

/// Lines half-way between a view's direction and others at most 90° from it, towards the viewer. They represent all
/// lines along which the view is used; lines that have their own view are omitted.
pub struct Lines<'a> {
    scene: &'a Scene,
    sight: &'a Sight,
    /// Limits of the cell, relative to the scene's origin.
    limits: Limits,
    /// Possible error of surface positions, metres.
    margin: f64,
    /// Unit vectors, those nearest to the view's direction first, because they most often reach the viewer.
    lines: Vec<DVec3>,
}

impl<'a> Lines<'a> {
    /// Creates the lines of one direction among others, within a cell. The scene must have been built.
    pub fn new(
        scene: &'a Scene,
        cell: &Cell,
        sight: &'a Sight,
        direction: Direction,
        directions: &[Direction],
    ) -> Result<Self> {
        let unit = |direction: &Direction| direction.frame().axes()[2];
        let (own, all) = (unit(&direction), directions.iter().map(unit));
        let others = all.clone().filter(|other| own.dot(*other) > -1e-9 && own.dot(*other) < SAME);
        let is_new = |line: &DVec3| all.clone().all(|other| other.dot(*line) < SAME);
        let mut lines: Vec<DVec3> = others.map(|other| (own + other).normalize()).filter(is_new).collect();
        lines.sort_by(|one, other| own.dot(*other).total_cmp(&own.dot(*one)));
        let limits = cell.limits(scene.origin)?.relative_to(scene.origin);
        Ok(Self { scene, sight, limits, margin: cell.margin(scene.origin), lines })
    }

    /// Returns whether a pixel's surface is visible along a line that it faces. `step` is the length of a depth step,
    /// metres.
    pub fn see(&self, pixel: usize, sample: &Sample, step: f32) -> bool {
        let point = self.sight.middle(pixel, f64::from(sample.depth * step)) - self.scene.origin;
        let normal = sample.normal.as_dvec3();
        self.lines.iter().any(|&line| {
            let cosine = normal.dot(line);
            // The surface itself intersects the line only up to this distance.
            cosine > 0.0 && self.is_free(point, line, self.margin / cosine)
        })
    }

    /// Returns whether a line is free between a distance from a point and the cell's side.
    fn is_free(&self, point: DVec3, line: DVec3, distance: f64) -> bool {
        let Segment { t_max, .. } = self.limits.clip_ray(point, line);
        let ray = Ray { origin: point.as_vec3(), direction: line.as_vec3(), t_min: distance as f32, t_max };
        let mut is_hit = [false];
        any_hits(self.scene, &[ray], &AlphaFilter::new(self.scene, All), &mut is_hit);
        !is_hit[0]
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;

    /// Returns the four sides, the top and the upper edges.
    fn nine() -> Vec<Direction> {
        let sides = [[0, 0, 1], [1, 0, 0], [0, 0, -1], [-1, 0, 0]];
        let edges = sides.map(|[x, _, z]| [x, 1, z]);
        sides.into_iter().chain([[0, 1, 0]]).chain(edges).map(|numbers| Direction::new(numbers).unwrap()).collect()
    }

    #[test]
    fn lines_lean_half_way_to_other_directions_and_none_is_a_direction() {
        let scene = Scene::new(DVec3::ZERO, vec![], vec![], Arc::default(), Arc::default()).unwrap();
        let cell = Cell::new(DVec3::ZERO, 1.0).unwrap();
        let lines = |n: usize, directions: &[Direction]| {
            let sight = Sight::new(&cell, directions[n].frame(), 8);
            Lines::new(&scene, &cell, &sight, directions[n], directions).unwrap().lines
        };
        let all = nine();
        // From the top half-way to the four edges; lines half-way to the sides coincide with the edges.
        let top = lines(4, &all);
        let angles: Vec<f64> = top.iter().map(|line| line.y.acos().to_degrees()).collect();
        assert!(top.len() == 4 && angles.iter().all(|angle| (angle - 22.5).abs() < 1e-9), "{angles:?}");
        // From a side to the edge above it, to two other sides and to the edges above those.
        let side = lines(0, &all);
        assert_eq!(side.len(), 5);
        assert!((side[0] - DVec3::new(0.0, 1.0, 1.0 + 2f64.sqrt()).normalize()).length() < 1e-12);
        assert!(side.iter().any(|line| (*line - DVec3::new(1.0, 0.0, 1.0).normalize()).length() < 1e-12));
        // Without edges, the directions half-way between sides and top have no own view.
        assert_eq!(lines(4, &all[..5]).len(), 4);
        assert_eq!(lines(0, &all[..1]).len(), 0);
    }
}
