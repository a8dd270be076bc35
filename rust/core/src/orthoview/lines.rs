//! Lines along which viewers may see a cell's surfaces past those in front of them.

use glam::DVec3;

use super::cell::{Cell, Sight};
use super::direction::Direction;
use super::reduce::Sample;
use crate::base::Result;
use crate::render::{Limits, Segment};
use crate::scene::Scene;
use crate::trace::{All, AlphaFilter, Ray, any_hits};

/// Two directions are the same above this cosine.
const SAME: f64 = 1.0 - 1e-9;

/// The lines half-way between a view's direction and others at most 90° from it, towards the viewer. They stand for all
/// those along which the view is looked at; those that have a view of their own are left out.
pub struct Lines<'a> {
    scene: &'a Scene,
    sight: &'a Sight,
    /// Relative to the scene's origin.
    limits: Limits,
    /// Metres by which surfaces may be off.
    margin: f64,
    /// Unit vectors; those nearest to the view's direction first, because they most often see something.
    lines: Vec<DVec3>,
}

impl<'a> Lines<'a> {
    /// The lines of one of some directions, within a cell. The scene must have been built.
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

    /// Whether a pixel's surface, which faces the view, is seen along one of the lines. `step` is the length of a step of
    /// its depth, metres.
    pub fn see(&self, pixel: usize, sample: &Sample, step: f32) -> bool {
        let point = self.sight.middle(pixel, f64::from(sample.depth * step)) - self.scene.origin;
        let normal = sample.normal.as_dvec3();
        self.lines.iter().any(|&line| {
            let cosine = normal.dot(line);
            // The surface itself crosses the line no farther away.
            cosine > 0.0 && self.is_free(point, line, self.margin / cosine)
        })
    }

    /// Whether nothing lies on a line between a distance from a point and the cell's side.
    fn is_free(&self, point: DVec3, line: DVec3, distance: f64) -> bool {
        let Segment { t_max, .. } = self.limits.of(point, line);
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

    /// The four sides, the top and the upper edges.
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
        // From the top half-way to the four edges; half-way to the sides are the edges themselves.
        let top = lines(4, &all);
        let angles: Vec<f64> = top.iter().map(|line| line.y.acos().to_degrees()).collect();
        assert!(top.len() == 4 && angles.iter().all(|angle| (angle - 22.5).abs() < 1e-9), "{angles:?}");
        // From a side to the edge above it, to two other sides and to the edges above those.
        let side = lines(0, &all);
        assert_eq!(side.len(), 5);
        assert!((side[0] - DVec3::new(0.0, 1.0, 1.0 + 2f64.sqrt()).normalize()).length() < 1e-12);
        assert!(side.iter().any(|line| (*line - DVec3::new(1.0, 0.0, 1.0).normalize()).length() < 1e-12));
        // Without edges the halves between sides and top have no view of their own.
        assert_eq!(lines(4, &all[..5]).len(), 4);
        assert_eq!(lines(0, &all[..1]).len(), 0);
    }
}
