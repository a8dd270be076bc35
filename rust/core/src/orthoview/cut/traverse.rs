//! Top-down traversal: draws cells whose pixels are fine enough for the picture, and refines the others.

use glam::{DVec3, DVec4, UVec3};

use super::cells::{Cells, PARTIAL, UNBUILT};
use super::rule::{Lift, Rule};
use crate::base::{Result, ensure};
use crate::camera::Camera;
use crate::orthoview::direction::Direction;

/// Maximum number of directions: a mask's higher bits have other meanings.
const MAX_DIRECTIONS: usize = 29;

/// A viewer of an octree.
#[derive(Clone, Debug)]
pub struct View<'a> {
    /// The camera.
    pub camera: &'a Camera,
    /// Distance rule of levels.
    pub rule: Rule,
    /// The octree's directions.
    pub directions: &'a [Direction],
    /// Number of views per cell.
    pub views: usize,
    /// Angle by which the viewer's direction is raised before the choice of views.
    pub lift: Lift,
    /// Whether leaves whose pixels are too coarse are drawn as geometry.
    pub geometry: bool,
    /// Whether to include cells outside the picture, because a viewer may turn faster than views arrive.
    pub around: bool,
}

/// A cell to draw.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Drawn {
    /// Level of the cell.
    pub level: u32,
    /// Position of the cell.
    pub place: UVec3,
    /// Distance of its nearest point, metres.
    pub distance: f64,
    /// Whether it intersects the picture.
    pub in_picture: bool,
    /// Whether finer cells are drawn in place of some of its splats.
    pub is_partial: bool,
    /// Numbers of directions, the nearest first; the first `count` are drawn.
    pub directions: [u8; Self::MAX],
    /// Number of its views.
    pub count: usize,
}

impl Drawn {
    /// Maximum number of views of a cell.
    pub const MAX: usize = 8;
}

/// Parts of an octree that a viewer sees, the nearest first.
#[derive(Clone, Debug, Default)]
pub struct Cut {
    /// Distance at which a leaf's pixels are fine enough, metres; for parallel rays the ratio of their width in the
    /// picture to the greatest sufficient width.
    pub reach: f64,
    /// Cells drawn as views.
    pub cells: Vec<Drawn>,
    /// Leaves drawn as geometry, without views.
    pub leaves: Vec<Drawn>,
    /// Subtrees that have not been added; the cells above are drawn in their place.
    pub unknown: Vec<(u32, UVec3)>,
    /// Number of possibly visible cells that an unfinished build has not reached, without the cells below them.
    pub unbuilt: usize,
}

/// Cuts an octree for a viewer.
pub fn cut(cells: &Cells, view: &View<'_>) -> Result<Cut> {
    ensure!((1..=Drawn::MAX).contains(&view.views), "views", format!("1 to {}", Drawn::MAX), view.views);
    ensure!(
        view.directions.len() <= MAX_DIRECTIONS,
        "directions",
        format!("at most {MAX_DIRECTIONS}"),
        view.directions.len()
    );
    let units = view.directions.iter().map(|direction| direction.frame().axes()[2]).collect();
    let frustum = frustum(view.camera);
    let toward = view.camera.is_parallel().then(|| -view.camera.ray(0.0, 0.0).1);
    let cut = Cut { reach: view.rule.reach, ..Cut::default() };
    let mut traversal = Traversal { cells, view, units, frustum, toward, cut };
    let top = cells.grid.levels - 1;
    match cells.get(top, UVec3::ZERO) {
        None => traversal.cut.unknown.push(cells.subtree_of(top, UVec3::ZERO)),
        Some(mask) => traversal.visit(top, UVec3::ZERO, mask, Position::Across),
    }
    let mut cut = traversal.cut;
    for cells in [&mut cut.cells, &mut cut.leaves] {
        cells.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    }
    Ok(cut)
}

/// Relation of a cell to the distance from which its pixels are fine enough.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Fineness {
    /// The whole cell is fine enough.
    Fine,
    /// Parts of it are.
    Mixed,
    /// No part is.
    Coarse,
}

struct Traversal<'a> {
    cells: &'a Cells,
    view: &'a View<'a>,
    /// Unit vectors of the directions.
    units: Vec<DVec3>,
    frustum: [DVec4; 5],
    /// Direction towards the viewer, for parallel rays.
    toward: Option<DVec3>,
    cut: Cut,
}

impl Traversal<'_> {
    fn visit(&mut self, level: u32, place: UVec3, mask: u32, parent_position: Position) {
        let side = self.cells.grid.side_at(level);
        let corner = self.cells.grid.corner(level, place);
        let center = corner + side / 2.0;
        let position = if parent_position == Position::Across {
            cube_position(&self.frustum, center, side)
        } else {
            parent_position
        };
        if mask == 0 || (position == Position::Outside && !self.view.around) {
            return;
        }
        if mask == UNBUILT || (mask == PARTIAL && level == 0) {
            self.cut.unbuilt += 1;
            return;
        }
        let (distance, in_picture) = (self.view.rule.distance(corner, side), position != Position::Outside);
        let drawn = Drawn { level, place, distance, in_picture, ..Drawn::default() };
        if mask == PARTIAL {
            return self.refine(drawn, center, mask, position);
        }
        match self.fineness(level, corner, side) {
            Fineness::Fine => self.draw(drawn, center, mask),
            Fineness::Mixed => self.refine(Drawn { is_partial: true, ..drawn }, center, mask, position),
            Fineness::Coarse if level > 0 => self.refine(drawn, center, mask, position),
            Fineness::Coarse if self.view.geometry => self.cut.leaves.push(drawn),
            Fineness::Coarse => self.draw(drawn, center, mask),
        }
    }

    /// Classifies a cell. Leaves are always drawn whole, because there are no finer cells to blend with.
    fn fineness(&self, level: u32, corner: DVec3, side: f64) -> Fineness {
        let ([nearest, farthest], start) = (self.view.rule.bounds(corner, side), self.view.rule.start(level));
        match self.view.rule.band.filter(|_| level > 0) {
            Some(band) if nearest < start * (1.0 + band) && farthest >= start => Fineness::Mixed,
            _ if nearest >= start => Fineness::Fine,
            _ => Fineness::Coarse,
        }
    }

    /// Visits the children of a cell and, if the cell is partial, draws it. If the children are unknown, draws the
    /// whole cell instead.
    fn refine(&mut self, drawn: Drawn, center: DVec3, mask: u32, position: Position) {
        let level = drawn.level - 1;
        let children: [(UVec3, Option<u32>); 8] = std::array::from_fn(|n| {
            let place = drawn.place * 2 + UVec3::new(n as u32 >> 2, n as u32 >> 1 & 1, n as u32 & 1);
            (place, self.cells.get(level, place))
        });
        if children.iter().any(|(_, mask)| mask.is_none()) {
            // All children of a cell lie in one subtree.
            self.cut.unknown.push(self.cells.subtree_of(level, children[0].0));
            self.draw(Drawn { is_partial: false, ..drawn }, center, mask);
            return;
        }
        if drawn.is_partial {
            self.draw(drawn, center, mask);
        }
        for (place, mask) in children {
            self.visit(level, place, mask.unwrap_or(0), position);
        }
    }

    /// Draws a cell, if it has views, from its directions that are nearest to the viewer's raised direction.
    fn draw(&mut self, mut drawn: Drawn, center: DVec3, mask: u32) {
        if mask == PARTIAL {
            return;
        }
        let toward = self.toward.unwrap_or(self.view.camera.position - center).normalize_or(DVec3::Y);
        let raised = self.view.lift.raised(toward);
        let cosines = self.units.iter().map(|unit| [raised, toward].map(|direction| unit.dot(direction)));
        let mut candidates: Vec<([f64; 2], u8)> = cosines.zip(0..).collect();
        // If the raised direction is +y, all directions of one elevation are equally near; the direction before raising
        // decides between them.
        let order = |a: &[f64; 2], b: &[f64; 2]| b[0].total_cmp(&a[0]).then(b[1].total_cmp(&a[1]));
        candidates.sort_by(|a, b| order(&a.0, &b.0).then(a.1.cmp(&b.1)));
        for &(_, number) in candidates.iter().filter(|(_, number)| mask >> number & 1 == 1).take(self.view.views) {
            drawn.directions[drawn.count] = number;
            drawn.count += 1;
        }
        self.cut.cells.push(drawn);
    }
}

/// Position of a box relative to a frustum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Position {
    Outside,
    Across,
    Inside,
}

/// Returns the half-spaces n·x + d ≥ 0 at a picture's four sides and in front of the camera plane.
fn frustum(camera: &Camera) -> [DVec4; 5] {
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
        let ((from, ray), (to, next_ray)) = (corners[n], corners[(n + 1) % 4]);
        // A second vector in the plane of this side.
        let second = if camera.is_parallel() { to - from } else { next_ray };
        plane(ray.cross(second), camera.position + from)
    };
    // Normal of the camera plane, from two steps in the picture.
    let [first, right, _, down] = corners.map(|(start, direction)| start + direction);
    let front = plane((right - first).cross(down - first), camera.position + start);
    [side(0), side(1), side(2), side(3), front]
}

/// Returns the position of a cube: outside one half-space, inside all of them, or across a boundary.
fn cube_position(frustum: &[DVec4], center: DVec3, side: f64) -> Position {
    let mut position = Position::Inside;
    for plane in frustum {
        let distance = plane.truncate().dot(center) + plane.w;
        let half_extent = plane.truncate().abs().element_sum() * side / 2.0;
        if distance < -half_extent {
            return Position::Outside;
        }
        if distance < half_extent {
            position = Position::Across;
        }
    }
    position
}
